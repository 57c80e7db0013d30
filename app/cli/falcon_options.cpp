#include "app/cli/falcon_options.h"

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/console/failure.h"
#include "app/console/quoted.h"
#include "app/files/config_folder.h"
#include "app/files/falcon_calibration_file.h"
#include "device/virtual_falcon/injected_fault.h"

namespace ghostforce {
namespace {

std::optional<std::uint16_t> four_hex_digits(std::string_view text) {
  std::uint16_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [after, error] = std::from_chars(text.data(), end, number, 16);
  if (text.size() != 4 || error != std::errc{} || after != end) return std::nullopt;
  return number;
}

std::optional<UsbId> parse_usb_id(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const auto vendor = four_hex_digits(text.substr(0, colon));
  const auto product = four_hex_digits(text.substr(colon + 1));
  if (!vendor || !product) return std::nullopt;
  return UsbId{*vendor, *product};
}

WordCheck is_usb_id() {
  return [](const std::string& text) -> std::string {
    if (parse_usb_id(text)) return {};
    return fmt::format(
        "'{}' is no USB id; give vendor and product as lsusb shows them, four hex digits each: "
        "{:04x}:{:04x}",
        quoted_text(text), falcon_usb_id.vendor, falcon_usb_id.product);
  };
}

}  // namespace

void FalconSetUp::attach(CLI::App& command, FileOptions& files) {
  files.reads(
      command
          .add_option(
              "--firmware", firmware,
              "The Falcon's firmware; default: $GHOSTFORCE_FIRMWARE, else falcon/firmware.bin among the settings")
          ->type_name("FILE"));
  command
      .add_option("--falcon-serial", serial, "Which Falcon, of several: its serial number; default: the first of them")
      ->type_name("NUMBER");
  command.add_option("--falcon-usb-id", usb_id, "Another device than 0403:cb48 is a Falcon")
      ->type_name("VVVV:PPPP")
      ->check(is_usb_id());
  std::vector<std::string_view> names;
  for (const InjectedFaultKind& kind : injected_fault_catalog()) names.push_back(kind.name);
  repeatable(command
                 .add_option("--misbehave", misbehave,
                             fmt::format("With --input virtual-falcon: what goes wrong with it. {}", listed(names)))
                 ->type_name("NAME[,NAME]")
                 ->delimiter(','))
      ->check(one_of(names));
}

std::optional<FirmwareImage> FalconSetUp::read_firmware_file() const {
  const auto path = firmware_path(firmware.empty() ? std::nullopt : std::optional<std::filesystem::path>(firmware));
  if (!path) return std::nullopt;
  try {
    return read_firmware(*path);
  } catch (const FirmwareError& error) {
    const ExitCode code =
        error.trouble() == FirmwareTrouble::unreadable ? ExitCode::file_trouble : ExitCode::wrong_call;
    throw Failure(code, fmt::format("the Falcon's firmware {}", quoted_text(error.what(), longest_path)));
  }
}

InputOptions FalconSetUp::input_options(const std::optional<FirmwareImage>& image) const {
  InputOptions options;
  if (image) options.falcon.firmware = image->bytes;
  options.falcon.calibrations = load_falcon_calibrations();
  // They have been looked at when the command line was.
  for (const std::string& name : misbehave) find_injected_fault(name)->add(options.injected_fault);
  return options;
}

FtdiLinkOptions FalconSetUp::cable() const {
  // It has been looked at when the command line was.
  return {.id = usb_id.empty() ? falcon_usb_id : parse_usb_id(usb_id).value(), .serial = serial};
}

}  // namespace ghostforce
