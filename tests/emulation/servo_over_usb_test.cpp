// The servo's thread with the real libusb beneath it, from before the device is plugged in until it has been armed for
// a while and lost and found again: of our own code it never touches the heap, and it makes no system call but those of
// an exchange and of waiting. Looking for, opening and closing the device would need many others.
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <dlfcn.h>
#include <libusb.h>
#include <sys/syscall.h>

#include <gtest/gtest.h>

#include "device/falcon/falcon_input.h"
#include "device/falcon_usb/ftdi_link.h"
#include "device/servo/servo.h"
#include "device/servo/servo_thread.h"
#include "tests/device/servo/motor_settings.h"
#include "tests/emulation/emulated_usb_device.h"
#include "tests/emulation/falcon_chip.h"
#include "tests/emulation/hand_in_scene.h"
#include "tests/support/call_guard.h"
#include "tests/support/heap_guard.h"
#include "tests/support/sanitized.h"

namespace ghostforce {
namespace {

using std::chrono::milliseconds;

// Of the servo's thread alone.
struct Watch {
  std::optional<HeapGuard> heap;
  std::uint64_t own_uses = 0;      // of the heap, by our code
  std::uint64_t library_uses = 0;  // and by libusb, which allocates as it likes
  std::uint64_t library_calls = 0;
  std::uint64_t waiting_calls = 0;
  bool is_in_library = false;

  template <typename Call>
  auto suspend(Call call) {
    ++library_calls;
    if (is_in_library) return call();  // by a callback of ours
    own_uses += heap->take_uses();
    is_in_library = true;
    const auto result = call();
    is_in_library = false;
    library_uses += heap->take_uses();
    return result;
  }
};
thread_local Watch* watch = nullptr;

template <typename Function>
Function* in_libusb(const char* name) {
  static void* const library = dlopen("libusb-1.0.so.0", RTLD_NOW | RTLD_NOLOAD);
  return reinterpret_cast<Function*>(dlsym(library, name));
}

template <typename Call>
auto suspended(Call call) {
  return watch != nullptr ? watch->suspend(call) : call();
}

}  // namespace
}  // namespace ghostforce

// These stand before libusb's own.
extern "C" {
int LIBUSB_CALL libusb_submit_transfer(libusb_transfer* transfer) {
  static auto* const real = ghostforce::in_libusb<decltype(libusb_submit_transfer)>("libusb_submit_transfer");
  return ghostforce::suspended([&] { return real(transfer); });
}
int LIBUSB_CALL libusb_cancel_transfer(libusb_transfer* transfer) {
  static auto* const real = ghostforce::in_libusb<decltype(libusb_cancel_transfer)>("libusb_cancel_transfer");
  return ghostforce::suspended([&] { return real(transfer); });
}
// These wait for the device.
int LIBUSB_CALL libusb_clear_halt(libusb_device_handle* handle, unsigned char endpoint) {
  static auto* const real = ghostforce::in_libusb<decltype(libusb_clear_halt)>("libusb_clear_halt");
  if (ghostforce::watch != nullptr) ++ghostforce::watch->waiting_calls;
  return real(handle, endpoint);
}
int LIBUSB_CALL libusb_bulk_transfer(libusb_device_handle* handle, unsigned char endpoint, unsigned char* bytes,
                                     int length, int* sent, unsigned timeout_ms) {
  static auto* const real = ghostforce::in_libusb<decltype(libusb_bulk_transfer)>("libusb_bulk_transfer");
  if (ghostforce::watch != nullptr) ++ghostforce::watch->waiting_calls;
  return real(handle, endpoint, bytes, length, sent, timeout_ms);
}
// Our callbacks run in here and are counted with the library: ftdi_link_test has shown that they only post again.
int LIBUSB_CALL libusb_handle_events_timeout_completed(libusb_context* context, timeval* timeout, int* completed) {
  static auto* const real =
      ghostforce::in_libusb<decltype(libusb_handle_events_timeout_completed)>("libusb_handle_events_timeout_completed");
  return ghostforce::suspended([&] { return real(context, timeout, completed); });
}
}

namespace ghostforce {
namespace {

constexpr int allowed[] = {
    // Of an exchange with the device, and of waiting; libusb's heap may grow.
    SYS_ioctl, SYS_ppoll, SYS_clock_nanosleep, SYS_timerfd_settime, SYS_read, SYS_write, SYS_futex, SYS_brk, SYS_mmap,
#ifdef SYS_poll
    SYS_poll,
#endif
    // The emulation asks its device over a socket, with signals blocked: what it may not do would end this process.
    SYS_sendto, SYS_recvfrom, SYS_rt_sigprocmask,
    // Of the end of a thread.
    SYS_sigaltstack, SYS_munmap, SYS_madvise, SYS_exit};

class WatchedInput final : public FalconInput {
 public:
  using FalconInput::FalconInput;

