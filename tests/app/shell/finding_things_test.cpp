// Finding things on the workbench: the scene picker, the bars, the help, the clipboard.
#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <imgui_internal.h>

#include "app/files/shipped_scenes.h"
#include "app/picture/glossary.h"
#include "app/shell/preferences.h"
#include "app/state/live_table.h"
#include "app/state/mode_changes.h"
#include "app/state/undo.h"
#include "app/workbench/bars.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::finding_things_test {
namespace {

// In a rectangle of the window.
int count_pixels(const Image& image, Colour colour, ImVec2 least, ImVec2 most) {
  int count = 0;
  for (int y = static_cast<int>(least.y); y < static_cast<int>(most.y); ++y) {
    for (int x = static_cast<int>(least.x); x < static_cast<int>(most.x); ++x) count += pixel(image, x, y) == colour;
  }
  return count;
}

class FindingThings : public DrivenWindow {
 protected:
  void open_at(int width, int height, double scale, const std::string& input = std::string(mouse_hand.name)) {
    ApplicationOptions options;
    options.input = input;
    options.input_options.virtual_falcon_clock = VirtualLink::Clock::stepped;
    options.appearance.scale = scale;
    open(options, "wall45", width, height);
  }
  static ImGuiWindow& window_named(const char* name) {
    ImGuiWindow* const window = ImGui::FindWindowByName(name);
    if (window == nullptr) throw std::runtime_error(fmt::format("there is no window {}", name));
    return *window;
  }
  static ImGuiID hovered() { return ImGui::GetCurrentContext()->HoveredId; }
  // Where the pointer finds what, along the middle of each row of the bar on top.
  std::map<ImGuiID, Vector<2>> things_in_bar() {
    std::map<ImGuiID, Vector<2>> found;
    const double scale = session().appearance.scale;
    const ImGuiWindow& bar = window_named("strategies");
    for (double y = 23.0 * scale; y < static_cast<double>(bar.Size.y); y += 35.0 * scale) {
      for (double x = 4.0; x < static_cast<double>(bar.Size.x); x += 8.0 * scale) {
        point_at(x, y);
        frames(2, 0);
        if (hovered() != 0) found.try_emplace(hovered(), x + 4.0 * scale, y);
      }
    }
    return found;
  }
  void click_on(const char* window, const char* name) {
    const ImGuiID id = window_named(window).GetID(name);
    const std::map<ImGuiID, Vector<2>> found = things_in_bar();
    ASSERT_TRUE(found.contains(id)) << name;
    click_at(found.at(id).x, found.at(id).y);
  }
  std::string clipboard() {
    const char* const text = glfwGetClipboardString(window_->handle());
    return text != nullptr ? text : "";
  }
};

// --- The picker ------------------------------------------------------------------------------------------------------

TEST_F(FindingThings, ThePickerOpensTheSceneThatTheArrowsHaveMarked) {
  press(key::o, modifier::control);
  ASSERT_EQ(session().dialog, Dialog::open_scene);
  ASSERT_EQ(session().form.marked_scene, shipped_scenes().size() - 1) << "wall45 is open, and comes last";
  const Vector<2> goal = session().goal;
  press(key::up);
  press(key::left);
  EXPECT_EQ(session().form.marked_scene, shipped_scenes().size() - 5) << "a row of three and one more";
  EXPECT_EQ(session().goal, goal) << "the arrows are the picker's";
  const std::string title = shipped_scenes()[session().form.marked_scene].scene.title;
  press(key::enter);
  EXPECT_EQ(session().scene->title, title);
  EXPECT_EQ(session().dialog, Dialog::none);
  EXPECT_EQ(session().undo_offer.undo, "opening “" + title + "”");
}

TEST_F(FindingThings, ThePickerTellsAPersonsSceneFromTheOneItWasMadeFrom) {
  const TemporaryFolder folder;
  const std::string path = folder / "mine.toml";
  session().settings.stiffnesses.k_r = 750.0;
  act(SaveScene{path});
  frames(2);
  act(OpenScene{path});
  frames(2);
  const Scene wall45 = load_scene("wall45");
  ASSERT_EQ(session().scene->title, wall45.title);
  ASSERT_FALSE(*session().scene == wall45);
  press(key::o, modifier::control);
  frames(3);
  EXPECT_FALSE(says("Open now"));
  press(key::enter);
  EXPECT_TRUE(*session().scene == wall45) << "Enter opens what is marked: that title";
  press(key::o, modifier::control);
  frames(3);
  EXPECT_TRUE(says("Open now"));
  const std::shared_ptr<const Scene> open = session().scene;
  press(key::enter);
  EXPECT_EQ(session().scene, open) << "what has been changed in it stays";
  EXPECT_EQ(session().dialog, Dialog::none);
}

TEST_F(FindingThings, ThePickerShowsAPictureOfEachSceneInEachTheme) {
  draw_every_frame();
  for (const Theme& theme : theme_catalog()) {
    session().appearance.theme = &theme;
    press(key::o, modifier::control);
    frames(3);
    const ImGuiWindow& dialog = window_named("Open a scene");
    const Image shown = picture();
    // The goal of each is in its picture, and nothing else in the dialog has that colour: nine discs of some pixels.
    EXPECT_GT(count_pixels(shown, theme.goal, dialog.Rect().Min, dialog.Rect().Max), 9 * 10) << theme.name;
    EXPECT_GT(count_pixels(shown, theme.wall, dialog.Rect().Min, dialog.Rect().Max), 9 * 1000) << theme.name;
    press(key::escape);
  }
}

TEST_F(FindingThings, ThePickerIsWholeInASmallWindowOfLargeLetters) {
  open_at(1024, 640, 2.0);
  press(key::o, modifier::control);
  frames(3);
  for (std::size_t i = 0; i < shipped_scenes().size(); ++i) {
    const ImGuiWindow& dialog = window_named("Open a scene");
    EXPECT_GE(dialog.Rect().Min.y, 0.0F);
    EXPECT_LE(dialog.Rect().Max.y, 640.0F);
    EXPECT_EQ(dialog.ScrollMax.y, 0.0F) << "only the scenes scroll";
    press(key::up);
    frames(2);
  }
  EXPECT_EQ(session().form.marked_scene, 0U);
  // The first of the scenes has come into sight.
  const auto& windows = ImGui::GetCurrentContext()->Windows;
  const auto scenes = std::ranges::find_if(windows, [](const ImGuiWindow* window) {
    return std::string_view(window->Name).starts_with("Open a scene/scenes");
  });
  ASSERT_NE(scenes, windows.end());
  EXPECT_GT((*scenes)->ScrollMax.y, 0.0F);
  EXPECT_LT((*scenes)->Scroll.y, 40.0F);
}

TEST_F(FindingThings, APathThatCannotBeOpenedStaysInThePickerWithTheReasonAndASuggestion) {
  press(key::o, modifier::control);
  type("fig3-norml");
  const Session before = session();
  press(key::enter);
  EXPECT_EQ(session().dialog, Dialog::open_scene);
  EXPECT_EQ(session().form.path, "fig3-norml");
  EXPECT_NE(session().form.problem.find("no scene named"), std::string::npos) << session().form.problem;
  EXPECT_EQ(session().form.suggestion, "fig3-normal");
  EXPECT_FALSE(session().notice);
  // What is typed on is typed into the field: 3 and Space would be another strategy and a pause.
  type("3 w");
  press(key::digit_3);
  press(key::space);
  press(key::left_bracket);
  EXPECT_EQ(session().settings, before.settings);
  EXPECT_FALSE(session().paused);
  EXPECT_EQ(session().form.path, "3 w") << "what was wrong is marked, and typed over";
}

TEST_F(FindingThings, TheSuggestionOpensWithAClick) {
  press(key::o, modifier::control);
  type("fig3-norml");
  press(key::enter);
  frames(3);
  const ImGuiWindow& dialog = window_named("Open a scene");
  const ImGuiID id = window_named("Open a scene").GetID("###suggestion");
  for (float y = dialog.Rect().Max.y; session().dialog != Dialog::none && y > dialog.Rect().Min.y; y -= 6.0F) {
    point_at(static_cast<double>(dialog.Rect().Min.x) + 60.0, static_cast<double>(y));
    frames(2);
    if (hovered() == id) click_at(static_cast<double>(dialog.Rect().Min.x) + 60.0, static_cast<double>(y));
  }
  EXPECT_EQ(session().scene->title, load_scene("fig3-normal").title);
  EXPECT_EQ(session().dialog, Dialog::none);
}

TEST_F(FindingThings, AFileWithAMistakeIsReportedInThePickerAndOpensOnceItIsMended) {
  const TemporaryFolder folder;
  const std::string path = folder / "mine.toml";
  write_whole(path, "format = 1\nnonsense = 2\n");
  press(key::o, modifier::control);
  type(path);
  press(key::enter);
  EXPECT_NE(session().form.problem.find("nonsense"), std::string::npos) << session().form.problem;
  EXPECT_EQ(session().form.path, path);
  Scene scene = load_scene("fig1");
  scene.title = "Mine";
  write_whole(path, scene_text(scene));
  press(key::enter);
  EXPECT_EQ(session().scene->title, "Mine");
  EXPECT_EQ(session().dialog, Dialog::none);
}

// --- The bars --------------------------------------------------------------------------------------------------------

TEST_F(FindingThings, EverythingInTheBarIsUnderThePointerAtEverySize) {
  struct Case {
    int width;
    int height;
    double scale;
    std::string input;
  };
  for (const Case& c :
       {Case{1024, 640, 1.0, "virtual-falcon"}, Case{1280, 800, 1.0, "virtual-falcon"}, Case{1024, 640, 1.0, "mouse"},
        Case{1024, 640, 2.0, "virtual-falcon"}, Case{1920, 1080, 2.0, "virtual-falcon"}}) {
    open_at(c.width, c.height, c.scale, c.input);
    const std::map<ImGuiID, Vector<2>> found = things_in_bar();
    ImGuiWindow& bar = window_named("strategies");
    std::vector<ImGuiID> wanted;
    for (int i = 0; i < 3; ++i) wanted.push_back(ImHashStr("strategy", 0, ImHashData(&i, sizeof i, bar.ID)));
    for (const char* const name : {"##compare", "##pause", "##back", "##step", "##reset", "##speed", "##record",
                                   "##undo", "##redo", "Stage (F4)"}) {
      wanted.push_back(bar.GetID(name));
    }
    if (c.input != "mouse") wanted.push_back(bar.GetID("###motors"));
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      EXPECT_TRUE(found.contains(wanted[i])) << i << " at " << c.width << ", scale " << c.scale;
    }
  }
}

