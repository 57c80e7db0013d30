// ghostforce sweep: where everything comes to rest, over ranges of one or two keys of a scene.
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/base/progress.h"
#include "app/base/quoted.h"
#include "app/base/words.h"
#include "app/cli/command.h"
#include "app/cli/option.h"
#include "app/files/output_file.h"
#include "app/files/run.h"
#include "app/tools/sweep/sweep.h"

namespace ghostforce {
namespace {

using Seconds = std::chrono::duration<double>;
using Clock = std::chrono::steady_clock;

struct SweepOptions {
  SceneOptions scene;
  std::vector<std::string> ranges;
  std::string kind = "both";
  std::string output = "-";
};

struct Spent {
  std::chrono::nanoseconds computing{0};   // all threads together
  std::chrono::nanoseconds formatting{0};  // likewise
  Seconds writing{0.0};
};

void tell(const Spent& spent, std::size_t thread_count, Seconds in_all) {
  const double threads = static_cast<double>(thread_count);
  say("{:.2f} s: computing {:.2f} s and formatting {:.2f} s on each of {} threads; writing {:.2f} s\n", in_all.count(),
      Seconds(spent.computing).count() / threads, Seconds(spent.formatting).count() / threads, thread_count,
      spent.writing.count());
}

int sweep_command(const SweepOptions& options) {
  const Scene scene = options.scene.load();
  const Grid grid = make_grid(options.ranges, scene);
  const EquilibriumKind& kind = *std::ranges::find(equilibrium_kinds, options.kind, &EquilibriumKind::name);

  OutputFile file(options.output);
  file.finish_despite_interruption();
  const Clock::time_point start = Clock::now();
  const std::size_t thread_count = sweep_threads();
  Spent spent;
  std::int64_t unsettled = 0;
  bool is_whole = false;
  bool has_rows = false;
  {
    Progress progress("sweeping", size_of(grid), !file.is_terminal());
    is_whole = sweep({scene, grid, kind}, thread_count, [&](const SweptBlock& block) {
      const Clock::time_point before = Clock::now();
      if (!block.rows.empty() && !std::exchange(has_rows, true)) file.write(sweep_header(scene, grid, kind));
      file.write(block.rows);
      spent.writing += Clock::now() - before;
      unsettled += block.unsettled;
      spent.computing += block.computing;
      spent.formatting += block.formatting;
      progress.at(block.points);
    });
    // A header alone is worth nothing, and what it would replace may be.
    if (!has_rows) throw Failure(ExitCode::interrupted, "interrupted before the first row; nothing was written");
    if (!is_whole) file.write(fmt::format("{}\n", interrupted_line));
    const Clock::time_point before = Clock::now();
    file.commit();
    spent.writing += Clock::now() - before;
  }
  if (unsettled > 0) {
    say("in {} of the rows, settled is 0: with those settings the sampled loop is unstable or does not come to rest\n",
        unsettled);
  }
  if (!is_whole) throw Failure(ExitCode::interrupted, "interrupted; the rows written so far are complete");
  if (!file.is_terminal() && isatty(STDERR_FILENO) != 0) tell(spent, thread_count, Clock::now() - start);
  return static_cast<int>(ExitCode::done);
}

}  // namespace

std::function<int()> attach_sweep(CLI::App& command, FileOptions& files) {
  const auto options = std::make_shared<SweepOptions>();
  options->scene.attach(command, files, true);
  repeatable(add_option(command, "--over KEY=FROM:TO:COUNT[:log]", options->ranges,
                        "Vary a numeric key of the scene over COUNT values from FROM to TO, both included, in "
                        "equal steps or, with :log, in equal ratios; may be given twice")
                 ->check(suggests_keys(KeyKind::number))
                 ->required());
  add_option(command, "--at-rest HOW", options->kind,
             "How to compute where things come to rest: closed-form, simulated or both; default: both. The closed "
             "form is hundreds of times faster")
      ->check(one_of(names_of(equilibrium_kinds)));
  files.writes(
      add_option(command, "-o,--output FILE", options->output,
                 "The CSV file to write; default: -, standard output. Ctrl+C leaves whole rows and a last line "
                 "'# interrupted'"));
  return [options] { return sweep_command(*options); };
}

}  // namespace ghostforce
