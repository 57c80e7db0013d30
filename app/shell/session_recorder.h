// SessionRecorder: writes down what the person does, line by line as it comes: each is in the file before the Action is
// done, so that the last line of a program that has crashed is what made it crash. UI thread.
#pragma once

#include <string>

#include "app/files/descriptor.h"
#include "app/shell/session_file.h"

namespace ghostforce {

class SessionRecorder {
 public:
  // A new file. Throws Failure(file_trouble), also where there is one already.
  SessionRecorder(const std::string& path, const SessionStart& start);

  // What the person had chosen before: preferences, as Actions at the beginning.
  void write_choices(const Session& session);
  void write(double time_s, const Action& action) { append(action_line({time_s, action})); }
  // The last line.
  void end(double time_s) { append(end_line(time_s)); }

  // Why the file is not complete; empty: it is.
  std::string problem() const;

 private:
  // Never throws: what the person does goes on without the file.
  void append(const std::string& line) noexcept;

  std::string path_;
  Descriptor descriptor_;
  int error_ = 0;
};

}  // namespace ghostforce
