// Takes the Falcon, arms it, and once its motors push ends in the way that its argument names. On the way it says a
// line at a time what it wants of the hand ("outside", "aside", "inside"), that its motors push ("pushing"), and, of what it
// does itself, when ("ends", in ns of CLOCK_MONOTONIC). Some ways take a second argument: a signal's number, or the
// name of a thread. With "signals blocked" before it all, it begins as a program does that was started with them so.
#undef NDEBUG  // assertions hold in every build of this program
#include <cassert>

#include <pthread.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cinttypes>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/files/scene_file.h"
#include "app/runs/recording.h"
#include "device/falcon/falcon_input.h"
#include "device/falcon_usb/ftdi_link.h"
#include "device/motors/emergency_stop.h"
#include "device/servo/servo.h"
#include "device/servo/servo_thread.h"
#include "device/spacemouse/hid_spacemouse_input.h"
#include "device/virtual_falcon/practice_firmware.h"
#include "tests/device/servo/motor_settings.h"
#include "tests/emulation/orders.h"

namespace ghostforce {
namespace {

constexpr double pushing_n = 1.0;
// For so many looks, 2 ms and more each: what checks the motors goes to and fro faster.
constexpr int enough_pushes = 40;

void say(const char* line) {
  std::printf("%s\n", line);
  std::fflush(stdout);
}

void say_end() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  std::printf("ends %" PRId64 "\n", std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec);
  std::fflush(stdout);
}

// A real one, at an address that is mapped: a null pointer would be found by the sanitizer first.
void touch_forbidden_memory() {
  auto* const page = static_cast<volatile char*>(
      mmap(nullptr, static_cast<std::size_t>(sysconf(_SC_PAGESIZE)), PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
  *page = 1;
}

// Until the stack of the thread that calls it is used up.
int go_deeper(int depth) {
  volatile char room[1024];
  room[0] = static_cast<char>(depth);
  return depth < 0 ? 0 : go_deeper(depth + 1) + room[0];
}

// Until a stack is used up nothing has gone wrong. A small one is used up at once, however busy the machine is.
constexpr std::size_t small_stack = 256 << 10;  // [bytes]

void overflow_stack() {
  // Wherever this program was started: the main thread's stack grows up to this limit, which may be none.
  rlimit limit{};
  getrlimit(RLIMIT_STACK, &limit);
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_cur, small_stack);
  setrlimit(RLIMIT_STACK, &limit);
  go_deeper(1);
}

void overflow_stack_of_new_thread() {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, small_stack);
  pthread_setattr_default_np(&attributes);
  pthread_attr_destroy(&attributes);
  std::thread(overflow_stack).detach();
}

void sleep_for_ever() {
  for (;;) std::this_thread::sleep_for(std::chrono::seconds(1));
}

void loop_for_ever() {
  for (volatile bool goes_on = true; goes_on;) {
  }
}

// Threads show their names here.
pid_t thread_named(std::string_view name) {
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::string line;
    std::getline(std::ifstream(task.path() / "comm"), line);
    if (line == name) return std::stoi(task.path().filename());
  }
  return 0;
}

// The second argument.
std::string_view fault_detail;

void raise_signal() {
  std::raise(std::stoi(std::string(fault_detail)));
}

// In which the servo's own thread may be made to run into a bug.
class MinedInput final : public FalconInput {
 public:
  using FalconInput::FalconInput;
  using Mine = void (*)();

  HandleReading read() noexcept override {
    if (const Mine mine = mine_.load()) mine();
    return FalconInput::read();
  }
  void lay(Mine mine) noexcept { mine_.store(mine); }

 private:
  std::atomic<Mine> mine_{nullptr};
};

// A floor, and a motor that pushes up from it.
Settings floor_settings() {
  Settings settings = motor_settings(StrategyId::naive);
  settings.wall_point = {0.0, -0.01};
  settings.wall_normal_angle = settings.actuated_angle = 0.5 * std::acos(-1.0);
  return settings;
}

// What the window is to the servo.
class Person {
 public:
  Person() {
    command_.settings = floor_settings();
    command_.restart_state = state_at_start(Vector<2>(0.0));
    FalconOptions options;
    options.firmware = practice_firmware();
    auto input = std::make_unique<MinedInput>(std::make_unique<FtdiLink>(), options, Vector<2>(0.0));
    input_ = input.get();
    servo_ = std::make_unique<Servo>(std::move(input), command_);
    thread_.start(*servo_);
  }

