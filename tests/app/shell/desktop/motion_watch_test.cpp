// What the desktop's settings say about animations, against a bus and a portal of the test's own.
#include "app/shell/desktop/motion_watch.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>

#include "tests/support/fake_settings.h"

namespace ghostforce::motion_watch_test {
namespace {

struct Desktop : FakeSettings {
  explicit Desktop(std::optional<bool> is_animated) : FakeSettings(is_animated) {
    setenv("DBUS_SESSION_BUS_ADDRESS", address().c_str(), 1);
  }
};

TEST(MotionWatch, ReducesWhereTheDesktopHasNoAnimations) {
  Desktop desktop(false);
  const MotionWatch watch;
  EXPECT_TRUE(desktop.comes_to([&] { return watch.is_reduced(); }));
}

TEST(MotionWatch, FollowsAChangeOfTheSetting) {
  Desktop desktop(true);
  const MotionWatch watch;
  ASSERT_TRUE(desktop.comes_to([&] { return desktop.asked > 0; }));
  EXPECT_FALSE(watch.is_reduced());
  desktop.change(false);
  EXPECT_TRUE(desktop.comes_to([&] { return watch.is_reduced(); }));
  // Another setting says nothing about it; it comes before the one that does.
  desktop.tell("org.gnome.desktop.interface", "enable-hot-corners", true);
  desktop.tell("org.example.other", "enable-animations", true);
  desktop.change(true);
  EXPECT_TRUE(desktop.comes_to([&] { return !watch.is_reduced(); }));
}

TEST(MotionWatch, ReducesNothingWhereTheDesktopHasNoSuchSetting) {
  Desktop desktop(std::nullopt);
  const MotionWatch watch;
  ASSERT_TRUE(desktop.comes_to([&] { return desktop.asked > 0; }));
  EXPECT_FALSE(watch.is_reduced());
}

TEST(MotionWatch, ReducesNothingWithoutABus) {
  setenv("DBUS_SESSION_BUS_ADDRESS", "unix:path=/nonexistent/socket", 1);
  const MotionWatch watch;
  EXPECT_FALSE(watch.is_reduced());
}

}  // namespace
}  // namespace ghostforce::motion_watch_test
