#include "app/shell/end_of_recording.h"

#include <fmt/format.h>

#include <cerrno>

#include "app/base/quoted.h"
#include "app/files/output_file.h"
#include "core/scene.h"

namespace ghostforce {

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

}  // namespace ghostforce
