// docs/theory.md sends its reader to files, functions and tests. They must be there.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/places.h"

namespace ghostforce::theory_test {
namespace {

const std::filesystem::path root = source_path();

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

// What stands between backticks, in order.
std::vector<std::string> code_spans(const std::string& line) {
  static const std::regex span("`([^`]+)`");
  std::vector<std::string> spans;
  for (std::sregex_iterator i(line.begin(), line.end(), span), end; i != end; ++i) spans.push_back((*i)[1]);
  return spans;
}

bool is_path(const std::string& span) {
  static const std::regex path("(core|device|app|tests|docs|assets|shaders|cmake)/[A-Za-z0-9_./-]*");
  return std::regex_match(span, path);
}

// Suite.Name
const std::regex test_name("([A-Z][A-Za-z0-9]*)\\.([A-Z][A-Za-z0-9]*)");

bool is_test(const std::string& span) {
  return std::regex_match(span, test_name);
}

// A test, or a word of the file.
bool is_named_in(const std::string& text, const std::string& name) {
  std::smatch match;
  if (std::regex_match(name, match, test_name)) {
    return std::regex_search(text, std::regex("TEST\\w*\\(\\s*" + match[1].str() + ",\\s*" + match[2].str() + "\\)"));
  }
  return std::regex_search(text, std::regex("\\b" + name + "\\b"));
}

std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  std::istringstream stream(row.substr(1));
  for (std::string cell; std::getline(stream, cell, '|');) cells.push_back(cell);
  return cells;
}

// What a line names that is not there, as sentences.
std::vector<std::string> missing_in(const std::string& line) {
  std::vector<std::string> missing;
  const bool row = line.starts_with('|');
  for (const std::string& part : row ? cells_of(line) : std::vector<std::string>{line}) {
    std::optional<std::string> file;
    for (const std::string& span : code_spans(part)) {
      if (is_path(span)) {
        file = span;
        if (!std::filesystem::exists(root / span)) missing.push_back("there is no " + span);
      } else if (row && file && !is_named_in(text_of(root / *file), span)) {
        missing.push_back("no " + span + " in " + *file);
      }
    }
  }
  return missing;
}

// Suite.Name of every test in the folder.
std::set<std::string> tests_in(const std::filesystem::path& folder) {
  static const std::regex test("TEST\\w*\\(\\s*(\\w+),\\s*(\\w+)\\)");
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = text_of(entry.path());
    for (std::sregex_iterator i(text.begin(), text.end(), test), end; i != end; ++i) {
      names.insert((*i)[1].str() + '.' + (*i)[2].str());
    }
  }
  return names;
}

std::vector<std::string> theory_lines() {
  std::vector<std::string> lines;
  std::istringstream stream(text_of(root / "docs/theory.md"));
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// Rows of the table equation -> code -> test: those whose first cell begins with an equation number.
std::vector<std::vector<std::string>> equation_rows() {
  static const std::regex first("\\s*\\([0-9]+\\).*");
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line : theory_lines()) {
    if (!line.starts_with('|')) continue;
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() >= 4 && std::regex_match(cells[0], first)) rows.push_back(cells);
  }
  return rows;
}

// (9)(10), but not q_u(0).
std::set<int> equation_numbers(const std::string& text) {
  static const std::regex number("(\\w?)\\(([0-9]{1,2})\\)");
  std::set<int> numbers;
  for (std::sregex_iterator i(text.begin(), text.end(), number), end; i != end; ++i) {
    if ((*i)[1].length() == 0) numbers.insert(std::stoi((*i)[2]));
  }
  return numbers;
}

std::set<int> numbers_in_table() {
  std::set<int> numbers;
  for (const auto& cells : equation_rows()) numbers.merge(equation_numbers(cells[0]));
  return numbers;
}

TEST(TheoryTest, NamesFilesFunctionsAndTestsThatExist) {
  const std::vector<std::string> lines = theory_lines();
  ASSERT_GT(lines.size(), 50U) << "docs/theory.md was not read";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const std::string& sentence : missing_in(lines[i])) {
      ADD_FAILURE() << "docs/theory.md:" << i + 1 << ": " << sentence;
    }
  }
}

