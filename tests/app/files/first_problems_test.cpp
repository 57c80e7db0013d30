// That a file which is wrong from end to end is told of from its beginning, and costs no more than its reading.
#include "app/files/read_error.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/files/falcon_calibration_file.h"
#include "app/files/scene_file.h"

namespace ghostforce::first_problems_test {
namespace {

std::vector<std::string> lines_of(const ProblemList<int>& problems) {
  std::vector<std::string> lines;
  const std::size_t more =
      problems.tell([&](int place, const std::string& words) { lines.push_back(fmt::format("{}: {}", place, words)); });
  if (more > 0) lines.push_back(fmt::format("… and {} more", more));
  return lines;
}

TEST(ProblemList, AreToldInTheirOrder) {
  ProblemList<int> problems;
  EXPECT_TRUE(problems.empty());
  problems.add(3, "c");
  problems.add(1, "a");
  problems.add(3, [] { return std::string("d"); });
  EXPECT_FALSE(problems.empty());
  EXPECT_EQ(lines_of(problems), (std::vector<std::string>{"1: a", "3: c", "3: d"}));
}

TEST(ProblemList, GetWordsOnlyIfTheyAreTold) {
  for (const bool is_backwards : {false, true}) {
    ProblemList<int> problems;
    int words_made = 0;
    constexpr int count = 100'000;
    for (int i = 0; i < count; ++i) {
      problems.add(is_backwards ? count - 1 - i : i, [&words_made] {
        ++words_made;
        return std::string("x");
      });
    }
    EXPECT_EQ(words_made, 0);
    const std::vector<std::string> lines = lines_of(problems);
    EXPECT_EQ(words_made, 20);
    ASSERT_EQ(lines.size(), 21U);
    EXPECT_EQ(lines.front(), "0: x");
    EXPECT_EQ(lines[19], "19: x");
    EXPECT_EQ(lines.back(), "… and 99980 more");
  }
}

// The order of the names is not that of the file.
std::string unknown_keys() {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += fmt::format("key{}=1\n", 9999 - i);
  return text;
}

std::string said_by(void (*read)(const std::string&)) {
  try {
    read(unknown_keys());
  } catch (const ReadError& error) {
    EXPECT_EQ(error.kind(), ReadError::Kind::wrong);
    return error.what();
  }
  return "";
}

TEST(ProblemList, OfScenesAndCalibrationsAreTold) {
  for (const auto read : {+[](const std::string& text) { read_scene("format = 1\n" + text, "f.toml"); },
                          +[](const std::string& text) { read_falcon_calibration("format = 1\n" + text, "f.toml"); }}) {
    const std::string said = said_by(read);
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 20) << said;
    EXPECT_NE(said.find("f.toml:3:1: the key key9998 is unknown"), std::string::npos) << said;
    EXPECT_EQ(said.find("key9900 "), std::string::npos) << said;
    EXPECT_NE(said.find("\n… and "), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace ghostforce::first_problems_test
