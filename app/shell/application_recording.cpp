// Recordings of what the servo does: begun, read while they grow, ended.
#include <memory>
#include <utility>

#include "app/files/file_exchange.h"
#include "app/files/scene_file.h"
#include "app/shell/application.h"
#include "app/shell/end_of_recording.h"

namespace ghostforce {

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
