#include "app/tools/doctor/haply_diagnosis.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/base/quoted.h"
#include "app/tools/doctor/readiness.h"

namespace ghostforce {
namespace {

constexpr std::string_view support_words = "written from the published firmware; not tried on a device";

std::string haply_port_words(const SerialPortFound& port) {
  std::string words = fmt::format("port: {}, {:04x}:{:04x}", port.path, port.vendor, port.product);
  if (!port.board.empty()) words += fmt::format(", {}", port.board);
  if (!port.product_name.empty()) words += fmt::format(", {}", quoted_text(port.product_name));
  if (port.has_node) words += fmt::format(", owner {}:{}, mode {:04o}", port.owner, port.group, port.mode);
  return words + (port.may_open ? ", this user may open it" : ", this user may not open it");
}

}  // namespace

std::string text_of(const HaplyDiagnosis& diagnosis) {
  std::string text;
  for (const ReadinessStepState& state : readiness_of(diagnosis.report, nullptr)) {
    const std::string_view mark = state.is_reached ? "✓" : state.is_current ? "✗" : "–";
    text += state.words.empty() ? fmt::format("{} {}\n", mark, state.title)
                                : fmt::format("{} {:24}  {}\n", mark, state.title, state.words);
  }
  text += "\n";
  if (diagnosis.report.is_virtual) text += "device: a virtual Haply, which is simulated\n";
  text += fmt::format("support: {}\n", support_words);
  if (diagnosis.ports.empty()) text += "port: this system has no serial port over USB\n";
  for (const SerialPortFound& port : diagnosis.ports) {
    text += haply_port_words(port) + "\n";
    if (port.board == m0_board)
      text += "counts: this board may count half of its variant's; 'ghostforce doctor haply --measure' finds out\n";
  }
  text += fmt::format("variant: {}\n", diagnosis.report.variant);
  text += !diagnosis.calibrated_board ? "calibration: none for this board; the values of the variant are used\n"
          : *diagnosis.calibrated_board == DeviceSerial() ? "calibration: found for any board\n"
                                                          : "calibration: found for this board\n";
  text += diagnosis.udev_rule.empty()
              ? "udev rule: not installed; 'ghostforce doctor --install-udev' installs it\n"
              : fmt::format("udev rule: {}\n", quoted_text(diagnosis.udev_rule.string(), longest_path));
  return text + fmt::format("real time: {}\n", describe(diagnosis.realtime));
}

std::string json_of(const HaplyDiagnosis& diagnosis) {
  using Json = nlohmann::ordered_json;
  const HaplyReport& report = diagnosis.report;
  Json readiness = Json::array();
  for (const ReadinessStepState& state : readiness_of(report, nullptr)) {
    readiness.push_back({{"rung", state.name},
                         {"title", state.title},
                         {"reached", state.is_reached},
                         {"current", state.is_current},
                         {"words", state.words}});
  }
  Json ports = Json::array();
  for (const SerialPortFound& port : diagnosis.ports) {
    ports.push_back({{"path", port.path},
                     {"by_id", port.by_id},
                     {"usb_id", fmt::format("{:04x}:{:04x}", port.vendor, port.product)},
                     {"serial", quoted_text(port.serial)},
                     {"product", quoted_text(port.product_name)},
                     {"board", port.board},
                     {"may_open", port.may_open}});
  }
  const Json all{
      {"ladder", readiness},
      {"state", name_of(report.state)},
      {"fault", entry_of(report.fault).name},
      {"serial", report.serial.text()},
      {"is_virtual", report.is_virtual},
      {"support", support_words},
      {"variant", report.variant},
      {"was_set_up", report.was_set_up},
      {"exchange_hz", report.exchange_hz},
      {"exchange_s", report.exchange_s},
      {"worst_exchange_s", report.worst_exchange_s},
      {"exchanges", report.exchanges},
      {"lost_exchanges", report.lost_exchanges},
      {"discarded_bytes", report.discarded_bytes},
      {"has_calibration", diagnosis.calibrated_board.has_value()},
      {"ports", ports},
      {"udev_rule",
       diagnosis.udev_rule.empty() ? Json() : Json(quoted_text(diagnosis.udev_rule.string(), longest_path))},
      {"real_time",
       {{"priority", diagnosis.realtime.priority_error == 0},
        {"memory_locked", diagnosis.realtime.memory_lock_error == 0}}},
      {"exit_code", static_cast<int>(diagnosis.verdict)},
  };
  return all.dump() + "\n";
}

namespace {

// As the servo's: what is measured here is what the window will have.
constexpr std::int64_t haply_tick_ns = 1'000'000;

// The driver measures over half a second; in a whole one there is one that had nothing else in it [s].
constexpr double haply_measuring_s = 1.1;

}  // namespace

HaplyReport examine(HaplyInput& haply, const std::function<void(const HaplyReport&)>& watch) {
  HaplyReport report;
  const auto has_ended = [&] {
    return report.has_looked && (report.state == HaplyState::absent || report.state == HaplyState::fault);
  };
  const auto answers = [&] { return report.state == HaplyState::zero_pose || report.is_readable(); };
  std::int64_t answered_ns = 0;
  do {
    haply.wait_until(haply.now_ns() + haply_tick_ns);
    haply.read();
    haply.set_force(Vector<2>(0.0), false);
    report = haply.report();
    watch(report);
    if (answers() && answered_ns == 0) answered_ns = haply.now_ns();
  } while (!has_ended() &&
           (answered_ns == 0 || static_cast<double>(haply.now_ns() - answered_ns) * 1e-9 < haply_measuring_s));
  haply.shut_down();
  return report;
}

}  // namespace ghostforce
