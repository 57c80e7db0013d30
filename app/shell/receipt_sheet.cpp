#include "app/shell/receipt_writing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "app/picture/chart.h"
#include "app/picture/text.h"
#include "app/picture/theme.h"

namespace ghostforce {
namespace {

// [points]
constexpr double margin = 44.0;
constexpr double name_width = 112.0;
constexpr double line_step = 1.2;  // in heights of letters
constexpr double row_gap = 3.0;
constexpr double chart_height = 180.0;
constexpr TextStyle title_style{22.0, true};
constexpr TextStyle name_style{10.5, true};
constexpr TextStyle body{10.5};
constexpr std::size_t most_lines = 5;  // of a row
// More letters than these lines hold. To break many more into lines would take seconds.
constexpr std::size_t most_letters = 1000;

struct Row {
  std::string_view name;
  std::string words;
};

// Whole words.
std::string_view first_words(std::string_view words) {
  return words.size() <= most_letters ? words : words.substr(0, words.rfind(' ', most_letters));
}

std::string words_about(const std::vector<SessionLog::Event>& events) {
  std::string words;
  for (const SessionLog::Event& event : events) {
    words += fmt::format("{}{} at {:.3f} s", words.empty() ? "" : ", ", event.name, event.time_s);
  }
  return words.empty() ? "none" : words;
}

std::string words_about(const DeviceFacts& device) {
  return fmt::format("{} {}{}. {} exchanges, {} lost, {} bytes discarded, {} errors on the line.", device.name,
                     device.serial, device.is_simulated ? ", simulated" : "", device.exchanges, device.lost_exchanges,
                     device.discarded_bytes, device.line_errors);
}

// One line: without its comments.
std::string words_about_calibration(const DeviceFacts& device) {
  std::string words = device.has_own_calibration ? "its own:" : "the default:";
  std::string_view text = device.calibration;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (!line.starts_with('#')) words += fmt::format("  {};", line);
  }
  return words;
}

std::string words_about_hand(const Receipt& receipt) {
  const std::optional<SessionLog::Hand>& hand = receipt.log.hand();
  const std::string measured = hand
                                   ? fmt::format("{:.0f} ± {} N/m at {:.1f} s (one standard deviation)",
                                                 hand->estimate.k_u, deviation_text(hand->estimate.sigma), hand->time_s)
                                   : std::string("not measured");
  return fmt::format("{}; believed at the end: {:.0f} N/m", measured, receipt.believed_k_u);
}

std::string words_about_rate(const Receipt& receipt) {
  const LoopPeriods& periods = receipt.periods;
  const std::string asked = fmt::format("{:g} Hz asked for", receipt.rate_hz);
  if (periods.ticks() == 0) return asked + "; not measured";
  return fmt::format("{}; {:.2f} Hz on average over {} ticks, {} of them late ({:.3f} %), {:.2f} ms apart at most{}{}",
                     asked, periods.mean_hz(), periods.ticks(), periods.late_ticks(), 100.0 * periods.late_share(),
                     1e3 * periods.worst_s(), receipt.real_time.empty() ? "" : "; ", receipt.real_time);
}

std::string words_about_heat(const MotorHeats& heat) {
  return fmt::format(
      "at most {:.0f} %, {:.0f} % and {:.0f} %, estimated from what the motors were told to give; no temperature was "
      "measured. 100 %: what {:.0f} % of full power comes to in the end, with a time constant of {:.0f} s; both are "
      "assumed.",
      100.0 * heat[0], 100.0 * heat[1], 100.0 * heat[2], 100.0 * motor_continuous_share, motor_heat_time_constant_s);
}

std::vector<Row> rows_of(const Receipt& receipt) {
  const ReceiptOrigin& origin = receipt.origin;
  std::vector<Row> rows{
      {"Recording",
       fmt::format("{}, {:.3f} s of model time, {} samples lost", receipt.recording, receipt.seconds, receipt.dropped)},
      {"Program", fmt::format("ghostforce {}{}{}; {}", origin.version, origin.commit.empty() ? "" : ", commit ",
                              origin.commit, origin.build)},
      {"Libraries", origin.libraries},
      {"Input", receipt.input},
  };
  if (receipt.device) {
    rows.push_back({"Device", words_about(*receipt.device)});
    rows.push_back({"Firmware", origin.firmware.empty() ? "no file" : origin.firmware});
    rows.push_back({"Calibration", words_about_calibration(*receipt.device)});
    rows.push_back(
        {"Limits",
         fmt::format("{:g} N; k_r up to {:g} N/m; {}", receipt.safety.force_limit, receipt.safety.greatest_k_r,
                     receipt.safety.needs_button ? "only while a button is held" : "no button has to be held")});
  }
  rows.push_back({"Hand", words_about_hand(receipt)});
  rows.push_back({"Loop", words_about_rate(receipt)});
  rows.push_back({"Set-up at the end", receipt.set_up});
  if (receipt.device) {
    rows.push_back({"Heat", words_about_heat(receipt.log.greatest_heat())});
    rows.push_back({"Motors off", words_about(receipt.log.motors_off())});
    rows.push_back({"Device faults", words_about(receipt.log.device_faults())});
  }
  return rows;
}

Chart periods_chart(const LoopPeriods& periods) {
  constexpr double floor = 0.5;  // below one tick
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Series bars{.name = "", .colour = paper().accent, .points = {}};
  for (std::size_t bin = 0; bin < LoopPeriods::bin_count; ++bin) {
    const auto ticks = static_cast<double>(periods.count(bin));
    const double from_ms = 1e3 * LoopPeriods::begin_of(bin);
    const double to_ms = 1e3 * LoopPeriods::begin_of(bin + 1);
    if (ticks == 0.0) continue;
    for (const Vector<2>& corner : {Vector<2>(from_ms, floor), Vector<2>(from_ms, ticks), Vector<2>(to_ms, ticks),
                                    Vector<2>(to_ms, floor), Vector<2>(nan)}) {
      bars.points.push_back(corner);
    }
  }
  return {.title = "How far apart the ticks of the loop were",
          .x = {.title = "period [ms]",
                .is_logarithmic = true,
                .range = 1e3 * Vector<2>(LoopPeriods::begin_of(0), LoopPeriods::begin_of(LoopPeriods::bin_count))},
          .y = {.title = "ticks",
                .is_logarithmic = true,
                .range = Vector<2>(floor, 2.0 * static_cast<double>(periods.ticks()))},
          .series = {std::move(bars)}};
}

}  // namespace

