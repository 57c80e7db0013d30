#include "app/cli/desktop_inputs.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <ranges>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/base/words.h"
#include "app/cli/command.h"
#include "app/cli/option.h"
#include "app/files/falcon_calibration_file.h"
#include "app/files/haply_calibration_file.h"
#include "app/files/xdg_folders.h"
#include "app/shell/haply_input_link.h"
#include "app/shell/spacemouse_input_link.h"
#include "app/tools/doctor/readiness.h"
#include "core/safety.h"
#include "device/falcon/falcon_input.h"
#include "device/spacemouse/hid_spacemouse_input.h"
#include "device/virtual_falcon/injected_fault.h"
#include "device/virtual_haply/virtual_haply_input.h"

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

template <typename Report>
std::vector<ReadinessStepState> readiness_with_motors(const Report& report, const MotorReport& motors) {
  return readiness_of(report, &motors);
}

}  // namespace

InputMaker<FalconInput> falcon_kind(const FtdiLinkOptions& cable) {
  return {{{"falcon", "Falcon", "A Novint Falcon: its handle is the goal, and with its motors on it is the device."}},
          [cable](const Scene& scene, const InputOptions& options) {
            return std::make_unique<FalconInput>(std::make_unique<FtdiLink>(cable), options.falcon, scene.view.center);
          }};
}

InputMaker<HaplyInput> haply_kind(const TtyPortOptions& port) {
  return {{{"haply", "Haply 2DIY",
            "A Haply 2DIY on a serial port: its handle is the goal, and with its motors on it is the device."}},
          [port](const Scene& scene, const InputOptions& options) {
            return std::make_unique<HaplyInput>(std::make_unique<TtyPort>(port), options.haply, scene.view.center);
          }};
}

const InputMaker<VirtualHaplyInput> virtual_haply_kind{
    {{"virtual-haply", "Virtual Haply",
      "The Haply's driver with a simulated board, arms and hand behind it; drag in the scene to guide that hand."},
     /*is_scripted=*/false,
     /*needs_recording=*/false,
     /*hand_is_simulated=*/true},
    [](const Scene& scene, const InputOptions& options) {
      // A board that is plugged in again gets another terminal: the link leads to it.
      static std::atomic<int> made{0};
      const std::filesystem::path link =
          std::filesystem::temp_directory_path() / fmt::format("ghostforce-virtual-haply-{}-{}", getpid(), ++made);
      auto board = std::make_unique<PtyBoard>(
          PtyBoard::Options{.device = {.variant = options.haply.usual.variant, .fault = options.injected_haply_fault},
                            .link = link.string()});
      auto port = std::make_unique<TtyPort>(TtyPortOptions{.path = board->port(), .is_guarded = false});
      return std::make_unique<VirtualHaplyInput>(std::move(board), std::move(port), options.haply, scene);
    }};

std::vector<InputEntry> desktop_inputs(const Cables& cables) {
  const auto of_falcon = readiness_with_motors<FalconReport>;
  const auto of_haply = readiness_with_motors<HaplyReport>;
  std::vector<InputEntry> inputs =
      portable_inputs(of_falcon, {linked<SpaceMouseInputLink>(spacemouse_kind, spacemouse_words),
                                  falcon_entry(falcon_kind(cables.falcon), of_falcon),
                                  haply_entry(haply_kind(cables.haply), of_haply)});
  inputs.push_back(virtual_haply_entry(virtual_haply_kind, of_haply));
  return inputs;
}

std::vector<InputEntry> simulated_inputs() {
  return portable_inputs(readiness_with_motors<FalconReport>);
}

EndOfRun end_of_run(const MotorReport& motors, std::span<const ReadinessStepState> readiness,
                    const EndOfRun& of_input) {
  if (const OffReasonEntry& reason = entry_of(motors.reason); reason.is_safety_limit) {
    return {ExitCode::safety_stop, fmt::format("The motors went off ({}). {}", reason.title, reason.remedy)};
  }
  // Whoever could read the handle has had what they came for.
  const auto step = std::ranges::find_if(readiness, &ReadinessStepState::is_current);
  if (step == readiness.end() || step->step > ReadinessStep::homed) return of_input;
  const char* const what = step->step == ReadinessStep::seen ? "No device is plugged in" : "The device is not ready";
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

void tell_of_haply_left_pushing(const DeviceSerial& serial) noexcept {
  say("The motors of the Haply {} may still push: pull the plug of its power supply now, then its USB cable.\n",
      serial.text());
}

struct MisbehavingDevice {
  std::string_view input;
  std::string_view title;
  std::vector<std::string_view> faults;
};

std::array<MisbehavingDevice, 2> misbehaving_devices() {
  return {
      MisbehavingDevice{virtual_falcon_kind.name, virtual_falcon_kind.title, names_of(injected_fault_catalog())},
      MisbehavingDevice{virtual_haply_kind.name, virtual_haply_kind.title, names_of(injected_haply_fault_catalog())}};
}

}  // namespace

