// What another client of a display does to a window, and what becomes of the display, as the window's watch hears it. The
// thread of the window does nothing meanwhile.
#include "app/shell/desktop/display_watch.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <optional>
#include <string>

#include "app/base/failure.h"
#include "app/shell/desktop/glfw_window.h"
#include "tests/support/becomes.h"
#include "tests/support/display.h"
#include "tests/support/x_client.h"

namespace ghostforce::display_watch_test {
namespace {

std::atomic<int> losses{0};

class WatchedDisplay : public testing::Test {
 protected:
  WatchedDisplay() {
    losses = 0;
    unsetenv("WAYLAND_DISPLAY");
    setenv("DISPLAY", name_.c_str(), 1);
  }

  void watch(std::uint32_t window) {
    watch_.emplace(window, []() noexcept { ++losses; });
  }

  Display display_{640, 480};
  std::string name_ = display_.environment().front().substr(std::string("DISPLAY=").size());
  XClient owner_{name_};
  XClient other_{name_};
  std::uint32_t window_ = owner_.make_window();
  std::optional<DisplayWatch> watch_;
};

TEST_F(WatchedDisplay, AGrabTakesTheKeyboardUntilItEnds) {
  watch(window_);
  owner_.focus(window_);
  EXPECT_FALSE(watch_->keyboard_is_taken());
  for (int time = 0; time < 2; ++time) {
    ASSERT_TRUE(other_.grab_keyboard());
    EXPECT_TRUE(becomes([&] { return watch_->keyboard_is_taken(); }));
    other_.release_keyboard();
    EXPECT_TRUE(becomes([&] { return !watch_->keyboard_is_taken(); }));
  }
}

TEST_F(WatchedDisplay, TheEndOfTheProgramThatHasTheKeyboardGivesItBack) {
  watch(window_);
  owner_.focus(window_);
  {
    XClient third(name_);
    ASSERT_TRUE(third.grab_keyboard());
    EXPECT_TRUE(becomes([&] { return watch_->keyboard_is_taken(); }));
  }
  EXPECT_TRUE(becomes([&] { return !watch_->keyboard_is_taken(); }));
}

TEST_F(WatchedDisplay, AWindowThatGetsTheFocusDuringAGrabDoesNotGetTheKeyboard) {
  watch(window_);
  ASSERT_TRUE(other_.grab_keyboard());
  owner_.focus(window_);
  EXPECT_TRUE(becomes([&] { return watch_->keyboard_is_taken(); }));
  other_.release_keyboard();
  EXPECT_TRUE(becomes([&] { return !watch_->keyboard_is_taken(); }));
}

// The end of the grab is then told to the other window.
TEST_F(WatchedDisplay, AGrabThatEndsWhileTheFocusIsElsewhereIsForgottenWithTheNextFocus) {
  watch(window_);
  owner_.focus(window_);
  ASSERT_TRUE(other_.grab_keyboard());
  EXPECT_TRUE(becomes([&] { return watch_->keyboard_is_taken(); }));
  other_.focus(other_.make_window());
  other_.release_keyboard();
  other_.focus(window_);
  EXPECT_TRUE(becomes([&] { return !watch_->keyboard_is_taken(); }));
}

TEST_F(WatchedDisplay, HearsThatTheWindowWasDestroyed) {
  watch(window_);
  other_.destroy(window_);
  EXPECT_TRUE(becomes([] { return losses == 1; }));
  EXPECT_EQ(watch_->loss(), DisplayLoss::window);
  EXPECT_FALSE(DisplayWatch::window_exists(window_));
}

TEST_F(WatchedDisplay, HearsThatTheConnectionOfTheWindowWasEnded) {
  watch(window_);
  EXPECT_TRUE(DisplayWatch::window_exists(window_));
  other_.kill_owner(window_);
  EXPECT_TRUE(becomes([] { return losses == 1; }));
  EXPECT_EQ(watch_->loss(), DisplayLoss::window);
}

TEST_F(WatchedDisplay, HearsThatTheServerEnded) {
  watch(window_);
  display_.lose();
  EXPECT_TRUE(becomes([] { return losses == 1; }));
  EXPECT_EQ(watch_->loss(), DisplayLoss::server);
  EXPECT_FALSE(DisplayWatch::window_exists(window_));
}

// Events come in their order: with the last one all have been heard.
TEST_F(WatchedDisplay, BelievesNoFocusThatAClientMadeUp) {
  watch(window_);
  owner_.focus(window_);
  ASSERT_TRUE(other_.grab_keyboard());
  other_.make_up(XCB_FOCUS_IN, window_);
  other_.destroy(window_);
  EXPECT_TRUE(becomes([] { return losses == 1; }));
  EXPECT_TRUE(watch_->keyboard_is_taken());
}

TEST_F(WatchedDisplay, BelievesNoEndThatAClientMadeUp) {
  watch(window_);
  owner_.focus(window_);
  other_.make_up(XCB_DESTROY_NOTIFY, window_);
  ASSERT_TRUE(other_.grab_keyboard());
  EXPECT_TRUE(becomes([&] { return watch_->keyboard_is_taken(); }));
  EXPECT_EQ(watch_->loss(), DisplayLoss::none);
}

TEST_F(WatchedDisplay, AnotherWindowIsNoneOfItsBusiness) {
  watch(window_);
  const std::uint32_t another = owner_.make_window();
  owner_.focus(another);
  owner_.destroy(another);
  owner_.focus(window_);
  ASSERT_TRUE(other_.grab_keyboard());
  EXPECT_TRUE(becomes([&] { return watch_->keyboard_is_taken(); }));
  EXPECT_EQ(watch_->loss(), DisplayLoss::none);
  watch_.reset();
  EXPECT_EQ(losses, 0) << "nothing was lost";
}

TEST_F(WatchedDisplay, RefusesAWindowThatIsGone) {
  owner_.destroy(window_);
  try {
    watch(window_);
    ADD_FAILURE();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), ExitCode::no_display);
  }
}

// The program's own window.
TEST_F(WatchedDisplay, AWindowHasNoFocusWhileAnotherClientHasTheKeyboard) {
  GlfwWindow window({.title = "test", .width = 320, .height = 240, .when_lost = []() noexcept { ++losses; }});
  const auto live = [&] { window.poll(0.0); };
  EXPECT_TRUE(becomes([&] { return window.has_focus(); }, live));
  ASSERT_TRUE(other_.grab_keyboard());
  EXPECT_TRUE(becomes([&] { return !window.has_focus(); }, live));
  other_.release_keyboard();
  EXPECT_TRUE(becomes([&] { return window.has_focus(); }, live));
}

TEST_F(WatchedDisplay, AWindowThatOpensDuringAGrabHasNoFocus) {
  ASSERT_TRUE(other_.grab_keyboard());
  GlfwWindow window({.title = "test", .width = 320, .height = 240});
  for (int frame = 0; frame < 20; ++frame) window.poll(0.01);
  EXPECT_TRUE(becomes([&] { return !window.has_focus(); }, [&] { window.poll(0.0); }));
  other_.release_keyboard();
  EXPECT_TRUE(becomes([&] { return window.has_focus(); }, [&] { window.poll(0.0); }));
}

}  // namespace
}  // namespace ghostforce::display_watch_test
