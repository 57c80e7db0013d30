// What a bench found, as one section of bench/RESULTS.md: on the standard output always, and in the file where the
// bench was called with --write FILE. The other sections of the file stay as they are.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ghostforce::bench {

// What a bench defines instead of a main: that of main.cpp calls it, and tells why where it throws.
int run(int argc, char** argv);

struct Goal {
  std::string words;
  bool is_met;
};

// "≤ 1.25", in the unit that the figure is told in.
Goal at_most(double value, double limit, std::string_view unit = "");
Goal at_least(double value, double limit, std::string_view unit = "");

class Report {
 public:
  // Sections are sorted by their titles, which therefore begin with the number: "1. The tick".
  explicit Report(std::string title) : title_(std::move(title)) {}

  // Above the table: what was compared with what.
  void paragraph(std::string words) { paragraphs_.push_back(std::move(words)); }

  // `measured` with its unit. Without a goal it is there to be known, not to be judged.
  void row(std::string what, std::string measured, std::optional<Goal> goal = std::nullopt);

  // Below the table: why a goal is not met and what was tried.
  void note(std::string words) { notes_.push_back(std::move(words)); }

  // The arguments of main: nothing, or --write FILE. Returns the exit code: 0, 2 for other arguments, 8 where the file
  // cannot be written. A goal that is not met is no failure.
  int finish(int argc, char** argv) const;

 private:
  struct Row {
    std::string what;
    std::string measured;
    std::optional<Goal> goal;
  };
  std::string text() const;

  std::string title_;
  std::vector<std::string> paragraphs_;
  std::vector<Row> rows_;
  std::vector<std::string> notes_;
};

// The file with the section in its place, sorted by title: instead of the one with the same title, if there is one.
std::string with_section(const std::string& file, const std::string& title, const std::string& section);

// "AMD EPYC 7763, 2 processors, Linux 6.1.0, g++ 12.2.0 Release, 2026-01-31", one line.
std::string machine_and_day();

}  // namespace ghostforce::bench
