// The project's own files as text, for the tests of what is made of them.
#pragma once

#include <regex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/places.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce {

inline std::string project_path(std::string_view path) {
  return source_path("/").append(path);
}

inline std::string project_file(std::string_view path) {
  std::string text = read_whole(project_path(path));
  if (text.empty()) throw std::runtime_error("nothing in " + project_path(path));
  return text;
}

// What the pattern's group finds, in order.
inline std::vector<std::string> all_in(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern, std::regex::ECMAScript | std::regex::multiline);
  const std::sregex_token_iterator found(text.begin(), text.end(), regex, 1);
  return {found, std::sregex_token_iterator()};
}

// The first cells of THIRD_PARTY_NOTICES.md's table of the desktop program.
inline std::vector<std::string> works_in_program() {
  const std::string notices = project_file("THIRD_PARTY_NOTICES.md");
  const std::string table = notices.substr(0, notices.find("\n## In the page"));
  std::vector<std::string> works = all_in(table, R"(^\| ([^|]+) \|)");
  if (works.size() < 3) throw std::runtime_error("no table in THIRD_PARTY_NOTICES.md");
  works.erase(works.begin(), works.begin() + 2);  // its head
  return works;
}

// One of cmake/package's scripts.
inline Outcome run_script(const std::string& name, std::vector<std::string> words) {
  words.insert(words.begin(), {"-B", project_path("cmake/package/" + name)});
  return run_program(GHOSTFORCE_PYTHON, std::move(words));
}

}  // namespace ghostforce
