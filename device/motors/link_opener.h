// LinkOpener: has a DeviceLink opened and closed on a thread of its own, because both allocate and wait for the system
// and for the device, perhaps for seconds. The driver asks, continues with its ticks, and is given a complete open
// link. A link that never waits (DeviceLink::waits_to_open) needs no thread: it is opened and closed as it is asked
// for. A page, which has no threads, has no other links.
//
// The link belongs to one thread at a time: to the opener's while is_busy(), else to the driver's. Its now_ns() and
// stop_at_once() belong to everybody, is_any_plugged_in() to the opener's thread. All functions here belong to the
// driver's thread; none but the constructor allocates or throws, and only end() and wait_until() wait.
#pragma once

#include <cstdint>
#include <memory>

#include "device/motors/device_link.h"
#include "device/motors/stop_debts.h"

namespace ghostforce {

class LinkOpener {
 public:
  // Throws std::system_error if there can be no thread.
  explicit LinkOpener(std::unique_ptr<DeviceLink> link);
  LinkOpener(const LinkOpener&) = delete;
  LinkOpener& operator=(const LinkOpener&) = delete;
  ~LinkOpener();

  // Not while it is busy. See DeviceLink::open_first().
  void open(const StopDebts& owed) noexcept;
  void close() noexcept;
  // For good: ends the thread with the link closed. Waits for what is under way, perhaps for seconds.
  void end() noexcept;
  bool is_busy() const noexcept;

  // Looks whether one of these devices is plugged in, while the driver goes on with the link. Nothing if it is looking.
  void look_for(const StopDebts& owed) noexcept;
  // Whether one was. Says so once.
  bool has_found_one() noexcept;

  DeviceLink& link() const noexcept { return *link_; }

  // As the link's, also while the link is not the driver's: then until the deadline.
  void wait_until(std::int64_t deadline_ns) noexcept;

 private:
  class Worker;

  std::unique_ptr<DeviceLink> link_;
  bool has_found_ = false;          // without a thread
  std::unique_ptr<Worker> worker_;  // with the thread; null: the link needs none
};

}  // namespace ghostforce
