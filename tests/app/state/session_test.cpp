// What a person does with a session besides moving the goal: undo, open, save, pictures, inputs, hints; and what is
// said when it does not work.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <string_view>

#include "app/files/png_writer.h"
#include "app/picture/handles.h"
#include "app/shell/preferences.h"
#include "app/stage/hints.h"
#include "app/state/proposed_path.h"
#include "app/state/scene_view.h"
#include "app/workbench/bars.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/read_png.h"
#include "tests/support/temporary_folder.h"

#include <imgui_internal.h>

namespace ghostforce::session_test {
namespace {

class SessionTest : public DrivenWindow {
 protected:
  void undo() { press(key::z, modifier::control); }
  void redo() { press(key::z, modifier::control | modifier::shift); }
};

// --- Undo ------------------------------------------------------------------------------------------------------------

TEST_F(SessionTest, WhereTheHandPullsIsTakenBackAndDoneAgain) {
  const Vector<2> start = session().goal;
  press(key::left, modifier::control);
  press(key::left, modifier::control);
  const Vector<2> nudged = session().goal;
  EXPECT_NE(nudged, start);
  EXPECT_EQ(session().undo_offer.undo, "the goal");
  press(key::digit_3);
  undo();
  EXPECT_EQ(session().goal, nudged);
  undo();
  EXPECT_EQ(session().goal, start);
  redo();
  EXPECT_EQ(session().goal, nudged);
}

// The view has followed the hand, and comes back with it.
TEST_F(SessionTest, AHandThatIsTakenBackIsInSight) {
  open({.face = Face::stage});
  frames(2);
  const SceneView view = session().stage_shown;
  const Vector<2> start = session().goal;
  session().goal = start + Vector<2>(0.05, 0.05);
  frames(2);
  session().stage_shown.center += Vector<2>(0.3, 0.0);
  frames(2);
  undo();
  frames(2);
  EXPECT_EQ(session().goal, start);
  EXPECT_NEAR(session().stage_shown.center.x, view.center.x, 1e-9);
}

TEST_F(SessionTest, EveryChangeOfASettingIsTakenBackAndDoneAgain) {
  const Settings start = session().settings;
  press(key::digit_3);
  const Settings second = session().settings;
  press(key::left_bracket);
  const Settings third = session().settings;
  session().settings.stiffnesses.k_r = 777.0;  // as a slider does
  frames(2);
  undo();
  EXPECT_EQ(session().settings, third);
  undo();
  EXPECT_EQ(session().settings, second);
  undo();
  EXPECT_EQ(session().settings, start);
  undo();
  EXPECT_EQ(session().settings, start) << "nothing before the beginning";
  redo();
  redo();
  EXPECT_EQ(session().settings, third);
  press(key::y, modifier::control);
  EXPECT_EQ(session().settings.stiffnesses.k_r, 777.0);
  undo();
  press(key::right_bracket);
  const Settings other = session().settings;
  redo();
  EXPECT_EQ(session().settings, other) << "a new change ends what could be done again";
}

TEST_F(SessionTest, ADragOfAHandleIsOneStep) {
  const Settings start = session().settings;
  const MotorDial dial = motor_dial(screen().panes()[0].camera, 1.0);
  press_at(in_window(dial.middle + Vector<2>(0.8 * dial.radius, 0.0)));
  for (int i = 1; i <= 9; ++i) {
    const double angle = 0.17 * i;
    point_at(in_window(dial.middle + 0.8 * dial.radius * Vector<2>(std::cos(angle), -std::sin(angle))));
    frames(1);
  }
  release();
  EXPECT_GT(session().settings.actuated_angle, 1.0);
  undo();
  EXPECT_EQ(session().settings, start);
}

TEST_F(SessionTest, OpeningAnotherSceneCanBeTakenBackToo) {
  session().settings.stiffnesses.k_u = 321.0;
  frames(3);
  act(OpenScene{"fig1"});
  frames(3);
  EXPECT_EQ(session().settings, load_scene("fig1").settings);
  EXPECT_EQ(now().goal, load_scene("fig1").goal.points.back());
  undo();
  EXPECT_EQ(session().settings.stiffnesses.k_u, 321.0);
  EXPECT_EQ(session().scene->title, load_scene("wall45").title);
}

// --- Scenes ----------------------------------------------------------------------------------------------------------

TEST_F(SessionTest, ASavedSceneShowsWhatWasSeen) {
  const TemporaryFolder folder;
  const std::string path = folder / "mine.toml";
  press(key::digit_3);
  press(key::left_bracket);
  press(key::right);
  session().settings.stiffnesses.chosen_tracking_ratio = 2.5;
  point_at(300.0, 300.0);
  scroll(1.0);
  frames(100);
  const Scene seen = scene_as_seen(session());
  act(SaveScene{path});
  frames(3);
  EXPECT_FALSE(is_problem()) << notice();
  const Scene read = load_scene(path);
  EXPECT_EQ(read.settings, seen.settings);
  EXPECT_EQ(read.goal.points, seen.goal.points);
  EXPECT_EQ(read.view.width, seen.view.width);
  EXPECT_NEAR(glm::distance(read.goal.points.back(), now().goal), 0.0, 1e-9);

  open({}, path);
  EXPECT_EQ(session().settings, seen.settings);
  EXPECT_EQ(now().goal, seen.goal.points.back());
}

TEST_F(SessionTest, TheDialogProposesAFreeNameAndSavesThere) {
  const TemporaryFolder folder;
  press(key::s, modifier::control);
  ASSERT_EQ(session().dialog, Dialog::save_scene);
  EXPECT_TRUE(session().form.path.ends_with("a-wall-at-45-degrees.ghostforce.toml")) << session().form.path;
  EXPECT_TRUE(std::filesystem::path(session().form.path).is_absolute());
  session().form.path.clear();
  frames(1);
  press(key::a, modifier::control);
  type(folder / "typed.toml");
  press(key::enter);
  frames(2);
  EXPECT_TRUE(std::filesystem::exists(folder / "typed.toml"));
  EXPECT_EQ(session().dialog, Dialog::none);
}

TEST_F(SessionTest, AViewFromFarAwayCanBeSavedAndOpenedToo) {
  const TemporaryFolder folder;
  point_at(400.0, 400.0);
  for (int i = 0; i < 40; ++i) scroll(-10.0);
  for (int i = 0; i < 4; ++i) drag({100.0, 200.0}, {800.0, 700.0}, GLFW_MOUSE_BUTTON_RIGHT);
  act(SaveScene{folder / "far.toml"});
  frames(2);
  EXPECT_EQ(load_scene(folder / "far.toml").view.width, session().shown.width);
}

TEST_F(SessionTest, ADroppedFileIsOpened) {
  const TemporaryFolder folder;
  Scene scene = load_scene("fig3-actuated");
  scene.title = "Dropped";
  session().scene = std::make_shared<const Scene>(scene);
  session().settings = scene.settings;
  write_whole(folder / "dropped.toml", scene_text(scene_as_seen(session())));
  open({});
  drop({(folder / "dropped.toml").c_str()});
  EXPECT_EQ(session().scene->title, "Dropped");
}

TEST_F(SessionTest, AFileThatIsNoSceneIsSaidAndChangesNothing) {
  const TemporaryFolder folder;
  write_whole(folder / "bad.toml", "format = 1\ntitle = 3\n");
  const Settings before = session().settings;
  drop({(folder / "bad.toml").c_str()});
  EXPECT_TRUE(is_problem());
  EXPECT_NE(notice().find("bad.toml:2"), std::string::npos) << notice();
  EXPECT_EQ(session().settings, before);
  for (int i = 0; i < 20; ++i) application_->frame(1.0);
  EXPECT_TRUE(session().notice) << "a problem stays until it is dismissed";
  press(key::escape);
  EXPECT_FALSE(session().notice);
}

// --- Pictures --------------------------------------------------------------------------------------------------------

TEST_F(SessionTest, WhatFailsKeepsNothingElseFromBeingDoneAndStaysToBeRead) {
  const TemporaryFolder folder;
  act(ChooseInput{"nobody"});
  act(SaveScene{"/proc/nowhere/scene.toml"});
  act(SaveScene{folder / "a.toml"});
  frames(2);
  EXPECT_TRUE(std::filesystem::exists(folder / "a.toml"));
  EXPECT_TRUE(is_problem());
  for (const char* const words : {"nobody", "/proc/nowhere", "Saved"}) {
    EXPECT_NE(notice().find(words), std::string::npos) << notice();
  }
  act(SaveScene{folder / "b.toml"});
  frames(2);
  EXPECT_FALSE(is_problem()) << "what failed before has been there to be read";
}

TEST_F(SessionTest, APictureIsTheScreenOnceToFourTimesAsFine) {
  draw_every_frame();
  const TemporaryFolder folder;
  session().paused = true;
  session().hint = 0;
  frames(3);
  for (const int density : {1, 2, 4}) {
    const std::string path = folder / (std::to_string(density) + ".png");
    act(SavePicture{path, density, false});
    frames(2);
    EXPECT_FALSE(is_problem()) << notice();
    const Image image = read_png(path);
    EXPECT_EQ(image.width, 1280 * density);
    EXPECT_EQ(image.height, 800 * density);
  }
  act(SavePicture{folder / "scene.png", 2, true});
  frames(2);
  const Image scene = read_png(folder / "scene.png");
  EXPECT_NEAR(scene.width, 2.0 * screen().scene_size().x, 2.0);
  EXPECT_NEAR(scene.height, 2.0 * screen().scene_size().y, 2.0);
}

TEST_F(SessionTest, APictureShowsNeitherHintsNorHandlesNorNotices) {
  draw_every_frame();
  const TemporaryFolder folder;
  session().paused = true;
  session().has_handles = false;
  point_at(5.0, 795.0);
  frames(8);
  const Image plain = picture();
  session().has_handles = true;
  for (std::size_t hint = 0; hint < hint_catalog().size(); ++hint) {
    session().hint = hint;
    session().notice = Notice{"something", true, 0.0};
    session().settings.active = StrategyId::naive;
    frames(2);
    EXPECT_NE(picture(), plain);
    act(SavePicture{folder / "picture.png", 1, false});
    frames(1);
    const Image saved = read_png(folder / "picture.png");
    ASSERT_EQ(saved.rgb.size(), plain.rgb.size());
    int greatest = 0;
    for (std::size_t i = 0; i < plain.rgb.size(); ++i) {
      greatest = std::max(greatest, std::abs(int{saved.rgb[i]} - int{plain.rgb[i]}));
    }
    // Blending into a renderbuffer rounds otherwise than into the window, by one step.
    EXPECT_LE(greatest, 1) << hint;
  }
}

TEST_F(SessionTest, ThePictureDialogKnowsItsFormatsInAnyCase) {
  const TemporaryFolder folder;
  for (const auto& [typed, written] :
       {std::pair{"a.PNG", "a.PNG"}, std::pair{"b", "b.png"}, std::pair{"c.jpg", "c.jpg.png"},
        std::pair{"d.Svg", "d.Svg"}, std::pair{"e.pdf", "e.pdf"}}) {
    press(key::s, modifier::control | modifier::shift);
    session().form.density = 1;
    frames(2);
    type(folder / typed);  // in place of the proposal, which is selected
    press(key::enter);
    frames(2);
    EXPECT_TRUE(std::filesystem::exists(folder / written)) << typed;
  }
  EXPECT_TRUE(read_whole(folder / "d.Svg").starts_with("<?xml"));
  EXPECT_TRUE(read_whole(folder / "e.pdf").starts_with("%PDF"));
}

TEST_F(SessionTest, EachDialogBeginsWithFieldsOfItsOwn) {
  press(key::s, modifier::control);
  EXPECT_FALSE(session().form.path.empty());
  press(key::o, modifier::control);
  EXPECT_EQ(session().dialog, Dialog::open_scene);
  EXPECT_EQ(session().form.path, "");
}

// --- Inputs ----------------------------------------------------------------------------------------------------------

TEST_F(SessionTest, TheInputChangesWhileTheProgramRuns) {
  act(ChooseInput{"script"});
  frames(3);
  EXPECT_FALSE(session().pointer_moves_goal);
  const Vector<2> early = now().goal;
  frames(60);
  EXPECT_GT(glm::distance(now().goal, early), 0.02) << "the script plays from its beginning";
  act(ChooseInput{"mouse"});
  frames(3);
  EXPECT_TRUE(session().pointer_moves_goal);
  EXPECT_EQ(now().goal, load_scene("wall45").goal.points.back());
}

// --- Hints -----------------------------------------------------------------------------------------------------------

TEST_F(SessionTest, ThreeHintsGoOneAfterAnotherAsTheyAreFollowed) {
  open({.offers_hints = true});
  ASSERT_EQ(session().hint, 0U);
  frames(60);
  EXPECT_EQ(session().hint, 0U) << "waits for the person";
  const Vector<2> goal = on_window(now().goal);
  press_at(goal);
  point_at(goal + Vector<2>(30.0, 10.0));
  frames(2);
  EXPECT_EQ(session().hint, 0U) << "not before the hand lets go";
  release();
  EXPECT_EQ(session().hint, 1U);
  press(key::digit_1);
  EXPECT_EQ(session().hint, 1U);
  press(key::digit_3);
  EXPECT_EQ(session().hint, 2U);
  press(key::left_bracket);
  EXPECT_FALSE(session().hint);
}

TEST_F(SessionTest, AHintThatCannotBeFollowedIsNotOffered) {
  open({.input = "script", .offers_hints = true});
  EXPECT_EQ(session().hint, 1U) << "a script moves the goal";
  session().hint = 2;
  frames(2);
  act(OpenScene{"fig4-ratio5"});
  frames(4);
  EXPECT_EQ(session().hint, 2U) << "another scene is no turn of the arrow";
  press(key::escape);
  EXPECT_FALSE(session().hint);
}

TEST_F(SessionTest, HintsAreTheSentencesOfTheDesign) {
  ASSERT_EQ(hint_catalog().size(), 3U);
  EXPECT_EQ(hint_catalog()[0].sentence, "Drag: this is where your hand wants to be.");
  EXPECT_EQ(hint_catalog()[1].sentence, "Press 3: same hand, same wall.");
  EXPECT_EQ(hint_catalog()[2].sentence, "Turn the arrow.");
}

// --- Sizes -----------------------------------------------------------------------------------------------------------

// The windows of ImGui that are on the screen, by name.
std::vector<const ImGuiWindow*> windows_on_screen() {
  std::vector<const ImGuiWindow*> found;
  for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
    if (window->WasActive && !window->Hidden && window->ParentWindow == nullptr) found.push_back(window);
  }
  return found;
}

TEST_F(SessionTest, EveryWindowStaysOnTheScreenAtEverySizeScaleAndTheme) {
  for (const auto& [width, height] : {std::pair{480, 360}, std::pair{1024, 640}, std::pair{1920, 1080}}) {
    for (const double scale : {0.75, 1.0, 2.0}) {
      for (const Theme& theme : theme_catalog()) {
        open({.appearance = {.theme = &theme, .scale = scale}, .offers_hints = true}, "fig1", width, height);
        for (const Dialog dialog : {Dialog::help, Dialog::open_scene, Dialog::save_scene, Dialog::save_picture}) {
          session().dialog = theme.dark ? dialog : Dialog::none;
          session().notice = Notice{std::string(300, 'w') + ' ' + std::string(300, 'o'), true, 0.0};
          frames(3);
          for (const ImGuiWindow* window : windows_on_screen()) {
            if (std::string_view(window->Name).starts_with("Debug")) continue;
            EXPECT_GE(window->Pos.x, -0.5F) << window->Name << ' ' << width << ' ' << scale;
            EXPECT_GE(window->Pos.y, -0.5F) << window->Name << ' ' << width << ' ' << scale;
            EXPECT_LE(window->Pos.x + window->Size.x, static_cast<float>(width) + 0.5F)
                << window->Name << ' ' << width << ' ' << scale;
            EXPECT_LE(window->Pos.y + window->Size.y, static_cast<float>(height) + 0.5F)
                << window->Name << ' ' << width << ' ' << scale;
          }
        }
      }
    }
  }
}

TEST_F(SessionTest, AtItsSmallestSizeThePanelsNeedNoScrolling) {
  open({.folded_panels = panels_folded_at_first(640.0)}, "fig1", 1024, 640);
  frames(3);
  EXPECT_EQ(ImGui::FindWindowByName("panels")->ScrollMax.y, 0.0F);
  open({.folded_panels = panels_folded_at_first(800.0)}, "fig1");
  frames(3);
  EXPECT_EQ(ImGui::FindWindowByName("panels")->ScrollMax.y, 0.0F);
}

TEST_F(SessionTest, NumbersDoNotMakeTheLayoutJump) {
  const auto content = [] { return ImGui::FindWindowByName("panels")->ContentSize; };
  session().paused = true;
  frames(4);
  const ImVec2 before = content();
  session().settings.stiffnesses = {
      .k_u = 0.4, .believed_k_u = 900000.0, .k_r = 1e6, .k_t = 0.1, .k_c = 1e9, .chosen_tracking_ratio = 123.456};
  for (const Strategy& entry : strategy_catalog()) {
    session().settings.active = entry.id;
    frames(3);
    EXPECT_EQ(content().x, before.x);
    EXPECT_EQ(content().y, before.y);
  }
}

// --- The caption -----------------------------------------------------------------------------------------------------

TEST(Caption, SaysWhatIsTrueNow) {
  Settings settings = load_scene("fig1").settings;
  const Vector<2> inside = load_scene("fig1").goal.points.back();
  for (const Strategy& entry : strategy_catalog()) {
    settings.active = entry.id;
    const bool has_ghost = entry.id == StrategyId::naive;
    EXPECT_EQ(caption_of(settings, inside), has_ghost ? entry.with_ghost : entry.without_ghost) << entry.name;
    EXPECT_NE(caption_of(settings, {-0.05, 0.05}).find("in front of the wall"), std::string_view::npos);
  }
  settings.active = StrategyId::anisotropic;
  settings.stiffnesses.chosen_tracking_ratio = 1.0;
  EXPECT_EQ(caption_of(settings, inside), strategy(StrategyId::anisotropic).with_ghost) << "not the ratio it needs";
  settings.active = StrategyId::naive;
  settings.actuated_angle = settings.wall_normal_angle;
  EXPECT_EQ(caption_of(settings, inside), strategy(StrategyId::naive).without_ghost) << "straight out of the wall";
  settings.actuated_angle = settings.wall_normal_angle + std::numbers::pi / 2.0;
  EXPECT_NE(caption_of(settings, inside).find("along the wall"), std::string_view::npos);
}

TEST(ProposedPath, MakesFileNamesOfTitles) {
  EXPECT_EQ(file_stem("A wall at 45 degrees"), "a-wall-at-45-degrees");
  EXPECT_EQ(file_stem("Figure 3: ρ = 1/2"), "figure-3-1-2");
  EXPECT_EQ(file_stem("«»"), "scene");
  EXPECT_EQ(file_stem("../../etc/passwd"), "etc-passwd");
}

}  // namespace
}  // namespace ghostforce::session_test