// Beside a statement, without a file.
TEST(TheoryTest, NamesTestsThatExistBesideStatements) {
  const std::set<std::string> tests = tests_in(root / "tests");
  int named = 0;
  for (const std::string& line : theory_lines()) {
    if (line.starts_with('|')) continue;
    for (const std::string& span : code_spans(line)) {
      if (!is_test(span)) continue;
      EXPECT_TRUE(tests.contains(span)) << span;
      ++named;
    }
  }
  EXPECT_GT(named, 30);
}

// The lists of "Any device" are statements, and each has a test.
TEST(TheoryTest, EachStatementAboutAnyDeviceNamesATest) {
  const std::string text = text_of(root / "docs/theory.md");
  const std::size_t begin = text.find("## Any device");
  ASSERT_NE(begin, std::string::npos);
  std::istringstream lines(text.substr(begin, text.find("\n## ", begin) - begin));
  std::vector<std::string> statements;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("- ")) {
      statements.push_back(line);
    } else if (line.starts_with("  ") && !line.starts_with("    ") && !statements.empty()) {
      statements.back() += line;
    }
  }
  EXPECT_GT(statements.size(), 15U);
  for (const std::string& statement : statements) {
    EXPECT_TRUE(std::ranges::any_of(code_spans(statement), is_test)) << statement;
  }
}

TEST(TheoryTest, TableHasEveryEquationOfThePaper) {
  std::set<int> every;
  for (int number = 1; number <= 25; ++number) every.insert(number);
  EXPECT_EQ(numbers_in_table(), every);
}

// Each row names code and a test, or says with a dash that there is none.
TEST(TheoryTest, RowsNameCodeAndTest) {
  for (const auto& cells : equation_rows()) {
    SCOPED_TRACE(cells[0]);
    for (const std::size_t cell : {2U, 3U}) {
      const bool dash = cells[cell].find("—") != std::string::npos;
      const bool named = cells[cell].find(cell == 2 ? "core/" : "tests/core/") != std::string::npos;
      EXPECT_TRUE(dash || named) << cells[cell];
    }
  }
}

// An equation number in a comment of core/ can be looked up.
TEST(TheoryTest, TableHasEveryEquationThatTheCodeNames) {
  const std::set<int> table = numbers_in_table();
  int named = 0;
  for (const auto& entry : std::filesystem::directory_iterator(root / "core")) {
    if (entry.path().extension() != ".h") continue;
    std::istringstream stream(text_of(entry.path()));
    for (std::string line; std::getline(stream, line);) {
      const std::size_t comment = line.find("//");
      if (comment == std::string::npos) continue;
      for (const int number : equation_numbers(line.substr(comment))) {
        EXPECT_TRUE(table.contains(number)) << entry.path().filename() << ": (" << number << ')';
        ++named;
      }
    }
  }
  EXPECT_GT(named, 20);
}

TEST(TheorySelfTest, MissesWhatIsNotThere) {
  EXPECT_TRUE(missing_in("see `core/wall.h` and the `depth` there").empty());
  EXPECT_TRUE(missing_in("| (8) | d | `core/wall.h` `depth` | `tests/core/wall_test.cpp` |").empty());
  EXPECT_EQ(missing_in("see `core/no_such_file.h`").size(), 1U);
  EXPECT_EQ(missing_in("| (8) | d | `core/wall.h` `no_such_function` | `tests/core/wall_test.cpp` |").size(), 1U);
  EXPECT_EQ(missing_in("| (8) | d | `core/wall.h` | `tests/core/wall_test.cpp` `WallTest.NoSuchTest` |").size(), 1U);
  EXPECT_TRUE(is_named_in("TYPED_TEST(A, B) {}", "A.B"));
  EXPECT_FALSE(is_named_in("TYPED_TEST(A, BC) {}", "A.B"));
  EXPECT_FALSE(is_named_in("void depths();", "depth"));
}

}  // namespace
}  // namespace ghostforce::theory_test
