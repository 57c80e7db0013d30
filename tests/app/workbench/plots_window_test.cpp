// The drawer with the plots, as a person uses it.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

#include "app/files/input_file.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/screen_text.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::plots_window_test {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

class PlotsWindow : public DrivenWindow {
 protected:
  PlotsWindow() {
    press(key::f3);
    frames(3);
  }

  const PlotView& view() { return session().plots; }

  // The drawer starts where the scene ends.
  Vector<2> in_drawer(double x, double y) const {
    return {x, static_cast<double>(screen().scene_corner().y) + screen().scene_size().y + y};
  }
  void click_in_drawer(double x, double y) {
    const Vector<2> at = in_drawer(x, y);
    click_at(at.x, at.y);
  }
  void choose(PlotTab tab) {
    session().plots.tab = tab;
    frames(3);
  }
};

TEST_F(PlotsWindow, ComesAndGoesWithItsKey) {
  EXPECT_TRUE(view().is_open);
  const double height = screen().scene_size().y;
  press(key::f3);
  frames(2);
  EXPECT_FALSE(view().is_open);
  EXPECT_GT(screen().scene_size().y, height + 150.0);
}

TEST_F(PlotsWindow, ABarSaysThatTimeStandsStillWhereThereIsNoCaption) {
  const auto says_paused = [](std::string_view window) {
    return std::ranges::any_of(words_on_screen(), [&](const ScreenWords& words) {
      return words.text.starts_with("PAUSED") && words.window.find(window) != std::string::npos;
    });
  };
  session().paused = true;
  frames(3);
  EXPECT_TRUE(says_paused("caption"));
  EXPECT_FALSE(says_paused("status")) << "once is enough";
  session().appearance.scale = 2.0;
  frames(3);
  EXPECT_FALSE(says_paused("caption"));
  EXPECT_TRUE(says_paused("status"));
  session().paused = false;
  frames(3);
  EXPECT_FALSE(says_paused("status"));
}

TEST_F(PlotsWindow, TabsChooseWhatIsShown) {
  click_in_drawer(110.0, 20.0);
  EXPECT_EQ(view().tab, PlotTab::wall_angle);
  click_in_drawer(195.0, 20.0);
  EXPECT_EQ(view().tab, PlotTab::ratio);
  click_in_drawer(30.0, 20.0);
  EXPECT_EQ(view().tab, PlotTab::time);
}

TEST_F(PlotsWindow, FollowsTheNewestTick) {
  const double before = view().to_s;
  frames(10);
  EXPECT_NEAR(view().to_s - before, 10 * 0.016, 1e-9);
  EXPECT_EQ(view().to_s, application_->history().plots().newest_s());
}

TEST_F(PlotsWindow, OneCursorForAllPlots) {
  point_at(in_drawer(200.0, 100.0));
  frames(2);
  ASSERT_TRUE(view().cursor_s.has_value());
  const double at = *view().cursor_s;
  EXPECT_GT(at, view().from_s);
  EXPECT_LT(at, view().to_s);
  point_at(40.0, 300.0);
  frames(2);
  EXPECT_FALSE(view().cursor_s.has_value());
}

TEST_F(PlotsWindow, TheWheelChoosesHowMuchIsInSight) {
  const double span = view().span_s();
  point_at(in_drawer(200.0, 100.0));
  frames(2);
  for (int notch = 0; notch < 3; ++notch) scroll(1.0);
  frames(3);
  EXPECT_LT(view().span_s(), 0.85 * span);
  EXPECT_TRUE(view().follows);
  EXPECT_EQ(view().to_s, application_->history().plots().newest_s());
}

TEST_F(PlotsWindow, DraggingLooksBackUntilLiveIsPressed) {
  drag(in_drawer(200.0, 100.0), in_drawer(320.0, 100.0));
  EXPECT_FALSE(view().follows);
  const double to = view().to_s;
  EXPECT_LT(to, application_->history().plots().newest_s());
  frames(10);
  EXPECT_EQ(view().to_s, to);
  // "Live" is left of "Save…" and "×".
  click_in_drawer(713.0, 20.0);
  EXPECT_TRUE(view().follows);
}

