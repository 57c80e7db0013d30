// The recording: to which file, how far it is, and what it has lost.
#include "app/workbench/recording.h"

#include <fmt/format.h>

#include "app/files/file_exchange.h"
#include "app/widgets/controls.h"
#include "app/widgets/save_path.h"
#include "app/workbench/panel_catalog.h"

namespace ghostforce {

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
  if (recording.path.empty()) return;
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(words_about(recording).c_str());
  tooltip(recording.path);
}

}  // namespace ghostforce
