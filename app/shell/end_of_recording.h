// What is to be said when a recording has ended. Pure; any thread.
#pragma once

#include <string>

#include "app/state/session.h"

namespace ghostforce {

struct EndOfRecording {
  std::string words;
  bool is_problem = false;  // not all of it is in the file that was named
};

// `found_at`: where the file is now; empty: it was removed. `error`: why nothing more could be written, an errno; else 0.
EndOfRecording end_of_recording(const RecordingReading& recording, const std::string& found_at, int error);

}  // namespace ghostforce
