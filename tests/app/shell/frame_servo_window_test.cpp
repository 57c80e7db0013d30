// The window in a program without threads: whoever draws it makes the ticks as well, frame by frame.
#include <utility>

#include <glm/common.hpp>

#include "device/servo/servo_driver.h"
#include "tests/app/shell/driven_window.h"

namespace ghostforce::frame_servo_window_test {
namespace {

class FrameServoWindow : public DrivenWindow {
 protected:
  void open_driven(const std::string& input) {
    ApplicationOptions options;
    options.input = input;
    options.input_options.virtual_falcon_clock = VirtualLink::Clock::stepped;
    options.make_servo_driver = [] { return std::make_unique<FrameServoDriver>(); };
    open(std::move(options));
    application_->start();
    draw(1);
  }
  // Only frames: nobody steps the servo by hand.
  void draw(int count, double interval_s = frame_s) {
    for (int i = 0; i < count; ++i) application_->frame(interval_s);
  }
  const MotorReport& motors() const { return application_->report().motors; }
};

TEST_F(FrameServoWindow, TicksAsTimeGoesOn) {
  open_driven("script");
  const std::int64_t before = now().tick;
  draw(60);
  EXPECT_NEAR(static_cast<double>(now().tick - before), 1000.0, 2.0);
  EXPECT_EQ(application_->report().loop.late_ticks, 0U);
}

TEST_F(FrameServoWindow, NobodyTicksBeforeTheStartOrAfterTheEnd) {
  ApplicationOptions options;
  options.make_servo_driver = [] { return std::make_unique<FrameServoDriver>(); };
  open(std::move(options));
  draw(1);
  const std::int64_t first = now().tick;  // the window was opened by hand
  draw(5);
  EXPECT_EQ(now().tick, first);
  application_->start();
  draw(5);
  const std::int64_t last = now().tick;
  EXPECT_GT(last, first);
  application_->stop();
  draw(5);
  EXPECT_EQ(now().tick, last);
}

TEST_F(FrameServoWindow, GoesOnWithAnotherInput) {
  open_driven("mouse");
  draw(10);
  act(ChooseInput{"circle"});
  draw(2);
  EXPECT_EQ(session().input, "circle");
  const std::int64_t before = now().tick;
  draw(10);
  EXPECT_GT(now().tick, before + 100);
}

TEST_F(FrameServoWindow, ARehearsalPushesAtTenFramesASecond) {
  open_driven("virtual-falcon");
  const auto run_until = [this](double seconds, const auto& is_so) {
    for (double t = 0.0; t < seconds && !is_so(); t += 0.1) draw(1, 0.1);
    return is_so();
  };
  ASSERT_TRUE(run_until(60.0, [this] { return virtual_falcon().report().state == FalconState::idle; }));
  constexpr Vector<2> outside{-0.015, 0.015};
  const Vector<2> from = session().goal;
  for (int i = 1; i <= 10; ++i) {
    session().goal = glm::mix(from, outside, i / 10.0);
    draw(1, 0.1);
  }
  ASSERT_TRUE(run_until(5.0, [this] { return motors().is_ready; }));
  ++session().acknowledgements;
  ++session().arms_asked;
  ASSERT_TRUE(run_until(5.0, [this] { return motors().state == SafetyState::on; }))
      << entry_of(motors().obstacle).sentence << entry_of(motors().reason).title;
  draw(20, 0.1);
  EXPECT_EQ(motors().state, SafetyState::on) << entry_of(motors().reason).title;
}

}  // namespace
}  // namespace ghostforce::frame_servo_window_test
