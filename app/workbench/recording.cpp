// The recording: to which file, how far it is, and what it has lost; and how evenly the loop ticks that it is of.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "app/files/file_exchange.h"
#include "app/state/proposed_path.h"
#include "app/widgets/controls.h"
#include "app/workbench/panel_catalog.h"
#include "app/workbench/plot_pieces.h"

namespace ghostforce {
namespace {

constexpr float chart_height = 6.0F;  // [heights of a letter]

// High is what is counted, on a logarithmic scale that begins at none.
double bar_height(double count) {
  return std::log10(1.0 + count);
}

// Where that period is among the bins, whose middles are whole numbers.
double bin_at(double period_s) {
  return 2.0 * std::log2(period_s / LoopPeriods::begin_of(0)) - 0.5;
}

void draw_periods(const PanelContext& context) {
  const LoopPeriods& periods = context.loop.periods;
  if (periods.ticks() == 0) return;
  wrapped_text(fmt::format("{:.1f} ticks a second, {:.2f} % late, {:.1f} ms apart at most", periods.mean_hz(),
                           100.0 * periods.late_share(), 1e3 * periods.worst_s()));
  tooltip(
      "Since this input was chosen, while time went on at full speed. Late: by a period or more. Below: how many ticks "
      "came how long after the one before; both scales are logarithmic.");
  const ImVec2 size{ImGui::GetContentRegionAvail().x, chart_height * ImGui::GetFontSize()};
  if (!ImPlot::BeginPlot("##periods", size, quiet_plot)) return;
  std::vector<double> heights;
  for (std::size_t bin = 0; bin < LoopPeriods::bin_count; ++bin) {
    heights.push_back(bar_height(static_cast<double>(periods.count(bin))));
  }
  const std::array named_s{bin_at(1e-4), bin_at(1e-3), bin_at(1e-2), bin_at(1e-1)};
  const std::array<std::string, 4> period_words{"0.1 ms", "1 ms", "10 ms", "100 ms"};
  const std::array named_counts{bar_height(1.0), bar_height(1e3), bar_height(1e6)};
  const std::array<std::string, 3> count_words{"1", "10³", "10⁶"};
  constexpr ImPlotAxisFlags still = ImPlotAxisFlags_Lock | ImPlotAxisFlags_NoHighlight;
  ImPlot::SetupAxes(nullptr, nullptr, still, still);
  ImPlot::SetupAxesLimits(-0.5, LoopPeriods::bin_count - 0.5, 0.0, bar_height(1e7), ImPlotCond_Always);
  set_up_ticks(ImAxis_X1, named_s, period_words);
  set_up_ticks(ImAxis_Y1, named_counts, count_words);
  ImPlotSpec bars;
  bars.FillColor = unpacked(context.theme.accent);
  ImPlot::PlotBars("ticks", heights.data(), static_cast<int>(heights.size()), 0.8, 0.0, bars);
  ImPlot::EndPlot();
}

}  // namespace

void toggle_recording(const PanelContext& context) {
  const Session& session = context.session;
  if (context.loop.recording.is_on) {
    context.apply(StopRecording{});
  } else {
    context.apply(StartRecording{session.recording_path.empty() ? proposed_path(file_stem(session.scene->title), "csv")
                                                                : session.recording_path});
    context.memory.recording_path.clear();  // the next one is another file
  }
}

std::string words_about(const RecordingReading& recording) {
  std::string words =
      fmt::format("{:.1f} s, {:.1f} MB", recording.seconds, 1e-6 * static_cast<double>(recording.bytes));
  if (recording.dropped > 0) words += fmt::format(", {} samples lost", recording.dropped);
  return words;
}

void draw_recording(const PanelContext& context) {
  const RecordingReading& recording = context.loop.recording;
  if (begin_rows("recording", context)) {
    row("File", save_place().about_recording);
    ImGui::BeginDisabled(recording.is_on);
    std::string shown = recording.is_on ? recording.path : context.session.recording_path;
    const bool entered = text_field("##recording", "a new name", shown);
    if (!recording.is_on) context.memory.recording_path = shown;
    ImGui::EndDisabled();
    if (entered) toggle_recording(context);
    end_rows();
  }
  if (ImGui::Button(recording.is_on ? "Stop###record" : "Start###record")) toggle_recording(context);
  tooltip("Writes every tick of the three strategies to a file.");
  if (!recording.path.empty()) {
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(words_about(recording).c_str());
    tooltip(recording.path);
  }
  draw_periods(context);
}

}  // namespace ghostforce
