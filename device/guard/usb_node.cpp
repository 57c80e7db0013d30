#include "device/guard/usb_node.h"

#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>

#include <cerrno>

namespace ghostforce::usb_node {
namespace {

constexpr unsigned patience_ms = 10;
constexpr std::uint8_t vendor_request_type = 0x40;  // to the device, of the maker's, without data

}  // namespace

bool send_once(int descriptor, std::uint8_t endpoint, std::span<const std::uint8_t> bytes,
               unsigned timeout_ms) noexcept {
  usbdevfs_bulktransfer transfer{};
  transfer.ep = endpoint;
  transfer.len = static_cast<unsigned>(bytes.size());
  transfer.timeout = timeout_ms;
  transfer.data = const_cast<std::uint8_t*>(bytes.data());  // outwards: the kernel reads it
  return ioctl(descriptor, USBDEVFS_BULK, &transfer) == static_cast<int>(bytes.size());
}

bool send(int descriptor, std::uint8_t endpoint, std::span<const std::uint8_t> bytes) noexcept {
  if (send_once(descriptor, endpoint, bytes, patience_ms)) return true;
  if (errno != EPIPE) return false;
  unsigned halted = endpoint;
  return ioctl(descriptor, USBDEVFS_CLEAR_HALT, &halted) == 0 && send_once(descriptor, endpoint, bytes, patience_ms);
}

bool control(int descriptor, const LineRequest& request) noexcept {
  usbdevfs_ctrltransfer transfer{};
  transfer.bRequestType = vendor_request_type;
  transfer.bRequest = request.request;
  transfer.wValue = request.value;
  transfer.wIndex = request.index;
  transfer.timeout = patience_ms;
  return ioctl(descriptor, USBDEVFS_CONTROL, &transfer) >= 0;
}

bool is_one(int descriptor) noexcept {
  std::uint32_t capabilities = 0;
  return ioctl(descriptor, USBDEVFS_GET_CAPABILITIES, &capabilities) == 0;
}

bool take_over(int descriptor, std::uint8_t interface) noexcept {
  usbdevfs_disconnect_claim claim{};
  claim.interface = interface;
  if (ioctl(descriptor, USBDEVFS_DISCONNECT_CLAIM, &claim) == 0) return true;
  unsigned number = interface;
  return ioctl(descriptor, USBDEVFS_CLAIMINTERFACE, &number) == 0;
}

void release(int descriptor, std::uint8_t interface) noexcept {
  unsigned number = interface;
  ioctl(descriptor, USBDEVFS_RELEASEINTERFACE, &number);
}

}  // namespace ghostforce::usb_node
