// The window itself, offscreen: what of it is remembered.
#include "app/desktop/glfw_window.h"

#include <gtest/gtest.h>

namespace ghostforce {
namespace {

TEST(Window, RemembersTheSizeBeforeItWasMaximised) {
  GlfwWindow window({.title = "test", .width = 640, .height = 480, .offscreen = true});
  window.resize(500, 400);
  window.maximize();
  ASSERT_TRUE(window.is_maximized());
  window.resize(1000, 900);  // what a desktop does then
  EXPECT_EQ(window.restored_size().width, 500);
  EXPECT_EQ(window.restored_size().height, 400);
}

}  // namespace
}  // namespace ghostforce
