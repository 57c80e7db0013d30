#include "app/tools/check/case_folder.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/files/input_file.h"

namespace ghostforce {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view extension = ".toml";

std::string shown(const fs::path& path) {
  return quoted_text(path.string(), longest_path);
}

// Another folder beside the one that is not there.
std::string folder_hint(const fs::path& folder) {
  const fs::path named = folder.filename().empty() ? folder.parent_path() : folder;
  const fs::path around = named.has_parent_path() ? named.parent_path() : fs::path(".");
  const auto name_of = [](const fs::path& path) {
    std::error_code unknown;
    return fs::is_directory(path, unknown) ? path.filename().string() : "";
  };
  const auto near = nearest_name_in(around, named.filename().string(), name_of);
  if (!near) return "";
  const fs::path found = named.has_parent_path() ? around / *near : fs::path(*near);
  return fmt::format("; did you mean '{}'?", shown(found));
}

std::vector<fs::path> case_paths(const std::string& folder) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (!fs::exists(status)) {
    if (error && error != std::errc::no_such_file_or_directory && error != std::errc::not_a_directory) {
      throw unreadable(shown(folder), error.value());
    }
    throw Failure(ExitCode::wrong_call, fmt::format("there is no folder '{}'{}", shown(folder), folder_hint(folder)));
  }
  if (!fs::is_directory(status)) {
    throw Failure(ExitCode::wrong_call,
                  fmt::format("'{}' is not a folder; name the folder of the cases, and choose a case with --only NAME",
                              shown(folder)));
  }
  std::vector<fs::path> paths = paths_in(folder, error);
  if (error) throw unreadable(shown(folder), error.value());
  std::erase_if(paths, [](const fs::path& path) {
    return path.extension() != extension || path.filename().string().starts_with('.');
  });
  return paths;
}

bool has_control_character(std::string_view name) {
  while (!name.empty()) {
    const auto [code, length] = first_character(name);
    if (length > 0 && is_control(code)) return true;
    name.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return false;
}

// What no case can tell alone.
void find_problems_between(const std::vector<Case>& cases, std::vector<ReadProblem>& problems) {
  const std::vector<std::string_view> names = names_of(cases);
  for (const Case& each : cases) {
    if (each.other.empty()) continue;
    ReadProblem problem = each.other_place;
    const Case* const other = find_case(cases, each.other);
    const std::string shown_other = quoted_text(each.other);
    if (other == nullptr) {
      problem.what = fmt::format("the key {}: there is no case '{}' in this folder", expectation_name(each.expectation),
                                 shown_other);
      if (const auto near = nearest_name(each.other, names)) problem.remedy = fmt::format("did you mean '{}'?", *near);
    } else if (other->width != each.width || other->height != each.height) {
      problem.what = fmt::format("the key {}: this picture has {}x{} pixels, and that of '{}' has {}x{}",
                                 expectation_name(each.expectation), each.width, each.height, shown_other, other->width,
                                 other->height);
      problem.remedy = "give both the same size";
    } else {
      continue;
    }
    problems.push_back(problem);
  }
}

}  // namespace

std::vector<Case> read_case_folder(const std::string& folder) {
  const std::vector<fs::path> paths = case_paths(folder);
  if (paths.empty()) {
    throw Failure(
        ExitCode::wrong_call,
        fmt::format("there is no case in '{}'; a case is a file NAME.toml with at least a line scene = \"wall45\"",
                    shown(folder)));
  }
  std::vector<Case> cases;
  std::vector<ReadProblem> problems;
  for (const fs::path& path : paths) {
    stop_if_interrupted();
    if (has_control_character(path.filename().string())) {
      problems.push_back(
          {.file = shown(path), .what = "there is a control character in its name", .remedy = "rename it"});
    }
    if (const std::string_view kind = kind_instead_of_file(path); !kind.empty()) {
      problems.push_back({.file = shown(path),
                          .what = fmt::format("is {}, but a case must be a file", kind),
                          .remedy = "rename it, or remove it"});
      continue;
    }
    cases.push_back(read_case(path.string(), problems).summary);
  }
  find_problems_between(cases, problems);
  if (!problems.empty()) throw ReadError(ReadError::Kind::wrong, problems);
  return cases;
}

std::vector<std::string> sources_overwritten_by(const std::vector<Case>& cases, const std::vector<std::string>& paths) {
  std::error_code unknown;
  std::map<fs::path, std::string> targets;  // and how each is called
  for (const std::string& path : paths) targets.try_emplace(fs::weakly_canonical(path, unknown), path);
  std::vector<std::string> lines;
  for (const Case& each : cases) {
    if (each.source_path.empty()) continue;
    const auto target = targets.find(fs::weakly_canonical(each.source_path, unknown));
    if (target == targets.end()) continue;
    lines.push_back(fmt::format("{} would be overwritten, but it is what the case {} shows; move it, or rename it",
                                shown(target->second), quoted_text(each.name)));
  }
  return lines;
}

const Case* find_case(const std::vector<Case>& cases, std::string_view name) noexcept {
  const auto found = std::find_if(cases.begin(), cases.end(), [&](const Case& each) { return each.name == name; });
  return found == cases.end() ? nullptr : &*found;
}

std::vector<const Case*> chosen_cases(const std::vector<Case>& cases, const std::vector<std::string>& names,
                                      std::string_view option) {
  const std::vector<std::string_view> known = names_of(cases);
  std::vector<std::string> problems;
  for (const std::string& name : names) {
    if (find_case(cases, name) != nullptr) continue;
    const std::string near = did_you_mean(name, known);
    problems.push_back(fmt::format("{} {}: there is no such case{}", option, quoted_text(name),
                                   near.empty() ? fmt::format("; the cases are {}", listed(known)) : near));
  }
  if (!problems.empty()) throw Failure(ExitCode::wrong_call, fmt::format("{}", fmt::join(problems, "\n")));
  std::vector<const Case*> chosen;
  for (const Case& each : cases) {
    if (names.empty() || std::find(names.begin(), names.end(), each.name) != names.end()) chosen.push_back(&each);
  }
  return chosen;
}

}  // namespace ghostforce