void DeviceSetUp::attach(CLI::App& command, FileOptions& files) {
  files.reads(add_option(command, "--firmware FILE", firmware,
                         "The Falcon's firmware file; default: $GHOSTFORCE_FIRMWARE, else "
                         "~/.config/ghostforce/falcon/firmware.bin"));
  add_option(command, "--falcon-serial NUMBER", serial,
             "Serial number of the Falcon to use; default: the first Falcon");
  add_option(command, "--falcon-usb-id VVVV:PPPP", usb_id, "USB ID of the Falcon, if it is not 0403:cb48")
      ->check(refuse_other_than_usb_id);
  files.reads(add_option(command, "--haply-port PATH", haply_port,
                         "Serial port of the Haply, as /dev/ttyACM0; default: that of the only board that is known"));
  const std::vector<std::string_view> variants = names_of(haply_variant_catalog());
  add_option(
      command, "--haply-variant NAME", haply_variant,
      fmt::format("Which Haply it is, where no calibration file of this very board says so: {}; default: that of "
                  "any.toml, else {}",
                  listed(variants), usual_haply_variant().name))
      ->check(one_of(variants));
  std::string about_faults = "Faults to inject.";
  std::vector<std::string_view> all;
  for (const MisbehavingDevice& device : misbehaving_devices()) {
    about_faults += fmt::format(" With --input {}: {}.", device.input, listed(device.faults));
    for (const std::string_view name : device.faults) {
      if (std::ranges::find(all, name) == all.end()) all.push_back(name);
    }
  }
  about_faults.pop_back();
  repeatable(add_option(command, "--misbehave NAME[,NAME]", misbehave, about_faults)->delimiter(','))
      ->check(one_of(all));
}

void DeviceSetUp::refuse_misbehaviour_of_others(std::string_view input) const {
  const std::array devices = misbehaving_devices();
  const auto device = std::ranges::find(devices, input, &MisbehavingDevice::input);
  for (const std::string& name : misbehave) {
    if (device == devices.end()) {
      throw Failure(ExitCode::wrong_call,
                    fmt::format("--misbehave is about virtual devices, but --input is {}; add --input {}, or leave it "
                                "out",
                                quoted_text(input, longest_path),
                                fmt::join(devices | std::views::transform(&MisbehavingDevice::input), " or --input ")));
    }
    if (std::ranges::find(device->faults, name) == device->faults.end()) {
      throw Failure(ExitCode::wrong_call,
                    fmt::format("--misbehave {}: the {} has no such fault; --help lists those of each device", name,
                                device->title));
    }
  }
}

std::optional<FirmwareImage> DeviceSetUp::read_firmware_file() const {
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

InputOptions DeviceSetUp::input_options(const std::optional<FirmwareImage>& image) const {
  InputOptions options;
  if (image) options.falcon.firmware = image->bytes;
  options.falcon.calibrations = load_falcon_calibrations();
  options.falcon.debts = std::make_shared<StopDebts>();
  options.falcon.when_left_pushing = tell_of_left_pushing;
  // They have been looked at when the command line was.
  options.haply.calibrations = load_haply_calibrations();
  const auto of_any = std::ranges::find(options.haply.calibrations, DeviceSerial(), &HaplyCalibration::serial);
  if (!haply_variant.empty()) {
    options.haply.usual = find_haply_variant(haply_variant)->calibration;
  } else if (of_any != options.haply.calibrations.end()) {
    options.haply.usual = *of_any;
  }
  options.haply.debts = std::make_shared<StopDebts>();
  options.haply.when_left_pushing = tell_of_haply_left_pushing;
  for (const std::string& name : misbehave) {
    if (const auto* const of_falcon = find_injected_fault(name)) of_falcon->add(options.injected_fault);
    if (const auto* const of_haply = find_injected_haply_fault(name)) of_haply->add(options.injected_haply_fault);
  }
  return options;
}

Cables DeviceSetUp::cables() const {
  // It has been looked at when the command line was.
  return {.falcon = {.id = usb_id.empty() ? falcon_usb_id : parse_usb_id(usb_id).value(), .serial = serial},
          .haply = {.path = haply_port}};
}

}  // namespace ghostforce
