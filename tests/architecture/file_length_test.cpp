// No source file is longer than 500 lines: what one reads at a sitting. A longer one holds two ideas and becomes two.

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <istream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/places.h"

namespace ghostforce::file_length_test {
namespace {

constexpr std::size_t most_lines = 500;

// A last line without its newline counts too.
std::size_t line_count(std::istream& text) {
  std::size_t count = 0;
  for (std::string line; std::getline(text, line);) ++count;
  return count;
}

// What people write for compilers and shells. Not data, nor pages; what is generated stands outside of the tree.
bool is_source(const std::filesystem::path& path) {
  static const std::set<std::string> endings{".c",    ".cc",   ".cpp",  ".h",     ".hpp", ".inl", ".ipp", ".glsl",
                                             ".vert", ".frag", ".geom", ".cmake", ".in",  ".sh",  ".py"};
  if (path.filename() == "CMakeLists.txt" || endings.contains(path.extension().string())) return true;
  std::string beginning;
  return !path.has_extension() && std::getline(std::ifstream(path), beginning) && beginning.starts_with("#!");
}

using Lengths = std::map<std::string, std::size_t>;  // path from the root of the tree -> lines

void add_length(const std::filesystem::path& root, const std::filesystem::directory_entry& entry, Lengths& lengths) {
  if (!entry.is_regular_file() || !is_source(entry.path())) return;
  std::ifstream file(entry.path());
  lengths[entry.path().lexically_relative(root).generic_string()] = line_count(file);
}

Lengths lengths_at(const std::filesystem::path& root) {
  Lengths lengths;
  for (const auto& entry : std::filesystem::directory_iterator(root)) add_length(root, entry, lengths);
  for (const char* room : {".ci", "app", "bench", "cmake", "core", "device", "docs", "shaders", "tests"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / room)) {
      add_length(root, entry, lengths);
    }
  }
  return lengths;
}

std::vector<std::string> too_long(const Lengths& lengths) {
  std::vector<std::string> found;
  for (const auto& [path, lines] : lengths) {
    if (lines > most_lines) found.push_back(path + " has " + std::to_string(lines) + " lines");
  }
  return found;
}

TEST(FileLengthTest, NoSourceHasMoreThan500Lines) {
  const Lengths lengths = lengths_at(source_path());
  for (const char* path : {".ci/run", "CMakeLists.txt", "app/cli/main.cpp", "bench/batch.py", "check", "cmake/setup.sh",
                           "cmake/testing.cmake", "core/conventions.h", "device/servo/servo.h", "shaders/mark.frag",
                           "tests/architecture/file_length_test.cpp"}) {
    EXPECT_TRUE(lengths.contains(path)) << path << " was not read";
  }
  for (const std::string& sentence : too_long(lengths)) {
    ADD_FAILURE() << sentence << "; split it along an idea, " << most_lines << " are the most";
  }
}

// --- The test itself: it must be able to fail ------------------------------------------------------------------------

TEST(FileLengthSelfTest, NamesTheFileAndItsLength) {
  EXPECT_EQ(too_long({{"app/a.cpp", 500}, {"app/b.cpp", 501}, {"check", 12}}),
            std::vector<std::string>{"app/b.cpp has 501 lines"});
}

TEST(FileLengthSelfTest, CountsLines) {
  for (const auto& [text, lines] : std::map<std::string, std::size_t>{{"", 0}, {"a", 1}, {"a\n", 1}, {"a\n\nb", 3}}) {
    std::istringstream stream(text);
    EXPECT_EQ(line_count(stream), lines) << text;
  }
}

TEST(FileLengthSelfTest, LeavesDataAlone) {
  const std::filesystem::path root = source_path();
  for (const char* path : {"LICENSE", "README.md", "packages.txt", ".clang-format", "assets/scenes/fig1.toml"}) {
    ASSERT_TRUE(std::filesystem::exists(root / path)) << path;
    EXPECT_FALSE(is_source(root / path)) << path;
  }
}

}  // namespace
}  // namespace ghostforce::file_length_test
