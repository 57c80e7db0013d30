// EmulatedUsbDevice: what the kernel's usbfs shows of a device with one interface, a bulk endpoint each way and a
// serial chip behind them. It answers the ioctls of libusb as the kernel does, and those of programs that do without;
// several of them may have it open at once. It keeps its queues of transfers and its time, can be pulled out and plugged
// in again, and goes wrong when asked to. What differs from a kernel: poll() tells of another program's transfers too.
// plug(), unplug(), inject() and the
// like on the test's thread; what only tells on any.
#pragma once

#include <array>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "device/falcon_usb/usb_search.h"
#include "tests/emulation/emulated_chip.h"
#include "tests/emulation/test_bed.h"
#include "tests/emulation/usb_fault.h"

namespace ghostforce {

class EmulatedUsbDevice {
 public:
  EmulatedUsbDevice(TestBed& bed, EmulatedChip& chip, std::string serial, UsbId id = falcon_usb_id);
  EmulatedUsbDevice(const EmulatedUsbDevice&) = delete;
  EmulatedUsbDevice& operator=(const EmulatedUsbDevice&) = delete;
  ~EmulatedUsbDevice();

  void plug();
  // Transfers that are under way fail, as does everything afterwards.
  void unplug();

  // Of the device file, while plugged in.
  const std::string& node() const { return file_.path; }
  void set_mode(mode_t mode) { bed_.set_mode(node(), mode); }

  // All that was asked for before ends, but for a halt, which only the host ends.
  void inject(const UsbFault& wrong);
  // The next so many transfers from the device fail, with an errno as a URB's status has it (EPIPE is a stall).
  void fail_in(int count, int error);
  // Claiming the interface fails so often: the kernel has not set the device up yet.
  void delay_claims(int count);

  // What a program has tried to send last, whether or not it could be.
  struct OutAttempt {
    std::vector<std::uint8_t> bytes;
    std::int64_t at_ns = 0;  // of CLOCK_MONOTONIC; 0: never
  };
  OutAttempt last_out() const;

  std::uint64_t times_taken() const;  // how often a program has claimed the interface
  std::uint64_t times_taken_by(int process) const;
  std::uint64_t halts_cleared() const;
  std::uint64_t transfers_pending() const;
  // Of the transfers from the device that have come back well: how many packets the fullest one carried.
  std::size_t most_packets_in_a_transfer() const;

 private:
  class File;

  // A program's call that waits for its transfer.
  struct Waiter {
    bool is_over = false;
    int status = 0;
    std::size_t length = 0;
    std::vector<std::uint8_t> data;  // that has come in
  };

  // A transfer that was handed to the kernel.
  struct Urb {
    File* file = nullptr;
    std::uintptr_t address = 0;  // in the program
    std::uintptr_t buffer = 0;
    std::size_t length = 0;
    std::vector<std::uint8_t> data;  // outwards: to be sent; inwards: come so far
    std::size_t packets = 0;
    Waiter* waiter = nullptr;  // null: it is reaped
  };
  struct ControlUrb {
    Urb urb;
    std::array<std::uint8_t, 8> setup;
  };
  struct Endpoint {
    std::deque<Urb> queue;
    int failures_to_come = 0;
    int error = 0;
    bool is_halted = false;
    std::int64_t naks_until_ns = 0;

    void inject(const EndpointFaults& wrong);
    bool naks() const;
    int next_failure();  // an errno; 0: none
  };

  static std::int64_t end_of(int duration_ms);

  // Of the device, as the kernel has it: held by one call at a time, even while that waits for the device.
  std::unique_lock<std::mutex> lock_device();
  CallResult submit(File& file, const CallerMemory& memory, std::uintptr_t address);
  CallResult reap(File& file, const CallerMemory& memory, std::uintptr_t into);
  CallResult discard(const File& file, std::uintptr_t address);
  void end_transfers_of(const File& file, int status);
  CallResult claim(File& file, const CallerMemory& memory, std::uintptr_t argument);
  CallResult disconnect_and_claim(File& file, const CallerMemory& memory, std::uintptr_t argument);
  int claim_obstacle(const File& file, int not_ready);
  int take(File& file);
  void let_go();
  CallResult release(const File& file, const CallerMemory& memory, std::uintptr_t argument);
  CallResult tell_driver(const CallerMemory& memory, std::uintptr_t argument);
  CallResult order_driver(const CallerMemory& memory, std::uintptr_t argument);
  CallResult transfer_now(File& file, const CallerMemory& memory, std::uintptr_t argument);
  CallResult control_now(File& file, const CallerMemory& memory, std::uintptr_t argument);
  void wait_for(const Waiter& waiter, std::unique_lock<std::mutex>& lock, unsigned int timeout_ms);
  CallResult clear_halt(File& file, const CallerMemory& memory, std::uintptr_t argument);
  CallResult reset(File& file);
  CallResult set_interface(File& file, const CallerMemory& memory, std::uintptr_t argument);
  CallResult set_configuration(File& file);
  int ask_device(File& file, std::unique_lock<std::mutex>& lock, int answer_ms);
  int answer_control(Urb& urb, const std::array<std::uint8_t, 8>& setup);
  void note_attempt(const std::vector<std::uint8_t>& bytes);
  void complete(const Urb& urb, int status, bool inwards);
  bool has_turn(Endpoint& endpoint);
  void move_packets();
  void keep_time();
  void show_completions();
  std::string configuration() const;

  TestBed& bed_;
  EmulatedChip& chip_;
  const std::string serial_;
  const UsbId id_;
  std::string syspath_;
  DeviceFile file_;
  std::vector<DeviceFile> past_files_;  // of earlier times; somebody may still have them open

  mutable std::mutex mutex_;  // of all that follows
  std::condition_variable changed_;
  bool is_plugged_ = false;
  bool is_ending_ = false;
  File* owner_ = nullptr;  // of the interface
  std::vector<File*> files_;
  bool is_waiting_for_device_ = false;  // a call is, which holds the lock meanwhile
  Endpoint in_;
  Endpoint out_;
  std::deque<ControlUrb> control_;
  UsbFault wrong_;  // with what is left of the counts
  std::int64_t control_naks_until_ns_ = 0;
  OutAttempt last_out_;
  int claims_to_delay_ = 0;
  std::vector<int> takers_;  // the processes that have claimed the interface, each time
  std::uint64_t halts_cleared_ = 0;
  std::size_t most_packets_ = 0;
  std::thread clock_;
};

}  // namespace ghostforce
