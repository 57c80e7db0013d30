#include "app/files/read_error.h"

#include <fmt/format.h>

namespace ghostforce {
namespace {

std::string lines_of(const std::vector<ReadProblem>& problems) {
  std::string lines;
  for (const ReadProblem& problem : problems) lines.append(lines.empty() ? "" : "\n").append(words_of(problem));
  return lines;
}

}  // namespace

std::string place_words(const ReadProblem& problem) {
  return problem.line == 0 ? problem.file : fmt::format("{}:{}:{}", problem.file, problem.line, problem.column);
}

std::string words_of(const ReadProblem& problem) {
  return fmt::format("{}{}{}{}{}", place_words(problem), problem.file.empty() ? "" : problem.joint, problem.what,
                     problem.remedy.empty() ? "" : "; ", problem.remedy);
}

ReadError::ReadError(Kind kind, std::vector<ReadProblem> problems)
    : std::runtime_error(lines_of(problems)), kind_(kind), problems_(std::move(problems)) {}

}  // namespace ghostforce
