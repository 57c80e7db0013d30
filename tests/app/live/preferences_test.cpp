// What is remembered from run to run, and that no damaged file stands in the way.
#include "app/live/preferences.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>

#include "app/console/failure.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce {
namespace {

class PreferencesTest : public testing::Test {
 protected:
  PreferencesTest() {
    setenv("XDG_CONFIG_HOME", (folder_ / "config").c_str(), 1);
    setenv("XDG_STATE_HOME", (folder_ / "state").c_str(), 1);
    setenv("HOME", (folder_ / "home").c_str(), 1);
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

TEST_F(PreferencesTest, ReadsBackWhatItWrote) {
  const Preferences written{.appearance = {.theme = find_theme("projector"), .scale = 1.25, .arrow_scale = 1.5},
                            .offers_hints = false,
                            .face = Face::workbench};
  const WindowLayout window{.width = 1024, .height = 640, .is_maximized = true, .folded_panels = {"View", "A \"b\""}};
  save(written);
  save(window);
  const StoredPreferences stored = load_preferences();
  EXPECT_EQ(stored.preferences, written);
  EXPECT_EQ(stored.layout, window);
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
        std::string("\xff\xfe\0garbage", 10)}) {
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
  EXPECT_NE(trouble_with(Preferences{}).find("preferences are kept there"), std::string::npos);
  EXPECT_NE(trouble_with(WindowLayout{}).find("the window's layout is kept there"), std::string::npos);
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
}  // namespace ghostforce
