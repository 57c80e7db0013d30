// What is remembered from run to run, and that no damaged file stands in the way.
#include "app/shell/preferences.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "app/base/failure.h"
#include "app/files/scene_file.h"
#include "app/state/lesson_file.h"
#include "app/state/lesson_guide.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::preferences_test {
namespace {

class PreferencesTest : public testing::Test {
 protected:
  PreferencesTest() {
    setenv("XDG_CONFIG_HOME", (folder_ / "config").c_str(), 1);
    setenv("XDG_STATE_HOME", (folder_ / "state").c_str(), 1);
    setenv("HOME", (folder_ / "home").c_str(), 1);
    setenv("LC_ALL", "C", 1);
  }
  std::string preferences() const { return folder_ / "config/ghostforce/preferences.toml"; }
  std::string layout() const { return folder_ / "state/ghostforce/layout.toml"; }
  void write_preferences(std::string_view text) const {
    std::filesystem::create_directories(folder_ / "config/ghostforce");
    write_whole(preferences(), text);
  }

  TemporaryFolder folder_;
};

TEST_F(PreferencesTest, KnowsNothingAtFirstAndWritesNothingUnasked) {
  const StoredPreferences stored = load_preferences();
  EXPECT_EQ(stored.preferences, Preferences{});
  EXPECT_FALSE(stored.layout);
  EXPECT_TRUE(stored.remarks.empty());
  EXPECT_EQ(folder_.count(), 0);
}

// A part that is added to one of these structs does not compile here until it has a line of its own: either it is
// kept, or it says why it is not.
std::vector<std::function<void(Preferences&)>> changes_of_preferences() {
  Preferences usual;
  [[maybe_unused]] const auto& [appearance, motion, options, plots, spacemouse, face, speed, speaks, hints, language] =
      usual;
  [[maybe_unused]] const auto& [theme, scale, arrow_scale] = appearance;
  [[maybe_unused]] const auto& [compare, ghost_forces, predictions, trails] = options;
  [[maybe_unused]] const auto& [is_open, tab, span_s] = plots;
  // Reach and speed cannot be chosen anywhere.
  [[maybe_unused]] const auto& [mode, up, dead_zone, reach, cap_speed] = spacemouse;
  return {
      [](Preferences& kept) { kept.appearance.theme = find_theme("projector"); },
      [](Preferences& kept) { kept.appearance.scale = 1.25; },
      [](Preferences& kept) { kept.appearance.arrow_scale = 1.0 / 3.0; },
      [](Preferences& kept) { kept.motion = ScreenMotion::reduced; },
      [](Preferences& kept) { kept.options.compare = Compare::active_only; },
      [](Preferences& kept) { kept.options.ghost_forces = false; },
      [](Preferences& kept) { kept.options.predictions = false; },
      [](Preferences& kept) { kept.options.trails = false; },
      [](Preferences& kept) { kept.plots.is_open = true; },
      [](Preferences& kept) { kept.plots.tab = PlotTab::ratio; },
      [](Preferences& kept) { kept.plots.span_s = 0.1; },
      [](Preferences& kept) { kept.spacemouse.mode = SpaceMouseSettings::Mode::rate; },
      [](Preferences& kept) { kept.spacemouse.up = SpaceMouseSettings::Up::push_away; },
      [](Preferences& kept) { kept.spacemouse.dead_zone = 0.07; },
      [](Preferences& kept) { kept.face = Face::workbench; },
      [](Preferences& kept) { kept.speed = 0.02; },
      [](Preferences& kept) { kept.speaks = true; },
      [](Preferences& kept) { kept.offers_hints = false; },
      [](Preferences& kept) { kept.language = "es"; },
  };
}
constexpr int parts_of_preferences = 19;  // counted in the lists above, without reach and speed

Preferences all_other() {
  Preferences preferences;
  for (const auto& change : changes_of_preferences()) change(preferences);
  return preferences;
}

// The same for the session: what is not kept, and why.
void name_the_parts_of_the_session(Session& session) {
  [[maybe_unused]] auto& [
      // Of the scene, which has a file of its own.
      scene, settings,
      // Tones are felt: nobody begins with them who has not asked for them in this run.
      belief_source, measured_k_u,
      // Of this moment.
      time_s,
      // Of the scene again.
      goal,
      // Of this moment: what a hand holds, what a key has just asked for.
      drags_goal, is_editing,
      // KEPT.
      face,
      // A mode is for a moment; the workbench's view and the stage's follow the scene.
      stage,
      // A lesson is begun anew; progress in lessons has a file of its own.
      lesson, lesson_progress, lesson_gone_through,
      // KEPT.
      language,
      // Nothing of a visit is kept.
      kiosk_visit,
      // As the stage.
      shown, pane_views, stage_shown,
      // KEPT; of the plots, what they show is of the moment. What begins with system_ is the system's.
      options, plots, appearance, system_theme, motion, system_reduces_motion,
      // KEPT, in the window's layout.
      folded_panels,
      // Of the front, and of this moment.
      has_room_for_workbench, offers_full_screen, offers_audience, has_audience,
      // Of the front.
      offers_speech,
      // KEPT.
      speaks,
      // Of this moment.
      speech_problem, paused,
      // KEPT.
      speed,
      // Counts of what was asked for.
      steps_asked, restarts_asked, arms_asked, offs_asked, acknowledgements,
      // A person agrees to these anew each time.
      safety,
      // KEPT.
      spacemouse,
      // Of the hand that is measured, and of the wall that is circled.
      aims_at_target, measurement, stiffness_probe, circle_test,
      // A device may be gone, and a line with a set-up must mean the same everywhere.
      injected_fault, input, pointer_moves_goal, hand_is_simulated, has_motors, motors_may_push,
      // Of the device, and of this moment.
      motor_line_turns, zero_poses_confirmed, device_motor,
      // A recording has a new name each time.
      recording_path,
      // Of the window.
      has_handles,
      // KEPT: whether there are any.
      hint,
      // Of this moment.
      dialog, form, notice, preference_resets, dial_turned_s, undo_offer, wanted_input, fits_view,
      ticks_through_history] = session;
  [[maybe_unused]] auto& [is_open, tab, follows, from_s, to_s, cursor_s] = plots;
}

TEST_F(PreferencesTest, EachPartIsReadBackAsItWasWritten) {
  const auto changes = changes_of_preferences();
  ASSERT_EQ(changes.size(), parts_of_preferences);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Preferences written;
    changes[i](written);
    EXPECT_NE(written, Preferences{}) << "change " << i << " changes nothing";
    save(written);
    const StoredPreferences stored = load_preferences();
    EXPECT_EQ(stored.preferences, written) << "change " << i << " is not kept:\n" << read_whole(preferences());
    EXPECT_TRUE(stored.remarks.empty());
  }
  save(all_other());
  EXPECT_EQ(load_preferences().preferences, all_other());
  const std::string text = read_whole(preferences());
  EXPECT_EQ(std::ranges::count(text, '='), 1 + parts_of_preferences) << "a line each, and the format:\n" << text;
}

