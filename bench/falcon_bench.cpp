// What a Falcon costs: how fast the driver's exchanges go, and how much of a processor the servo's thread takes. A
// table for people, then the same as CSV. Through umockdev: cmake --build build/release --target run_falcon_bench; see
// README.md for what the numbers mean.
#include <pthread.h>
#include <time.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "bench/prompt_chip.h"
#include "device/falcon/falcon_input.h"
#include "device/falcon_usb/ftdi_link.h"
#include "device/input/mouse_input.h"
#include "device/servo/servo_thread.h"
#include "device/virtual_falcon/virtual_falcon_input.h"
#include "tests/device/virtual_falcon/rehearsal.h"
#include "tests/emulation/emulated_usb_device.h"
#include "tests/emulation/falcon_chip.h"

namespace ghostforce {
namespace {

constexpr FalconDsp::Options homed_device{.starts_with_firmware = true, .starts_homed = true};

std::int64_t clock_ns(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

class Results {
 public:
  void add(const std::string& what, const std::string& quantity, double value, const char* unit) {
    rows_.push_back({what, quantity, value, unit});
  }
  void print() const {
    for (const Row& row : rows_) {
      std::printf("%-44s %-12s %10.2f %s\n", row.what.c_str(), row.quantity.c_str(), row.value, row.unit);
    }
    std::printf("\nwhat,quantity,value,unit\n");
    for (const Row& row : rows_) {
      std::printf("%s,%s,%.6g,%s\n", row.what.c_str(), row.quantity.c_str(), row.value, row.unit);
    }
  }

 private:
  struct Row {
    std::string what;
    std::string quantity;
    double value;
    const char* unit;
  };
  std::vector<Row> rows_;
};

// A command as soon as the last one has been answered, for three seconds.
void exchange(Results& results, const std::string& what, std::unique_ptr<FalconLink> link) {
  Falcon falcon(std::move(link), {});
  const auto until = [&](auto is_so) {
    const std::int64_t deadline_ns = falcon.link().now_ns() + 5'000'000'000;
    while (!is_so() && falcon.link().now_ns() < deadline_ns) {
      falcon.update();
      if (!is_so()) falcon.wait_until(falcon.link().now_ns() + 1'000'000);
    }
    if (!is_so()) throw std::runtime_error(what + ": no exchange");
  };
  until([&] { return falcon.report().is_readable(); });
  std::vector<std::int64_t> times_ns;
  const std::int64_t began_ns = falcon.link().now_ns();
  std::int64_t now_ns = began_ns;
  while (now_ns < began_ns + 3'000'000'000) {
    const std::uint64_t exchanges = falcon.report().exchanges;
    falcon.set_force(Vector<3>(0.0), true);
    until([&] { return falcon.report().exchanges > exchanges; });
    times_ns.push_back(falcon.link().now_ns() - std::exchange(now_ns, falcon.link().now_ns()));
  }
  falcon.shut_down();
  std::ranges::sort(times_ns);
  const auto at = [&](double share) {
    return static_cast<double>(times_ns[static_cast<std::size_t>(share * static_cast<double>(times_ns.size() - 1))]) /
           1000.0;
  };
  results.add(what, "exchanges", static_cast<double>(times_ns.size()) * 1e9 / static_cast<double>(now_ns - began_ns),
              "1/s");
  results.add(what, "median", at(0.5), "us");
  results.add(what, "99 %", at(0.99), "us");
  results.add(what, "worst", at(1.0), "us");
}

// An input that tells which thread ticks.
class ClockedInput final : public Input {
 public:
  explicit ClockedInput(std::unique_ptr<Input> input) : input_(std::move(input)) {}

  void restart(const Vector<2>& goal) noexcept override { input_->restart(goal); }
  Vector<2> goal(std::int64_t tick, double rate) noexcept override {
    clockid_t clock{};
    pthread_getcpuclockid(pthread_self(), &clock);
    clock_ = clock;
    return input_->goal(tick, rate);
  }
  HapticDevice* haptic_device() noexcept override { return input_->haptic_device(); }

  clockid_t clock() const noexcept { return clock_; }  // good after the first tick, while the thread runs

 private:
  std::unique_ptr<Input> input_;
  std::atomic<clockid_t> clock_{};
};

ServoCommand first_command() {
  ServoCommand command;
  command.settings = rehearsal_settings();
  command.restart_state = state_at_start(Rehearsal::free_place);
  return command;
}

// Of the servo's thread at 1 kHz, over five seconds, from the second one on: by then a Falcon is homed.
void share(Results& results, const std::string& what, std::unique_ptr<Input> input, std::chrono::seconds start) {
  auto clocked = std::make_unique<ClockedInput>(std::move(input));
  const ClockedInput& thread = *clocked;
  Servo servo(std::move(clocked), first_command());
  ServoThread driver;
  driver.start(servo);
  std::this_thread::sleep_for(start);
  const std::int64_t began_ns = clock_ns(CLOCK_MONOTONIC);
  const std::int64_t cpu_began_ns = clock_ns(thread.clock());
  std::this_thread::sleep_for(std::chrono::seconds(5));
  const auto cpu_ns = static_cast<double>(clock_ns(thread.clock()) - cpu_began_ns);
  const auto wall_ns = static_cast<double>(clock_ns(CLOCK_MONOTONIC) - began_ns);
  results.add(what, "processor", 100.0 * cpu_ns / wall_ns, "%");
  results.add(what, "ticks", servo.newest().loop.rate_hz, "1/s");
}

// What the virtual Falcon's far end takes of that: it lives on the servo's thread.
void simulation(Results& results) {
  FalconDsp dsp(homed_device, 0);
  SimulatedArm arm({});
  SimulatedHand hand({}, 0);
  constexpr std::int64_t duration_ns = 5'000'000'000;
  const std::int64_t began_ns = clock_ns(CLOCK_THREAD_CPUTIME_ID);
  for (std::int64_t now = 0; now < duration_ns; now += VirtualLink::step_ns) {
    dsp.advance(now);
    hand.advance(now, false);
    arm.step(static_cast<double>(VirtualLink::step_ns) * 1e-9, dsp.motors(), hand.goal(), hand.stiffness());
    dsp.set_encoders(arm.encoders());
  }
  const auto cpu_ns = static_cast<double>(clock_ns(CLOCK_THREAD_CPUTIME_ID) - began_ns);
  results.add("virtual device alone", "processor", 100.0 * cpu_ns / static_cast<double>(duration_ns), "%");
}

template <typename Work>
double ns_per_tick(int ticks, const Work& work) {
  const std::int64_t began_ns = clock_ns(CLOCK_THREAD_CPUTIME_ID);
  for (int i = 0; i < ticks; ++i) work();
  return static_cast<double>(clock_ns(CLOCK_THREAD_CPUTIME_ID) - began_ns) / ticks;
}

void servo_step(Results& results) {
  Sample sample;
  Servo with_mouse(std::make_unique<MouseInput>(), first_command());
  results.add("Servo::step with a mouse", "processor",
              ns_per_tick(200'000,
                          [&] {
                            with_mouse.step();
                            with_mouse.take_sample(sample);
                          }),
              "ns");
  Rehearsal rehearsal;
  rehearsal.turn_on();
  rehearsal.input().move_to({0.01, -0.01}, 0.3);
  rehearsal.run(1.0);
  if (rehearsal.motors().state != SafetyState::on) throw std::runtime_error("the rehearsal's motors went off");
  results.add("Servo::step armed with a stepped virtual Falcon", "processor",
              ns_per_tick(20'000,
                          [&] {
                            rehearsal.step();
                            rehearsal.servo().take_sample(sample);
                          }),
              "ns");
}

std::unique_ptr<FalconLink> virtual_link() {
  return std::make_unique<VirtualLink>(VirtualLink::Options{.device = homed_device});
}

// Plugged in as long as this stands.
template <typename Chip>
struct Cable {
  explicit Cable(std::unique_ptr<Chip> far_end) : chip(std::move(far_end)) { falcon.plug(); }

  std::unique_ptr<Chip> chip;
  TestBed bed;
  EmulatedUsbDevice falcon{bed, *chip, "12PZ657E"};
};

void measure() {
  Results results;
  {
    const Cable cable(std::make_unique<FalconChip>(homed_device));
    exchange(results, "libusb; emulated Falcon", std::make_unique<FtdiLink>());
    share(results, "servo: Falcon through libusb",
          std::make_unique<FalconInput>(std::make_unique<FtdiLink>(), FalconOptions{}, Vector<2>(0.0)),
          std::chrono::seconds(1));
  }
  {
    const Cable cable(std::make_unique<PromptChip>());
    exchange(results, "libusb; chip that answers at once", std::make_unique<FtdiLink>());
  }
  exchange(results, "virtual Falcon", virtual_link());
  share(results, "servo: mouse", std::make_unique<MouseInput>(), std::chrono::seconds(1));
  Scene scene;
  scene.settings.stiffnesses.k_u = 100.0;
  // It has to be loaded and homed first.
  share(results, "servo: virtual Falcon", std::make_unique<VirtualFalconInput>(FalconOptions{}, InjectedFault{}, scene),
        std::chrono::seconds(6));
  simulation(results);
  servo_step(results);
  results.print();
}

}  // namespace
}  // namespace ghostforce

int main() {
  try {
    ghostforce::measure();
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
