// TestBed: a machine with nothing plugged in, as far as this process and those that it starts can see (umockdev). One
// per process at a time; one thread.
#pragma once

#include <sys/types.h>

#include <memory>
#include <string>

#include "tests/emulation/awake_processors.h"
#include "tests/emulation/kernel_door.h"
#include "tests/emulation/terminal.h"

struct _UMockdevTestbed;

namespace ghostforce {

// The file by which programs reach an emulated device, as long as this stands. What has been opened stays open until
// its program closes it.
struct DeviceFile {
  std::string path;  // as programs see it
  std::unique_ptr<Terminal> terminal;
  std::unique_ptr<KernelDoor> door;

  // For the attribute `dev`: programs compare it with what fstat() tells, which is the terminal's.
  std::string number() const;
};

class TestBed {
 public:
  TestBed();
  TestBed(const TestBed&) = delete;
  TestBed& operator=(const TestBed&) = delete;
  ~TestBed();

  // Where the emulated "/" lies.
  const std::string& root() const { return root_; }

  DeviceFile make_file(const std::string& path, KernelDoor::Open open);
  // The name goes; whoever has it open still does.
  void remove_name(const std::string& path);
  void set_mode(const std::string& path, mode_t mode);
  void make_unreadable(const std::string& path);

  // In umockdev's language, one device per paragraph; programs are told of each.
  void add(const std::string& description);
  // Programs are told, then it is gone from /sys. Children first.
  void remove(const std::string& syspath);

  // The next address on the emulated bus, which has 127.
  int next_address() { return last_address_ = last_address_ < 127 ? last_address_ + 1 : 2; }
  // Where usb devices hang.
  static constexpr const char* hub = "/devices/pci0000:00/0000:00:14.0/usb1";

 private:
  const AwakeProcessors awake_;
  _UMockdevTestbed* testbed_;
  std::string root_;
  int last_address_ = 1;  // the root hub's
};

std::string hex_of(const std::string& bytes);

}  // namespace ghostforce
