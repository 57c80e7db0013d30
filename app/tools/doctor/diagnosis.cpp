#include "app/tools/doctor/diagnosis.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/base/quoted.h"
#include "app/tools/doctor/readiness.h"

namespace ghostforce {
namespace {

std::string_view mark_of(const ReadinessStepState& state) {
  if (state.is_reached) return "✓";
  return state.is_current ? "✗" : "–";
}

std::string open_error_words(const UsbDeviceFound& device) {
  return device.may_open ? "" : std::generic_category().message(device.open_error);
}

std::string words_about(const UsbDeviceFound& device) {
  std::string words = fmt::format("device: {}", device.node);
  if (!device.serial.empty()) words += fmt::format(", serial number {}", quoted_text(device.serial));
  if (device.has_node) words += fmt::format(", owner {}:{}, mode {:04o}", device.owner, device.group, device.mode);
  return words + (device.may_open ? ", this user may open it"
                                  : fmt::format(", this user may not open it: {}", open_error_words(device)));
}

std::string calibration_words(const Diagnosis& diagnosis) {
  if (diagnosis.report.serial.text().empty()) return "calibration: not known before the device is open";
  return diagnosis.has_calibration
             ? fmt::format("calibration: found for {}", diagnosis.report.serial.text())
             : fmt::format("calibration: none for {}; the default values are used", diagnosis.report.serial.text());
}

struct SpaceMouseWords {
  std::string_view state;  // in JSON
  std::string_view words;
};

// In the order of SpaceMouseReading::Trouble.
constexpr std::array<SpaceMouseWords, 4> spacemouse_words{{
    {"ready", "ready"},
    {"absent", "none is plugged in"},
    {"not_allowed", "this user may not open it; 'ghostforce doctor --install-udev' helps"},
    {"not_opened", "it cannot be opened; close the other program that has it"},
}};

const SpaceMouseWords& words_about(SpaceMouseReading::Trouble trouble) {
  return spacemouse_words[static_cast<std::size_t>(trouble)];
}

std::string words_about(const RendererState& renderer) {
  return fmt::format("pictures by {}: {}{}", renderer.name, renderer.words, renderer.is_default ? "; the default" : "");
}

std::string realtime_words(const RealtimeStatus& status) {
  return fmt::format(
      "real time: {}{}", describe(status),
      status.priority_error == 0
          ? ""
          : "; allow this user a priority of 40 ('rtprio 40' in /etc/security/limits.d) and log in again");
}

}  // namespace

std::string firmware_words(const std::optional<FirmwareImage>& image) {
  if (!image) return "firmware: no file; see docs/falcon.md for where to get one and where to put it";
  const std::string_view name = known_firmware(image->sha256);
  return fmt::format("firmware: {}, SHA-256 {}, {}", quoted_text(image->path.string(), longest_path), image->sha256,
                     name.empty() ? "not one of the published files" : fmt::format("known as {}", name));
}

std::string text_of(const Diagnosis& diagnosis) {
  std::string text;
  for (const ReadinessStepState& state : readiness_of(diagnosis.report, nullptr)) {
    text += state.words.empty() ? fmt::format("{} {}\n", mark_of(state), state.title)
                                : fmt::format("{} {:24}  {}\n", mark_of(state), state.title, state.words);
  }
  text += "\n";
  if (diagnosis.report.is_virtual) text += "device: a virtual Falcon, which is simulated\n";
  if (!diagnosis.usb.has_usb) text += "device: this system shows no USB devices to programs, as in many containers\n";
  for (const UsbDeviceFound& device : diagnosis.usb.devices) text += words_about(device) + "\n";
  text += diagnosis.udev_rule.empty()
              ? "udev rule: not installed; 'ghostforce doctor --install-udev' installs it\n"
              : fmt::format("udev rule: {}\n", quoted_text(diagnosis.udev_rule.string(), longest_path));
  text += firmware_words(diagnosis.firmware) + "\n";
  text += calibration_words(diagnosis) + "\n";
  text += fmt::format("SpaceMouse: {}\n", words_about(diagnosis.spacemouse.trouble).words);
  for (const SerialPortFound& port : diagnosis.serial_ports) {
    if (port.board.empty()) continue;
    text += fmt::format("Haply: {} at {} may be one; 'ghostforce doctor haply' examines it\n", port.board, port.path);
  }
  text += realtime_words(diagnosis.realtime) + "\n";
  for (const RendererState& renderer : diagnosis.renderers) text += words_about(renderer) + "\n";
  return text;
}

std::string json_of(const Diagnosis& diagnosis) {
  using Json = nlohmann::ordered_json;
  const FalconReport& report = diagnosis.report;
  Json readiness = Json::array();
  for (const ReadinessStepState& state : readiness_of(report, nullptr)) {
    readiness.push_back({{"rung", state.name},
                         {"title", entry_of(state.step).title},
                         {"reached", state.is_reached},
                         {"current", state.is_current},
                         {"words", state.words}});
  }
  Json firmware{{"file", nullptr}, {"sha256", nullptr}, {"known_as", nullptr}, {"is_running", report.has_firmware}};
  if (diagnosis.firmware) {
    firmware["file"] = quoted_text(diagnosis.firmware->path.string(), longest_path);
    firmware["sha256"] = diagnosis.firmware->sha256;
    if (const auto name = known_firmware(diagnosis.firmware->sha256); !name.empty()) firmware["known_as"] = name;
  }
  Json devices = Json::array();
  for (const UsbDeviceFound& device : diagnosis.usb.devices) {
    const auto of_node = [&](const auto& value) { return device.has_node ? Json(value) : Json(); };
    devices.push_back({{"bus", device.bus},
                       {"address", device.address},
                       {"node", device.node},
                       {"serial", quoted_text(device.serial)},
                       {"may_open", device.may_open},
                       {"open_error", open_error_words(device)},
                       {"owner", of_node(device.owner)},
                       {"group", of_node(device.group)},
                       {"mode", of_node(fmt::format("{:04o}", device.mode))}});
  }
  Json renderers = Json::array();
  for (const RendererState& renderer : diagnosis.renderers) {
    renderers.push_back({{"name", renderer.name},
                         {"is_there", renderer.is_there},
                         {"is_default", renderer.is_default},
                         {"words", renderer.words}});
  }
  const Json udev_rule =
      diagnosis.udev_rule.empty() ? Json() : Json(quoted_text(diagnosis.udev_rule.string(), longest_path));
  const Json all{
      {"ladder", readiness},
      {"state", name_of(report.state)},
      {"fault", entry_of(report.fault).name},
      {"serial", report.serial.text()},
      {"is_virtual", report.is_virtual},
      {"firmware", firmware},
      {"has_homed", report.has_homed},
      {"has_moved", report.has_moved},
      {"encoders", report.encoders},
      {"exchange_hz", attainable_exchange_hz(report)},
      {"exchange_s", report.exchange_s},
      {"worst_exchange_s", report.worst_exchange_s},
      {"exchanges", report.exchanges},
      {"lost_exchanges", report.lost_exchanges},
      {"discarded_bytes", report.discarded_bytes},
      {"line_errors", report.line_errors},
      {"has_calibration", diagnosis.has_calibration},
      {"has_usb", diagnosis.usb.has_usb},
      {"devices", devices},
      {"spacemouse", words_about(diagnosis.spacemouse.trouble).state},
      {"udev_rule", udev_rule},
      {"real_time",
       {{"priority", diagnosis.realtime.priority_error == 0},
        {"memory_locked", diagnosis.realtime.memory_lock_error == 0}}},
      {"renderers", renderers},
      {"exit_code", static_cast<int>(diagnosis.verdict)},
  };
  return all.dump() + "\n";
}

namespace {

// As the servo's: what is measured here is what the window will have.
constexpr std::int64_t tick_ns = 1'000'000;

// A device that was homed before tells it with its first replies [s].
constexpr double first_replies_s = 0.1;

// The driver measures over half a second; in a whole one there is one that had nothing else in it [s].
constexpr double measuring_s = 1.1;

bool has_ended(const FalconReport& report) noexcept {
  if (!report.has_looked) return false;
  return report.state == FalconState::absent || report.state == FalconState::fault;
}

}  // namespace

FalconReport examine(FalconInput& falcon, double wait_s, const std::function<void(const FalconReport&)>& watch) {
  // The driver itself gives up, after its attempts.
  constexpr double for_ever_s = 1e9;
  FalconReport report;
  // Until the device is lost, `is_enough` says so, or the time is over.
  const auto go_on = [&](double longest_s, const auto& is_enough) {
    if (has_ended(report)) return;
    const std::int64_t began_ns = falcon.now_ns();
    const auto elapsed_s = [&] { return static_cast<double>(falcon.now_ns() - began_ns) * 1e-9; };
    do {
      falcon.wait_until(falcon.now_ns() + tick_ns);
      falcon.read();
      falcon.set_force(Vector<2>(0.0), false);
      report = falcon.report();
      watch(report);
    } while (!has_ended(report) && !is_enough() && elapsed_s() < longest_s);
  };
  go_on(for_ever_s, [&] { return report.state == FalconState::homing || report.is_readable(); });
  go_on(std::max(wait_s, first_replies_s),
        [&] { return report.is_readable() && (report.encoders_move() || !(wait_s > 0.0)); });
  go_on(measuring_s, [] { return false; });
  falcon.shut_down();
  return report;
}

}  // namespace ghostforce
