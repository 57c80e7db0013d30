// The standard output, a line at a time. Who reads no further (head, less) still gets the exit code. Any one thread.
#pragma once

#include <string>

#include "app/files/output_file.h"

namespace ghostforce {

class Lines {
 public:
  void write(const std::string& line) {
    if (!is_read_) return;
    try {
      output_.write(line + "\n");
      output_.commit();
    } catch (const BrokenPipe&) {
      is_read_ = false;
    }
  }
  bool is_terminal() const noexcept { return output_.is_terminal(); }

 private:
  OutputFile output_{"-"};
  bool is_read_ = true;
};

}  // namespace ghostforce
