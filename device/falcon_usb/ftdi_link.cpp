#include "device/falcon_usb/ftdi_link.h"

#include <algorithm>

#include <libusb.h>
#include <time.h>

#include "device/falcon/frame.h"
#include "device/falcon/link_setup.h"
#include "device/motors/emergency_stop.h"

namespace ghostforce {
namespace {

constexpr std::uint8_t line_error_bits = 0x0E;
constexpr std::uint8_t vendor_request_type = 0x40;  // to the device, of the maker's, without data

// A transfer may fail once; a cable that is being pulled makes several fail before the system says that it is
// unplugged. All posted transfers fail together, so that this stands for a few incidents.
constexpr int most_failures_in_a_row = 16;
// A command that fails is sent again at once, and the link is given up sooner: what has failed may have been a zero.
constexpr int most_errors_out_in_a_row = 3;

constexpr unsigned send_timeout_ms = 1000;
constexpr unsigned request_timeout_ms = 300;
constexpr std::int64_t close_timeout_ns = 200'000'000;
// In closing, a stop that is under way gets so long; then it is sent anew.
constexpr std::int64_t stop_timeout_ns = 20'000'000;
// For so long after that, and with such pauses.
constexpr std::int64_t insist_ns = 500'000'000;
constexpr std::int64_t attempt_pause_ns = 100'000;
// While nothing comes, libusb is asked this often whether a transfer has timed out, and the guard hears of it.
constexpr std::int64_t longest_wait_ns = 5'000'000;

}  // namespace

struct FtdiLink::Callbacks {
  static void LIBUSB_CALL received(libusb_transfer* transfer) {
    auto& receiver = *static_cast<Receiver*>(transfer->user_data);
    receiver.link->received(receiver);
  }
  static void LIBUSB_CALL sent(libusb_transfer* transfer) {
    static_cast<FtdiLink*>(transfer->user_data)->sent(*transfer);
  }
};

// --- Opening and closing ---------------------------------------------------------------------------------------------

LinkFault FtdiLink::open_first(const StopDebts& owed) noexcept {
  close();
  counters_ = {};
  modem_status_ = 0;
  first_ = held_ = 0;
  failures_in_a_row_ = errors_out_in_a_row_ = 0;
  owed_size_ = 0;
  fault_ = usb_.open(options_.id, options_.serial, owed);
  if (fault_ == LinkFault::none && !make_transfers()) fault_ = LinkFault::broken;
  if (fault_ == LinkFault::none) find_poll_descriptors();
  for (Receiver& receiver : receivers_) {
    if (fault_ == LinkFault::none) post(receiver);
  }
  if (fault_ != LinkFault::none) {
    close();
  } else {
    start_guard(owed.has(device_serial_of(usb_.serial())));
  }
  return fault_;
}

// A busy machine may not let it begin in time. Without a guard the motors stay off for as long as the device is open.
void FtdiLink::start_guard(bool may_push) noexcept {
  constexpr int attempts = 3;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    if (guard_.start(usb_.descriptor(), usb_.node(), guard_orders(), may_push)) break;
  }
  poll_descriptors_[poll_count_] = {guard_.descriptor(), POLLIN, 0};
}

// The guard knows nothing of frames: it gets the bytes.
GuardOrders FtdiLink::guard_orders() const noexcept {
  GuardOrders orders;
  orders.interface = UsbConnection::interface_number;
  orders.out_endpoint = usb_.out_endpoint();
  for (const VendorRequest& request : {ftdi::running_rate, ftdi::eight_bits_no_parity_one_stop}) {
    orders.set_up[orders.set_up_count++] = {request.request, request.value, request.index};
  }
  const auto stop = stop_frames();
  std::ranges::copy(stop, orders.stop.begin());
  orders.stop_size = static_cast<std::uint8_t>(stop.size());
  return orders;
}

// A guard that has stopped motors has locked this program out, and what fails then fails because of that.
bool FtdiLink::is_overruled() const noexcept {
  return guard_.state() > GuardState::watching;
}

