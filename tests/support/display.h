// A display of its own for a test: Xvfb, whose picture is a file that can be read at any moment, and xdotool as the
// person's hands.
#pragma once

#include <sys/types.h>

#include <csignal>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/files/image.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce {

// A program that runs beside the test and is ended with it.
class BackgroundProgram {
 public:
  // `words[0]` is looked for in PATH. The write end of a pipe is handed on as descriptor 3 when `pipe` is 3 or more.
  BackgroundProgram(std::vector<std::string> words, std::vector<std::string> environment, int pipe = -1);
  ~BackgroundProgram();
  BackgroundProgram(const BackgroundProgram&) = delete;
  BackgroundProgram& operator=(const BackgroundProgram&) = delete;

  bool is_running();
  // While it runs.
  pid_t pid() const noexcept { return pid_; }
  // Sends the signal and waits for the end; the exit code, or 128 + N when signal N ended it.
  int end(int signal);

 private:
  pid_t pid_ = -1;
  int exit_code_ = -1;
};

class Display {
 public:
  // `dots_per_inch`: 96 is an ordinary screen, 192 a dense one, on which everything is to be twice as large.
  Display(int width, int height, int dots_per_inch = 96);

  // NAME=VALUE each, for programs that shall appear on it: the display, and folders of its own for what they remember.
  std::vector<std::string> environment() const {
    return {std::string("DISPLAY=") + name_, std::string("XDG_CONFIG_HOME=") + (folder_ / "config"),
            std::string("XDG_STATE_HOME=") + (folder_ / "state")};
  }
  std::string layout_file() const { return folder_ / "state/ghostforce/layout.toml"; }
  std::string preferences_file() const { return folder_ / "config/ghostforce/preferences.toml"; }
  // The server's own memory, in the format of xwd.
  std::string memory_file() const { return folder_ / "Xvfb_screen0"; }
  // What is on the screen now.
  Image picture() const;
  // As when the server crashes.
  void lose() const { server_->end(SIGKILL); }
  // xdotool with these words, to its end.
  void act(const std::vector<std::string>& words) const;
  // Looks at the screen until it is as wanted; false if that takes too long.
  bool becomes(const std::function<bool(const Image&)>& as_wanted) const;

 private:
  TemporaryFolder folder_;
  std::string name_{":"};  // and the number that the server found
  std::unique_ptr<BackgroundProgram> server_;
};

}  // namespace ghostforce
