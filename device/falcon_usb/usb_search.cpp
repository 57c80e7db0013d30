#include "device/falcon_usb/usb_search.h"

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <span>

#include <fcntl.h>
#include <libusb.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ghostforce {
namespace {

constexpr const char* usb_folder = "/dev/bus/usb";

// The kernel's own answer, which knows of access lists and of devices that a container may not touch; the mode alone
// does not.
void try_to_open(UsbDeviceFound& found) {
  const int descriptor = open(found.node.c_str(), O_RDWR | O_CLOEXEC | O_NOCTTY);
  found.may_open = descriptor >= 0;
  found.open_error = found.may_open ? 0 : errno;
  if (found.may_open) close(descriptor);
}

UsbDeviceFound describe(libusb_device* device) {
  UsbDeviceFound found;
  found.bus = libusb_get_bus_number(device);
  found.address = libusb_get_device_address(device);
  found.node = usb_node_of(device);
  struct stat status {};
  if (stat(found.node.c_str(), &status) == 0) {
    found.has_node = true;
    found.owner = status.st_uid;
    found.group = status.st_gid;
    found.mode = status.st_mode & 07777U;
  }
  try_to_open(found);
  libusb_device_handle* handle = nullptr;
  if (found.may_open && libusb_open(device, &handle) == LIBUSB_SUCCESS) {
    found.serial = usb_serial_of(handle).value_or("");
    libusb_close(handle);
  }
  return found;
}

}  // namespace

std::string usb_node_of(libusb_device* device) {
  char node[64];
  std::snprintf(node, sizeof node, "%s/%03u/%03u", usb_folder, unsigned{libusb_get_bus_number(device)},
                unsigned{libusb_get_device_address(device)});
  return node;
}

std::optional<std::string> usb_serial_of(libusb_device_handle* handle) {
  libusb_device_descriptor descriptor{};
  if (libusb_get_device_descriptor(libusb_get_device(handle), &descriptor) != LIBUSB_SUCCESS) return {};
  if (descriptor.iSerialNumber == 0) return "";
  // libusb's own function for this waits up to 2 s for a device that does not answer.
  const auto ask = [handle](std::uint8_t index, std::uint16_t language, std::span<unsigned char> into) {
    constexpr unsigned patience_ms = 100;
    return libusb_control_transfer(handle, LIBUSB_ENDPOINT_IN, LIBUSB_REQUEST_GET_DESCRIPTOR,
                                   static_cast<std::uint16_t>(LIBUSB_DT_STRING << 8U | index), language, into.data(),
                                   static_cast<std::uint16_t>(into.size()), patience_ms);
  };
  // Two bytes of head, then letters of two bytes each; string 0 is the languages that there are.
  std::array<unsigned char, 255> bytes{};
  int length = ask(0, 0, bytes);
  if (length >= 4) length = ask(descriptor.iSerialNumber, static_cast<std::uint16_t>(bytes[2] | bytes[3] << 8U), bytes);
  if (length < 0 && length != LIBUSB_ERROR_PIPE) return {};
  std::string serial;
  for (int i = 2; i + 1 < length; i += 2) {
    const bool is_plain = bytes[static_cast<std::size_t>(i) + 1] == 0 && bytes[static_cast<std::size_t>(i)] < 0x80;
    serial += is_plain ? static_cast<char>(bytes[static_cast<std::size_t>(i)]) : '?';
  }
  return serial;
}

UsbSearch list_falcons(const UsbId& id) noexcept {
  UsbSearch search;
  struct stat status {};
  search.has_usb = stat(usb_folder, &status) == 0;
  libusb_context* context = nullptr;
  if (libusb_init(&context) != LIBUSB_SUCCESS) return search;
  libusb_device** devices = nullptr;
  const ssize_t count = libusb_get_device_list(context, &devices);
  try {
    for (ssize_t i = 0; i < count; ++i) {
      libusb_device_descriptor descriptor{};
      if (libusb_get_device_descriptor(devices[i], &descriptor) != LIBUSB_SUCCESS) continue;
      if (UsbId{descriptor.idVendor, descriptor.idProduct} == id) search.devices.push_back(describe(devices[i]));
    }
  } catch (const std::exception&) {  // out of memory: as far as it got
  }
  if (count >= 0) libusb_free_device_list(devices, 1);
  libusb_exit(context);
  return search;
}

}  // namespace ghostforce
