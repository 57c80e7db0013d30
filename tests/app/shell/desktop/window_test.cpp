// The window itself, offscreen: what of it is remembered, and what is drawn on.
#include "app/shell/desktop/glfw_window.h"

#include <gtest/gtest.h>

#include "app/state/keys.h"

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

class PastingWindow : public GlfwWindow {
 public:
  PastingWindow() : GlfwWindow({.title = "test", .width = 64, .height = 48, .offscreen = true}) {}

  // Until ImGui has taken all that was handed on to it: how often that was Ctrl+V.
  int pastes() {
    for (; !key_events().empty(); key_events().pop_front()) hand_on(key_events().front());
    int count = 0;
    for (int i = 0; i < 10; ++i) {
      frame(0.0, [&count] {
        if (ImGui::IsKeyPressed(ImGuiKey_V, false) && ImGui::GetIO().KeyCtrl) ++count;
      });
    }
    return count;
  }
  using Window::add_paste;
};

TEST(Window, PastesOnceTheTextIsThereWhetherOrNotTheKeyIsStillDown) {
  PastingWindow window;
  window.key_events().push_back({.press = {key::v, modifier::control, false}});
  EXPECT_EQ(window.pastes(), 1);
  window.add_paste();
  EXPECT_EQ(window.pastes(), 1) << "V is down";
  window.add_paste();
  window.add_paste();
  EXPECT_EQ(window.pastes(), 2) << "asked for twice";
  EXPECT_FALSE(ImGui::GetIO().KeyCtrl);
}

}  // namespace
}  // namespace ghostforce::window_test