  // Until motors push. Begins once more whenever they went off before, or did not come on, because this machine has
  // other things to do.
  void arm_and_lean_in() {
    constexpr int most_attempts = 300;  // of two seconds or more each
    while (!input_->report().is_readable()) live();
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
      say(attempt % 2 == 0 ? "outside" : "aside");
      ask_for_motors();
      for (int rounds = 0; !is_armed() && rounds < 1000; ++rounds) live();
      if (!is_armed()) continue;
      say("inside");
      int pushes = 0;  // in a row
      while (motors().state == SafetyState::ramp || motors().state == SafetyState::on) {
        pushes = glm::length(motors().sent) > pushing_n ? pushes + 1 : 0;
        if (pushes > enough_pushes) return say("pushing");
        live();
      }
      while (motors().state != SafetyState::off) live();
    }
    const MotorReport& now = motors();
    throw std::runtime_error(fmt::format("the motors do not come on: {}; last {}", entry_of(now.obstacle).sentence,
                                         entry_of(now.last_reason).name));
  }

  void ask_for_motors() {
    ++command_.acknowledgements;
    ++command_.arms_asked;
  }

  // Throws when interrupted.
  void live() {
    stop_if_interrupted();
    ++command_.heartbeats;
    servo_->send(command_);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }

  const MotorReport& motors() { return servo_->newest().motors; }
  bool is_armed() { return motors().state != SafetyState::off && motors().state != SafetyState::arming; }
  ServoCommand& command() { return command_; }
  MinedInput& input() { return *input_; }
  Servo& servo() { return *servo_; }
  ServoThread& thread() { return thread_; }

 private:
  ServoCommand command_;
  MinedInput* input_ = nullptr;
  std::unique_ptr<Servo> servo_;
  ServoThread thread_;
};

struct Way {
  std::string_view name;
  void (*go)(Person& person);
};

constexpr Way ways[] = {
    {"return", [](Person&) {}},
    {"stop and exit",
     [](Person& person) {
       person.thread().stop();
       std::exit(0);
     }},
    // As libraries do, Xlib for one when it has lost its display: no destructor on any stack runs.
    {"exit", [](Person&) { std::exit(0); }},
    {"wait",
     [](Person& person) {
       for (;;) person.live();
     }},
    {"obey", [](Person& person) { obey_orders(person); }},
    {"look", [](Person& person) { obey_orders(person); }},  // without arming the motors first
    // Hears of nothing, because its main thread hangs.
    {"hang", [](Person&) { sleep_for_ever(); }},
    {"stall",
     [](Person& person) {
       std::this_thread::sleep_for(std::chrono::milliseconds(1500));
       say(entry_of(person.motors().reason).name.data());
     }},
    {"abort", [](Person&) { std::abort(); }},
    {"assertion", [](Person& person) { assert(glm::length(person.motors().sent) < 0.0); }},
    {"exception", [](Person&) { throw std::runtime_error("that nobody catches"); }},
    {"segmentation fault", [](Person&) { touch_forbidden_memory(); }},
    {"stack overflow", [](Person&) { overflow_stack(); }},
    // On one that has no place of its own to run into a bug: it gets a signal that nothing else uses.
    {"stack overflow on another thread",
     [](Person& person) {
       Recording recording("run.csv", load_scene("wall45"), person.servo(), 1);
       const HidSpaceMouseInput space_mouse;
       struct sigaction action {};
       action.sa_handler = [](int) { overflow_stack(); };
       sigaction(SIGURG, &action, nullptr);
       pid_t thread = 0;
       while ((thread = thread_named(fault_detail)) == 0) person.live();
       tgkill(getpid(), thread, SIGURG);
       sleep_for_ever();
     }},
    // On one that knows nothing of this program's handlers.
    {"stack overflow on a library's thread",
     [](Person&) {
       overflow_stack_of_new_thread();
       sleep_for_ever();
     }},
    {"segmentation faults on two threads",
     [](Person& person) {
       person.input().lay(touch_forbidden_memory);
       touch_forbidden_memory();
     }},
    {"signal on the servo's thread", [](Person& person) { person.input().lay(raise_signal); }},
    {"stack overflow on the servo's thread", [](Person& person) { person.input().lay(overflow_stack); }},
    {"endless loop on the servo's thread", [](Person& person) { person.input().lay(loop_for_ever); }},
    {"abort on the servo's thread", [](Person& person) { person.input().lay([] { std::abort(); }); }},
    {"segmentation fault on the servo's thread", [](Person& person) { person.input().lay(touch_forbidden_memory); }},
};

int run(std::string_view name) {
  for (const Way& way : ways) {
    if (way.name != name) continue;
    Person person;
    if (name != "look") person.arm_and_lean_in();
    say_end();
    way.go(person);
    // The servo's thread is on its way.
    if (name.ends_with("thread")) sleep_for_ever();
    return 0;
  }
  return static_cast<int>(ExitCode::wrong_call);
}

// As whoever started it may have had them; what a program begins with outlives its exec.
void start_anew_with_signals_blocked(char** argv) {
  sigset_t blocked;
  sigemptyset(&blocked);
  for (const int signal : {SIGTERM, SIGHUP, SIGINT}) sigaddset(&blocked, signal);
  sigprocmask(SIG_BLOCK, &blocked, nullptr);
  execv("/proc/self/exe", argv + 1);
}

}  // namespace
}  // namespace ghostforce

int main(int argc, char** argv) {
  using namespace ghostforce;
  if (argc > 1 && std::string_view(argv[1]) == "signals blocked") start_anew_with_signals_blocked(argv);
  // In the order of the real main().
  remember_interruptions(emergency_stop::stop_motors);
  emergency_stop::install_handlers();
  try {
    if (argc > 2) fault_detail = argv[2];
    return run(argc > 1 ? argv[1] : "");
  } catch (const Failure& failure) {
    return static_cast<int>(failure.code());
  }
}
