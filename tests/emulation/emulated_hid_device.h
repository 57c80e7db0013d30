// EmulatedHidDevice: what the kernel's hidraw shows of an input device on USB. It hands out reports one by one, and can
// be pulled out and plugged in again. One thread.
#pragma once

#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <vector>

#include "device/falcon_usb/usb_search.h"
#include "tests/emulation/test_bed.h"

namespace ghostforce {

class EmulatedHidDevice {
 public:
  // `usage` on the generic desktop page: what the device says that it is.
  EmulatedHidDevice(TestBed& bed, UsbId id, std::string name, std::uint8_t usage);
  EmulatedHidDevice(const EmulatedHidDevice&) = delete;
  EmulatedHidDevice& operator=(const EmulatedHidDevice&) = delete;
  ~EmulatedHidDevice();

  void plug();
  void unplug();
  void set_mode(mode_t mode) { bed_.set_mode(file_.path, mode); }

  // What a program finds that looks while the device is unplugged: still listed, and no file there can be read.
  void forget_what_it_is();

  // Nobody reads it: it waits, as in the kernel.
  void send(std::vector<std::uint8_t> report);

 private:
  class File;

  TestBed& bed_;
  const UsbId id_;
  const std::string name_;
  const std::string descriptor_;
  std::vector<std::string> syspaths_;  // parents first
  DeviceFile file_;
  std::vector<DeviceFile> past_files_;  // of earlier times; somebody may still have them open

  std::mutex mutex_;  // of what follows
  bool is_plugged_ = false;
  std::vector<File*> files_;
  std::deque<std::vector<std::uint8_t>> reports_;
};

}  // namespace ghostforce