void FtdiLink::heed_guard() noexcept {
  const std::int64_t now_ns = monotonic_ns();
  guard_.beat(now_ns);
  if (is_overruled()) {
    set_fault(LinkFault::overruled);
  } else if (guard_.state() == GuardState::watching && !guard_.is_watching(now_ns)) {
    set_fault(LinkFault::unguarded);
  }
}

bool FtdiLink::is_any_plugged_in(const StopDebts& owed) const noexcept {
  return std::ranges::any_of(list_falcons(options_.id).devices, [&owed](const UsbDeviceFound& found) {
    return found.may_open && owed.has(device_serial_of(found.serial));
  });
}

bool FtdiLink::make_transfers() {
  for (Transfer* const transfer : transfers()) {
    transfer->transfer = libusb_alloc_transfer(0);
    if (transfer->transfer == nullptr) return false;
  }
  for (Receiver& receiver : receivers_) {
    receiver.link = this;
    libusb_fill_bulk_transfer(receiver.transfer, usb_.handle(), usb_.in_endpoint(), receiver.buffer.data(),
                              int{in_size}, &Callbacks::received, &receiver, 0);
  }
  return true;
}

std::array<FtdiLink::Transfer*, FtdiLink::in_transfers + 3> FtdiLink::transfers() noexcept {
  static_assert(in_transfers == 4);
  return {&receivers_[0], &receivers_[1], &receivers_[2], &receivers_[3], &out_, &control_, &stop_};
}

void FtdiLink::free_transfers() noexcept {
  for (Transfer* const transfer : transfers()) {
    libusb_free_transfer(std::exchange(transfer->transfer, nullptr));
    transfer->is_posted = false;
  }
}

void FtdiLink::find_poll_descriptors() {
  poll_count_ = 0;
  const libusb_pollfd** const list = libusb_get_pollfds(usb_.context());
  if (list == nullptr) return;
  for (const libusb_pollfd** entry = list; *entry != nullptr && poll_count_ + 1 < poll_descriptors_.size(); ++entry) {
    poll_descriptors_[poll_count_++] = {(*entry)->fd, (*entry)->events, 0};
  }
  libusb_free_pollfds(list);
}

void FtdiLink::close() noexcept {
  if (usb_.context() == nullptr) return;
  closing_ = true;
  if (is_overruled()) guard_.end();  // it gives back what it has taken
  std::int64_t deadline_ns = monotonic_ns() + stop_timeout_ns;
  while (stop_.is_posted && monotonic_ns() < deadline_ns) handle_events(1);
  for (const Transfer* const transfer : transfers()) {
    if (transfer->is_posted) libusb_cancel_transfer(transfer->transfer);
  }
  deadline_ns = monotonic_ns() + close_timeout_ns;
  while (std::ranges::any_of(transfers(), &Transfer::is_posted) && monotonic_ns() < deadline_ns) handle_events(10);
  insist_on_stop();
  guard_.end();
  usb_.release_device();
  // A transfer that did not come back in time was libusb's until now.
  free_transfers();
  usb_.close();
  closing_ = false;
  poll_count_ = 0;
}

// The guard is told that this program lives, or it would do the same, and lock it out.
void FtdiLink::insist_on_stop() noexcept {
  const std::int64_t deadline_ns = monotonic_ns() + insist_ns;
  while (owes_stop() && monotonic_ns() < deadline_ns) {
    guard_.beat(monotonic_ns());
    const LinkFault why_not = usb_.send(std::span(stop_.buffer).first(owed_size_));
    if (why_not == LinkFault::none) owed_size_ = 0;
    if (why_not == LinkFault::unplugged) return;
    sleep_until_monotonic(monotonic_ns() + attempt_pause_ns);
  }
}

// --- Out -------------------------------------------------------------------------------------------------------------

bool FtdiLink::is_sending() const noexcept {
  return out_.is_posted || control_.is_posted || stop_.is_posted;
}

bool FtdiLink::request(const VendorRequest& request) noexcept {
  if (!is_usable() || out_.is_posted || control_.is_posted) return false;
  libusb_fill_control_setup(control_.buffer.data(), vendor_request_type, request.request, request.value, request.index,
                            0);
  libusb_fill_control_transfer(control_.transfer, usb_.handle(), control_.buffer.data(), &Callbacks::sent, this,
                               request_timeout_ms);
  return post(control_);
}

