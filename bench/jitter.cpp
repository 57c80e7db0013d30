// How punctual the servo's thread is, beside the program's own window, against cyclictest and against a loop as one
// writes it first. Each contestant's turns are processes of their own, which draw the window at 60 Hz meanwhile.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <pthread.h>

#include <atomic>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "app/cli/desktop_inputs.h"
#include "app/files/scene_file.h"
#include "app/shell/application.h"
#include "app/shell/desktop/glfw_window.h"
#include "bench/support/contest.h"
#include "bench/support/report.h"
#include "device/input/monotonic_clock.h"
#include "device/servo/realtime.h"
#include "device/servo/servo_thread.h"

namespace ghostforce::bench {
namespace {

using std::chrono::duration;
using std::chrono::steady_clock;

constexpr int rounds = 5;

// What one turn has found. Crosses processes whole.
struct Turn {
  LatencyHistogram latency_histogram;
  std::uint64_t lost = 0;         // deadlines that passed while the loop was late
  double processor_share = -1.0;  // of one processor, by the loop's thread; negative: not known
  double frames_per_second = 0.0;
  RealtimeStatus realtime;
};
static_assert(std::is_trivially_copyable_v<Turn>);

// The program's window, with a hand that goes round inside the wall.
class DrawnWindow {
 public:
  explicit DrawnWindow(double rate_hz)
      : application_(window_, load_scene("wall45", std::vector{fmt::format("device.rate_hz={:.0f}", rate_hz)}),
                     {.inputs = desktop_inputs(), .input = "circle"}) {
    draw_for(1.0);  // shaders are compiled meanwhile
  }

  Servo& servo() { return application_.servo(); }

  // Returns frames per second.
  double draw_for(double seconds) {
    const auto began = steady_clock::now();
    auto next = began;
    int frames = 0;
    for (; duration<double>(next - began).count() < seconds; ++frames) {
      application_.frame(interval_s);
      window_.poll(0.0);
      next = std::max(next + std::chrono::duration_cast<steady_clock::duration>(duration<double>(interval_s)),
                      steady_clock::now());
      std::this_thread::sleep_until(next);
    }
    return frames / duration<double>(steady_clock::now() - began).count();
  }

 private:
  static constexpr double interval_s = 1.0 / 60.0;