  HandleReading read() noexcept override {
    if (!is_bound_) {
#ifndef GHOSTFORCE_SANITIZED  // a sanitizer makes calls of its own, and pipes to see what memory is mapped
      can_forbid = forbid_calls_but(allowed);
#endif
      is_bound_ = true;
      watch = &watched;
      watched.heap.emplace();
    }
    return FalconInput::read();
  }
  void shut_down() noexcept override {
    FalconInput::shut_down();
    watched.own_uses += watched.heap->take_uses();
    watched.heap.reset();
    watch = nullptr;
  }

  // Once the servo has stopped.
  Watch watched;
  bool can_forbid = false;

 private:
  bool is_bound_ = false;
};

class ServoOverUsbTest : public testing::Test {
 protected:
  ServoOverUsbTest() {
    command.settings = motor_settings(StrategyId::naive);
    command.settings.wall_point = {0.0, -0.01};
    command.settings.wall_normal_angle = command.settings.actuated_angle = 0.5 * std::acos(-1.0);
    command.restart_state = state_at_start(Vector<2>(0.0));
    auto watched = std::make_unique<WatchedInput>(std::make_unique<FtdiLink>(), FalconOptions{}, Vector<2>(0.0));
    input = watched.get();
    servo = std::make_unique<Servo>(std::move(watched), command);
    thread.start(*servo);
  }

  const MotorReport& motors() { return servo->newest().motors; }

  void live() {
    ++command.heartbeats;
    servo->send(command);
    std::this_thread::sleep_for(milliseconds(2));
  }
  // False: it did not become so, however busy this machine may be.
  bool live_until(const std::function<bool()>& condition) {
    const auto end = std::chrono::steady_clock::now() + milliseconds(60'000);
    while (!condition()) {
      if (std::chrono::steady_clock::now() > end) return false;
      live();
    }
    return true;
  }
  bool is_armed() { return motors().state != SafetyState::off && motors().state != SafetyState::arming; }
  // Once more whenever a busy machine has made the motors go off, or has kept them from coming on.
  bool arm_and_lean_in() {
    int rounds = 0;
    return live_until([this, &rounds] {
      if (is_armed()) {
        rounds = 0;
      } else if (rounds++ % 1000 == 0) {
        lead_hand(chip, rounds % 2000 == 1 ? "outside" : "aside");
        ++command.acknowledgements;
        ++command.arms_asked;
      }
      if (motors().state == SafetyState::on) lead_hand(chip, "inside");
      return motors().state == SafetyState::on && glm::length(motors().sent) > 1.0;
    });
  }

  TestBed bed;
  FalconChip chip{{.starts_with_firmware = true, .starts_homed = true}};
  EmulatedUsbDevice falcon{bed, chip, "12PZ657E"};
  ServoCommand command;
  WatchedInput* input = nullptr;
  std::unique_ptr<Servo> servo;
  ServoThread thread;
};

TEST_F(ServoOverUsbTest, NeitherHeapNorForbiddenCallsWhateverBecomesOfTheDevice) {
  const char* const asked = std::getenv("GHOSTFORCE_ARMED_SECONDS");
  const int armed_s = asked != nullptr ? std::atoi(asked) : 2;
  ASSERT_TRUE(live_until([this] { return input->report().has_looked; }));
  falcon.plug();
  ASSERT_TRUE(live_until([this] { return input->report().is_readable(); }));
  ASSERT_TRUE(arm_and_lean_in());
  int armed_ticks = 0;
  while (armed_ticks < armed_s * 500) {
    ASSERT_TRUE(arm_and_lean_in());
    live();
    ++armed_ticks;
  }
  falcon.inject(usb_fault("in-halt"));
  ASSERT_TRUE(live_until([this] { return motors().state == SafetyState::off; }));
  falcon.inject({});
  ASSERT_TRUE(live_until([this] { return input->report().is_readable(); }));
  falcon.unplug();
  ASSERT_TRUE(live_until([this] { return input->report().fault == FalconFault::unplugged; }));
  falcon.plug();
  ASSERT_TRUE(live_until([this] { return input->report().is_readable(); }));
  thread.stop();
  EXPECT_EQ(input->watched.own_uses, 0U);
  EXPECT_GT(input->watched.library_calls, 0U);
  EXPECT_EQ(input->watched.waiting_calls, 0U);
  RecordProperty("uses_of_the_heap_by_libusb", std::to_string(input->watched.library_uses));
  if (!input->can_forbid) GTEST_SKIP() << "no seccomp in this kernel or container, or a sanitizer is built in";
  EXPECT_EQ(forbidden_calls(), std::vector<int>{});
}

}  // namespace
}  // namespace ghostforce