TEST_F(PreferencesTest, EachPartGoesIntoTheSessionAndBack) {
  for (const auto& change : changes_of_preferences()) {
    Preferences chosen;
    change(chosen);
    Session session = session_of(load_scene("wall45"));
    name_the_parts_of_the_session(session);
    apply(chosen, session);
    if (chosen.language.empty()) chosen.language = "en";  // the environment's
    EXPECT_EQ(preferences_in(session), chosen);
  }
}

TEST_F(PreferencesTest, TheLanguageIsTheOneThatWasChosenOrTheEnvironments) {
  Session session = session_of(load_scene("wall45"));
  setenv("LC_ALL", "es_ES.UTF-8", 1);
  apply(Preferences{}, session);
  EXPECT_EQ(session.language, "es");
  PreferenceKeeper keeper(Preferences{}, session);
  keeper.keep(session);
  EXPECT_FALSE(std::filesystem::exists(preferences())) << "nobody has chosen it";
  session.language = "en";
  keeper.keep(session);
  EXPECT_EQ(load_preferences().preferences.language, "en");
  apply(load_preferences().preferences, session);
  EXPECT_EQ(session.language, "en");
}

TEST_F(PreferencesTest, VisitorsGetWhatWasChosenForTheMachine) {
  const Preferences chosen = all_other();
  const StoredPreferences visitors =
      for_visitors({.preferences = chosen, .layout = WindowLayout{.width = 1024}, .remarks = {"damaged"}});
  Preferences expected;
  expected.appearance.theme = chosen.appearance.theme;
  expected.appearance.scale = chosen.appearance.scale;
  expected.motion = chosen.motion;
  expected.language = chosen.language;
  expected.offers_hints = false;
  EXPECT_EQ(visitors.preferences, expected);
  EXPECT_EQ(visitors.layout, WindowLayout{.is_full_screen = true});
  EXPECT_EQ(visitors.remarks.size(), 1U);
}

