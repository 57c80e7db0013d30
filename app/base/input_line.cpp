#include "app/base/input_line.h"

#include <unistd.h>

#include <cerrno>

#include "app/base/interruption.h"

namespace ghostforce {

InputLine read_line(int descriptor) {
  InputLine line;
  while (line.text.size() <= longest_input_line) {
    wait_to_read(descriptor);
    char letter = 0;
    const ssize_t count = read(descriptor, &letter, 1);
    stop_if_interrupted();
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (count <= 0) break;
    if (letter == '\n') {
      line.is_whole = true;
      break;
    }
    line.text += letter;
  }
  return line;
}

}  // namespace ghostforce