TEST_F(FindingThings, UndoAndRedoAreButtonsThatSayWhatTheyChange) {
  EXPECT_EQ(session().undo_offer.undo, "");
  session().settings.stiffnesses.k_r = 900.0;
  frames(2);
  EXPECT_EQ(session().undo_offer.undo, "k_r");
  click_on("strategies", "##undo");
  EXPECT_EQ(session().settings.stiffnesses.k_r, 600.0);
  EXPECT_EQ(session().undo_offer.undo, "");
  EXPECT_EQ(session().undo_offer.redo, "k_r");
  EXPECT_EQ(notice(), "Undone: k_r.");
  click_on("strategies", "##redo");
  EXPECT_EQ(session().settings.stiffnesses.k_r, 900.0);
  EXPECT_EQ(notice(), "Redone: k_r.");
}

TEST_F(FindingThings, TheWordsOfUndoNameOneChangeOrTwo) {
  const auto scene = std::make_shared<const Scene>(load_scene("wall45"));
  const UndoState before{scene, scene->settings};
  UndoState after = before;
  after.settings.actuated_angle += 1.0;
  EXPECT_EQ(words_of_change(before, after), "the actuated direction");
  after.settings.active = StrategyId::full;
  EXPECT_EQ(words_of_change(before, after), "the strategy and the actuated direction");
  after.settings.stiffnesses.k_u = 1.0;
  EXPECT_EQ(words_of_change(before, after), "several settings");
}

