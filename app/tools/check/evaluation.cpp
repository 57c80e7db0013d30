#include "app/tools/check/evaluation.h"

#include <signal.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/base/quoted.h"
#include "app/shell/desktop/offscreen_driver.h"
#include "app/tools/check/rendered_cases.h"
#include "app/tools/check/verdict.h"
#include "app/tools/check/worker_processes.h"

namespace ghostforce {
namespace {

[[noreturn]] void refuse_to_guess(const WorkerEnded& ended, const std::vector<const Case*>& chosen) {
  const std::string doing =
      ended.piece < 0
          ? ""
          : fmt::format(" while checking {}", quoted_text(chosen.at(static_cast<std::size_t>(ended.piece))->name));
  if (ended.signal == SIGKILL) {
    throw Failure(ExitCode::file_trouble,
                  fmt::format("a worker process was killed{}, perhaps because memory is short; choose fewer --jobs, "
                              "or close other programs",
                              doing));
  }
  throw std::runtime_error(ended.signal == 0
                               ? fmt::format("a worker process ended unexpectedly{}", doing)
                               : fmt::format("a worker process was ended by signal {}{}", ended.signal, doing));
}

}  // namespace

void evaluate_all(const std::vector<Case>& all, const std::vector<const Case*>& chosen, const Evaluation& how,
                  const std::function<void(Verdict)>& take) {
  RenderedCases rendered(all, chosen, how.renderer);
  const auto count = static_cast<std::int64_t>(chosen.size());
  const auto verdict_on = [&](std::int64_t i) {
    stop_if_interrupted();
    return evaluate(*chosen[static_cast<std::size_t>(i)], rendered, how.folder, how.wants_pictures);
  };
  if (how.jobs == 1) {
    for (std::int64_t i = 0; i < count; ++i) take(verdict_on(i));
    return;
  }
  if (how.renderer != Renderer::gpu) choose_offscreen_driver();  // what it says is said once
  try {
    run_in_workers(
        count, how.jobs, [&](std::int64_t i) { return bytes_of(verdict_on(i)); },
        [&](const std::string& bytes) { take(verdict_of(bytes)); });
  } catch (const WorkerEnded& ended) {
    refuse_to_guess(ended, chosen);
  }
}

}  // namespace ghostforce
