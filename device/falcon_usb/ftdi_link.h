// FtdiLink: the FalconLink over USB, through libusb: the serial chip of FTDI's inside a Falcon that is plugged in.
//
// Receiving never pauses: several transfers are always posted, and each is posted again as soon as its bytes have been
// taken out, so that the chip's 1 ms is not lost waiting for a program. Everything is allocated by open(); afterwards
// only libusb allocates, as it likes. A transfer that fails is tried again, until many in a row have failed. Transfers'
// callbacks run inside wait_until() and close(), on the thread that calls these.
#pragma once

#include <poll.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "device/falcon/falcon_link.h"
#include "device/falcon_usb/usb_connection.h"
#include "device/falcon_usb/usb_search.h"
#include "device/guard/motor_guard.h"
#include "device/input/monotonic_clock.h"
#include "device/motors/stop_debts.h"

struct libusb_transfer;

namespace ghostforce {

struct FtdiLinkOptions {
  UsbId id = falcon_usb_id;
  std::string serial{};  // empty: the first of them, in the order of their serial numbers, that can be had
};

class FtdiLink final : public FalconLink {
 public:
  explicit FtdiLink(FtdiLinkOptions options = {}) : options_(std::move(options)) {}
  ~FtdiLink() override { close(); }

  bool waits_to_open() const noexcept override { return true; }
  LinkFault open() noexcept override { return open_first({}); }
  LinkFault open_first(const StopDebts& owed) noexcept override;
  bool is_any_plugged_in(const StopDebts& owed) const noexcept override;
  void close() noexcept override;
  LinkFault fault() const noexcept override { return fault_; }
  std::string_view serial() const noexcept override { return usb_.serial(); }

  bool request(const VendorRequest& request) noexcept override;
  RequestOutcome request_outcome() const noexcept override { return request_outcome_; }
  bool write(std::span<const std::uint8_t> bytes) noexcept override;
  bool is_sending() const noexcept override;

  void stop(std::span<const std::uint8_t> bytes) noexcept override;
  bool owes_stop() const noexcept override { return owed_size_ > 0; }

  bool is_guarded() const noexcept override { return guard_.is_watching(monotonic_ns()); }
  void set_may_push(bool may_push) noexcept override { guard_.set_may_push(may_push, monotonic_ns()); }

  std::size_t read(std::span<std::uint8_t> into) noexcept override;
  std::uint8_t modem_status() const noexcept override { return modem_status_; }
  LinkCounters counters() const noexcept override { return counters_; }

  std::int64_t now_ns() const noexcept override { return monotonic_ns(); }
  void wait_until(std::int64_t deadline_ns) noexcept override;
  void send_at_once(std::span<const std::uint8_t> bytes) noexcept override;

 private:
  static constexpr std::size_t in_transfers = 4;
  static constexpr std::size_t in_size = 512;  // several packets: a chip that has more than was asked for is an error
  static constexpr std::size_t out_size = 64;  // the contract's; a control transfer's setup is shorter
  static constexpr std::size_t ring_size = 16384;  // 0.1 s of the chip's fastest stream

  struct Transfer {
    libusb_transfer* transfer = nullptr;
    bool is_posted = false;
  };

  // From the device, and what it fills.
  struct Receiver : Transfer {
    FtdiLink* link = nullptr;
    alignas(8) std::array<std::uint8_t, in_size> buffer{};
  };

  // To the device, and what it sends.
  struct Sender : Transfer {
    alignas(8) std::array<std::uint8_t, out_size> buffer{};
  };

  struct Callbacks;  // libusb's way into this object

  bool make_transfers();
  void find_poll_descriptors();
  void free_transfers() noexcept;

  bool is_usable() const noexcept { return usb_.handle() != nullptr && fault_ == LinkFault::none; }
  std::array<Transfer*, in_transfers + 3> transfers() noexcept;
  bool post(Transfer& transfer) noexcept;
  void received(Receiver& receiver) noexcept;
  void sent(const libusb_transfer& transfer) noexcept;
  void take_packets(std::span<const std::uint8_t> bytes) noexcept;
  void keep(std::span<const std::uint8_t> payload) noexcept;
  bool may_send_again() noexcept;
  GuardOrders guard_orders() const noexcept;
  void start_guard(bool may_push) noexcept;
  bool is_overruled() const noexcept;
  void heed_guard() noexcept;
  void insist_on_stop() noexcept;
  void failed(int transfer_status) noexcept;
  void recover() noexcept;
  void handle_events(int timeout_ms) noexcept;
  void set_fault(LinkFault fault) noexcept;

  FtdiLinkOptions options_;
  UsbConnection usb_;
  MotorGuard guard_;
  LinkFault fault_ = LinkFault::absent;
  LinkCounters counters_;
  std::uint8_t modem_status_ = 0;

  std::array<Receiver, in_transfers> receivers_{};
  Sender out_;
  Sender control_;
  Sender stop_;
  RequestOutcome request_outcome_ = RequestOutcome::done;
  bool closing_ = false;
  int failures_in_a_row_ = 0;
  int errors_out_in_a_row_ = 0;
  bool something_happened_ = false;  // since wait_until() was called

  // Of the stop in stop_'s buffer that the chip has not taken yet. 0: it has, or the link was opened anew.
  std::size_t owed_size_ = 0;

  // The bytes that nobody has taken yet, from first_ on.
  std::array<std::uint8_t, ring_size> ring_{};
  std::size_t first_ = 0;
  std::size_t held_ = 0;

  // What libusb waits for, so that we can wait with a finer clock than its milliseconds.
  std::array<pollfd, 8> poll_descriptors_{};  // of libusb, and after them that of the guard
  nfds_t poll_count_ = 0;
};

}  // namespace ghostforce