  GlfwWindow window_{{.title = "jitter", .offscreen = true, .takes_mouse = false}};
  Application application_;
};

// Of all threads of that name in this process [ns].
double processor_ns(std::string_view thread_name) {
  double sum = 0.0;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::string name;
    std::getline(std::ifstream(task.path() / "comm"), name);
    double ns = 0.0;
    if (name == thread_name && std::ifstream(task.path() / "schedstat") >> ns) sum += ns;
  }
  return sum;
}

// While the loop of that name runs.
void watch(DrawnWindow& window, const char* thread_name, double seconds, Turn& turn) {
  const std::int64_t began = monotonic_ns();
  const double before = processor_ns(thread_name);
  turn.frames_per_second = window.draw_for(seconds);
  turn.processor_share = (processor_ns(thread_name) - before) / static_cast<double>(monotonic_ns() - began);
}

void run_servo(DrawnWindow& window, double /*rate_hz*/, double seconds, Turn& turn) {
  ServoThread thread;
  thread.start(window.servo());
  watch(window, "servo", seconds, turn);
  thread.stop();
  turn.latency_histogram = thread.latency_histogram();
  turn.lost = window.servo().newest().loop.late_ticks;
  turn.realtime = window.servo().newest().realtime;
}

// As one writes it first.
void run_naive_loop(DrawnWindow& window, double rate_hz, double seconds, Turn& turn) {
  std::atomic<bool> stopping{false};
  std::thread loop([&] {
    pthread_setname_np(pthread_self(), "naive");
    const auto period = std::chrono::duration_cast<steady_clock::duration>(duration<double>(1.0 / rate_hz));
    auto deadline = steady_clock::now();
    while (!stopping) {
      deadline += period;
      std::this_thread::sleep_until(deadline);
      const auto late = steady_clock::now() - deadline;
      turn.latency_histogram.add(std::chrono::nanoseconds(late).count());
      turn.lost += static_cast<std::uint64_t>(late / period);
      deadline += late / period * period;
    }
  });
  watch(window, "naive", seconds, turn);
  stopping = true;
  loop.join();
}

// Its histogram is in whole µs, cut off: half of one is added.
void read_cyclictest(std::FILE* output, double rate_hz, Turn& turn) {
  const auto period_us = static_cast<std::int64_t>(1e6 / rate_hz);
  char line[256];
  while (std::fgets(line, sizeof line, output) != nullptr) {
    long late_us = 0;
    unsigned long long ticks = 0;
    if (line[0] == '#' || std::sscanf(line, "%ld %llu", &late_us, &ticks) != 2 || ticks == 0) continue;
    turn.latency_histogram.add(late_us * 1000 + 500, ticks);
    turn.lost += ticks * static_cast<std::uint64_t>(late_us / period_us);
  }
}

void run_cyclictest(DrawnWindow& window, double rate_hz, double seconds, Turn& turn) {
  const std::string call =
      fmt::format("cyclictest -p80 -m -q -i{:.0f} -h 50000 -l{:.0f} 2>/dev/null", 1e6 / rate_hz, seconds * rate_hz);
  std::FILE* const output = popen(call.c_str(), "r");
  if (output == nullptr) throw std::system_error(errno, std::generic_category(), "cyclictest");
  turn.frames_per_second = window.draw_for(seconds + 0.2);
  read_cyclictest(output, rate_hz, turn);
  pclose(output);
}

// What an ordinary user may.
void drop_privileges() {
  for (const auto resource : {RLIMIT_RTPRIO, RLIMIT_NICE}) {
    const rlimit nothing{0, 0};
    setrlimit(resource, &nothing);
  }
  constexpr uid_t nobody = 65534;
  if (geteuid() == 0 && (setresgid(nobody, nobody, nobody) != 0 || setresuid(nobody, nobody, nobody) != 0)) {
    throw std::system_error(errno, std::generic_category(), "an ordinary user");
  }
}

struct Contestant {
  const char* name;
  double rate_hz;
  bool is_privileged;
  void (*run)(DrawnWindow& window, double rate_hz, double seconds, Turn& turn);
  std::vector<Turn> turns{};

  double median_of(double share) const {
    return of_turns(
        [share](const Turn& turn) { return static_cast<double>(turn.latency_histogram.percentile_ns(share)); });
  }
  double of_turns(const std::function<double(const Turn&)>& value) const {
    std::vector<double> values;
    for (const Turn& turn : turns) values.push_back(value(turn));
    return median(std::move(values));
  }
  std::uint64_t sum(const std::function<std::uint64_t(const Turn&)>& value) const {
    std::uint64_t sum = 0;
    for (const Turn& turn : turns) sum += value(turn);
    return sum;
  }
  std::uint64_t lost() const {
    return sum([](const Turn& turn) { return turn.lost; });
  }
  std::uint64_t ticks() const {
    return sum([](const Turn& turn) { return turn.latency_histogram.ticks(); });
  }
  double worst_us() const {
    std::int64_t worst = 0;
    for (const Turn& turn : turns) worst = std::max(worst, turn.latency_histogram.worst_ns());
    return 1e-3 * static_cast<double>(worst);
  }
  // Deadlines stay on a grid: those kept, of all that there were.
  double kept_rate_hz() const { return rate_hz * static_cast<double>(ticks()) / static_cast<double>(ticks() + lost()); }
};

// Privileges that are dropped, and memory that is locked, end with the process.
Turn turn_of(const Contestant& contestant, double seconds) {
  int ends[2];
  if (pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    int code = 1;
    try {
      if (!contestant.is_privileged) drop_privileges();
      if (contestant.run == run_servo) leave_processor_to_servo();  // as ghostforce run does
      DrawnWindow window(contestant.rate_hz);
      Turn turn;
      contestant.run(window, contestant.rate_hz, seconds, turn);
      if (write(ends[1], &turn, sizeof turn) == static_cast<ssize_t>(sizeof turn)) code = 0;
    } catch (const std::exception& error) {
      fmt::print(stderr, "{}: {}\n", contestant.name, error.what());
    }
    _exit(code);
  }
  close(ends[1]);
  Turn turn;
  std::size_t got = 0;
  while (got < sizeof turn) {
    const ssize_t count = read(ends[0], reinterpret_cast<char*>(&turn) + got, sizeof turn - got);
    if (count <= 0) break;
    got += static_cast<std::size_t>(count);
  }
  close(ends[0]);
  waitpid(child, nullptr, 0);
  if (got < sizeof turn || turn.latency_histogram.ticks() == 0)
    throw std::runtime_error(fmt::format("{}: no ticks (cyclictest is in Debian's rt-tests)", contestant.name));
  return turn;
}

double ratio(const Contestant& one, const Contestant& other, double share) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < one.turns.size(); ++i) {
    const auto of = [share](const Turn& turn) {
      return static_cast<double>(turn.latency_histogram.percentile_ns(share));
    };
    ratios.push_back(of(one.turns[i]) / of(other.turns[i]));
  }
  return median(std::move(ratios));
}

