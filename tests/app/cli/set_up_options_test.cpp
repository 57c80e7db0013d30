#include "app/cli/set_up_options.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <CLI/CLI.hpp>

#include "app/console/shell_word.h"
#include "app/set_up/set_up_line.h"
#include "tests/support/program.h"
#include "tests/support/random_set_up.h"
#include "tests/support/set_up_values.h"

namespace ghostforce {
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
  for (int i = 0; i < 1000; ++i) {
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

}  // namespace
}  // namespace ghostforce
