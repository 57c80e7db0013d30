// SessionReplay: a recorded session done again, in frames of one length, so that the same file always gives the same
// values. The hand of a device is not in the file, and nothing that lasts is done: no file is written, nothing is
// copied, the window stays, and only simulated motors push. UI thread.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/shell/application.h"
#include "app/shell/session_file.h"

namespace ghostforce {

class SessionReplay {
 public:
  static constexpr double frame_s = 1.0 / 60.0;

  struct Counts {
    std::size_t done = 0;
    std::size_t refused = 0;   // not allowed at that moment, as it was when they were recorded
    std::size_t left_out = 0;  // what a replay does not do
  };

  // What the application has to be made with, of a session with that start. `inputs`: simulated ones. Throws ReadError.
  static ApplicationOptions options_for(const SessionStart& start, std::vector<InputEntry> inputs);
  static Scene scene_of(const SessionStart& start, const std::string& shown_path);

  // Of an application that these options have made and that nobody has drawn. Both must outlive the replay.
  SessionReplay(Application& application, const RecordedSession& session);

  // The next frame, with what was done by then.
  void step();
  // Whether the session has come to its end. After that frames go on, and the person may do what they like.
  bool is_over() const;
  const Counts& counts() const noexcept { return counts_; }

  // One line: how many Actions, and what stands on the screen now.
  std::string result() const;

 private:
  void repeat(const Action& action);

  Application& application_;
  const RecordedSession& session_;
  std::size_t next_ = 0;  // of its actions
  bool is_told_that_it_is_over_ = false;
  Counts counts_;
};

}  // namespace ghostforce