void tell(Report& report, const Contestant& contestant) {
  const auto us = [&](double share) { return 1e-3 * contestant.median_of(share); };
  report.row(fmt::format("{}: late by, p50 · p99 · p99.9 · worst", contestant.name),
             fmt::format("{:.2f} · {:.1f} · {:.1f} · {:.0f} µs", us(0.5), us(0.99), us(0.999), contestant.worst_us()));
  const double share = contestant.of_turns([](const Turn& turn) { return turn.processor_share; });
  report.row(fmt::format("{}: lost ticks · rate · share of a processor", contestant.name),
             fmt::format("{} of {} · {:.1f} Hz · {}", contestant.lost(), contestant.lost() + contestant.ticks(),
                         contestant.kept_rate_hz(), share < 0.0 ? "—" : fmt::format("{:.1f} %", 100.0 * share)));
}

void compare(Report& report, const Contestant& one, const Contestant& other, double share, const char* words,
             std::optional<double> limit) {
  const double value = ratio(one, other, share);
  report.row(fmt::format("{}: {} / {}", words, one.name, other.name), fmt::format("{:.3f}", value),
             limit ? std::optional(at_most(value, *limit)) : std::nullopt);
}

double seconds_in_all() {
  const char* const words = std::getenv("GHOSTFORCE_JITTER_SECONDS");
  return words != nullptr ? std::max(1.0, std::strtod(words, nullptr)) : 60.0;
}

