// Page: the program in a browser's tab. Puts together what the address asks for, the window and the session in it, and
// gives each of the browser's frames to them. Main thread.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/shell/application.h"
#include "app/shell/frame_pacer.h"
#include "app/shell/preferences.h"
#include "app/shell/web/frame_times.h"
#include "app/shell/web/html_window.h"
#include "app/state/progress_keeper.h"

namespace ghostforce {

class Page {
 public:
  // Throws Failure: the browser lacks what the page needs.
  Page();
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;

  // Once for each of the browser's.
  void frame();

  Application& application() noexcept { return application_; }
  const HtmlWindow& window() const noexcept { return window_; }

  struct Times {
    FrameTimes script;     // of this thread in a frame
    FrameTimes servo;      // of that, in the servo's ticks
    double ready_s = 0.0;  // from the page's begin to its first picture
  };
  const Times& times() const noexcept { return times_; }
  std::uint64_t frames() const noexcept { return frames_; }  // that were drawn

 private:
  struct Start;  // what the address and the browser's storage ask for
  explicit Page(Start start);
  static ApplicationOptions options_for(const Start& start, Times& times);

  void keep();
  void follow_address();
  void write_address();
  void tell_listeners();

  bool is_kiosk_;
  Times times_;
  HtmlWindow window_;
  Application application_;
  std::optional<PreferenceKeeper> preference_keeper_;
  std::optional<ProgressKeeper> progress_keeper_;
  FramePacer pacer_{0.0};
  double last_s_ = 0.0;
  double drawn_s_ = 0.0;
  std::uint64_t frames_ = 0;
  double looked_at_s_ = 0.0;
  std::string line_;     // of the set-up, at the last look
  std::string address_;  // that stands in the address
  std::string spoken_;   // for screen readers
};

}  // namespace ghostforce
