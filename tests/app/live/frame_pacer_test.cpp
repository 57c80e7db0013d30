// When a window draws again, told every time by hand.
#include "app/live/frame_pacer.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace ghostforce {
namespace {

// A window whose pacer is asked as `run` asks it. Moments of things that happen are in order.
class PacedWindow {
 public:
  // Until `end_s`; returns how many frames were drawn.
  int live_until(double end_s, bool idle, std::vector<double> stirs = {}) {
    int frames = 0;
    auto stir = stirs.begin();
    while (now_s_ < end_s) {
      const double began_s = now_s_;
      if (!idle || !pacer_.may_sleep(drawn_s_, now_s_)) {
        now_s_ += 0.001;
        drawn_s_ = began_s;
        ++frames;
      }
      const double wait_s = pacer_.wait_s(idle, began_s, now_s_);
      EXPECT_GE(wait_s, 0.0);
      EXPECT_LE(wait_s, FramePacer::look_s);
      const bool stirred = stir != stirs.end() && *stir < now_s_ + wait_s;
      now_s_ = stirred ? std::max(now_s_, *stir++) : now_s_ + wait_s;
      pacer_.waited(stirred, idle, now_s_);
      EXPECT_FALSE(stirred && idle && pacer_.may_sleep(drawn_s_, now_s_)) << "at " << now_s_;
    }
    return frames;
  }

 private:
  double now_s_ = 0.0;
  double drawn_s_ = 0.0;
  FramePacer pacer_{0.0};
};

TEST(FramePacer, DrawsSixtyTimesASecondWhileSomethingMoves) {
  EXPECT_NEAR(PacedWindow().live_until(10.0, false), 600, 2);
}

TEST(FramePacer, DrawsEveryFiveSecondsWhileNothingDoes) {
  PacedWindow window;
  window.live_until(10.0, true);
  EXPECT_NEAR(window.live_until(60.0, true), 10, 1);
}

TEST(FramePacer, DrawsAFewFramesAtOnceForEachThingThatHappens) {
  PacedWindow window;
  window.live_until(9.0, true);
  // Whenever in a wait it comes, at its very end too.
  for (const double later_s : {0.0, 0.01, 0.05, 0.0999, 0.09999999}) {
    PacedWindow copy = window;
    const double stir_s = 9.5 + later_s;
    copy.live_until(stir_s + 0.001, true, {stir_s});
    EXPECT_GE(copy.live_until(stir_s + 0.2, true), FramePacer::settling_frames) << later_s;
    // What waits for a pointer to rest must come; then the window sleeps again.
    EXPECT_GT(copy.live_until(stir_s + 1.5, true), 5);
    copy.live_until(stir_s + 1.7, true);
    EXPECT_LE(copy.live_until(stir_s + 4.5, true), 1);
  }
}

TEST(FramePacer, TakesNoTimeBackFromAFrameThatTookLong) {
  const FramePacer pacer(0.0);
  EXPECT_EQ(pacer.wait_s(false, 1.0, 1.5), 0.0);
  EXPECT_DOUBLE_EQ(pacer.wait_s(false, 1.0, 1.0), FramePacer::frame_s);
}

}  // namespace
}  // namespace ghostforce