TEST_F(PreferencesTest, PlotsThatFollowThePresentAreNoChange) {
  Session session = session_of(load_scene("wall45"));
  session.plots.set_span(0.1);
  PreferenceKeeper keeper(Preferences{}, session);
  for (int i = 0; i < 1000; ++i) {
    session.plots.to_s += 1.0 / 60.0;
    session.plots.from_s += 1.0 / 60.0;
    keeper.keep(session);
  }
  EXPECT_FALSE(std::filesystem::exists(preferences()));
}

TEST_F(PreferencesTest, TheLayoutIsReadBackAsItWasWritten) {
  const WindowLayout usual;
  [[maybe_unused]] const auto& [width, height, is_maximized, is_full_screen, folded_panels] = usual;
  for (const WindowLayout& window :
       {WindowLayout{.width = 1024}, WindowLayout{.height = 640}, WindowLayout{.is_maximized = true},
        WindowLayout{.is_full_screen = true}, WindowLayout{.folded_panels = {"View", "A \"b\""}}}) {
    save(window);
    EXPECT_EQ(load_preferences().layout, window);
  }
}

TEST_F(PreferencesTest, WhatTheCommandLineAskedForHoldsForItsRunOnly) {
  const Preferences stored{.appearance = {.theme = find_theme("projector"), .scale = 1.5}, .language = "es"};
  save(stored);
  Session session = session_of(load_scene("wall45"));
  apply(stored, session);
  session.appearance.theme = find_theme("dark");  // --theme dark
  session.face = Face::workbench;
  PreferenceKeeper keeper(stored, session);
  keeper.keep(session);
  EXPECT_EQ(load_preferences().preferences, stored) << "nothing was chosen";
  session.options.trails = false;
  keeper.keep(session);
  Preferences expected = stored;
  expected.options.trails = false;
  EXPECT_EQ(load_preferences().preferences, expected);
  session.appearance.theme = find_theme("light");
  session.hint.reset();
  keeper.keep(session);
  expected.appearance.theme = find_theme("light");
  expected.offers_hints = false;
  EXPECT_EQ(load_preferences().preferences, expected);
}

TEST_F(PreferencesTest, TwoWindowsKeepWhatTheOtherHasChosen) {
  Session first = session_of(load_scene("wall45"));
  Session second = first;
  PreferenceKeeper keeper_of_first({}, first);
  PreferenceKeeper keeper_of_second({}, second);
  first.appearance.theme = find_theme("dark");
  keeper_of_first.keep(first);
  second.speed = 0.5;
  keeper_of_second.keep(second);
  EXPECT_EQ(load_preferences().preferences, (Preferences{.appearance = {.theme = find_theme("dark")}, .speed = 0.5}));
  // What the first has chosen goes on to be the first's; a reset is for both.
  apply(Preferences{}, first);
  ++first.preference_resets;
  keeper_of_first.keep(first);
  second.motion = ScreenMotion::reduced;
  keeper_of_second.keep(second);
  EXPECT_EQ(load_preferences().preferences, Preferences{.motion = ScreenMotion::reduced});
}

