#include "app/cli/desktop_inputs.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/base/words.h"
#include "app/cli/command.h"
#include "app/cli/option.h"
#include "app/files/falcon_calibration_file.h"
#include "app/files/xdg_folders.h"
#include "app/shell/spacemouse_input_link.h"
#include "app/tools/doctor/readiness.h"
#include "core/safety.h"
#include "device/falcon/falcon_input.h"
#include "device/spacemouse/hid_spacemouse_input.h"
#include "device/virtual_falcon/injected_fault.h"

namespace ghostforce {
namespace {

const InputMaker<SpaceMouseInput> spacemouse_kind{
    {{spacemouse_hand}}, [](const Scene&, const InputOptions&) { return std::make_unique<HidSpaceMouseInput>(); }};

constexpr SpaceMouseWords spacemouse_words{
    .absent = "None is plugged in. The program keeps looking for one.",
    .not_allowed =
        "One is plugged in, but this user may not open it: run 'ghostforce doctor --install-udev' once, then plug it "
        "in again.",
    .not_opened = "One is plugged in, but it cannot be opened: is another program using it?"};

std::vector<ReadinessStepState> readiness_with_motors(const FalconReport& report, const MotorReport& motors) {
  return readiness_of(report, &motors);
}

}  // namespace

InputMaker<FalconInput> falcon_kind(const FtdiLinkOptions& cable) {
  return {{{"falcon", "Falcon", "A Novint Falcon: its handle is the goal, and with its motors on it is the device."}},
          [cable](const Scene& scene, const InputOptions& options) {
            return std::make_unique<FalconInput>(std::make_unique<FtdiLink>(cable), options.falcon, scene.view.center);
          }};
}

std::vector<InputEntry> desktop_inputs(const FtdiLinkOptions& cable) {
  return portable_inputs(readiness_with_motors, {linked<SpaceMouseInputLink>(spacemouse_kind, spacemouse_words),
                                                 falcon_entry(falcon_kind(cable), readiness_with_motors)});
}

std::vector<InputEntry> simulated_inputs() {
  return portable_inputs(readiness_with_motors);
}

EndOfRun end_of_run(const MotorReport& motors, std::span<const ReadinessStepState> readiness,
                    const EndOfRun& of_input) {
  if (const OffReasonEntry& reason = entry_of(motors.reason); reason.is_safety_limit) {
    return {ExitCode::safety_stop, fmt::format("The motors went off ({}). {}", reason.title, reason.remedy)};
  }
  // Whoever could read the handle has had what they came for.
  const auto step = std::ranges::find_if(readiness, &ReadinessStepState::is_current);
  if (step == readiness.end() || step->step > ReadinessStep::homed) return of_input;
  const char* const what = step->step == ReadinessStep::seen ? "No Falcon is plugged in" : "The Falcon is not ready";
  return {exit_code_of(readiness, true), fmt::format("{}. {}", what, step->words)};
}

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

void tell_of_left_pushing(const DeviceSerial& serial) noexcept {
  say("{}\n", left_pushing_words(serial));
}

}  // namespace

void FalconSetUp::attach(CLI::App& command, FileOptions& files) {
  files.reads(add_option(command, "--firmware FILE", firmware,
                         "The Falcon's firmware file; default: $GHOSTFORCE_FIRMWARE, else "
                         "~/.config/ghostforce/falcon/firmware.bin"));
  add_option(command, "--falcon-serial NUMBER", serial,
             "Serial number of the Falcon to use; default: the first Falcon");
  add_option(command, "--falcon-usb-id VVVV:PPPP", usb_id, "USB ID of the Falcon, if it is not 0403:cb48")
      ->check(refuse_other_than_usb_id);
  const std::vector<std::string_view> names = names_of(injected_fault_catalog());
  repeatable(add_option(command, "--misbehave NAME[,NAME]", misbehave,
                        fmt::format("With --input virtual-falcon: faults to inject. {}", listed(names)))
                 ->delimiter(','))
      ->check(one_of(names));
}

void FalconSetUp::refuse_misbehaviour_of_others(std::string_view input) const {
  if (misbehave.empty() || input == virtual_falcon_kind.name) return;
  throw Failure(
      ExitCode::wrong_call,
      fmt::format("--misbehave is about the virtual Falcon, but --input is {}; add --input {}, or leave it out",
                  quoted_text(input, longest_path), virtual_falcon_kind.name));
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
