#include "app/console/words.h"

#include <unistd.h>

#include <climits>
#include <cstdio>

#include "app/console/interruption.h"

namespace ghostforce {

void write_words(std::string_view words) noexcept {
  while (!words.empty() && wait_for_reader(STDERR_FILENO)) {
    // A pipe that can be written to takes this much at once.
    const std::string_view piece = words.substr(0, PIPE_BUF);
    std::fwrite(piece.data(), 1, piece.size(), stderr);
    words.remove_prefix(piece.size());
  }
}

}  // namespace ghostforce
