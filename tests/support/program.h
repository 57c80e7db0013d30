// Runs a program as a person or a script would, and catches all that comes out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ghostforce {

struct Outcome {
  int exit_code = -1;  // 128 + N when signal N ended it
  std::string out;
  std::string err;
};

struct ProgramCall {
  std::vector<std::string> words;        // after the program's name
  std::vector<std::string> environment;  // NAME=VALUE, on top of this process's
  std::string folder;                    // working directory; empty: this one
  std::string out_to;                    // standard output goes to this path; empty: it is caught
  std::string signal_when_created_in;    // a folder: as soon as anything is created there, send `signal`
  int signal = 0;
  bool close_after_first_piece = false;  // read a little of the standard output, then close it
};

// Starts `program` with signals as a terminal would have them, and waits for
// its end.
Outcome run_program(const std::string& program, const ProgramCall& call);

inline Outcome run_program(const std::string& program, std::vector<std::string> words) {
  ProgramCall call;
  call.words = std::move(words);
  return run_program(program, call);
}

}  // namespace ghostforce
