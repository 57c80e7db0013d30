// What a person does with a session besides moving the goal: undo, open, save, pictures, inputs, hints; and what is
// said when it does not work.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "app/panels/hints.h"
#include "app/panels/save_path.h"
#include "app/png_file.h"
#include "app/saving.h"
#include "app/view/handles.h"
#include "tests/app/driven_window.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce {
namespace {

class SessionTest : public DrivenWindow {
 protected:
  void undo() { press(GLFW_KEY_Z, GLFW_MOD_CONTROL); }
  void redo() { press(GLFW_KEY_Z, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT); }
};

// --- Undo --------------------------------------------------------------------------------------------------------------

TEST_F(SessionTest, EveryChangeOfASettingIsTakenBackAndDoneAgain) {
  const Settings start = session().settings;
  press(GLFW_KEY_3);
  const Settings second = session().settings;
  press(GLFW_KEY_LEFT_BRACKET);
  const Settings third = session().settings;
  session().settings.impedances.k_r = 777.0;  // as a slider does
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
  press(GLFW_KEY_Y, GLFW_MOD_CONTROL);
  EXPECT_EQ(session().settings.impedances.k_r, 777.0);
  undo();
  press(GLFW_KEY_RIGHT_BRACKET);
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
  session().settings.impedances.k_u = 321.0;
  frames(3);
  session().wishes.open_scene = "fig1";
  frames(3);
  EXPECT_EQ(session().settings, load_scene("fig1").settings);
  EXPECT_EQ(now().goal, load_scene("fig1").goal.points.back());
  undo();
  EXPECT_EQ(session().settings.impedances.k_u, 321.0);
  EXPECT_EQ(session().scene->title, load_scene("wall45").title);
}

// --- Scenes ------------------------------------------------------------------------------------------------------------

TEST_F(SessionTest, ASavedSceneShowsWhatWasSeen) {
  const TemporaryFolder folder;
  const std::string path = folder / "mine.toml";
  press(GLFW_KEY_3);
  press(GLFW_KEY_LEFT_BRACKET);
  press(GLFW_KEY_RIGHT);
  session().settings.impedances.chosen_tracking_ratio = 2.5;
  point_at(300.0, 300.0);
  scroll(1.0);
  frames(100);
  const Scene seen = scene_as_seen(session());
  session().wishes.save_scene = path;
  frames(3);
  ASSERT_TRUE(session().notice);
  EXPECT_FALSE(session().notice->is_problem) << session().notice->words;
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
  press(GLFW_KEY_S, GLFW_MOD_CONTROL);
  ASSERT_EQ(session().dialog, Dialog::save_scene);
  EXPECT_TRUE(session().form.path.ends_with("a-wall-at-45-degrees.toml")) << session().form.path;
  EXPECT_TRUE(std::filesystem::path(session().form.path).is_absolute());
  session().form.path.clear();
  frames(1);
  press(GLFW_KEY_A, GLFW_MOD_CONTROL);
  type(folder / "typed.toml");
  press(GLFW_KEY_ENTER);
  frames(2);
  EXPECT_TRUE(std::filesystem::exists(folder / "typed.toml"));
  EXPECT_EQ(session().dialog, Dialog::none);
}

TEST_F(SessionTest, ADroppedFileIsOpened) {
  const TemporaryFolder folder;
  Scene scene = load_scene("fig3-actuated");
  scene.title = "Dropped";
  session().scene = std::make_shared<const Scene>(scene);
  session().settings = scene.settings;
  save_scene(session(), folder / "dropped.toml");
  open({});
  drop({(folder / "dropped.toml").c_str()});
  EXPECT_EQ(session().scene->title, "Dropped");
}

TEST_F(SessionTest, AFileThatIsNoSceneIsSaidAndChangesNothing) {
  const TemporaryFolder folder;
  write_whole(folder / "bad.toml", "format = 1\ntitle = 3\n");
  const Settings before = session().settings;
  drop({(folder / "bad.toml").c_str()});
  ASSERT_TRUE(session().notice);
  EXPECT_TRUE(session().notice->is_problem);
  EXPECT_NE(session().notice->words.find("bad.toml:2"), std::string::npos) << session().notice->words;
  EXPECT_EQ(session().settings, before);
  for (int i = 0; i < 20; ++i) application_->frame(1.0);
  EXPECT_TRUE(session().notice) << "a problem stays until it is dismissed";
  press(GLFW_KEY_ESCAPE);
  EXPECT_FALSE(session().notice);
}

TEST_F(SessionTest, SavingWhereNothingCanBeIsSaid) {
  session().wishes.save_scene = "/proc/nowhere/scene.toml";
  frames(2);
  ASSERT_TRUE(session().notice);
  EXPECT_TRUE(session().notice->is_problem);
}

// --- Pictures ----------------------------------------------------------------------------------------------------------

TEST_F(SessionTest, APictureIsTheScreenOnceToFourTimesAsFine) {
  const TemporaryFolder folder;
  session().paused = true;
  session().hint = 0;
  frames(3);
  for (const int density : {1, 2, 4}) {
    const std::string path = folder / (std::to_string(density) + ".png");
    session().wishes.save_picture = PictureWish{path, density, false};
    frames(2);
    ASSERT_TRUE(session().notice);
    EXPECT_FALSE(session().notice->is_problem) << session().notice->words;
    const Image image = read_png(path);
    EXPECT_EQ(image.width, 1280 * density);
    EXPECT_EQ(image.height, 800 * density);
  }
  session().wishes.save_picture = PictureWish{folder / "scene.png", 2, true};
  frames(2);
  const Image scene = read_png(folder / "scene.png");
  EXPECT_NEAR(scene.width, 2.0 * screen().scene_size().x, 2.0);
  EXPECT_NEAR(scene.height, 2.0 * screen().scene_size().y, 2.0);
}

TEST_F(SessionTest, APictureShowsNeitherHintNorNoticeNorDialog) {
  const TemporaryFolder folder;
  session().paused = true;
  session().has_handles = false;  // the picture's grips are those of the screen
  point_at(5.0, 795.0);
  frames(8);
  const Image plain = picture();
  session().hint = 0;
  session().notice = Notice{"something", true, 0.0};
  frames(2);
  EXPECT_NE(picture(), plain);
  session().wishes.save_picture = PictureWish{folder / "picture.png", 1, false};
  frames(1);
  const Image saved = read_png(folder / "picture.png");
  ASSERT_EQ(saved.rgb.size(), plain.rgb.size());
  int greatest = 0;
  for (std::size_t i = 0; i < plain.rgb.size(); ++i) {
    greatest = std::max(greatest, std::abs(int{saved.rgb[i]} - int{plain.rgb[i]}));
  }
  // Blending into a renderbuffer rounds otherwise than into the window, by one step.
  EXPECT_LE(greatest, 1);
}

// --- Inputs ------------------------------------------------------------------------------------------------------------

TEST_F(SessionTest, TheInputChangesWhileTheProgramRuns) {
  session().wishes.input = "script";
  frames(3);
  EXPECT_FALSE(session().pointer_moves_goal);
  const Vector<2> early = now().goal;
  frames(60);
  EXPECT_GT(glm::distance(now().goal, early), 0.02) << "the script plays from its beginning";
  session().wishes.input = "mouse";
  frames(3);
  EXPECT_TRUE(session().pointer_moves_goal);
  EXPECT_EQ(now().goal, load_scene("wall45").goal.points.back());
}

// --- Hints -------------------------------------------------------------------------------------------------------------

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
  press(GLFW_KEY_1);
  EXPECT_EQ(session().hint, 1U);
  press(GLFW_KEY_3);
  EXPECT_EQ(session().hint, 2U);
  press(GLFW_KEY_LEFT_BRACKET);
  EXPECT_FALSE(session().hint);
}

