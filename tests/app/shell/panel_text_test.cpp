// Every word of the workbench can be read: none is cut off, none lies on another, at any size of the window and the
// letters, with all panels open, with plots, hints, dialogs and a device.
#include <utility>

#include "app/state/user_measurement_guide.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/screen_text.h"

namespace ghostforce::panel_text_test {
namespace {

class PanelText : public DrivenWindow {
 protected:
  // All of the column, a page at a time.
  void expect_no_faults(const std::string& where) {
    ImGuiWindow& column = *ImGui::FindWindowByName("panels");
    ImGui::SetScrollY(&column, 0.0F);
    frames(2, 1);
    for (;;) {
      for (const std::string& fault : faults_of(words_on_screen())) ADD_FAILURE() << where << ": " << fault;
      if (column.Scroll.y >= column.ScrollMax.y) break;
      ImGui::SetScrollY(&column, std::min(column.ScrollMax.y, column.Scroll.y + 0.8F * column.InnerRect.GetHeight()));
      frames(2, 1);
    }
  }
  void expect_no_faults_at_all_scales(const std::string& where) {
    for (const double scale : {0.75, 1.0, 1.5, 2.0}) {
      session().appearance.scale = scale;
      for (const bool has_plots : {false, true}) {
        session().plots.is_open = has_plots;
        frames(3, 1);
        expect_no_faults(fmt::format("{}, scale {}{}", where, scale, has_plots ? ", plots" : ""));
      }
    }
  }
};

TEST(ScreenText, FindsWhatIsCutOffAndWhatLiesOnSomethingElse) {
  const auto words = [](float left, float right) {
    return ScreenWords{"a", "w", {left, 0.0F, right, 10.0F}, {0.0F, 0.0F, 100.0F, 100.0F}};
  };
  // No window of that name is asked for anything without a context.
  const auto* const no_context = ImGui::GetCurrentContext();
  if (no_context == nullptr) ImGui::CreateContext();
  EXPECT_TRUE(faults_of({words(0.0F, 50.0F), words(50.0F, 100.0F)}).empty());
  EXPECT_EQ(faults_of({words(60.0F, 110.0F)}).size(), 1U);
  EXPECT_EQ(faults_of({words(0.0F, 50.0F), words(40.0F, 90.0F)}).size(), 1U);
  if (no_context == nullptr) ImGui::DestroyContext();
}

TEST_F(PanelText, IsReadFromTheFrame) {
  std::string all;
  for (const ScreenWords& words : words_on_screen()) all += words.text + "\n";
  for (const char* const words : {"Anisotropic", "Rendering", "600 N/m", "optimal"}) {
    EXPECT_NE(all.find(words), std::string::npos) << words << " is missing in\n" << all;
  }
}

// In the half of the slider where its knob is not.
TEST_F(PanelText, ASlidersNumberIsBesideItsKnob) {
  const auto left_of = [&](double k_r, std::string_view words) {
    session().settings.stiffnesses.k_r = k_r;
    frames(3);
    const std::vector<ScreenWords> all = words_on_screen();
    const auto found = std::ranges::find(all, words, &ScreenWords::text);
    return found == all.end() ? -1.0F : found->ink.Min.x;
  };
  const float of_small = left_of(50.0, "50.0 N/m");
  const float of_great = left_of(5000.0, "5000 N/m");
  ASSERT_GT(of_great, 0.0F);
  EXPECT_GT(of_small, of_great + 100.0F);
}

TEST_F(PanelText, IsAllThereAtEverySize) {
  for (const auto& [width, height] :
       {std::pair{1024, 640}, std::pair{1280, 800}, std::pair{1920, 1080}, std::pair{3840, 2160}}) {
    open({}, "wall45", width, height);
    expect_no_faults_at_all_scales(fmt::format("{}×{}", width, height));
  }
}

TEST_F(PanelText, IsAllThereWithADevice) {
  for (const auto& [width, height] : {std::pair{1024, 640}, std::pair{1280, 800}}) {
    open({.input = "virtual-falcon"}, "wall45", width, height);
    expect_no_faults_at_all_scales(fmt::format("virtual Falcon, {}×{}", width, height));
  }
}

TEST_F(PanelText, IsAllThereInEveryThemeAndWithHints) {
  for (const Theme& theme : theme_catalog()) {
    open({.appearance = {.theme = &theme}, .offers_hints = true}, "wall45", 1024, 640);
    expect_no_faults_at_all_scales(fmt::format("{}, hints", theme.name));
  }
}

TEST_F(PanelText, IsAllThereWhileTheHandIsMeasuredAndAfterwards) {
  open({}, "wall45", 1024, 640);
  start_measuring(session());
  expect_no_faults_at_all_scales("measuring");
  session().measurement.readings.assign(readings_wanted, {4.0, 200.0});
  session().measurement.stage = UserMeasurement::Stage::done;
  session().measurement.given_k_u = 200.0;
  expect_no_faults_at_all_scales("the result");
}

TEST_F(PanelText, IsAllThereWhileTheBeliefFollowsTheHand) {
  open({}, "wall45", 1024, 640);
  session().plots.tab = PlotTab::hand;
  session().settings.stiffnesses.believed_k_u = 700.0;
  session().belief_source = BeliefSource::live;
  frames(2);
  expect_no_faults_at_all_scales("unknown yet");
  frames(20, 200);
  ASSERT_TRUE(application_->report().hand.estimate.is_known());
  expect_no_faults_at_all_scales("known");
  session().goal = {0.0, 0.05};
  frames(20, 200);
  ASSERT_FALSE(application_->report().hand.estimate.is_known());
  expect_no_faults_at_all_scales("no contact");
}

TEST_F(PanelText, TheNameOfASceneHasIndicesToo) {
  open({}, "fig4-ratio5");
  expect_no_faults_at_all_scales("a ratio of stiffnesses");
}

TEST_F(PanelText, ANoticeIsReadInTheLowestWindowToo) {
  open({}, "wall45", 1024, 640);
  session().notice = Notice{.words = "k_r is too large for this rate.", .is_problem = true};
  expect_no_faults_at_all_scales("notice");
}

TEST_F(PanelText, IsAllThereInDialogs) {
  for (const Dialog dialog : {Dialog::help, Dialog::doctor, Dialog::open_scene, Dialog::save_scene,
                              Dialog::save_picture, Dialog::save_plots, Dialog::reset_preferences, Dialog::palette}) {
    open({}, "wall45", 1024, 640);
    session().dialog = dialog;
    expect_no_faults_at_all_scales(fmt::format("dialog {}", static_cast<int>(dialog)));
  }
}

}  // namespace
}  // namespace ghostforce::panel_text_test