// It has the stage and the usual speed, whatever the person likes.
TEST_F(PreferencesTest, ALessonChangesNone) {
  Session session = session_of(load_scene("wall45"));
  session.face = Face::workbench;
  session.speed = 0.1;
  const Preferences before = preferences_in(session);
  begin_lesson(session, std::make_shared<const Lesson>(load_lesson("ghost")));
  EXPECT_NE(session.face, before.face);
  EXPECT_EQ(preferences_in(session), before);
}

// They come back with its end.
TEST_F(PreferencesTest, ALessonHoldsItsStageWhateverIsPreferred) {
  Session session = session_of(load_scene("wall45"));
  session.face = Face::stage;
  begin_lesson(session, std::make_shared<const Lesson>(load_lesson("ghost")));
  const Preferences preferred{.face = Face::workbench, .speed = 0.25};
  apply(preferred, session);
  EXPECT_EQ(session.face, Face::stage);
  EXPECT_EQ(session.speed, 1.0);
  EXPECT_EQ(preferences_in(session).face, Face::workbench);
  leave_lesson(session);
  EXPECT_EQ(session.face, Face::workbench);
  EXPECT_EQ(session.speed, 0.25);
}

// Also what the command line hides, and what only a newer program knows.
TEST_F(PreferencesTest, AResetForgetsEverything) {
  save(all_other());
  write_whole(preferences(), read_whole(preferences()) + "[novelty]\nx = 1\n");
  Session session = session_of(load_scene("wall45"));
  apply(all_other(), session);
  session.appearance.theme = find_theme("light");  // --theme light
  PreferenceKeeper keeper(all_other(), session);
  apply(Preferences{}, session);
  ++session.preference_resets;
  save(WindowLayout{.width = 1024});
  keeper.keep(session);
  EXPECT_EQ(load_preferences().preferences, Preferences{});
  EXPECT_FALSE(load_preferences().layout);
  session.speed = 0.5;
  keeper.keep(session);
  EXPECT_EQ(load_preferences().preferences, Preferences{.speed = 0.5});
  EXPECT_EQ(read_whole(preferences()).find("novelty"), std::string::npos);
}

TEST_F(PreferencesTest, WhatANewerProgramWroteOutlivesAnOlderOne) {
  write_preferences("scale = 2.0\nnovelty = 1\n[more]\nx = \"two words\"\n[more.still]\ny = [1, 2]\n");
  Preferences preferences = load_preferences().preferences;
  for (const double scale : {1.0, 1.5}) {
    preferences.appearance.scale = scale;
    save(preferences);
    EXPECT_EQ(load_preferences().preferences, preferences);
    const std::string text = read_whole((folder_ / "config/ghostforce/preferences.toml"));
    for (const char* words : {"\nnovelty = 1\n", "[more]\n", "x = 'two words'", "y = [ 1, 2 ]"}) {
      EXPECT_NE(text.find(words), std::string::npos) << words << " in\n" << text;
    }
  }
}

TEST_F(PreferencesTest, FallsBackToTheHomeFolder) {
  unsetenv("XDG_CONFIG_HOME");
  setenv("XDG_STATE_HOME", "relative/paths/are/ignored", 1);
  save(Preferences{});
  save(WindowLayout{});
  EXPECT_TRUE(std::filesystem::exists(folder_ / "home/.config/ghostforce/preferences.toml"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "home/.local/state/ghostforce/layout.toml"));
}

TEST_F(PreferencesTest, WithoutAHomeNothingIsRememberedAndNothingFails) {
  for (const char* name : {"XDG_CONFIG_HOME", "XDG_STATE_HOME", "HOME"}) unsetenv(name);
  save(Preferences{});
  EXPECT_EQ(load_preferences().preferences, Preferences{});
}