bool FtdiLink::write(std::span<const std::uint8_t> bytes) noexcept {
  heed_guard();
  if (!is_usable() || is_sending() || bytes.size() > out_size) return false;
  std::ranges::copy(bytes, out_.buffer.begin());
  libusb_fill_bulk_transfer(out_.transfer, usb_.handle(), usb_.out_endpoint(), out_.buffer.data(),
                            static_cast<int>(bytes.size()), &Callbacks::sent, this, send_timeout_ms);
  return post(out_);
}

void FtdiLink::stop(std::span<const std::uint8_t> bytes) noexcept {
  if (usb_.handle() == nullptr || bytes.size() > out_size) return;
  // What waits in vain must not go out after the stop, should the device listen again.
  if (out_.is_posted) libusb_cancel_transfer(out_.transfer);
  if (stop_.is_posted) return;
  std::ranges::copy(bytes, stop_.buffer.begin());
  owed_size_ = bytes.size();
  libusb_fill_bulk_transfer(stop_.transfer, usb_.handle(), usb_.out_endpoint(), stop_.buffer.data(),
                            static_cast<int>(bytes.size()), &Callbacks::sent, this, send_timeout_ms);
  post(stop_);
}

bool FtdiLink::post(Transfer& transfer) noexcept {
  ++counters_.library_calls;
  const int error = libusb_submit_transfer(transfer.transfer);
  if (error != LIBUSB_SUCCESS) set_fault(link_fault_of(error));
  transfer.is_posted = error == LIBUSB_SUCCESS;
  return transfer.is_posted;
}

void FtdiLink::sent(const libusb_transfer& transfer) noexcept {
  something_happened_ = true;
  const bool is_done = transfer.status == LIBUSB_TRANSFER_COMPLETED;
  const bool is_whole = transfer.actual_length == transfer.length;
  if (&transfer == control_.transfer) {
    control_.is_posted = false;
    const bool is_refused = transfer.status == LIBUSB_TRANSFER_STALL;
    request_outcome_ = is_done      ? RequestOutcome::done
                       : is_refused ? RequestOutcome::refused
                                    : RequestOutcome::unanswered;
    // Whether the link can do without it is for the one who asked to say.
    if (transfer.status == LIBUSB_TRANSFER_NO_DEVICE) failed(transfer.status);
    return;
  }
  const bool was_stop = &transfer == stop_.transfer;
  (was_stop ? stop_ : out_).is_posted = false;
  if (is_done) {
    errors_out_in_a_row_ = 0;
    counters_.bytes_out += static_cast<std::uint64_t>(transfer.actual_length);
    if (was_stop && is_whole) owed_size_ = 0;
  } else if (!was_stop && transfer.status == LIBUSB_TRANSFER_ERROR && may_send_again()) {
    // The device goes on with the force of before, so that there is no time to lose.
    post(out_);
  } else if (transfer.status != LIBUSB_TRANSFER_CANCELLED) {
    failed(transfer.status);
  }
}

bool FtdiLink::may_send_again() noexcept {
  if (closing_ || owes_stop() || fault_ != LinkFault::none || emergency_stop::is_ordered()) return false;
  if (++errors_out_in_a_row_ < most_errors_out_in_a_row) return true;
  set_fault(LinkFault::broken);
  return false;
}

void FtdiLink::send_at_once(std::span<const std::uint8_t> bytes) noexcept {
  usb_.send_at_once(bytes);
}

// --- In --------------------------------------------------------------------------------------------------------------

void FtdiLink::received(Receiver& receiver) noexcept {
  receiver.is_posted = false;
  const libusb_transfer& transfer = *receiver.transfer;
  // Also of a transfer that failed half-way: what had come by then has come.
  take_packets({receiver.buffer.data(), static_cast<std::size_t>(transfer.actual_length)});
  if (transfer.status == LIBUSB_TRANSFER_COMPLETED) {
    failures_in_a_row_ = 0;
    if (!closing_ && fault_ == LinkFault::none) post(receiver);
    return;
  }
  failed(transfer.status);
}

