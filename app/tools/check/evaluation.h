// The verdicts on all cases of a run, in this process or in several. Main thread only (it draws).
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "app/tools/check/case_file.h"
#include "app/tools/check/verdict.h"

namespace ghostforce {

// Each takes some 50 MB, and more than the machine has processors gain nothing.
inline constexpr int most_jobs = 64;

struct Evaluation {
  std::string_view folder;             // as the person named it
  bool wants_pictures = false;         // of the cases that fail
  int jobs = 1;                        // processes that draw, 1 to most_jobs
  std::optional<Renderer> renderer{};  // empty: the usual one
};

// Hands over the verdict on each of the chosen cases in their order; the same whatever the number of jobs. Throws what
// RenderedCases and evaluate() do, and Failure(file_trouble) where there can be no such number of processes or one of
// them was killed.
void evaluate_all(const std::vector<Case>& all, const std::vector<const Case*>& chosen, const Evaluation& how,
                  const std::function<void(Verdict)>& take);

}  // namespace ghostforce