TEST_F(PreferencesTest, DamagedFilesAreSetAsideOneByOne) {
  int number = 0;
  for (const std::string& text :
       {std::string("theme = "), std::string("theme = \"pink\""), std::string("theme = 3"), std::string("scale = 99.0"),
        std::string("scale = nan"), std::string("scale = \"2\""), std::string("scale = true"),
        std::string("hints = \"yes\""), std::string("view = \"bench\""), std::string("view = 1"),
        std::string("compare = \"none\""), std::string("plots_span_s = 0"), std::string("speed = 2"),
        std::string("language = \"../es\""), std::string("language = \"spa\""),
        std::string("spacemouse_dead_zone = -1"), std::string("\xff\xfe\0garbage", 10)}) {
    write_preferences(text);
    const StoredPreferences stored = load_preferences();
    EXPECT_EQ(stored.preferences, Preferences{}) << text;
    ASSERT_EQ(stored.remarks.size(), 1U) << text;
    EXPECT_NE(stored.remarks[0].find("damaged"), std::string::npos) << stored.remarks[0];
    ++number;
    std::string aside = preferences() + ".damaged";
    if (number > 1) aside.append("-").append(std::to_string(number));
    EXPECT_EQ(read_whole(aside), text) << "nothing is lost";
    EXPECT_FALSE(std::filesystem::exists(preferences()));
  }
}

TEST_F(PreferencesTest, AllThatIsDamagedIsSaidWithItsLine) {
  write_preferences("theme = \"pink\"\nscale = 99\n");
  const StoredPreferences stored = load_preferences();
  ASSERT_EQ(stored.remarks.size(), 1U);
  EXPECT_NE(stored.remarks[0].find("(line 1: the key theme: 'pink' is not one of light, dark, projector; "
                                   "line 2: the key scale: 99 is out of range; give 0.75 to 3)"),
            std::string::npos)
      << stored.remarks[0];
}

TEST_F(PreferencesTest, WhatANewerProgramWroteIsLeftAlone) {
  write_preferences("scale = 2.0\nnovelty = 1\n[more]\nx = 1\n");
  EXPECT_EQ(load_preferences().preferences.appearance.scale, 2.0);
  EXPECT_TRUE(load_preferences().remarks.empty());
}

TEST_F(PreferencesTest, ADamagedLayoutLeavesThePreferencesAlone) {
  save(Preferences{.appearance = {.theme = find_theme("dark")}, .offers_hints = false});
  std::filesystem::create_directories(folder_ / "state/ghostforce");
  for (const char* text : {"width = 0", "height = 1e9", "folded = 3", "folded = [3]", "width = -5", "maximized = 1"}) {
    write_whole(layout(), text);
    const StoredPreferences stored = load_preferences();
    EXPECT_FALSE(stored.layout) << text;
    EXPECT_EQ(stored.preferences.appearance.theme->name, "dark");
    EXPECT_EQ(stored.remarks.size(), 1U) << text;
  }
}

TEST_F(PreferencesTest, MissingKeysKeepTheirUsualValue) {
  write_preferences("scale = 2.0\n");
  const StoredPreferences stored = load_preferences();
  EXPECT_EQ(stored.preferences.appearance.scale, 2.0);
  EXPECT_EQ(stored.preferences.appearance.theme, Preferences{}.appearance.theme);
  EXPECT_TRUE(stored.remarks.empty());
}

TEST_F(PreferencesTest, TheStageIsFirstUntilTheWorkbenchWasLeftLast) {
  EXPECT_EQ(load_preferences().preferences.face, Face::stage);
  for (const FaceEntry& entry : face_catalog) {
    save(Preferences{.face = entry.id});
    EXPECT_EQ(load_preferences().preferences.face, entry.id);
    EXPECT_NE(read_whole(preferences()).find("view = \"" + std::string(entry.name) + "\"\n"), std::string::npos);
  }
}

TEST_F(PreferencesTest, AWholeNumberIsANumber) {
  write_preferences("scale = 2\n");
  const StoredPreferences stored = load_preferences();
  EXPECT_EQ(stored.preferences.appearance.scale, 2.0);
  EXPECT_TRUE(stored.remarks.empty());
}