// The stage knows no goal, no device and no k_r.
TEST_F(FindingThings, OnTheStageUndoSpeaksAsTheStageDoes) {
  act(ShowFace{Face::stage});
  frames(2);
  session().settings.stiffnesses.k_r = session().settings.stiffnesses.k_t = 900.0;
  frames(2);
  act(Undo{});
  frames(2);
  EXPECT_EQ(notice(), "Undone: the wall's stiffness.");
  session().settings.actuated_angle += 1.0;
  session().goal.x += 0.001;
  frames(2);
  session().language = "es";
  act(Undo{});
  frames(2);
  EXPECT_EQ(notice(), "Deshecho: el lugar de la mano y la dirección del motor.");
}

TEST_F(FindingThings, UndoTakesTheLandscapesDialBackToo) {
  act(ShowFace{Face::stage});
  act(ChooseStrategy{StrategyId::naive});
  act(ToggleMode{StageMode::landscape});
  frames(2);
  act(TurnLandscapeDial{0.9});
  frames(2);
  EXPECT_EQ(dragged_landscape_dial(session()), 0.9);
  act(Undo{});
  frames(2);
  EXPECT_EQ(session().settings.active, StrategyId::naive);
  EXPECT_FALSE(dragged_landscape_dial(session()));
  act(Redo{});
  frames(2);
  EXPECT_EQ(dragged_landscape_dial(session()), 0.9);
}

