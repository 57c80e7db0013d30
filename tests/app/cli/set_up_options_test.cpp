#include "app/cli/picture_options.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <CLI/CLI.hpp>

#include "app/base/shell_word.h"
#include "app/state/set_up.h"
#include "app/state/set_up_of.h"
#include "tests/support/long_run.h"
#include "tests/support/program.h"
#include "tests/support/random_set_up.h"
#include "tests/support/set_up_values.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::set_up_options_test {
namespace {

// What `ghostforce run` opens with these words after it, where the face that was used last is another one.
SetUp opened_with(std::vector<std::string> words) {
  CLI::App command;
  FileOptions files;
  SetUpOptions options;
  options.attach(command, files);
  std::ranges::reverse(words);  // as CLI11 takes them
  command.parse(std::move(words));
  return options.set_up(options.scene.load(), Face::workbench);
}

TEST(SetUpOptions, GiveWhatTheLineIsOf) {
  Random random(16);
  const int lines = is_long_run() ? 1000 : 250;
  for (int i = 0; i < lines; ++i) {
    const auto set_up = random_set_up(random);
    const std::string line = set_up_line(set_up);
    std::vector<std::string> words = split_shell_words(line).words;
    words.erase(words.begin(), words.begin() + 2);  // ghostforce run
    ASSERT_EQ(set_up_values(opened_with(words)), set_up_values(set_up)) << line;
  }
}

TEST(SetUpOptions, GetTheLinesWordsFromAShell) {
  Random random(17);
  for (int i = 0; i < 50; ++i) {
    const std::string line = set_up_line(random_set_up(random));
    std::string expected;
    for (const std::string& word : split_shell_words(line).words) expected += word + "\n";
    ASSERT_EQ(run_program("/bin/sh", {"-c", "printf '%s\\n' " + line}).out, expected);
  }
}

TEST(RenderedPicture, SaysWhatItShows) {
  const TemporaryFolder folder;
  const std::string line =
      "ghostforce run wall45 --set user.k_u_N_per_m=150.0 --goal-mm=20,-10 --strategy full --view ";
  for (const std::string face : {"stage", "workbench"}) {
    for (const std::string ending : {"png", "svg", "pdf"}) {
      std::vector<std::string> words = split_shell_words(line + face).words;
      words.erase(words.begin(), words.begin() + 2);
      std::erase(words, "--goal-mm=20,-10");
      words.insert(words.begin(), "render");
      words.insert(words.end(), {"--set", "goal.path_mm=[[-21.213203435596427, 21.213203435596427], [20, -10]]",
                                 "--size", "320x240", "-o"});
      for (const std::string name : {"a.", "b."}) {
        words.push_back(folder / (name + ending));
        ASSERT_EQ(run_ghostforce(words).exit_code, 0);
        words.pop_back();
      }
      EXPECT_EQ(read_whole(folder / ("a." + ending)), read_whole(folder / ("b." + ending)));
      EXPECT_EQ(set_up_line(read_picture_set_up(folder / ("a." + ending))), line + face) << ending;
    }
  }
}

}  // namespace
}  // namespace ghostforce::set_up_options_test
