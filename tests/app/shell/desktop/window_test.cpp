// The window itself, offscreen: what of it is remembered, and what is drawn on.
#include "app/shell/desktop/glfw_window.h"

#include <gtest/gtest.h>

namespace ghostforce::window_test {
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

// Its lower right corner.
unsigned char last_red(const Image& image) {
  return image.rgb.at(image.rgb.size() - 3);
}

TEST(Window, DrawsOnAllOfItWhateverItsSizeIsAndWhateverElseWasDrawn) {
  GlfwWindow window({.title = "test", .width = 64, .height = 48, .offscreen = true});
  const auto fill = [] {
    ImGui::GetBackgroundDrawList()->AddRectFilled({0.0F, 0.0F}, {1000.0F, 1000.0F}, IM_COL32(200, 0, 0, 255));
  };
  for (const int width : {64, 640, 100}) {
    window.resize(width, 480);
    window.frame(0.0, fill);
    const Image picture = window.picture();
    EXPECT_EQ(picture.width, width);
    EXPECT_EQ(last_red(picture), 200) << width;
    EXPECT_EQ(last_red(window.picture_of(2, [] {})), 0) << "a picture of its own, with nothing in it";
    EXPECT_EQ(last_red(window.picture()), 200) << "the window's again";
  }
}

}  // namespace
}  // namespace ghostforce::window_test