TEST_F(PreferencesTest, NoWindowIsSmallerThanTheSmallest) {
  std::filesystem::create_directories(folder_ / "state/ghostforce");
  write_whole(layout(), "width = 100\nheight = 1\n");
  const StoredPreferences stored = load_preferences();
  EXPECT_EQ(stored.layout, (WindowLayout{.width = 480, .height = 360}));
  EXPECT_TRUE(stored.remarks.empty());
}

// What went wrong, in words for a person; empty where nothing did.
template <typename Value>
std::string trouble_with(const Value& value) {
  try {
    save(value);
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), ExitCode::file_trouble);
    return failure.what();
  }
  return "";
}

TEST_F(PreferencesTest, WhatCannotBeWrittenIsSaid) {
  write_whole(folder_ / "config", "a file where a folder should be");
  write_whole(folder_ / "state", "another");
  EXPECT_NE(trouble_with(Preferences{}).find(", so preferences are not kept"), std::string::npos);
  EXPECT_NE(trouble_with(WindowLayout{}).find(", so the window's layout is not kept"), std::string::npos);
}

TEST_F(PreferencesTest, APipeHoldsNothingUp) {
  std::filesystem::create_directories(folder_ / "state/ghostforce");
  ASSERT_EQ(mkfifo(layout().c_str(), 0600), 0);
  EXPECT_FALSE(load_preferences().layout);
  const std::string trouble = trouble_with(WindowLayout{});
  EXPECT_NE(trouble.find("layout.toml is a pipe"), std::string::npos) << trouble;
  EXPECT_NE(trouble.find("remove it"), std::string::npos) << trouble;
  std::filesystem::remove(layout());
  std::filesystem::create_directory(layout());
  EXPECT_NE(trouble_with(WindowLayout{}).find("is a folder"), std::string::npos);
}

TEST_F(PreferencesTest, ALinkToAFileIsAFile) {
  std::filesystem::create_directories(folder_ / "state/ghostforce");
  std::filesystem::create_symlink(folder_ / "kept.toml", layout());
  for (const int width : {600, 700}) {  // the file is not there at first
    EXPECT_EQ(trouble_with(WindowLayout{.width = width}), "");
    EXPECT_EQ(load_preferences().layout, WindowLayout{.width = width});
  }
  EXPECT_TRUE(std::filesystem::is_symlink(layout()));
  EXPECT_TRUE(std::filesystem::is_regular_file(folder_ / "kept.toml"));
}

// Nothing lies at the beginning of a process's memory: a true error of reading, EIO.
TEST_F(PreferencesTest, WhatCannotBeReadIsSaidAndStaysAsItIs) {
  std::filesystem::create_directories(folder_ / "config/ghostforce");
  std::filesystem::create_directories(folder_ / "state/ghostforce");
  for (const std::string& file : {preferences(), layout()}) std::filesystem::create_symlink("/proc/self/mem", file);
  const StoredPreferences stored = load_preferences();
  EXPECT_EQ(stored.preferences, Preferences{});
  EXPECT_FALSE(stored.layout);
  ASSERT_EQ(stored.remarks.size(), 2U);
  EXPECT_TRUE(stored.remarks[0].starts_with(preferences() + " cannot be read (")) << stored.remarks[0];
  EXPECT_TRUE(stored.remarks[0].ends_with(", so the defaults are used; the file stays as it is"));
  for (const std::string& trouble : {trouble_with(Preferences{}), trouble_with(WindowLayout{})}) {
    EXPECT_NE(trouble.find(" stays as it is"), std::string::npos) << trouble;
    EXPECT_NE(trouble.find("repair or remove it"), std::string::npos) << trouble;
  }
  for (const std::string& file : {preferences(), layout()}) {
    EXPECT_EQ(std::filesystem::read_symlink(file), "/proc/self/mem");
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_ / "config/ghostforce"), {}), 1);
}

}  // namespace
}  // namespace ghostforce::preferences_test
