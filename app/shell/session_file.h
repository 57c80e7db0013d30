// A session as a file: how it began, and what the person did then, a line for each Action with its time; and the
// recorder that writes it. For bug reports, tutorials and what a monkey did. docs/sessions.md describes the format. Not
// for the servo thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/files/descriptor.h"
#include "app/files/read_error.h"
#include "app/state/action.h"

namespace ghostforce {

struct SessionStart {
  static constexpr int newest_format = 1;

  int format = newest_format;
  std::string program{};  // which build of it
  std::string input{mouse_hand.name};
  Face face = Face::stage;
  StageMode mode = StageMode::none;
  std::string lesson{};  // a name or a path; empty: none
  std::string language{"en"};
  int width = 1280;  // of the window [points]
  int height = 800;
  std::string scene{};  // as the text of a file
};

struct TimedAction {
  double time_s = 0.0;  // real time since the session began
  Action action;
};

struct RecordedSession {
  SessionStart start;
  std::vector<TimedAction> actions;  // in their order
  double end_s = 0.0;                // real time likewise; where the file does not tell it, that of the last action
};

// Lines of the file, each with its end.
std::string start_line(const SessionStart& start);
std::string action_line(const TimedAction& timed);
std::string end_line(double time_s);
std::string session_text(const RecordedSession& session);

// Throws ReadError(wrong), one line per problem:
//     FILE:LINE:COLUMN: what is wrong; what to do
RecordedSession read_session(std::string_view text, std::string_view shown_path);
// Throws ReadError; Failure(interrupted).
RecordedSession load_session(const std::string& path);

// Writes down what the person does, line by line as it comes: each is in the file before the Action is done, so that
// the last line of a program that has crashed is what made it crash. UI thread.
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