// News, such as what was undone, go by themselves.
TEST_F(FindingThings, EscapeLeavesAModeThoughThereAreNews) {
  act(ShowFace{Face::stage});
  for (const bool is_problem : {false, true}) {
    act(ToggleMode{StageMode::why});
    session().notice = Notice{"something", is_problem};
    act(Escape{});
    EXPECT_FALSE(session().notice);
    EXPECT_EQ(session().stage.mode, is_problem ? StageMode::why : StageMode::none);
  }
}

TEST_F(FindingThings, ButtonsStepBackAndOnAndLeadToTheStage) {
  click_on("strategies", "##back");
  EXPECT_TRUE(session().stage.looks_back_to_s);
  click_on("strategies", "##step");
  EXPECT_TRUE(session().paused);
  click_on("strategies", "Stage (F4)");
  EXPECT_EQ(session().face, Face::stage);
}

TEST_F(FindingThings, PausedIsSaidInLargeLetters) {
  const ImGuiWindow& caption = window_named("caption");
  const Colour accent = session().appearance.theme->accent;
  const auto letters = [&] { return count_pixels(picture(), accent, caption.Rect().Min, caption.Rect().Max); };
  ASSERT_EQ(letters(), 0);
  press(key::space);
  EXPECT_GT(letters(), 300);
  press(key::space);
  EXPECT_EQ(letters(), 0);
}

TEST_F(FindingThings, NoColumnOfPixelsIsLeftOverAtTheEdges) {
  for (const auto& [width, height, scale] :
       {std::tuple{1280, 800, 1.0}, std::tuple{1024, 640, 1.0}, std::tuple{1279, 801, 1.05},
        std::tuple{1366, 768, 1.25}, std::tuple{1024, 640, 2.0}}) {
    open_at(width, height, scale);
    for (const bool has_plots : {false, true}) {
      session().plots.is_open = has_plots;
      frames(3);
      const Image shown = picture();
      const auto right = static_cast<float>(width);
      const auto bottom = static_cast<float>(height);
      const Colour panel = session().appearance.theme->panel;
      EXPECT_EQ(count_pixels(shown, panel, {right - 1.0F, 0.0F}, {right, bottom}), height) << width << ' ' << scale;
      EXPECT_EQ(count_pixels(shown, panel, {0.0F, bottom - 1.0F}, {right, bottom}), width) << width << ' ' << scale;
    }
  }
}

TEST(StatusBar, IsQuietWhenAllIsWell) {
  const Settings settings = load_scene("wall45").settings;
  LoopReading loop;
  loop.rate_hz = 1000.0;
  loop.refused_by_system = "no real-time priority";
  loop.late_ticks = 1089;
  loop.late_ticks_lately = 10;  // of the 10,000 of ten seconds
  EXPECT_TRUE(troubles_of(loop, settings).empty());
}

TEST(StatusBar, SaysWhatIsWrongAndWhatToDo) {
  const Settings settings = load_scene("wall45").settings;
  LoopReading loop;
  loop.late_ticks_lately = 11;
  ASSERT_EQ(troubles_of(loop, settings).size(), 1U);
  EXPECT_EQ(troubles_of(loop, settings)[0], "11 ticks late in 10 s: close other programs");
  loop.refused_by_system = "no real-time priority";
  EXPECT_EQ(troubles_of(loop, settings).size(), 2U);
  loop.dropped_samples = 3;
  EXPECT_EQ(troubles_of(loop, settings).size(), 3U);
  loop.diverged = true;
  EXPECT_EQ(troubles_of(loop, settings).size(), 1U) << "the rest follows from it";
}

