#include "device/motors/motor_keeper.h"

#include <utility>

#include "device/motors/emergency_stop.h"

namespace ghostforce {

MotorKeeper::MotorKeeper(std::unique_ptr<DeviceLink> link, Options options)
    : opener_(std::move(link)),
      debts_(options.debts ? std::move(options.debts) : std::make_shared<StopDebts>()),
      when_left_pushing_(options.when_left_pushing),
      pause_began_ns_(now_ns()) {}

MotorKeeper::Event MotorKeeper::update() noexcept {
  if (opener_.is_busy()) return Event::away;
  if (stage_ == Stage::pausing) {
    if (since(pause_began_ns_) < pause_s_) return Event::away;
    opener_.open(*debts_);
    stage_ = Stage::opening;
    if (opener_.is_busy()) return Event::away;
  }
  if (stage_ == Stage::opening) return opened();
  link().wait_until(now_ns());  // lets transfers make progress
  if (link().fault() != LinkFault::none) return Event::failed;
  return has_owed_returned() ? Event::overtaken : Event::open;
}

MotorKeeper::Event MotorKeeper::opened() noexcept {
  opener_.has_found_one();  // whatever it was, it has been looked for again
  has_looked_ = true;
  pause_began_ns_ = now_ns();
  const LinkFault fault = link().fault();
  is_there_ = fault != LinkFault::absent;
  if (!is_there_) {
    stage_ = Stage::pausing;
    pause_s_ = debts_->empty() ? look_again_s : soon_s;
    return Event::absent;
  }
  if (fault != LinkFault::none) return Event::failed;
  stage_ = Stage::open;
  emergency_stop::watch(&link());
  const DeviceSerial before = std::exchange(serial_, device_serial_of(link().serial()));
  is_another_ = before != serial_;
  may_push_ = debts_->has(serial_);
  link().set_may_push(may_push_);
  is_only_owed_ = may_push_ && serial_ != in_use_;
  if (!is_only_owed_) in_use_ = serial_;
  return Event::opened;
}

// One that is owed a stop is plugged in again, while another one is in use.
bool MotorKeeper::has_owed_returned() noexcept {
  if (debts_->empty() || debts_->has(serial_)) return false;
  if (since(looked_ns_) >= soon_s) {
    looked_ns_ = now_ns();
    opener_.look_for(*debts_);
  }
  return opener_.has_found_one();
}

// Somebody who plugs a device in again is not made to wait.
void MotorKeeper::let_go(double pause_s) noexcept {
  const bool has_gone = link().fault() == LinkFault::unplugged;
  if (stage_ == Stage::open) debts_->postpone(serial_);
  opener_.close();
  if (has_gone) is_there_ = false;
  stage_ = Stage::pausing;
  pause_began_ns_ = now_ns();
  pause_s_ = has_gone || !debts_->empty() ? std::min(pause_s, soon_s) : pause_s;
}

void MotorKeeper::will_push() noexcept {
  if (may_push_) return;
  may_push_ = true;
  link().set_may_push(true);
}

bool MotorKeeper::must_stop(std::int64_t heard_ns) const noexcept {
  return is_leaving_ || since(heard_ns) > stop_s || emergency_stop::is_ordered();
}

bool MotorKeeper::sent(bool pushes, std::int64_t at_ns) noexcept {
  const bool is_first_zero = !pushes && !zero_ns_;
  if (pushes) zero_ns_.reset();
  if (is_first_zero) zero_ns_ = at_ns;
  return is_first_zero;
}

void MotorKeeper::zero_answered() noexcept {
  if (may_push_) link().set_may_push(false);
  may_push_ = false;
  debts_->remove(serial_);
}

void MotorKeeper::note_stop() noexcept {
  if (may_push_) debts_->add(serial_);
}

// Whether one that is owed a stop is open; or some device is there and could not be opened, perhaps that one.
bool MotorKeeper::is_paying() const noexcept {
  return stage_ == Stage::open ? debts_->has(serial_) : is_there_;
}

void MotorKeeper::end_for_good() noexcept {
  if (when_left_pushing_ != nullptr) {
    for (const DeviceSerial& serial : debts_->serials()) when_left_pushing_(serial);
  }
  opener_.end();
  emergency_stop::watch(nullptr);
}

}  // namespace ghostforce