TEST_F(SessionTest, HintsAreTheSentencesOfTheDesign) {
  ASSERT_EQ(hint_catalog().size(), 3U);
  EXPECT_EQ(hint_catalog()[0].sentence, "Drag: this is where your hand wants to be.");
  EXPECT_EQ(hint_catalog()[1].sentence, "Press 3. Same hand, same wall.");
  EXPECT_EQ(hint_catalog()[2].sentence, "Turn the arrow.");
}

TEST_F(SessionTest, NobodyIsOfferedHintsUnasked) {
  EXPECT_FALSE(session().hint);
}

// --- Sizes -------------------------------------------------------------------------------------------------------------

TEST_F(SessionTest, EverySizeScaleAndThemeDraws) {
  for (const auto& [width, height] : {std::pair{320, 240}, std::pair{1024, 640}, std::pair{1920, 1080}}) {
    for (const double scale : {0.75, 1.0, 3.0}) {
      for (const Theme& theme : theme_catalog()) {
        open({.look = {.theme = &theme, .scale = scale}, .offers_hints = true}, "fig1", width, height);
        for (const Dialog dialog : {Dialog::help, Dialog::open_scene, Dialog::save_scene, Dialog::save_picture}) {
          session().dialog = theme.dark ? dialog : Dialog::none;
          frames(2);
          EXPECT_EQ(picture().width, width);
        }
      }
    }
  }
}

TEST_F(SessionTest, NumbersDoNotMakeTheLayoutJump) {
  // Widths of what stands beside numbers: the same marks at the same places while the numbers change.
  session().paused = true;
  frames(4);
  const ImVec2 corner = screen().scene_corner();
  const Vector<2> size = screen().scene_size();
  session().settings.impedances = {.k_u = 0.4, .believed_k_u = 900000.0, .k_r = 1e6, .k_t = 0.1, .k_c = 1e9, .chosen_tracking_ratio = {}};
  session().settings.active = StrategyId::anisotropic;
  frames(4);
  EXPECT_EQ(screen().scene_corner().x, corner.x);
  EXPECT_EQ(screen().scene_size(), size);
}

TEST(SavePath, MakesFileNamesOfTitles) {
  EXPECT_EQ(file_stem("A wall at 45 degrees"), "a-wall-at-45-degrees");
  EXPECT_EQ(file_stem("Figure 3: ρ = 1/2"), "figure-3-1-2");
  EXPECT_EQ(file_stem("«»"), "scene");
  EXPECT_EQ(file_stem("../../etc/passwd"), "etc-passwd");
}

}  // namespace
}  // namespace ghostforce
