// Takes the Haply at the port that its first argument names, arms it, and once its motors push ends in the way that its
// second argument names. On the way it says a line at a time what it wants of the hand ("outside", "inside", and "zero
// pose", which is to be answered by a line once the arms are there), that its motors push ("pushing"), and, of what it
// does itself, when ("ends", in ns of CLOCK_MONOTONIC). The hand must hold the zero pose when this program begins. Some
// ways take a third argument: a signal's number.
#include <pthread.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cinttypes>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <glm/geometric.hpp>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "device/haply/haply_input.h"
#include "device/haply_serial/tty_port.h"
#include "device/input/monotonic_clock.h"
#include "device/motors/emergency_stop.h"
#include "device/servo/servo.h"
#include "device/servo/servo_thread.h"
#include "tests/device/servo/motor_settings.h"

namespace ghostforce {
namespace {

constexpr double pushing_n = 1.0;
// For so many looks, 2 ms and more each: what checks the motors goes to and fro faster.
constexpr int enough_pushes = 40;
constexpr Vector<2> free_place{-0.015, 0.015};  // as held_haply.h has it

void say(const std::string& line) {
  std::printf("%s\n", line.c_str());
  std::fflush(stdout);
}

void say_end() {
  say(fmt::format("ends {}", monotonic_ns()));
}

// The arguments.
std::string port_path;
std::string detail;

// --- What goes wrong -------------------------------------------------------------------------------------------------

// Null where no compiler sees it; a sanitizer would find it first.
#if defined(__clang__) || defined(__GNUC__)
__attribute__((no_sanitize("address", "undefined")))
#endif
void write_to_null() {
  char* volatile nothing = nullptr;
  char* const place = nothing;
  *static_cast<volatile char*>(place) = 1;
}

// Until the stack of the thread that calls it is used up.
int go_deeper(int depth) {
  volatile char room[1024];
  room[0] = static_cast<char>(depth);
  return depth < 0 ? 0 : go_deeper(depth + 1) + room[0];
}

void overflow_stack() {
  // The main thread's stack grows up to this limit, which may be none. A small one is used up at once.
  rlimit limit{};
  getrlimit(RLIMIT_STACK, &limit);
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_cur, 256 << 10);
  setrlimit(RLIMIT_STACK, &limit);
  go_deeper(1);
}

void sleep_for_ever() {
  for (;;) std::this_thread::sleep_for(std::chrono::seconds(1));
}

void loop_for_ever() {
  for (volatile bool goes_on = true; goes_on;) {
  }
}

// In a system call, as one that waits for a lock or a disk.
void block_for_ever() {
  for (;;) poll(nullptr, 0, -1);
}

void raise_signal() {
  std::raise(std::stoi(detail));
}

// The number of this program's file of the port; negative: it has none open.
int port_descriptor() {
  const std::string node = std::filesystem::canonical(port_path);
  for (const auto& file : std::filesystem::directory_iterator("/proc/self/fd")) {
    std::error_code gone;
    if (std::filesystem::read_symlink(file.path(), gone) == node) return std::stoi(file.path().filename());
  }
  return -1;
}

// As a library does that closes the same number twice.
void close_port() {
  close(port_descriptor());
}

// And a file of somebody else's has got it before the driver comes to write: that takes all of its packets, and says
// nothing.
void put_socket_in_place_of_port() {
  int ends[2] = {-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, ends) != 0) return;
  dup3(ends[0], port_descriptor(), O_CLOEXEC);
}

// As a program does that means to become a daemon: the guard's pipe goes as well.
void close_all_files() {
  close_range(STDERR_FILENO + 1, ~0U, 0);
}

void become_another_program() {
  execl("/bin/sleep", "sleep", "1000", nullptr);
}

// A child that has all of this one's files open, and does nothing with them.
void leave_child() {
  const pid_t child = fork();
  if (child == 0) block_for_ever();
  say(fmt::format("child {}", child));
}

// --- The program -----------------------------------------------------------------------------------------------------

// In which the servo's own thread may be made to run into a bug.
class MinedHaplyInput final : public HaplyInput {
 public:
  using HaplyInput::HaplyInput;
  using Mine = void (*)();

  HandleReading read() noexcept override {
    if (const Mine mine = mine_.load()) mine();
    return HaplyInput::read();
  }
  void lay(Mine mine) noexcept { mine_.store(mine); }

 private:
  std::atomic<Mine> mine_{nullptr};
};

// A wall of 45° through the middle, free on the upper left of the scene.
Settings wall_settings() {
  Settings settings = motor_settings(StrategyId::naive);
  settings.wall_normal_angle = 0.75 * std::acos(-1.0);
  return settings;
}

// What the window is to the servo.
class Person {
 public:
  Person() {
    command_.settings = wall_settings();
    command_.restart_state = state_at_start(free_place);
    auto input = std::make_unique<MinedHaplyInput>(std::make_unique<TtyPort>(TtyPortOptions{.path = port_path}),
                                                   HaplyOptions{}, Vector<2>(0.0));
    input->choose_motor(1);
    input_ = input.get();
    servo_ = std::make_unique<Servo>(std::move(input), command_);
    thread_.start(*servo_);
  }

