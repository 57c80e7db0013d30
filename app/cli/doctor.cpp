// ghostforce doctor: what lies between a device and its use, step by step, and what to do about it.
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/base/quoted.h"
#include "app/base/words.h"
#include "app/cli/command.h"
#include "app/cli/desktop_inputs.h"
#include "app/cli/option.h"
#include "app/shell/desktop/offscreen.h"
#include "app/shell/desktop/renderer.h"
#include "app/tools/doctor/diagnosis.h"
#include "app/tools/doctor/haply_diagnosis.h"
#include "app/tools/doctor/haply_measure_command.h"
#include "app/tools/doctor/haply_motor_flip.h"
#include "app/tools/doctor/measure_command.h"
#include "app/tools/doctor/readiness.h"
#include "app/tools/doctor/udev_rule.h"
#include "core/scene.h"
#include "device/servo/realtime.h"
#include "device/spacemouse/hid_spacemouse_input.h"
#include "device/virtual_falcon/virtual_falcon_input.h"
#include "device/virtual_haply/virtual_haply_input.h"

namespace ghostforce {
namespace {

constexpr double wait_on_terminal_s = 30.0;

// Long enough for the SpaceMouse's thread to have looked once.
constexpr std::chrono::milliseconds time_to_look{200};

struct DoctorOptions {
  DeviceSetUp devices;
  std::string input = "falcon";
  std::optional<double> wait_s;  // empty: as long as somebody is probably there
  bool json = false;
  bool install_udev = false;
  bool is_udev_announced = false;
  bool measure = false;
  std::string flip_motor;  // "1" or "2"; empty: none
  std::string report = "-";
  std::optional<std::string> calibration;
};

InputMaker<FalconInput> falcon_kind_of(const DoctorOptions& options) {
  if (options.input == virtual_falcon_kind.name) return {virtual_falcon_kind, virtual_falcon_kind.make};
  return falcon_kind(options.devices.cables().falcon);
}

bool is_somebody_there() {
  return isatty(STDIN_FILENO) != 0 && isatty(STDERR_FILENO) != 0;
}

// The step that is next, as one line of the terminal that is written over.
class LiveLine {
 public:
  explicit LiveLine(bool shows) : shows_(shows) {}
  ~LiveLine() {
    if (has_shown_) write_words("\r\x1b[K");
  }
  LiveLine(const LiveLine&) = delete;
  LiveLine& operator=(const LiveLine&) = delete;

  template <typename Report>
  void show(const Report& report) {
    if (!shows_) return;
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(100);
    const std::vector<ReadinessStepState> readiness = readiness_of(report, nullptr);
    const auto current = std::ranges::find_if(readiness, &ReadinessStepState::is_current);
    if (current == readiness.end()) return;
    const std::string line = fmt::format("{}. {}", current->title, current->words);
    has_shown_ = true;
    say("\r{:.{}}\x1b[K", line, columns() - 1);
  }

 private:
  // A line that is broken into two cannot be written over.
  static int columns() {
    winsize size{};
    constexpr int usual = 80;
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1 ? size.ws_col : usual;
  }

