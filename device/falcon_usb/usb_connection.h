// UsbConnection: a USB device that was found, opened and claimed through libusb: its handle, its two bulk endpoints and
// the file behind them. Everything that waits for the system or for the device is here. It may wait for seconds, and it
// allocates: never on the servo's thread. One thread at a time, but for send_at_once().
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "device/falcon/falcon_link.h"
#include "device/falcon_usb/usb_search.h"
#include "device/motors/stop_debts.h"

struct libusb_context;
struct libusb_device_handle;

namespace ghostforce {

// At the beginning of every packet that comes in from an FTDI chip [bytes].
inline constexpr std::size_t ftdi_status_size = 2;

class UsbConnection {
 public:
  static constexpr int interface_number = 0;

  UsbConnection() = default;
  UsbConnection(const UsbConnection&) = delete;
  UsbConnection& operator=(const UsbConnection&) = delete;
  ~UsbConnection() { close(); }

  // Takes the first device with these ids, in the order of their serial numbers, that can be had; `serial` empty: any.
  // Clears the halt of both endpoints: a device that another driver or an earlier fault has left halted works again.
  // While any that is `owed` a stop is plugged in, the one whose debt is oldest is taken instead, and no other.
  LinkFault open(const UsbId& id, const std::string& serial, const StopDebts& owed = {}) noexcept;

  // Gives the device back: what is still under way on it ends. Transfers are freed after that, and before close().
  void release_device() noexcept;

  // That, and leaves libusb.
  void close() noexcept;

  // Sends bytes, and waits 10 ms for the device to take them. Where the endpoint is halted it clears that, and the next
  // attempt may succeed.
  LinkFault send(std::span<const std::uint8_t> bytes) noexcept;

  // That without libusb, on any thread and in a signal's handler, one at a time: tries once, for 20 ms. Nothing happens
  // while no device is open.
  void send_at_once(std::span<const std::uint8_t> bytes) noexcept;

  // Null while it is not open.
  libusb_context* context() const noexcept { return context_; }
  libusb_device_handle* handle() const noexcept { return handle_; }

  std::uint8_t in_endpoint() const noexcept { return in_endpoint_; }
  std::uint8_t out_endpoint() const noexcept { return out_endpoint_; }
  std::size_t packet_size() const noexcept { return packet_size_; }  // of the IN endpoint [bytes]
  // The file by which the kernel gives the device to programs.
  std::string node() const;
  // Of the device that is open or was.
  std::string_view serial() const noexcept { return serial_; }
  // The file behind the handle; -1: not open, or not known.
  int descriptor() const noexcept { return descriptor_; }

 private:
  LinkFault find_and_take(const UsbId& id, const std::string& serial, const StopDebts& owed);
  LinkFault take(libusb_device_handle* handle);
  LinkFault find_endpoints(libusb_device_handle* handle);
  LinkFault clear_halts(libusb_device_handle* handle) const noexcept;
  void find_descriptor();

  libusb_context* context_ = nullptr;
  libusb_device_handle* handle_ = nullptr;
  std::uint8_t in_endpoint_ = 0;
  std::uint8_t out_endpoint_ = 0;
  std::size_t packet_size_ = 0;
  std::string serial_;
  std::atomic<int> descriptor_{-1};
  std::atomic<bool> is_sending_at_once_{false};
  static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free,
                "a signal handler may touch nothing else");
};

// What libusb's error means for a link.
LinkFault link_fault_of(int libusb_error) noexcept;

}  // namespace ghostforce
