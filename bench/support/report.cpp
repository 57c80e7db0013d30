#include "bench/support/report.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>

#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "app/base/failure.h"
#include "app/files/output_file.h"

namespace ghostforce::bench {
namespace {

constexpr std::string_view heading = "## ";

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unnamed processor";
}

// A file that is not there yet has no sections.
std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string_view title_of(std::string_view section) {
  const std::string_view line = section.substr(heading.size());
  return line.substr(0, line.find('\n'));
}

}  // namespace

Goal at_most(double value, double limit, std::string_view unit) {
  return {fmt::format("≤ {}{}{}", limit, unit.empty() ? "" : " ", unit), value <= limit};
}

Goal at_least(double value, double limit, std::string_view unit) {
  return {fmt::format("≥ {}{}{}", limit, unit.empty() ? "" : " ", unit), value >= limit};
}

void Report::row(std::string what, std::string measured, std::optional<Goal> goal) {
  rows_.push_back({std::move(what), std::move(measured), std::move(goal)});
}

std::string Report::text() const {
  std::string text = fmt::format("{}{}\n\n{}\n", heading, title_, machine_and_day());
  for (const std::string& words : paragraphs_) text += '\n' + words + '\n';
  text += "\n| what | measured | goal | met |\n| --- | ---: | ---: | --- |\n";
  for (const Row& row : rows_) {
    text += fmt::format("| {} | {} | {} | {} |\n", row.what, row.measured, row.goal ? row.goal->words : "",
                        !row.goal          ? ""
                        : row.goal->is_met ? "yes"
                                           : "**no**");
  }
  if (!notes_.empty()) text += "\nFound while the program was made, on an AMD EPYC with 2 processors:\n";
  for (const std::string& words : notes_) text += '\n' + words + '\n';
  return text;
}

int Report::finish(int argc, char** argv) const {
  const std::string section = text();
  std::fputs(section.c_str(), stdout);
  if (argc == 1) return 0;
  if (argc != 3 || std::string_view(argv[1]) != "--write") {
    fmt::print(stderr, "usage: {} [--write FILE]\n", argv[0]);
    return 2;
  }
  try {
    OutputFile file(argv[2]);
    file.write(with_section(contents(argv[2]), title_, section));
    file.commit();
  } catch (const std::exception& failure) {
    fmt::print(stderr, "{}\n", failure.what());
    return 8;
  }
  return 0;
}

std::string with_section(const std::string& file, const std::string& title, const std::string& section) {
  std::istringstream lines(file);
  std::string preface;
  std::vector<std::string> sections;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(heading)) sections.emplace_back();
    (sections.empty() ? preface : sections.back()) += line + '\n';
  }
  std::erase_if(sections, [&](const std::string& other) { return title_of(other) == title; });
  auto place = sections.begin();
  while (place != sections.end() && title_of(*place) < title) ++place;
  sections.insert(place, section);
  std::string whole = preface;
  for (const std::string& one : sections) {
    while (!whole.empty() && !whole.ends_with("\n\n")) whole += '\n';
    whole += one;
  }
  while (whole.ends_with("\n\n")) whole.pop_back();
  return whole;
}

std::string machine_and_day() {
  utsname system{};
  uname(&system);
  std::time_t now = std::time(nullptr);
#if defined(__clang__)
  constexpr std::string_view compiler = "clang++ " __clang_version__;
#else
  constexpr std::string_view compiler = "g++ " __VERSION__;
#endif
  return fmt::format("{}, {} processors, {} {}, {} {}, {:%Y-%m-%d}", processor(), std::thread::hardware_concurrency(),
                     system.sysname, system.release, compiler, GHOSTFORCE_BUILD_TYPE, fmt::gmtime(now));
}

}  // namespace ghostforce::bench
