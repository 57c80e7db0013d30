// Other programs that do a part of the work, such as a clipboard's tool or ffmpeg: found on PATH and started without a
// shell, as they would be started by hand. Any thread.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace ghostforce {

// The tool's standard streams, as open files of ours.
struct ToolStreams {
  int in = -1;
  int out = -1;  // negative: what is written there is lost
  int err = -1;  // negative: what is written there is lost
};

// `words`: its name and its arguments. Returns 0, or the number of an error: ENOENT where there is no such tool. It
// gets every signal, and no other file of ours: a device that is open would stay taken.
int start_tool(const std::vector<std::string>& words, const ToolStreams& streams, pid_t& child);

}  // namespace ghostforce
