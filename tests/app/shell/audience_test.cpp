// The second window, which an audience watches: what it shows, and what it leaves to the first.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "app/shell/desktop/glfw_audience_window.h"
#include "app/state/stage_language.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::audience_test {
namespace {

class AudienceTest : public DrivenWindow {
 protected:
  AudienceTest() {
    session().face = Face::stage;
    frames(3);
    act(ToggleAudience{});
    frames(3);
  }

  const GlfwAudienceWindow& audience() const { return dynamic_cast<const GlfwAudienceWindow&>(*screen().audience()); }
  int count_shown(Role role) const {
    int count = 0;
    for (const Pane& pane : audience().panes()) {
      count += static_cast<int>(std::ranges::count(pane.marks, role, &Mark::role));
    }
    return count;
  }
  // As a display would tell it.
  void press_there(int key) {
    const GLFWkeyfun on_key = glfwSetKeyCallback(audience().handle(), nullptr);
    glfwSetKeyCallback(audience().handle(), on_key);
    on_key(audience().handle(), key, glfwGetKeyScancode(key), GLFW_PRESS, 0);
    on_key(audience().handle(), key, glfwGetKeyScancode(key), GLFW_RELEASE, 0);
    frames(3);
  }
  Image shown() {
    draw_every_frame();
    frames(1);
    return audience().picture();
  }
};

bool is_black(const Image& image) {
  return std::ranges::all_of(image.rgb, [](std::uint8_t channel) { return channel == 0; });
}

TEST_F(AudienceTest, SeesTheStageWithoutButtonsDialogsAndNotices) {
  frames(240);  // until labels have found their places
  EXPECT_GT(count_marks(Role::button), 0);
  EXPECT_EQ(count_shown(Role::button), 0);
  EXPECT_GT(count_shown(Role::sentence), 0);
  EXPECT_GT(count_shown(Role::number), 0);
  const Image before = shown();
  EXPECT_FALSE(is_black(before));
  act(OpenDialog{Dialog::help});
  application_->show_notice("Something was saved.", false);
  point_at(640.0, 300.0);
  frames(5);
  EXPECT_EQ(shown(), before);
}

TEST_F(AudienceTest, SeesItAtTheSizeOfItsWindow) {
  glfwSetWindowSize(audience().handle(), 700, 300);
  frames(2);
  ASSERT_EQ(audience().panes().size(), 1U);
  EXPECT_EQ(audience().panes()[0].camera.size, Vector<2>(700.0, 300.0));
  const Image picture = shown();
  EXPECT_EQ(picture.width, 700);
  EXPECT_EQ(picture.height, 300);
}

TEST_F(AudienceTest, SeesWhatThePersonDoes) {
  const auto goal = [&] { return place_of_mark(audience().panes()[0], Role::goal); };
  const Vector<2> before = goal();
  session().goal += Vector<2>(0.004, 0.0);
  frames(2);
  EXPECT_NEAR(goal().x, before.x + 0.004, 1e-9);
  act(ShowFace{Face::workbench});
  session().goal += Vector<2>(0.004, 0.0);
  frames(2);
  EXPECT_NEAR(goal().x, before.x + 0.008, 1e-9) << "while the workbench is in the first window";
}

TEST_F(AudienceTest, NotesAreInTheFirstWindowAlone) {
  const auto& steps = english_stage.lecture.steps;
  press(key::page_down);
  EXPECT_TRUE(says(steps[0].title));
  EXPECT_TRUE(says(filled(english_stage.lecture.next, steps[1].title)));
  EXPECT_LT(screen().scene_size().y, 800.0) << "they cover nothing of the stage";
  for (const Mark& mark : audience().panes()[0].marks) {
    const auto* const label = std::get_if<Label>(&mark.form);
    EXPECT_TRUE(label == nullptr || label->text.find(steps[1].title) == std::string::npos);
  }
  act(ToggleAudience{});
  frames(3);
  EXPECT_FALSE(says(steps[0].title));
  EXPECT_EQ(screen().scene_size().y, 800.0);
}

TEST_F(AudienceTest, BlankIsTheAudiencesAlone) {
  press(key::b);
  EXPECT_TRUE(is_black(shown()));
  EXPECT_FALSE(is_black(picture()));
  act(ShowFace{Face::workbench});
  EXPECT_TRUE(is_black(shown())) << "it stays so while the lecturer looks something up";
  act(ShowFace{Face::stage});
  press(key::b);
  EXPECT_FALSE(is_black(shown()));
}

TEST_F(AudienceTest, SavedPicturesHaveNoNotes) {
  const TemporaryFolder folder;
  draw_every_frame();
  const auto saved = [&](const std::string& name) {
    act(SavePicture{folder / name, 1, false});
    frames(1);
    return read_whole(folder / name);
  };
  const std::string with = saved("with.png");
  act(ToggleAudience{});
  frames(3);
  EXPECT_TRUE(with == saved("without.png"));
}

TEST_F(AudienceTest, ClosingItsWindowEndsItAndNothingElse) {
  glfwSetWindowShouldClose(audience().handle(), GLFW_TRUE);
  frames(1);
  EXPECT_EQ(screen().audience(), nullptr);
  EXPECT_FALSE(session().has_audience);
  EXPECT_FALSE(window().should_close());
  frames(3);
}

TEST_F(AudienceTest, KeysThatReachItsWindowAreTheFirstWindows) {
  press_there(key::page_down);
  EXPECT_EQ(session().stage.demo_step, 0);
  press_there(key::digit_3);
  EXPECT_EQ(session().settings.active, StrategyId::anisotropic);
}

TEST_F(AudienceTest, F11FillsItsOwnMonitor) {
  press_there(key::f11);
  EXPECT_TRUE(audience().is_full_screen());
  EXPECT_FALSE(window().is_full_screen());
  press_there(key::f11);
  EXPECT_FALSE(audience().is_full_screen());
}

// The desktop ends full screen then, and leaves the size.
TEST_F(AudienceTest, AMonitorThatIsGoneLeavesAWindowThatCanBeMoved) {
  const Vector<2> usual = audience().size();
  press_there(key::f11);
  ASSERT_NE(audience().size(), usual);
  const Vector<2> full = audience().size();
  glfwSetWindowMonitor(audience().handle(), nullptr, 0, 0, static_cast<int>(full.x), static_cast<int>(full.y), 0);
  frames(2);
  EXPECT_FALSE(audience().is_full_screen());
  EXPECT_EQ(audience().size(), usual);
}

TEST(AudienceMonitor, IsOneThatShowsNothingOfTheFirstWindows) {
  const DesktopArea own{0, 0, 1280, 800};
  const DesktopArea beside{1280, 0, 1920, 1080};
  const DesktopArea below{0, 800, 800, 600};
  const DesktopArea mirrored{0, 0, 1024, 768};
  const DesktopArea off{5000, 0, 0, 0};
  EXPECT_EQ(find_area_apart(own, std::array{own}), std::nullopt);
  EXPECT_EQ(find_area_apart(own, std::array{own, mirrored, off}), std::nullopt);
  EXPECT_EQ(find_area_apart(own, std::array{own, mirrored, beside}), 2U);
  EXPECT_EQ(find_area_apart(beside, std::array{own, beside}), 0U);
  EXPECT_EQ(find_area_apart(own, std::array{own, below, beside}), 1U);
}

}  // namespace
}  // namespace ghostforce::audience_test
