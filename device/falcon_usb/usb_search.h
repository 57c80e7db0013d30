// Which devices of one kind are plugged in over USB, and whether this user may open them: for the driver that opens
// one, and for the diagnosis that tells a person why it could not. May take some ms, allocates; any thread. Never
// throws: what cannot be found out is left empty.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

struct libusb_device;
struct libusb_device_handle;

namespace ghostforce {

struct UsbId {
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;

  friend bool operator==(const UsbId&, const UsbId&) = default;
};

inline constexpr UsbId falcon_usb_id{0x0403, 0xCB48};

// One that is plugged in.
struct UsbDeviceFound {
  int bus = 0;
  int address = 0;
  std::string node;       // the file by which the kernel gives it to programs
  bool may_open = false;  // by this user, for reading and writing
  int open_error = 0;     // errno of an attempt that failed
  bool has_node = false;  // what follows is known
  uid_t owner = 0;
  gid_t group = 0;
  mode_t mode = 0;     // permission bits
  std::string serial;  // empty: it has none, or it may not be asked
};

struct UsbSearch {
  bool has_usb = false;  // this system shows USB devices to programs at all; a container often does not
  std::vector<UsbDeviceFound> devices;
};

UsbSearch list_falcons(const UsbId& id) noexcept;

// /dev/bus/usb/BBB/DDD
std::string usb_node_of(libusb_device* device);

// Empty: the device has none, or keeps it to itself. Nothing: it does not answer now.
std::optional<std::string> usb_serial_of(libusb_device_handle* handle);

}  // namespace ghostforce
