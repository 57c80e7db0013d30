// Page: the program in a browser's tab. Puts together what the address asks for, the window and the session in it, and
// gives each of the browser's frames to them. Main thread.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/picture/system_theme.h"
#include "app/shell/application.h"
#include "app/shell/frame_pacer.h"
#include "app/shell/preferences.h"
#include "app/shell/web/html_window.h"
#include "app/shell/web/page_controls.h"
#include "app/state/lesson_progress.h"

namespace ghostforce {

// How long something took in each of the last frames.
class FrameTimes {
 public:
  static constexpr std::size_t capacity = 300;

  void add(double seconds) {
    if (times_.size() < capacity) {
      times_.push_back(seconds);
    } else {
      times_[next_] = seconds;
      next_ = (next_ + 1) % capacity;
    }
  }

  // The time that this share of them did not exceed: 0.5 is the median [s]. 0 where there are none.
  double quantile(double share) const {
    if (times_.empty()) return 0.0;
    std::vector<double> sorted = times_;
    std::ranges::sort(sorted);
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
  }

 private:
  std::vector<double> times_;  // a ring, once it is full
  std::size_t next_ = 0;
};

class Page {
 public:
  // Throws Failure: the browser lacks what the page needs.
  Page();
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;

  // Once for each of the browser's.
  void frame();

  // Somebody has used one of the controls beside the canvas.
  void use_control(std::string_view id, double value) { controls_.use(application_, id, value); }

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
  void follow_system();
  void follow_colours();
  void follow_address();
  void write_address();
  void tell_embedder();
  void follow_size();
  void follow_fingers();
  void offer_way_back();
  void follow_keys();

  bool is_kiosk_;
  bool keeps_;  // what is chosen and done
  bool fits_;   // the picture to each size anew
  std::string embedder_;
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
  std::optional<SystemColours> forced_colours_;
  std::string line_;            // of the set-up, at the last look
  std::string address_;         // that stands in the address
  std::string lesson_{"null"};  // as the page around this one knows it
  WindowSize seen_size_;
  Face seen_face_ = Face::stage;
  int frames_without_graphics_ = 0;  // one after another
  PageControls controls_;
};

}  // namespace ghostforce