  bool shows_;
  bool has_shown_ = false;
  std::chrono::steady_clock::time_point next_{};
};

std::vector<RendererState> renderer_states() {
  std::vector<RendererState> states;
  for (const RendererFinding& finding : examine_renderers()) {
    states.push_back(
        {std::string(entry_of(finding.renderer).name), finding.is_there, finding.is_default, finding.words});
  }
  return states;
}

int examine_haply(const DoctorOptions& options) {
  const InputOptions input_options = options.devices.input_options({});
  HaplyDiagnosis diagnosis;
  diagnosis.ports = list_serial_ports();
  diagnosis.udev_rule = installed_udev_rule(udev_folders());
  // This thread drives the device as the servo's would.
  diagnosis.realtime = request_realtime();
  {
    const bool is_virtual = options.input == virtual_haply_kind.name;
    const std::unique_ptr<HaplyInput> input =
        is_virtual ? virtual_haply_kind.make(Scene{}, input_options)
                   : haply_kind(options.devices.cables().haply).make(Scene{}, input_options);
    LiveLine live(is_somebody_there());
    diagnosis.report = examine(*input, [&](const HaplyReport& report) {
      stop_if_interrupted();
      live.show(report);
    });
  }
  const HaplyOptions& haply = input_options.haply;
  const HaplyCalibration used = calibration_of(diagnosis.report.serial, haply.calibrations, haply.usual);
  if (std::ranges::find(haply.calibrations, used) != haply.calibrations.end()) diagnosis.calibrated_board = used.serial;
  diagnosis.verdict = exit_code_of(readiness_of(diagnosis.report, nullptr), false);
  print(options.json ? json_of(diagnosis) : text_of(diagnosis));
  return static_cast<int>(diagnosis.verdict);
}

int measure_haply(const DoctorOptions& options) {
  const InputOptions input = options.devices.input_options({});
  const TtyPortOptions port = options.devices.cables().haply;
  const bool is_virtual = options.input == virtual_haply_kind.name;
  return measure_haply_with_doctor({.port = is_virtual ? nullptr : std::make_unique<TtyPort>(port),
                                    .port_words = is_virtual          ? "a virtual Haply, which is simulated"
                                                  : port.path.empty() ? "the only board that is known"
                                                                      : port.path,
                                    .haply = input.haply,
                                    .injected_fault = input.injected_haply_fault,
                                    .report = options.report,
                                    .calibration = options.calibration});
}

int flip_motor(const DoctorOptions& options) {
  if (options.input != "haply") {
    throw Failure(ExitCode::wrong_call,
                  fmt::format("--flip-motor is about a Haply that is plugged in; write: ghostforce doctor haply "
                              "--flip-motor {}",
                              options.flip_motor));
  }
  print(flip_haply_motor({.motor = options.flip_motor == "1" ? 0U : 1U,
                          .port = options.devices.haply_port,
                          .variant = options.devices.haply_variant,
                          .ports = list_serial_ports(),
                          .calibrations = options.devices.input_options({}).haply.calibrations}));
  return static_cast<int>(ExitCode::done);
}

void refuse_results_without_measuring(const DoctorOptions& options) {
  if (!options.measure && (options.calibration || options.report != "-"))
    throw Failure(ExitCode::wrong_call, "-o and --calibration are for a measurement; add --measure");
}

int measure_falcon(const DoctorOptions& options) {
  const std::optional<FirmwareImage> firmware = options.devices.read_firmware_file();
  const InputOptions input = options.devices.input_options(firmware);
  return measure_with_doctor({.firmware = firmware,
                              .falcon = input.falcon,
                              .injected_fault = input.injected_fault,
                              .cable = options.devices.cables().falcon,
                              .is_virtual = falcon_kind_of(options).hand_is_simulated,
                              .report = options.report,
                              .calibration = options.calibration});
}

int examine_falcon(const DoctorOptions& options) {
  Diagnosis diagnosis;
  diagnosis.renderers = renderer_states();  // while there is one thread
  HidSpaceMouseInput spacemouse;            // looks for one meanwhile
  const auto began = std::chrono::steady_clock::now();
  diagnosis.firmware = options.devices.read_firmware_file();
  const InputOptions input_options = options.devices.input_options(diagnosis.firmware);
  diagnosis.usb = list_falcons(options.devices.cables().falcon.id);
  diagnosis.serial_ports = list_serial_ports();
  diagnosis.udev_rule = installed_udev_rule(udev_folders());
  // This thread drives the device as the servo's would.
  diagnosis.realtime = request_realtime();
  const double wait_s = options.wait_s.value_or(is_somebody_there() ? wait_on_terminal_s : 0.0);
  {
    const std::unique_ptr<FalconInput> input = falcon_kind_of(options).make(Scene{}, input_options);
    LiveLine live(is_somebody_there());
    diagnosis.report = examine(*input, wait_s, [&](const FalconReport& report) {
      stop_if_interrupted();
      live.show(report);
    });
  }
  diagnosis.has_calibration = std::ranges::find(input_options.falcon.calibrations, diagnosis.report.serial,
                                                &FalconCalibration::serial) != input_options.falcon.calibrations.end();
  std::this_thread::sleep_until(began + time_to_look);
  diagnosis.spacemouse = spacemouse.reading();
  diagnosis.verdict = exit_code_of(diagnosis.report, wait_s > 0.0);
  print(options.json ? json_of(diagnosis) : text_of(diagnosis));
  return static_cast<int>(diagnosis.verdict);
}

struct ExaminedDevice {
  std::string_view name;
  int (*examine)(const DoctorOptions&);
  int (*measure)(const DoctorOptions&);
};

std::array<ExaminedDevice, 4> examined_devices() {
  return {ExaminedDevice{"falcon", examine_falcon, measure_falcon},
          ExaminedDevice{virtual_falcon_kind.name, examine_falcon, measure_falcon},
          ExaminedDevice{"haply", examine_haply, measure_haply},
          ExaminedDevice{virtual_haply_kind.name, examine_haply, measure_haply}};
}

int doctor(const DoctorOptions& options) {
  if (options.install_udev) {
    install_udev_rule(options.is_udev_announced);
    return static_cast<int>(ExitCode::done);
  }
  options.devices.refuse_misbehaviour_of_others(options.input);
  refuse_results_without_measuring(options);
  if (!options.flip_motor.empty()) return flip_motor(options);
  const auto devices = examined_devices();
  const ExaminedDevice& device = *std::ranges::find(devices, options.input, &ExaminedDevice::name);
  return options.measure ? device.measure(options) : device.examine(options);
}

}  // namespace

std::function<int()> attach_doctor(CLI::App& command, FileOptions& files) {
  const auto options = std::make_shared<DoctorOptions>();
  CLI::Option* const json = command.add_flag("--json", options->json, "Print JSON for programs, in SI units");
  CLI::Option* const install =
      command.add_flag("--install-udev", options->install_udev,
                       "Install the udev rule that lets the person at this machine use the devices; asks for root");
  command.add_flag("--udev-announced", options->is_udev_announced, "")->group("");
  CLI::Option* const wait =
      add_option(
          command, "--wait S", options->wait_s,
          "How long to wait for a person to home the device and move its handle; default: 30 on a terminal, else 0")
          ->check(number_between(0.0, 3600.0, "s"));
  const auto devices = examined_devices();
  const std::vector<std::string_view> names = names_of(devices);
  CLI::Option* const device =
      add_option(command, "DEVICE", options->input,
                 "falcon or haply, or virtual-falcon or virtual-haply to try this out; default: falcon")
          ->check(one_of(names))
          ->excludes(install);
  add_option(command, "--input NAME", options->input, "The same as DEVICE")
      ->check(one_of(names))
      ->excludes(install)
      ->excludes(device);
  CLI::Option* const measure = command.add_flag(
      "--measure", options->measure,
      "Measure the device with a ruler and a weight; takes ten minutes, motors below 2 N; see docs/falcon.md and "
      "docs/haply.md");
  measure->excludes(json)->excludes(install)->excludes(wait);
  add_option(command, "--flip-motor N", options->flip_motor,
             "With haply: turn round the sign of motor 1 or 2 in the board's calibration file, where the check of the "
             "motors says that it pushes the wrong way; see docs/haply.md")
      ->check(one_of(std::vector<std::string_view>{"1", "2"}))
      ->excludes(json)
      ->excludes(install)
      ->excludes(wait)
      ->excludes(measure);
  files.writes(add_option(command, "-o,--output REPORT.md", options->report,
                          "With --measure: where the report goes; default: -, standard output"));
  files.writes(add_option(command, "--calibration FILE.toml", options->calibration,
                          "With --measure: where the calibration goes; default: ~/.config/ghostforce, after asking"));
  options->devices.attach(command, files);
  return [options] { return doctor(*options); };
}

}  // namespace ghostforce
