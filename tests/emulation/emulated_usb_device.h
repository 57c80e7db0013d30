// EmulatedUsbDevice: what the kernel's usbfs shows of a device with one interface, a bulk endpoint each way and a
// serial chip behind them. It answers the ioctls of libusb as the kernel does, keeps its queues of transfers and its
// time, and can be pulled out and plugged in again. plug(), unplug() and the like on the test's thread.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "device/falcon/usb_search.h"
#include "tests/emulation/emulated_chip.h"
#include "tests/emulation/test_bed.h"

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

  // The next so many transfers from the device fail, with an errno as a URB's status has it (EPIPE is a stall).
  void fail_in(int count, int error);
  // Claiming the interface fails so often: the kernel has not set the device up yet.
  void delay_claims(int count);

  std::uint64_t halts_cleared() const;
  std::uint64_t transfers_pending() const;
  // Of the transfers from the device that have come back well: how many packets the fullest one carried.
  std::size_t most_packets_in_a_transfer() const;

 private:
  class File;

  // A transfer that was handed to the kernel.
  struct Urb {
    File* file = nullptr;
    std::uintptr_t address = 0;  // in the program
    std::uintptr_t buffer = 0;
    std::size_t length = 0;
    std::vector<std::uint8_t> data;  // outwards: to be sent; inwards: come so far
    std::size_t packets = 0;
  };

  CallResult submit(File& file, const CallerMemory& memory, std::uintptr_t address);
  CallResult reap(File& file, const CallerMemory& memory, std::uintptr_t into);
  CallResult discard(std::uintptr_t address);
  CallResult claim(File& file, int not_ready);
  CallResult send_now(const CallerMemory& memory, std::uintptr_t argument);
  int answer_control(Urb& urb, const std::uint8_t (&setup)[8]);
  void complete(const Urb& urb, int status, bool inwards);
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
  std::deque<Urb> in_;
  std::deque<Urb> out_;
  int failures_to_come_ = 0;
  int failure_ = 0;
  int claims_to_delay_ = 0;
  std::uint64_t halts_cleared_ = 0;
  std::size_t most_packets_ = 0;
  std::thread clock_;
};

}  // namespace ghostforce
