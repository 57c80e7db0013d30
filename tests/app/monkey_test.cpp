// Somebody who presses and drags whatever there is, in any order: nothing breaks, and every value stays one that a
// scene may have.
#include <cmath>
#include <filesystem>
#include <random>

#include "app/gestures.h"
#include "app/keys.h"
#include "app/saving.h"
#include "tests/app/driven_window.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce {
namespace {

class MonkeyTest : public DrivenWindow {
 protected:
  MonkeyTest() { std::filesystem::current_path(folder_.path()); }
  ~MonkeyTest() override { std::filesystem::current_path(before_); }

  int any(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  Vector<2> anywhere() { return {static_cast<double>(any(1300) - 10), static_cast<double>(any(820) - 10)}; }

  void do_something() {
    switch (any(8)) {
      case 0:
      case 1:
      case 2: {
        const KeyBinding& binding = key_table()[static_cast<std::size_t>(any(static_cast<int>(key_table().size())))];
        if (binding.key != GLFW_KEY_Q) send_key(binding.key, any(4) == 0 ? GLFW_REPEAT : GLFW_PRESS, binding.modifiers);
        break;
      }
      case 3:
        drag(anywhere(), anywhere(), any(3) == 0 ? GLFW_MOUSE_BUTTON_RIGHT : GLFW_MOUSE_BUTTON_LEFT);
        break;
      case 4:
        click_at(anywhere().x, anywhere().y);
        break;
      case 5:
        point_at(anywhere());
        scroll(any(20) - 10);
        break;
      case 6:
        type(any(2) == 0 ? "1e5" : ".x");
        send_key(GLFW_KEY_ENTER, GLFW_PRESS, 0);
        break;
      case 7:
        session().wishes.open_scene = shipped_scene_names()[static_cast<std::size_t>(any(9))];
        session().wishes.input = any(2) == 0 ? "mouse" : "script";
        break;
    }
    frames(1, any(30));
  }

  std::mt19937 random_{20200417};
  TemporaryFolder folder_;
  std::filesystem::path before_ = std::filesystem::current_path();
};

TEST_F(MonkeyTest, BreaksNothing) {
  for (int i = 0; i < 150; ++i) {
    do_something();
    ASSERT_TRUE(is_in_range(session().settings)) << i;
    ASSERT_LE(std::max(std::abs(session().goal.x), std::abs(session().goal.y)), farthest_mm / 1000.0) << i;
    const SceneView nearest = within_scene_limits(session().shown);
    ASSERT_EQ(nearest.width, session().shown.width) << i;
    ASSERT_EQ(nearest.center, session().shown.center) << i;
    ASSERT_GE(session().look.scale, Look::least_scale) << i;
    ASSERT_LE(session().look.scale, Look::greatest_scale) << i;
  }
  // And at the end all is as it was at the beginning for who asks for it.
  press(GLFW_KEY_ESCAPE);
  press(GLFW_KEY_ESCAPE);
  session().wishes.input = "mouse";
  session().wishes.open_scene = "wall45";
  frames(5);
  EXPECT_EQ(session().settings, load_scene("wall45").settings);
  save_scene(session(), folder_ / "last.toml");
  EXPECT_EQ(load_scene(folder_ / "last.toml").settings, session().settings);
}

}  // namespace
}  // namespace ghostforce
