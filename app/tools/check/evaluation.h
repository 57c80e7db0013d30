// The verdicts on all cases of a run, in this process or in several, and how work is shared among processes. Main
// thread only (it draws).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
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

// A worker has ended before its piece was made; all of them are gone when this is thrown.
struct WorkerEnded {
  std::int64_t piece = 0;  // that it should have made; negative: none
  int signal = 0;          // that ended it; 0: it ended by itself
};

// Does work piece by piece in several processes and hands it over in order in this one, as if this one had done it all
// alone, only sooner. For what a process can do on its main thread alone, such as drawing.
//
// Forks `workers` processes, at most one a piece, which call make(i) for i = 0 … count−1. Calls take() here for each
// piece in order, and holds a few pieces per worker at most. Where make(i) throws in a worker, it is called again here,
// so that what it throws comes out here. No worker outlives the call.
// This process must have no other thread, and must not have drawn yet.
// Throws WorkerEnded; and Failure: file_trouble where there can be no more processes; interrupted.
void run_in_workers(std::int64_t count, int workers, const std::function<std::string(std::int64_t)>& make,
                    const std::function<void(std::string)>& take);

}  // namespace ghostforce