// --- The clipboard ---------------------------------------------------------------------------------------------------

TEST_F(FindingThings, TheLiveValuesAreCopiedAsATable) {
  press(key::space);
  press(key::c, modifier::control | modifier::shift);
  EXPECT_EQ(clipboard(), live_table(now()));
  ASSERT_TRUE(session().notice);
  EXPECT_FALSE(is_problem());
}

TEST(LiveTable, HasUnitsInItsHeadAndALineForEachStrategy) {
  Snapshot snapshot;
  snapshot.strategies[index_of(StrategyId::naive)].force = {-3.0, 4.0};
  snapshot.strategies[index_of(StrategyId::anisotropic)].energy = -0.0125;
  const auto& q = quantity_catalog();
  const std::string head =
      fmt::format("strategy\t{} [N]\t{} [N]\t{} [mm]\t{} [mJ]\n", q[0].title, q[1].title, q[2].title, q[3].title);
  EXPECT_EQ(live_table(snapshot),
            head + "Fully actuated\t0\t0\t0\t0\nNaïve\t5\t0\t0\t0\nAnisotropic\t0\t0\t0\t-12.5\n");
  snapshot.measured = StrategyId::naive;
  EXPECT_EQ(live_table(snapshot), head + "Fully actuated\t0\t\t\t0\nNaïve\t5\t\t\t0\nAnisotropic\t0\t\t\t-12.5\n");
}

TEST(LiveTable, SaysThatNumbersAreRelativeToATarget) {
  Snapshot snapshot;
  snapshot.measured = StrategyId::naive;
  snapshot.has_target = true;
  snapshot.strategies[index_of(StrategyId::naive)].ghost_force = {-3.0, 4.0};
  EXPECT_EQ(live_table(snapshot),
            "strategy\tforce [N]\tghost force relative to the target [N]\tdrift relative to the target [mm]\tenergy "
            "[mJ]\nFully actuated\t0\t\t\t0\nNaïve\t0\t5\t0\t0\nAnisotropic\t0\t\t\t0\n");
}

TEST_F(FindingThings, APictureThatCannotBeCopiedSaysWhy) {
  press(key::p, modifier::control | modifier::shift);
  EXPECT_TRUE(is_problem()) << "there is no desktop in a test";
}

TEST_F(FindingThings, AllPreferencesAreResetAfterAQuestion) {
  open({.appearance = {.theme = find_theme("dark"), .scale = 1.5}, .face = Face::workbench, .folded_panels = {"View"}},
       "wall45", 1024, 700);
  session().settings.stiffnesses.k_r = 321.0;
  session().plots.is_open = true;
  session().dialog = Dialog::reset_preferences;
  frames(3);
  ImGui::ActivateItemByID(window_named("###reset").GetID("Cancel"));
  frames(4);
  EXPECT_EQ(session().dialog, Dialog::none);
  EXPECT_TRUE(session().plots.is_open) << "a question that is declined changes nothing";
  session().dialog = Dialog::reset_preferences;
  frames(3);
  ImGui::ActivateItemByID(window_named("###reset").GetID("Reset all"));
  frames(4);
  EXPECT_EQ(session().dialog, Dialog::none);
  EXPECT_EQ(preferences_in(session()), Preferences{.language = session().language}) << "the environment's";
  EXPECT_EQ(session().hint, 0U);
  EXPECT_EQ(session().preference_resets, 1U);
  EXPECT_EQ(session().folded_panels, panels_folded_at_first(WindowLayout::first_height));
  EXPECT_EQ(window_->restored_size().width, WindowLayout::first_width);
  EXPECT_EQ(window_->restored_size().height, WindowLayout::first_height);
  EXPECT_EQ(session().settings.stiffnesses.k_r, 321.0) << "that is the scene's";
  ASSERT_TRUE(session().notice);
  EXPECT_FALSE(is_problem());
}

}  // namespace
}  // namespace ghostforce::finding_things_test