void FtdiLink::take_packets(std::span<const std::uint8_t> bytes) noexcept {
  while (bytes.size() >= ftdi_status_size) {
    const auto packet = bytes.first(std::min(bytes.size(), usb_.packet_size()));
    bytes = bytes.subspan(packet.size());
    ++counters_.packets_in;
    modem_status_ = packet[0];
    if ((packet[1] & line_error_bits) != 0) ++counters_.line_errors;
    if (packet.size() == ftdi_status_size) ++counters_.status_packets;
    keep(packet.subspan(ftdi_status_size));
  }
}

// Never asked to keep more than the ring holds. What is oldest goes first: news of the device is worth more.
void FtdiLink::keep(std::span<const std::uint8_t> payload) noexcept {
  if (payload.empty()) return;
  something_happened_ = true;
  counters_.bytes_in += payload.size();
  if (held_ + payload.size() > ring_size) {
    const std::size_t lost = held_ + payload.size() - ring_size;
    first_ = (first_ + lost) % ring_size;
    held_ -= lost;
    counters_.discarded_bytes += lost;
  }
  for (const std::uint8_t byte : payload) ring_[(first_ + held_++) % ring_size] = byte;
}

std::size_t FtdiLink::read(std::span<std::uint8_t> into) noexcept {
  const std::size_t count = std::min(into.size(), held_);
  for (std::size_t i = 0; i < count; ++i) into[i] = ring_[(first_ + i) % ring_size];
  first_ = (first_ + count) % ring_size;
  held_ -= count;
  return count;
}

// --- Faults ----------------------------------------------------------------------------------------------------------

// The first one is the cause of all others.
void FtdiLink::set_fault(LinkFault fault) noexcept {
  if (fault_ == LinkFault::none) fault_ = is_overruled() ? LinkFault::overruled : fault;
  something_happened_ = true;
}

void FtdiLink::failed(int transfer_status) noexcept {
  if (closing_) return;
  if (transfer_status == LIBUSB_TRANSFER_NO_DEVICE) {
    set_fault(LinkFault::unplugged);
  } else if (transfer_status == LIBUSB_TRANSFER_STALL || ++failures_in_a_row_ > most_failures_in_a_row) {
    // To clear an endpoint's halt is to wait for the device, for seconds if it pleases: closing and opening do it, on
    // their own thread.
    set_fault(LinkFault::broken);
  }
}

// Not from a callback.
void FtdiLink::recover() noexcept {
  if (fault_ != LinkFault::none) return;
  for (Receiver& receiver : receivers_) {
    if (!receiver.is_posted && fault_ == LinkFault::none) post(receiver);
  }
}

// --- Time ------------------------------------------------------------------------------------------------------------

void FtdiLink::handle_events(int timeout_ms) noexcept {
  guard_.beat(monotonic_ns());
  timeval timeout{0, timeout_ms * 1000L};
  ++counters_.library_calls;
  libusb_handle_events_timeout_completed(usb_.context(), &timeout, nullptr);
}

// libusb waits in whole milliseconds, rounded up, and here one of them is a whole tick; so it is only asked to look,
// and the waiting is done here.
void FtdiLink::wait_until(std::int64_t deadline_ns) noexcept {
  something_happened_ = false;
  heed_guard();
  if (!is_usable()) return sleep_until_monotonic(deadline_ns);  // nothing but the deadline will come
  for (;;) {
    handle_events(0);
    recover();
    const std::int64_t left_ns = deadline_ns - monotonic_ns();
    if (something_happened_ || left_ns <= 0) return;
    const timespec wait{0, std::min(left_ns, longest_wait_ns)};  // far less than a second
    pollfd& of_guard = poll_descriptors_[poll_count_];
    if (ppoll(poll_descriptors_.data(), poll_count_ + 1, &wait, nullptr) <= 0 || of_guard.revents == 0) continue;
    guard_.note_gone();
    of_guard.fd = -1;
    return heed_guard();
  }
}

}  // namespace ghostforce
