#include "device/motors/link_opener.h"

#include <cassert>
#include <utility>

namespace ghostforce {

class LinkOpener::Worker {};

LinkOpener::LinkOpener(std::unique_ptr<DeviceLink> link) : link_(std::move(link)) {
  assert(!link_->waits_to_open());
}

LinkOpener::~LinkOpener() {
  end();
}

void LinkOpener::open(const StopDebts& owed) noexcept {
  link_->open_first(owed);
}

void LinkOpener::close() noexcept {
  link_->close();
}

void LinkOpener::end() noexcept {
  link_->close();
}

void LinkOpener::look_for(const StopDebts& owed) noexcept {
  has_found_ = link_->is_any_plugged_in(owed);
}

bool LinkOpener::has_found_one() noexcept {
  return std::exchange(has_found_, false);
}

bool LinkOpener::is_busy() const noexcept {
  return false;
}

void LinkOpener::wait_until(std::int64_t deadline_ns) noexcept {
  link_->wait_until(deadline_ns);
}

}  // namespace ghostforce
