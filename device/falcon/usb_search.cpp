#include "device/falcon/usb_search.h"

#include <cerrno>
#include <cstdio>
#include <exception>

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
    found.serial = usb_serial_of(handle);
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

std::string usb_serial_of(libusb_device_handle* handle) {
  libusb_device_descriptor descriptor{};
  if (libusb_get_device_descriptor(libusb_get_device(handle), &descriptor) != LIBUSB_SUCCESS) return {};
  if (descriptor.iSerialNumber == 0) return {};
  unsigned char text[128];
  const int length = libusb_get_string_descriptor_ascii(handle, descriptor.iSerialNumber, text, sizeof text);
  return length > 0 ? std::string(text, text + length) : std::string();
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
