// Section 3 of RESULTS.md: core/batch.h against the same written by hand, against tick() and against NumPy. Ends with 1
// where they do not agree on where everything ends.
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "app/files/scene_file.h"
#include "app/tools/sweep/sweep.h"
#include "bench/batch_by_hand.h"
#include "bench/support/contest.h"
#include "bench/support/report.h"
#include "core/batch.h"
#include "core/tick.h"
#include "tests/core/random_setting.h"

namespace ghostforce::bench {
namespace {

constexpr int setting_count = 1024;
constexpr int ticks = 1000;
constexpr double steps = setting_count * double{ticks};  // of one piece of work

// The slow ones do a part of the work.
constexpr int tick_settings = 32;
constexpr int vectorised_ticks = 100;
constexpr int straight_ticks = 200;
constexpr int straight_settings = 8;  // that are compared; one is timed

// What two ways may differ by, of the extent of the setting [1].
constexpr double tolerance = 1e-9;

struct Case {
  Setting<2> setting;
  double mass;
  double damping;
  double rate;
  Vector<2> start;

  TickCoefficients<2> coefficients() const {
    return coefficients_of(setting.wall, setting.actuation(), setting.stiffnesses, mass, damping, rate);
  }
  double extent() const { return glm::length(start) + glm::length(setting.goal) + glm::length(setting.wall.point); }
};

// Anisotropic rendering, all over the range of settings that come to rest in a thousand ticks or so.
std::vector<Case> random_cases() {
  Random random(20);
  std::vector<Case> cases;
  for (int i = 0; i < setting_count; ++i) {
    Setting<2> setting = random_setting<2>(random);
    Stiffnesses& k = setting.stiffnesses;
    k.k_r = k.k_u * random.over_decades(0.1, 3.0);
    const double rate = random.over_decades(100.0, 10000.0);
    const double omega = 2.0 * std::numbers::pi * rate / random.uniform(30.0, 60.0);
    cases.push_back({setting, (k.k_u + k.k_r) / (omega * omega), 2.0 * (k.k_u + k.k_r) / omega, rate,
                     setting.wall.point + 0.02 * setting.wall.normal});
  }
  return cases;
}

struct End {
  Vector<2> device;  // [m]
  Vector<2> force;   // [N]
};

// --- The contestants -------------------------------------------------------------------------------------------------

Batch batch_of(std::span<const Case> cases, Instructions instructions) {
  Batch batch(instructions);
  for (const Case& one : cases) {
    batch.add(one.coefficients(), StrategyId::anisotropic, one.start);
    batch.set_goal(batch.size() - 1, one.setting.goal);
  }
  return batch;
}

std::vector<End> ends_of(const Batch& batch) {
  std::vector<End> ends;
  for (std::size_t i = 0; i < batch.size(); ++i) ends.push_back({batch[i].device, batch[i].force});
  return ends;
}

void run_batch(const Batch& at_start, Batch& batch, std::int64_t calls) {
  for (std::int64_t i = 0; i < calls; ++i) {
    batch = at_start;
    batch.hold(ticks);
    keep(batch[0].device.x);
  }
}

using ByHand = void (*)(HandBlock*, long, long);

std::vector<HandBlock> blocks_of(std::span<const Case> cases) {
  std::vector<HandBlock> blocks(cases.size() / 8, HandBlock{});
  for (std::size_t at = 0; at < cases.size(); ++at) {
    const Case& one = cases[at];
    const TickCoefficients<2> coefficients = one.coefficients();
    const auto& [rendering, gain] = coefficients.strategies[index_of(StrategyId::anisotropic)];
    const double dt = coefficients.device.period;
    const double mass = one.mass + dt * one.damping + dt * dt * coefficients.device.user_stiffness;
    const Vector<2> w = dt * dt / mass * (rendering * gain);
    HandBlock& block = blocks[at / 8];
    const std::size_t i = at % 8;
    block.v_xx[i] = (one.mass - dt * dt * rendering[0][0]) / mass;
    block.v_xy[i] = -dt * dt * rendering[0][1] / mass;
    block.v_yy[i] = (one.mass - dt * dt * rendering[1][1]) / mass;
    block.c[i] = dt * dt * coefficients.device.user_stiffness / mass;
    block.w_x[i] = w.x;
    block.w_y[i] = w.y;
    block.n_x[i] = coefficients.wall.normal.x;
    block.n_y[i] = coefficients.wall.normal.y;
    block.n_o[i] = glm::dot(coefficients.wall.normal, coefficients.wall.point);
    block.goal_x[i] = one.setting.goal.x;
    block.goal_y[i] = one.setting.goal.y;
    block.q_x[i] = one.start.x;
    block.q_y[i] = one.start.y;
  }
  return blocks;
}

void run_by_hand(ByHand by_hand, const std::vector<HandBlock>& at_start, std::vector<HandBlock>& blocks,
                 std::int64_t calls) {
  for (std::int64_t i = 0; i < calls; ++i) {
    blocks = at_start;
    by_hand(blocks.data(), static_cast<long>(blocks.size()), ticks);
    keep(blocks[0].q_x[0]);
  }
}

std::vector<End> ends_by_hand(ByHand by_hand, std::span<const Case> cases) {
  std::vector<HandBlock> blocks = blocks_of(cases);
  by_hand(blocks.data(), static_cast<long>(blocks.size()), ticks);
  std::vector<End> ends;
  for (std::size_t at = 0; at < cases.size(); ++at) {
    const HandBlock& block = blocks[at / 8];
    const std::size_t i = at % 8;
    const auto [rendering, gain] = cases[at].coefficients().strategies[index_of(StrategyId::anisotropic)];
    const Vector<2> way(block.u_x[i], block.u_y[i]);
    ends.push_back({{block.q_x[i], block.q_y[i]}, rendering * (gain * block.h[i] - way)});
  }
  return ends;
}

End ticked(const Case& one) {
  const TickCoefficients<2> coefficients = one.coefficients();
  TickState<2> state = state_at_start(one.start);
  for (int k = 0; k < ticks; ++k) tick(coefficients, one.setting.goal, state);
  const auto seen = snapshot_of(coefficients, state).strategies[index_of(StrategyId::anisotropic)];
  return {seen.device, seen.force};
}

// Python beside this program, ready for requests, until the end of this object.
class NumPy {
 public:
  explicit NumPy(std::span<const Case> cases) {
    std::array<int, 2> to{};
    std::array<int, 2> from{};
    if (pipe(to.data()) != 0 || pipe(from.data()) != 0) return;
    child_ = fork();
    if (child_ == 0) {
      dup2(to[0], STDIN_FILENO);
      dup2(from[1], STDOUT_FILENO);
      for (const int end : {to[0], to[1], from[0], from[1]}) close(end);
      // One thread, as everybody here.
      setenv("OPENBLAS_NUM_THREADS", "1", 1);
      execl("/usr/bin/python3", "python3", GHOSTFORCE_BENCH_FOLDER "/batch.py", nullptr);
      _exit(127);
    }
    close(to[0]);
    close(from[1]);
    to_.reset(fdopen(to[1], "wb"));
    from_.reset(fdopen(from[0], "rb"));
    fmt::print(to_.get(), "{}\n", cases.size());
    for (const Case& one : cases) {
      const Vector<2>& actuated = one.setting.motors.front();
      const Stiffnesses& k = one.setting.stiffnesses;
      const Wall<2>& wall = one.setting.wall;
      const std::array row{wall.point.x,
                           wall.point.y,
                           wall.normal.x,
                           wall.normal.y,
                           actuated.x,
                           actuated.y,
                           one.mass,
                           one.damping,
                           one.rate,
                           k.k_u,
                           k.k_r,
                           k.k_t,
                           k.k_c,
                           tracking_ratio(k),
                           one.start.x,
                           one.start.y,
                           one.setting.goal.x,
                           one.setting.goal.y};
      std::fwrite(row.data(), sizeof(double), row.size(), to_.get());
    }
  }
  ~NumPy() {
    to_.reset();
    from_.reset();
    if (child_ > 0) waitpid(child_, nullptr, 0);
  }
  NumPy(const NumPy&) = delete;
  NumPy& operator=(const NumPy&) = delete;