std::vector<Pane> receipt_sheet(const Receipt& receipt, const MeasureText& measure) {
  const Vector<2>& size = receipt_sheet_size;
  std::vector<Pane> panes;
  panes.push_back({Vector<2>(0.0), Camera{0.5 * size, 1.0, size}, StrategyId::full, {}});
  Pane& page = panes.front();
  const auto put = [&](double left, double top, std::string words, const TextStyle& style) {
    page.marks.push_back({Role::sentence,
                          {},
                          Label{to_world(page.camera, {left, top}), Vector<2>(0.0), std::move(words), style,
                                paper().text, Colour{0, 0, 0, 0}}});
  };
  const double step = line_step * body.height;
  const double end = size.y - margin - (receipt.periods.ticks() > 0 ? chart_height + row_gap : 0.0);
  const double left = margin + name_width;
  put(margin, margin, "Receipt of a session", title_style);
  double top = margin + 1.6 * title_style.height;
  for (const Row& row : rows_of(receipt)) {
    std::vector<std::string> lines = broken_into_lines(first_words(row.words), size.x - margin - left, body, measure);
    const auto room = static_cast<std::size_t>(std::max(0.0, std::floor((end - top) / step)));
    if (const std::size_t most = std::min(room, most_lines); lines.size() > most) {
      if (most == 0) break;
      lines.resize(most);
      lines.back() = "… the rest is in the JSON file";
    }
    put(margin, top, std::string(row.name), name_style);
    for (const std::string& line : lines) {
      put(left, top, line, body);
      top += step;
    }
    top += row_gap;
  }
  if (receipt.periods.ticks() > 0) {
    panes.push_back(chart_pane(periods_chart(receipt.periods), {margin, size.y - margin - chart_height},
                               {size.x - 2.0 * margin, chart_height}, paper(), 1.0, measure));
  }
  return panes;
}

}  // namespace ghostforce