// Wherever the drag begins: the operating point comes to the pointer.
TEST_F(PlotsWindow, TheWallFollowsADragAnywhereInThePlot) {
  choose(PlotTab::wall_angle);
  for (const double from : {120.0, 330.0}) {
    const Vector<2> goal = session().goal;
    const double before = depth(wall_of(session().settings), goal);
    drag(in_drawer(from, 150.0), in_drawer(140.0, 150.0));
    const double angle = session().settings.wall_normal_angle / degree;
    EXPECT_LT(angle, 120.0);
    EXPECT_GT(angle, 60.0);
    EXPECT_NEAR(angle, std::round(angle), 1e-9);
    EXPECT_NEAR(depth(wall_of(session().settings), session().goal), before, 1e-12) << "the goal is turned with it";
    // One step back is the whole drag.
    press(key::z, modifier::control);
    EXPECT_NEAR(session().settings.wall_normal_angle / degree, 135.0, 1e-9);
    EXPECT_EQ(session().goal, goal);
  }
}

TEST_F(PlotsWindow, TheWallStaysWhereNoPlotIsDragged) {
  choose(PlotTab::wall_angle);
  point_at(in_drawer(200.0, 150.0));
  frames(3);
  drag(in_drawer(600.0, 20.0), in_drawer(140.0, 150.0));  // from the line of the buttons
  EXPECT_NEAR(session().settings.wall_normal_angle / degree, 135.0, 1e-9);
}

TEST_F(PlotsWindow, TheDialFollowsADragAndSnapsToTheOptimum) {
  choose(PlotTab::ratio);
  EXPECT_FALSE(session().settings.stiffnesses.chosen_tracking_ratio.has_value());
  drag(in_drawer(390.0, 150.0), in_drawer(240.0, 150.0));
  ASSERT_TRUE(session().settings.stiffnesses.chosen_tracking_ratio.has_value());
  const double chosen = *session().settings.stiffnesses.chosen_tracking_ratio;
  EXPECT_GT(chosen, 1.0);
  EXPECT_LT(chosen, 4.0);
  // ρ* is somewhere to the right of the middle.
  bool has_snapped = false;
  for (double x = 250.0; x < 390.0 && !has_snapped; x += 10.0) {
    drag(in_drawer(240.0, 150.0), in_drawer(x, 150.0));
    has_snapped = !session().settings.stiffnesses.chosen_tracking_ratio.has_value();
  }
  EXPECT_TRUE(has_snapped);
}

TEST_F(PlotsWindow, AResetBringsBackTheNewestTick) {
  drag(in_drawer(200.0, 100.0), in_drawer(320.0, 100.0));
  ASSERT_FALSE(view().follows);
  press(key::r);
  frames(3);
  EXPECT_TRUE(view().follows);
  EXPECT_EQ(view().to_s, application_->history().plots().newest_s());
}

TEST_F(PlotsWindow, SavesWhatItShows) {
  const TemporaryFolder folder;
  for (const char* const name : {"plots.csv", "plots.png", "plots.svg", "plots.pdf"}) {
    const std::string path = folder / name;
    act(SavePlots{path, false});
    frames(1);
    EXPECT_EQ(file_contents(path).error, 0) << name;
  }
  act(SavePlots{folder / "nowhere/plots.csv", false});
  frames(1);
  ASSERT_TRUE(session().notice.has_value());
  EXPECT_TRUE(is_problem());
}

TEST_F(PlotsWindow, TheButtonAsksForAName) {
  click_in_drawer(770.0, 20.0);
  EXPECT_EQ(session().dialog, Dialog::save_plots);
  EXPECT_TRUE(session().form.path.ends_with("-over-time.csv"));
}

TEST_F(PlotsWindow, StaysWithinASmallWindow) {
  open({}, "wall45", 640, 480);
  press(key::f3);
  for (const PlotTab tab : {PlotTab::time, PlotTab::wall_angle, PlotTab::ratio, PlotTab::hand}) choose(tab);
  EXPECT_GT(screen().scene_size().y, 60.0);
}

TEST_F(PlotsWindow, AMinuteOfHistoryShowsToo) {
  session().plots.to_s = session().plots.from_s + 60.0;
  for (int k = 0; k < 4000; ++k) {
    application_->servo().step();
    if (k % 500 == 0) frames(1, 0);
  }
  frames(2);
  EXPECT_NEAR(view().span_s(), 60.0, 1e-9);
}

}  // namespace
}  // namespace ghostforce::plots_window_test