  // Empty where there is no NumPy.
  std::optional<std::vector<End>> ends(int settings, int for_ticks, std::string_view way) {
    fmt::print(to_.get(), "{} {} {}\n", settings, for_ticks, way);
    std::fflush(to_.get());
    std::vector<End> ends(static_cast<std::size_t>(settings));
    static_assert(sizeof(End) == 4 * sizeof(double));
    if (std::fread(ends.data(), sizeof(End), ends.size(), from_.get()) != ends.size()) return std::nullopt;
    return ends;
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  pid_t child_ = -1;
  std::unique_ptr<std::FILE, Close> to_;
  std::unique_ptr<std::FILE, Close> from_;
};

// Processor time that this program has used [s].
double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// --- Agreement -------------------------------------------------------------------------------------------------------

// The greatest difference in device and force, of the extent and of what the rendering makes of it [1].
double difference(std::span<const Case> cases, std::span<const End> ends, std::span<const End> expected) {
  double greatest = 0.0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const double extent = cases[i].extent();
    const double device = glm::distance(ends[i].device, expected[i].device) / extent;
    const double force = glm::distance(ends[i].force, expected[i].force) / (extent * cases[i].setting.stiffnesses.k_r);
    greatest = std::max(
        greatest, std::isfinite(device + force) ? std::max(device, force) : std::numeric_limits<double>::infinity());
  }
  return greatest;
}

}  // namespace

int run(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a Python without NumPy has gone
  const std::vector<Case> cases = random_cases();
  const bool has_avx2 = widest_instructions() == Instructions::avx2;
  const bool has_fma = has_avx2 && __builtin_cpu_supports("fma");
  NumPy numpy(cases);

  std::vector<End> expected;
  for (const Case& one : cases) expected.push_back(ticked(one));
  double greatest = 0.0;
  const auto compare = [&](std::string_view name, std::span<const End> ends) {
    const double found = difference(cases, ends, expected);
    if (!(found <= tolerance)) fmt::print(stderr, "{} ends elsewhere than tick(): {:.1e} of the extent\n", name, found);
    greatest = std::max(greatest, found);
  };
  const auto compare_batch = [&](std::string_view name, Instructions instructions) {
    Batch batch = batch_of(cases, instructions);
    batch.hold(ticks);
    compare(name, ends_of(batch));
  };
  compare_batch("baseline batch", Instructions::baseline);
  compare("baseline hand", ends_by_hand(hand_baseline, cases));
  if (has_avx2) compare_batch("AVX2 batch", Instructions::avx2);
  if (has_avx2) compare("AVX2 hand", ends_by_hand(hand_avx2, cases));
  if (has_fma) compare("FMA hand", ends_by_hand(hand_fma, cases));
  const auto vectorised = numpy.ends(setting_count, ticks, "vectorised");
  if (vectorised) compare("vectorised NumPy", *vectorised);
  if (vectorised) compare("straight NumPy", numpy.ends(straight_settings, ticks, "straight").value());
  if (!(greatest <= tolerance)) return 1;

  const Batch widest = batch_of(cases, widest_instructions());
  const Batch baseline = batch_of(cases, Instructions::baseline);
  const std::vector<HandBlock> by_hand = blocks_of(cases);
  const std::size_t threads = sweep_threads();
  // What is worked on stays where it is from turn to turn, so that turns of any length compare.
  std::vector<Batch> work(threads, widest);
  Batch work_baseline = baseline;
  std::vector<HandBlock> work_by_hand = by_hand;
  const Contestant batch{"batch", [&](std::int64_t calls) { run_batch(widest, work[0], calls); }};
  const Contestant batch_baseline{"batch", [&](std::int64_t calls) { run_batch(baseline, work_baseline, calls); }};
  const auto hand = [&](ByHand way) {
    return Contestant{"hand", [&, way](std::int64_t calls) { run_by_hand(way, by_hand, work_by_hand, calls); }};
  };
  // In pairs, and in turns shorter than what a busy system hands out of a core at a time: so most turns are whole, and
  // what disturbs one of them disturbs the other.
  const auto against_hand = [&](const Contestant& one, ByHand way) {
    return Contest({one, hand(way)}, {.rounds = 399, .seconds_per_turn = 0.0005});
  };
  const Contest with_baseline = against_hand(batch_baseline, hand_baseline);
  const Contest with_tick({batch, {"tick", [&](std::int64_t calls) {
                                     for (; calls > 0; --calls) {
                                       for (int i = 0; i < tick_settings; ++i) {
                                         keep(ticked(cases[static_cast<std::size_t>(i)]).device.x);
                                       }
                                     }
                                   }}});
  const auto on_all_cores = [&](std::int64_t calls) {
    std::vector<std::jthread> all;
    for (std::size_t i = 0; i < threads; ++i) all.emplace_back([&, i] { run_batch(widest, work[i], calls); });
  };
  const Contest with_all_cores({batch, {"all cores", on_all_cores}});
  // On a busy machine only this tells whether the threads are in each other's way.
  std::vector<double> dearer;
  for (int round = 0; round < 9; ++round) {
    constexpr std::int64_t calls = 30;
    const double began = processor_seconds();
    batch.run(calls);
    const double between = processor_seconds();
    on_all_cores(calls);
    dearer.push_back((processor_seconds() - between) / (static_cast<double>(threads) * (between - began)));
  }
  const auto ns = [](const Contest& contest, std::string_view name, double its_steps = steps) {
    return fmt::format("{:.3g} ns", 1e9 * contest.median_seconds(name) / its_steps);
  };

  Report report("3. Batch");
  report.paragraph(fmt::format(
      "`batch_bench`: {} settings of anisotropic rendering, {} ticks each under a goal that is held, from k = 0; a "
      "step is one tick of one setting. The loop by hand is the same recurrence in vector types, the state in "
      "registers. NumPy computes (23) to (25): vectorised with a number per array and what the settings fix computed "
      "beforehand, straight with 2×2 matrices, one setting at a time. All of them end within {:.0e} of the setting's "
      "extent where tick() does (1e-9 asked, else the bench fails).",
      setting_count, ticks, greatest));
  if (has_avx2) {
    const Contest with_avx2 = against_hand(batch, hand_avx2);
    const double ratio = with_avx2.ratio("batch", "hand");
    report.row("step, one core, AVX2", ns(with_avx2, "batch"));
    report.row("step against the loop by hand, AVX2", fmt::format("{:.2f}", ratio), at_most(ratio, 1.25));
  }
  if (has_fma) {
    report.row("step against the loop by hand with fused multiply-adds, which round otherwise",
               fmt::format("{:.2f}", against_hand(batch, hand_fma).ratio("batch", "hand")));
  }
  report.row("step, one core, baseline x86-64", ns(with_baseline, "batch"));
  const double baseline_ratio = with_baseline.ratio("batch", "hand");
  report.row("step against the loop by hand, baseline x86-64", fmt::format("{:.2f}", baseline_ratio),
             at_most(baseline_ratio, 1.25));
  report.row(fmt::format("steps per second, {} threads against one", threads),
             fmt::format("{:.2f}", static_cast<double>(threads) * with_all_cores.ratio("batch", "all cores")));
  report.row(fmt::format("processor time of a step, {} threads at once against one", threads),
             fmt::format("{:.2f}", median(dearer)));
  const double ticked_steps = double{tick_settings} * ticks * strategy_count;
  report.row("step of tick(), which runs three strategies", ns(with_tick, "tick", ticked_steps));
  report.row("step against that of tick()",
             fmt::format("{:.3f}", with_tick.ratio("batch", "tick") * ticked_steps / steps));
  const auto against_numpy = [&](std::string_view what, std::string way, int settings, int for_ticks, double limit) {
    if (!vectorised) {
      report.row(fmt::format("step against {}", what), "not measured: apt install python3-numpy");
      return;
    }
    const Contest contest({batch, {"NumPy", [&](std::int64_t calls) {
                                     for (; calls > 0; --calls) numpy.ends(settings, for_ticks, way);
                                   }}});
    const double its_steps = double{1} * settings * for_ticks;
    const double ratio = contest.ratio("batch", "NumPy") * its_steps / steps;
    report.row(fmt::format("step of {}", what), ns(contest, "NumPy", its_steps));
    report.row(fmt::format("step against {}", what), fmt::format("{:.2g}", ratio), at_most(ratio, limit));
  };
  against_numpy("NumPy, vectorised over the settings", "vectorised", setting_count, vectorised_ticks, 0.08);
  against_numpy("the formulas written straight in NumPy", "straight", 1, straight_ticks, 0.001);

  const Scene scene = load_scene("fig3-normal");
  const Grid grid =
      make_grid(std::vector<std::string>{"wall.normal_deg=90:180:100", "rendering.k_r_N_per_m=100:1e4:100:log"}, scene);
  const Contest sweeps({{"sweep", [&](std::int64_t calls) {
                           for (; calls > 0; --calls) {
                             sweep({scene, grid, equilibrium_kinds[1]}, threads,
                                   [](const SweptBlock& block) { keep(block.rows.size()); });
                           }
                         }}});
  report.row(fmt::format("`sweep --at-rest simulated`, 100×100 points of fig3-normal to text, {} threads", threads),
             fmt::format("{:.0f} ms", 1e3 * sweeps.median_seconds("sweep")));
  report.note(
      "Where other programs keep all cores busy, a second thread brings no second core: the processor time tells what "
      "it would bring on a core of its own.");
  return report.finish(argc, argv);
}

}  // namespace ghostforce::bench
