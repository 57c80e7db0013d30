// ghostforce help: the same words as --help, and manual pages from the same tables.
#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "app/cli/command.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::help_test {
namespace {

Outcome help(std::vector<std::string> words) {
  words.insert(words.begin(), "help");
  return run_ghostforce(std::move(words));
}

// Of each command, and of the program by an empty name.
std::vector<std::string> all_pages() {
  std::vector<std::string> names{""};
  for (const Command& command : command_catalog()) names.emplace_back(command.name);
  return names;
}

std::string printed(std::vector<std::string> words, const std::string& command) {
  if (!command.empty()) words.push_back(command);
  const Outcome outcome = help(std::move(words));
  EXPECT_EQ(outcome.exit_code, 0) << command << outcome.err;
  EXPECT_EQ(outcome.err, "") << command;
  return outcome.out;
}

// The names in front of a description: "-o,--output FILE" has two.
void add_names(std::string words, std::set<std::string>& names) {
  std::ranges::replace(words, ',', ' ');
  std::istringstream in(words);
  for (std::string word; in >> word && word.starts_with('-');) names.insert(word);
}

std::set<std::string> options_in_help(const std::string& text) {
  std::set<std::string> names;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("  -")) add_names(line, names);
  }
  return names;
}

std::set<std::string> options_in_page(const std::string& page) {
  std::set<std::string> names;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    if (line != ".TP" || !std::getline(lines, line)) continue;
    for (const std::string_view escape : {"\\fB", "\\fR", "\\fI", "\\"}) {
      for (std::size_t at = line.find(escape); at != std::string::npos; at = line.find(escape)) {
        line.erase(at, escape.size());
      }
    }
    add_names(line, names);
  }
  return names;
}

// man puts a wider space after a sentence.
std::string without_wide_blanks(std::string text) {
  const auto end = std::ranges::unique(text, [](char a, char b) { return a == ' ' && b == ' '; }).begin();
  text.erase(end, text.end());
  return text;
}

TEST(Help, IsWhatTheOptionPrints) {
  EXPECT_EQ(printed({}, ""), run_ghostforce({"--help"}).out);
  for (const Command& command : command_catalog()) {
    const std::string name(command.name);
    EXPECT_EQ(printed({}, name), run_ghostforce({name, "--help"}).out);
  }
}

TEST(Help, WrongCallsAreNamedAndExit2) {
  const Outcome mistyped = help({"rendr"});
  EXPECT_EQ(mistyped.exit_code, 2);
  EXPECT_EQ(mistyped.out, "");
  EXPECT_NE(mistyped.err.find("did you mean 'render'?"), std::string::npos) << mistyped.err;
  const Outcome no_format = help({"--format", "pdf"});
  EXPECT_EQ(no_format.exit_code, 2);
  EXPECT_NE(no_format.err.find("'pdf' is not one of text, man, bash, zsh, fish"), std::string::npos) << no_format.err;
  const Outcome of_one = help({"--format", "bash", "render"});
  EXPECT_EQ(of_one.exit_code, 2);
  EXPECT_EQ(of_one.out, "");
  EXPECT_NE(of_one.err.find("leave out render"), std::string::npos) << of_one.err;
}

TEST(ManualPages, HaveEachOptionOfHelpAndNoOther) {
  for (const std::string& name : all_pages()) {
    const std::set<std::string> in_help = options_in_help(printed({}, name));
    EXPECT_TRUE(in_help.contains("--help")) << name;
    EXPECT_EQ(options_in_page(printed({"--format", "man"}, name)), in_help) << name;
  }
}

TEST(ManualPages, HaveTheSentencesOfHelp) {
  for (const std::string& name : all_pages()) {
    const TemporaryFolder folder;
    write_whole(folder / "page.1", printed({"--format", "man"}, name));
    ProgramCall call;
    // As a person reads it, each sentence in one long line.
    call.words = {"--local-file", "--no-justification", "--warnings=w", folder / "page.1"};
    call.environment = {"MANWIDTH=2000", "LC_ALL=C.UTF-8", "MANPAGER=cat", "MAN_KEEP_FORMATTING="};
    const Outcome shown = run_program("/usr/bin/man", call);
    EXPECT_EQ(shown.exit_code, 0) << name;
    EXPECT_EQ(shown.err, "") << name;
    const std::string page = without_wide_blanks(shown.out);
    std::istringstream lines(printed({}, name));
    int sentences = 0;
    for (std::string line; std::getline(lines, line) && line != "Examples:";) {
      constexpr std::size_t column = 30;  // where sentences begin
      // Two blanks: a long row of options may have one there by chance.
      if (line.size() <= column || line.substr(column - 2, 2) != "  " || line[column] == ' ') continue;
      EXPECT_NE(page.find(line.substr(column)), std::string::npos) << name << ": " << line << "\n" << page;
      ++sentences;
    }
    EXPECT_GT(sentences, 0) << name;
  }
}

TEST(ManualPages, ShowLettersAndSigns) {
  const TemporaryFolder folder;
  write_whole(folder / "page.1", printed({"--format", "man"}, "measure-user"));
  ProgramCall call;
  call.words = {"--local-file", folder / "page.1"};
  call.environment = {"MANWIDTH=2000", "LC_ALL=C.UTF-8", "MANPAGER=cat"};
  const std::string shown = run_program("/usr/bin/man", call).out;
  for (const char* part : {"ρ°", "k_u = k_r / (ρ° − 1)", "--target-mm X,Y", "'simulate'", "ghostforce(1)",
                           "ghostforce measure-user visitor.csv --target-mm=0,0 --json"}) {
    EXPECT_NE(shown.find(part), std::string::npos) << part << "\n" << shown;
  }
}

}  // namespace
}  // namespace ghostforce::help_test
