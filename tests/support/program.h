// Runs a program as a person or a script would, and catches all that comes out.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/places.h"

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
  bool takes_orders = false;             // a RunningProgram's standard input is what order() says; else there is none
};

// Starts `program` with signals as a terminal would have them, and waits for its end.
Outcome run_program(const std::string& program, const ProgramCall& call);

inline Outcome run_program(const std::string& program, std::vector<std::string> words) {
  ProgramCall call;
  call.words = std::move(words);
  return run_program(program, call);
}

// The program under test.
inline Outcome run_ghostforce(std::vector<std::string> words) {
  return run_program(ghostforce_program(), std::move(words));
}
inline Outcome run_ghostforce(const ProgramCall& call) {
  return run_program(ghostforce_program(), call);
}

// A program that runs while the test does something else: it is listened to line by line, and gets signals. What it
// says on the standard error goes to the test's. Killed if it still runs in the end.
class RunningProgram {
 public:
  RunningProgram(const std::string& program, const ProgramCall& call);
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;
  ~RunningProgram();

  // The next line of the standard output; none: there is no more, or none within so long. A machine that is busy with
  // other things may let an armed program get no farther for a minute and more.
  std::optional<std::string> next_line(std::chrono::milliseconds patience = std::chrono::minutes(4));
  void send(int signal) const;
  // A line of the standard input. After its end: nothing.
  void order(const std::string& line) const;
  bool has_ended();
  // While it has not been waited for.
  pid_t pid() const noexcept { return child_; }
  // As Outcome has it.
  int wait_for_end();

 private:
  pid_t child_ = -1;  // -1: has ended
  int in_ = -1;
  int out_ = -1;
  std::string heard_;  // and not taken yet
  int exit_code_ = -1;
};

}  // namespace ghostforce
