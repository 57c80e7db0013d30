#include "app/cli/falcon_options.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/base/words.h"
#include "app/cli/command.h"
#include "app/files/falcon_calibration_file.h"
#include "app/files/xdg_folders.h"
#include "app/tools/doctor/readiness.h"
#include "device/virtual_falcon/injected_fault.h"

namespace ghostforce {
namespace {

std::optional<UsbId> parse_usb_id(std::string_view text) {
  constexpr std::size_t digits = 4;
  if (text.size() != 2 * digits + 1 || text[digits] != ':') return std::nullopt;
  const auto vendor = number_in<std::uint16_t>(text.substr(0, digits), 16);
  const auto product = number_in<std::uint16_t>(text.substr(digits + 1), 16);
  return vendor && product ? std::optional(UsbId{*vendor, *product}) : std::nullopt;
}

std::string refuse_other_than_usb_id(const std::string& text) {
  if (parse_usb_id(text)) return {};
  return fmt::format(
      "'{}' is not a USB ID; give vendor and product as lsusb shows them, four hex digits each, as in {:04x}:{:04x}",
      quoted_text(text), falcon_usb_id.vendor, falcon_usb_id.product);
}

void tell_of_left_pushing(const FalconSerial& serial) noexcept {
  say("{}\n", left_pushing_words(serial));
}

}  // namespace

void FalconSetUp::attach(CLI::App& command, FileOptions& files) {
  files.reads(command
                  .add_option("--firmware", firmware,
                              "The Falcon's firmware file; default: $GHOSTFORCE_FIRMWARE, else "
                              "~/.config/ghostforce/falcon/firmware.bin")
                  ->type_name("FILE"));
  command.add_option("--falcon-serial", serial, "Serial number of the Falcon to use; default: the first Falcon")
      ->type_name("NUMBER");
  command.add_option("--falcon-usb-id", usb_id, "USB ID of the Falcon, if it is not 0403:cb48")
      ->type_name("VVVV:PPPP")
      ->check(refuse_other_than_usb_id);
  const std::vector<std::string_view> names = names_of(injected_fault_catalog());
  repeatable(command
                 .add_option("--misbehave", misbehave,
                             fmt::format("With --input virtual-falcon: faults to inject. {}", listed(names)))
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
  options.falcon.debts = std::make_shared<StopDebts>();
  options.falcon.when_left_pushing = tell_of_left_pushing;
  // They have been looked at when the command line was.
  for (const std::string& name : misbehave) find_injected_fault(name)->add(options.injected_fault);
  return options;
}

FtdiLinkOptions FalconSetUp::cable() const {
  // It has been looked at when the command line was.
  return {.id = usb_id.empty() ? falcon_usb_id : parse_usb_id(usb_id).value(), .serial = serial};
}

}  // namespace ghostforce