int measure(int argc, char** argv) {
  const double seconds = seconds_in_all() / rounds;
  Contestant servo{"servo, real time", 1000.0, true, run_servo};
  Contestant cyclictest{"cyclictest", 1000.0, true, run_cyclictest};
  Contestant fast_servo{"servo at 4 kHz", 4000.0, true, run_servo};
  Contestant fast_cyclictest{"cyclictest at 4 kHz", 4000.0, true, run_cyclictest};
  Contestant ordinary_servo{"servo, ordinary user", 1000.0, false, run_servo};
  Contestant naive_loop{"sleep_until", 1000.0, false, run_naive_loop};
  const std::vector<Contestant*> all{&servo, &cyclictest, &fast_servo, &fast_cyclictest, &ordinary_servo, &naive_loop};
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t turn = 0; turn < all.size(); ++turn) {
      Contestant& contestant = *all[round % 2 == 0 ? turn : all.size() - 1 - turn];
      contestant.turns.push_back(turn_of(contestant, seconds));
    }
  }

  Report report("2. The loop");
  report.paragraph(
      fmt::format("How late ticks come behind their deadlines, {:.0f} s per contestant in {} turns, each turn a "
                  "process that draws the program's window at 60 Hz beside the loop (offscreen, in software, on the "
                  "same processors). Percentiles are medians over the turns, ratios medians of those within a round. "
                  "`servo` is the program's own thread, `cyclictest` `-p80 -m` (µs), `sleep_until` a loop around "
                  "`std::this_thread::sleep_until` that does nothing else.",
                  seconds * rounds, rounds));
  for (const Contestant* contestant : all) tell(report, *contestant);
  if (servo.turns.front().realtime.priority_error == 0) {
    compare(report, servo, cyclictest, 0.5, "p50", 0.05);
    compare(report, servo, cyclictest, 0.99, "p99", 0.75);
    compare(report, servo, cyclictest, 0.999, "p99.9", 1.5);
    const double share = 100.0 * servo.of_turns([](const Turn& turn) { return turn.processor_share; });
    report.row("servo, real time: share of a processor", fmt::format("{:.1f} %", share), at_most(share, 6.0, "%"));
    compare(report, fast_servo, fast_cyclictest, 0.5, "p50", std::nullopt);
    compare(report, fast_servo, fast_cyclictest, 0.99, "p99", std::nullopt);
    compare(report, fast_servo, fast_cyclictest, 0.999, "p99.9", std::nullopt);
    report.row("servo at 4 kHz: rate", fmt::format("{:.1f} Hz", fast_servo.kept_rate_hz()),
               at_least(fast_servo.kept_rate_hz(), 3980.0, "Hz"));
  } else {
    report.note("Real-time priority was not allowed: nothing to compare with cyclictest.");
  }
  compare(report, ordinary_servo, naive_loop, 0.5, "p50", std::nullopt);
  compare(report, ordinary_servo, naive_loop, 0.99, "p99", 0.02);
  compare(report, ordinary_servo, naive_loop, 0.999, "p99.9", 0.5);
  const double lost = static_cast<double>(ordinary_servo.lost());
  const double lost_naively = static_cast<double>(naive_loop.lost());
  report.row("lost ticks: servo, ordinary user / sleep_until", fmt::format("{:.0f} / {:.0f}", lost, lost_naively),
             Goal{"≤ 0.05", lost <= 0.05 * lost_naively});
  report.row("servo, ordinary user: rate", fmt::format("{:.1f} Hz", ordinary_servo.kept_rate_hz()),
             at_least(ordinary_servo.kept_rate_hz(), 995.0, "Hz"));
  const auto frames = [](const Turn& turn) { return turn.frames_per_second; };
  report.row("frames beside: servo, real time · cyclictest · servo, ordinary user · sleep_until",
             fmt::format("{:.0f} · {:.0f} · {:.0f} · {:.0f} /s", servo.of_turns(frames), cyclictest.of_turns(frames),
                         ordinary_servo.of_turns(frames), naive_loop.of_turns(frames)));
  report.note(fmt::format("What the system grants the servo: “{}”, and as an ordinary user “{}”.",
                          describe(servo.turns.front().realtime), describe(ordinary_servo.turns.front().realtime)));
  report.note(
      "An ordinary user's servo has short time slices and a processor that drawing leaves to it. It stays there: seen "
      "beside other programs that kept both processors busy, that lost 165 ticks of 5000 instead of 923 with the "
      "choice of both (a loop around sleep_until: 624), p99 1.1 instead of 4.0 ms. Tried beside it: a long slice and "
      "SCHED_BATCH for drawing (252 of 5000, against 228 without, and 1138 against 813 with the choice of both "
      "processors), and nice 19 for drawing (155, against 165), from which an ordinary user's thread cannot come back, "
      "as it must before motors are armed. Nothing that needs no privilege was found against the rest of what other "
      "programs take.");
  report.note(
      "Drawing in the idle class is not used: Linux refuses to let an ordinary user's thread out of it again (EPERM), "
      "also those that it creates, and beside other programs it drew 3 frames a second. Nor is spinning without "
      "real-time priority: seen, it doubled the ticks lost. On a machine with nothing else to do 0.02 is out of reach "
      "where waking from sleep alone takes longer than that share of the naive loop's p99 (p50).");
  return report.finish(argc, argv);
}

}  // namespace
}  // namespace ghostforce::bench

int main(int argc, char** argv) {
  try {
    return ghostforce::bench::measure(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
