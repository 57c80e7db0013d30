// When a window draws again, told every time by hand.
#include "app/shell/frame_pacer.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace ghostforce::frame_pacer_test {
namespace {

// A window whose pacer is asked as `run` asks it. Moments of things that happen are in order.
class PacedWindow {
 public:
  struct Lived {
    int looks = 0;
    int frames = 0;
  };

  // Until `end_s`. `moves`: there is something to draw at every look; `idle`: nothing goes on by itself.
  Lived live_until(double end_s, bool moves, bool idle, std::vector<double> stirs = {}) {
    Lived lived;
    auto stir = stirs.begin();
    while (now_s_ < end_s) {
      const double began_s = now_s_;
      ++lived.looks;
      if (moves || pacer_.is_due(drawn_s_, now_s_)) {
        now_s_ += 0.001;
        drawn_s_ = began_s;
        ++lived.frames;
      }
      const double wait_s = pacer_.wait_s(idle, began_s, now_s_);
      EXPECT_GE(wait_s, 0.0);
      EXPECT_LE(wait_s, FramePacer::rest_look_s);
      const bool stirred = stir != stirs.end() && *stir < now_s_ + wait_s;
      now_s_ = stirred ? std::max(now_s_, *stir++) : now_s_ + wait_s;
      pacer_.waited(stirred, now_s_);
      EXPECT_TRUE(!stirred || pacer_.is_due(drawn_s_, now_s_)) << "at " << now_s_;
    }
    return lived;
  }

 private:
  double now_s_ = 0.0;
  double drawn_s_ = 0.0;
  FramePacer pacer_{0.0};
};

TEST(FramePacer, DrawsSixtyTimesASecondWhileSomethingMoves) {
  EXPECT_NEAR(PacedWindow().live_until(10.0, true, false).frames, 600, 2);
}

TEST(FramePacer, DrawsNothingAtRestAndLooksAsOftenAsTheServoGoesOn) {
  PacedWindow window;
  window.live_until(10.0, false, false);
  const PacedWindow::Lived running = window.live_until(60.0, false, false);
  EXPECT_EQ(running.frames, 0);
  EXPECT_NEAR(running.looks, 50 * 60, 2);
  const PacedWindow::Lived paused = window.live_until(110.0, false, true);
  EXPECT_EQ(paused.frames, 0);
  EXPECT_NEAR(paused.looks, 50 * 10, 2);
}

TEST(FramePacer, DrawsAFewFramesAtOnceForEachThingThatHappens) {
  for (const bool idle : {true, false}) {
    PacedWindow window;
    window.live_until(9.0, false, idle);
    // Whenever in a wait it comes, at its very end too.
    for (const double later_s : {0.0, 0.01, 0.05, 0.0999, 0.09999999}) {
      PacedWindow copy = window;
      const double stir_s = 9.5 + later_s;
      copy.live_until(stir_s + 0.001, false, idle, {stir_s});
      const int at_once = copy.live_until(stir_s + 0.2, false, idle).frames;
      EXPECT_GE(at_once, FramePacer::settling_frames - 1) << later_s;
      EXPECT_LE(at_once, FramePacer::settling_frames + 2) << later_s;
      // What waits for a pointer to rest must come; then the window sleeps again.
      EXPECT_GT(copy.live_until(stir_s + 1.5, false, idle).frames, 5);
      copy.live_until(stir_s + 1.7, false, idle);
      EXPECT_EQ(copy.live_until(stir_s + 30.0, false, idle).frames, 0);
    }
  }
}

TEST(FramePacer, TakesNoTimeBackFromAFrameThatTookLong) {
  const FramePacer pacer(0.0);
  EXPECT_EQ(pacer.wait_s(false, 1.0, 1.5), 0.0);
  EXPECT_DOUBLE_EQ(pacer.wait_s(false, 1.0, 1.0), FramePacer::frame_s);
}

}  // namespace
}  // namespace ghostforce::frame_pacer_test