  // Arms that stand still on a machine that is busy with other things may not be there yet.
  void ask_for_zero_pose() {
    say("zero pose");
    pollfd answer{STDIN_FILENO, POLLIN, 0};
    while (poll(&answer, 1, 0) == 0) live();
    for (char letter = 0; letter != '\n' && read(STDIN_FILENO, &letter, 1) == 1;) continue;
    set_zero_pose();
  }
  void set_zero_pose() {
    const auto may_confirm = [this] {
      return report().state == HaplyState::zero_pose || report().state == HaplyState::idle ||
             report().fault == HaplyFault::kinematics;
    };
    while (!may_confirm()) live();
    while (report().zero_pose != ZeroPose::confirmed) {
      // What is not still yet is asked for again after a while.
      if (report().zero_pose != ZeroPose::setting) input_->confirm_zero_pose();
      for (int rounds = 0; report().zero_pose != ZeroPose::confirmed && rounds < 200; ++rounds) live();
    }
  }

  // Until motors push. Begins once more whenever they went off before, or did not come on, because this machine has
  // other things to do.
  void arm_and_lean_in() {
    constexpr int most_attempts = 100;  // of two seconds or more each
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
      if (!report().is_readable()) ask_for_zero_pose();
      say("outside");
      for (int rounds = 0; rounds < 500; ++rounds) live();
      ask_for_motors();
      for (int rounds = 0; !is_on() && rounds < 2000; ++rounds) live();
      if (!is_on()) continue;
      say("inside");
      int pushes = 0;  // in a row
      while (is_on()) {
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

  // Says why, each time that the port cannot be had.
  void look_on() {
    for (std::uint64_t told = 0;; live()) {
      if (report().faults == told) continue;
      told = report().faults;
      say(std::string(entry_of(report().fault).name));
    }
  }

  // Throws when interrupted.
  void live() {
    stop_if_interrupted();
    ++command_.heartbeats;
    servo_->send(command_);
    for (Sample sample; servo_->take_sample(sample);) continue;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }

  void ask_for_motors() {
    ++command_.acknowledgements;
    ++command_.arms_asked;
  }

  bool is_on() { return motors().state == SafetyState::on; }
  const MotorReport& motors() { return servo_->newest().motors; }
  const HaplyReport& report() { return input_->report(); }
  MinedHaplyInput& input() { return *input_; }
  ServoThread& thread() { return thread_; }

 private:
  ServoCommand command_;
  MinedHaplyInput* input_ = nullptr;
  std::unique_ptr<Servo> servo_;
  ServoThread thread_;
};

void live_for_ever(Person& person) {
  for (;;) person.live();
}

// --- The ways out ----------------------------------------------------------------------------------------------------

struct Way {
  std::string_view name;
  void (*go)(Person& person);
};

constexpr Way ways[] = {
    {"return", [](Person&) {}},
    {"wait", live_for_ever},
    // Alone: its process group has no other program in it but this one.
    {"wait in a group of its own", live_for_ever},
    // Hears of nothing, because its main thread hangs.
    {"hang", [](Person&) { sleep_for_ever(); }},
    {"abort", [](Person&) { std::abort(); }},
    {"null pointer", [](Person&) { write_to_null(); }},
    {"stack overflow", [](Person&) { overflow_stack(); }},
    {"exception", [](Person&) { throw std::runtime_error("that nobody catches"); }},
    {"exit", [](Person&) { std::exit(0); }},
    {"exit on another thread",
     [](Person&) {
       std::thread([] { std::exit(0); }).detach();
       sleep_for_ever();
     }},
    {"_exit", [](Person&) { _exit(0); }},
    {"another program", [](Person&) { become_another_program(); }},
    {"port closed",
     [](Person& person) {
       close_port();
       live_for_ever(person);
     }},
    {"port closed, its number taken",
     [](Person& person) {
       put_socket_in_place_of_port();
       live_for_ever(person);
     }},
    {"all files closed",
     [](Person& person) {
       close_all_files();
       live_for_ever(person);
     }},
    {"child left",
     [](Person& person) {
       leave_child();
       live_for_ever(person);
     }},
    {"signal on the servo's thread", [](Person& person) { person.input().lay(raise_signal); }},
    {"null pointer on the servo's thread", [](Person& person) { person.input().lay(write_to_null); }},
    {"stack overflow on the servo's thread", [](Person& person) { person.input().lay(overflow_stack); }},
    {"_exit on the servo's thread", [](Person& person) { person.input().lay([] { _exit(0); }); }},
    {"endless loop on the servo's thread", [](Person& person) { person.input().lay(loop_for_ever); }},
    {"block on the servo's thread", [](Person& person) { person.input().lay(block_for_ever); }},
};

int run(std::string_view name) {
  if (name == "wait in a group of its own") setpgid(0, 0);
  Person person;
  if (name == "look") person.look_on();
  for (const Way& way : ways) {
    if (way.name != name) continue;
    person.set_zero_pose();
    person.arm_and_lean_in();
    say_end();
    way.go(person);
    // The servo's thread is on its way.
    if (name.ends_with("servo's thread")) live_for_ever(person);
    return 0;
  }
  return static_cast<int>(ExitCode::wrong_call);
}

}  // namespace
}  // namespace ghostforce

int main(int argc, char** argv) {
  using namespace ghostforce;
  // In the order of the real main() and of its command `run`.
  remember_interruptions(emergency_stop::stop_motors);
  emergency_stop::install_handlers();
  std::signal(SIGPIPE, SIG_IGN);
  emergency_stop::refuse_to_be_stopped();
  if (argc < 3) return static_cast<int>(ExitCode::wrong_call);
  port_path = argv[1];
  if (argc > 3) detail = argv[3];
  try {
    return run(argv[2]);
  } catch (const Failure& failure) {
    return static_cast<int>(failure.code());
  }
}
