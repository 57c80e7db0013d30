// Recordings of what the servo does: begun, read while they grow, ended.
#include <cerrno>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/base/quoted.h"
#include "app/files/file_exchange.h"
#include "app/files/scene_file.h"
#include "app/shell/application.h"
#include "app/shell/receipt_writing.h"
#include "app/state/scene_view.h"
#include "app/state/session.h"
#include "app/state/set_up.h"
#include "app/state/set_up_of.h"
#include "core/scene.h"
#include "device/servo/realtime_status.h"

namespace ghostforce {
namespace {

// What is to be said when a recording has ended.
struct EndOfRecording {
  std::string words;
  bool is_problem = false;  // not all of it is in the file that was named
};

// `found_at`: where the file is now; empty: it was removed. `error`: why no more could be written, an errno; else 0.
EndOfRecording end_of_recording(const RecordingReading& recording, const std::string& found_at, int error) {
  const std::string shown = quoted_text(found_at.empty() ? recording.path : found_at, longest_path);
  if (found_at.empty()) {
    return {fmt::format("{:.1f} s of recording are lost: {} was removed while it was being written. Record again, to "
                        "another folder.",
                        recording.seconds, shown),
            true};
  }
  if (error == EOVERFLOW) {
    return {fmt::format("The recording ended after {:.1f} s: {} has reached the maximum length of a run, {:.0f} ticks. "
                        "It is complete. Record to another file to go on.",
                        recording.seconds, shown, most_ticks),
            true};
  }
  if (error != 0) {
    return {
        fmt::format("The recording ended after {:.1f} s: {} cannot be written any further: {}. What it contains can "
                    "still be read.",
                    recording.seconds, shown, reason_of(error)),
        true};
  }
  const std::string lost =
      recording.dropped > 0 ? fmt::format("; {} samples were lost", recording.dropped) : std::string();
  const std::string words = fmt::format("Recorded {:.1f} s to {}{}", recording.seconds, shown, lost);
  if (found_at == recording.path) return {words};
  return {fmt::format("{}. It was moved there while it was being written, so it is no longer {}.", words,
                      quoted_text(recording.path, longest_path)),
          true};
}

}  // namespace

void Application::start_recording(const std::string& path) {
  end_recording();
  Scene scene = *session_.scene;
  scene.settings = command_.settings;
  recording_ = std::make_unique<Recording>(path, rounded_to_file(std::move(scene)), *servo_, ++recordings_);
  recording_problem_.clear();
  command_.recording = recordings_;
  servo_->send(command_);
  read_recording();
}

void Application::keep_receipt_of(const std::string& recording) const {
  const ShownMoment present{settings_now(session_), report_.snapshot};
  const Receipt receipt{.origin = *receipt_origin_,
                        .recording = quoted_text(std::filesystem::path(recording).filename().string(), longest_path),
                        .seconds = recording_reading_.seconds,
                        .dropped = recording_reading_.dropped,
                        .input = session_.input,
                        .device = link_->device(),
                        .set_up = set_up_line(set_up_of(session_, present)),
                        .scene = scene_text(scene_as_seen(session_)),
                        .safety = session_.safety,
                        .rate_hz = session_.settings.rate,
                        .believed_k_u = believed_user_stiffness(session_.settings.stiffnesses),
                        .periods = report_.loop.periods,
                        .real_time = report_.loop.periods.ticks() > 0 ? describe(report_.realtime) : "",
                        .log = log_};
  write_receipt(receipt, painter_, recording);
}

std::string Application::end_recording() {
  if (!recording_) return {};
  command_.recording = 0;
  servo_->send(command_);
  recording_->end();
  read_recording();
  const int error = recording_->progress().error;
  const std::string found_at = recording_->found_at();
  recording_.reset();
  if (!found_at.empty()) hand_out(found_at);
  recording_reading_.is_on = false;
  EndOfRecording end = end_of_recording(recording_reading_, found_at, error);
  // A program that is interrupted writes nothing more.
  if (receipt_origin_ && !found_at.empty() && !interrupted()) {
    if (!end.words.ends_with('.')) end.words += '.';
    try {
      keep_receipt_of(found_at);
      end.words += " Its receipt is beside it.";
    } catch (const Failure& failure) {
      if (failure.code() != ExitCode::interrupted)
        end.words += fmt::format(" Its receipt could not be written: {}", failure.what());
      end.is_problem = true;
    }
  }
  if (end.is_problem) recording_problem_ = end.words;
  return std::move(end.words);
}

void Application::read_recording() {
  const RecordingProgress progress = recording_->progress();
  recording_reading_ = {.is_on = true,
                        .path = recording_->path(),
                        .seconds = progress.seconds,
                        .bytes = progress.bytes,
                        .dropped = progress.dropped};
}

}  // namespace ghostforce
