// MotorKeeper: keeps a device with motors for its driver, from when it is looked for until it is let go, and sees to it
// that none is left pushing that can be reached. It has the link opened and closed, remembers which devices have been
// told to stop and have not answered a zero since (stop_debts.h), looks for those first, and has them stopped when the
// program ends. What goes over the link is the driver's: it sends the zeros, and tells when one was answered.
//
// A device that is owed a stop comes before any other: while it is plugged in no other one is used, and when it is
// plugged in while another one is, that one's motors stop and it is closed. It is opened for that stop alone, and then
// the one that is to be used is next, unless it is that one itself. Another one may push while it is away: nothing
// could be done for it meanwhile.
//
// What a driver does with it:
//   update()         calls update() here first, and does what Event says
//   before a force   asks must_stop(), and calls will_push(); after each command sent()
//   each reply       where it answers a zero (answers_zero()), calls zero_answered(); where has_paid(), let_go()
//   a stop           sends zeros, then calls note_stop()
//   a fault          stops, then let_go()
//   its shut_down()  say_goodbye(), then let_go()
//   its destructor   end()
// After each of these tell() puts what has become of it into the driver's report.
//
// The driver's thread, as LinkOpener's functions; a signal's handler reaches the link by emergency_stop.h. Nothing but
// the constructor allocates or throws; nothing but wait_until(), say_goodbye() and end() waits. Times in ns.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "device/motors/device_link.h"
#include "device/motors/device_serial.h"
#include "device/motors/link_opener.h"
#include "device/motors/stop_debts.h"

namespace ghostforce {

// What end() asks of a driver: update() does what can be done now, shut_down() turns the motors off and lets the device
// go.
template <typename Driver>
concept DriverOfMotors = noexcept(std::declval<Driver&>().update()) && noexcept(std::declval<Driver&>().shut_down());

class MotorKeeper {
 public:
  static constexpr double look_again_s = 0.5;  // while there is none
  static constexpr double try_again_s = 1.0;   // after a fault
  static constexpr double soon_s = 0.1;        // after it was unplugged, and while a stop is owed
  static constexpr double stop_s = 0.020;      // without a reply: no force goes out any more
  static constexpr int goodbye_answers = 3;    // before a device is let go
  // At the end of the program, for devices that are owed a stop and are plugged in.
  static constexpr double last_stops_s = 3.0;
  static constexpr double last_look_s = 0.5;  // since the last sign of one of them

  struct Options {
    // Of the devices of this link; they outlive a driver, so that the next one with these options pays them. One driver
    // runs at a time; the one before ends on the thread that has made the next. Null: those of this driver alone.
    std::shared_ptr<StopDebts> debts{};
    // The driver ends, and this device has not answered a stop: it may still push. On the thread that ends the driver;
    // null: nobody wants to hear of it.
    void (*when_left_pushing)(const DeviceSerial& serial) noexcept = nullptr;
  };

  enum class Event : std::uint8_t {
    away,       // there is nothing to do: it is being opened or closed, or will be looked for later
    absent,     // it has been looked for, and is not there
    opened,     // just now
    open,       // and well
    failed,     // it could not be opened, or is of no use any more: link().fault() says why, and it is to be let go
    overtaken,  // another one, which is owed a stop, is plugged in again: this one is to be stopped and let go
  };

  // Throws std::system_error if there can be no thread.
  MotorKeeper(std::unique_ptr<DeviceLink> link, Options options);

  Event update() noexcept;
  // As LinkOpener's.
  void wait_until(std::int64_t deadline_ns) noexcept { opener_.wait_until(deadline_ns); }
  // Closes it, tells the guard, and looks again after the pause at the latest.
  void let_go(double pause_s) noexcept;
  // The link is being opened or closed, and not the driver's.
  bool is_busy() const noexcept { return opener_.is_busy(); }

  DeviceLink& link() const noexcept { return opener_.link(); }
  std::int64_t now_ns() const noexcept { return link().now_ns(); }
  double since(std::int64_t then_ns) const noexcept { return static_cast<double>(now_ns() - then_ns) * 1e-9; }

  // Of the device that is open or was.
  const DeviceSerial& serial() const noexcept { return serial_; }
  // It is not the one that was open before.
  bool is_another() const noexcept { return is_another_; }
  // It is open for its stop alone, and not to be used.
  bool is_only_owed() const noexcept { return is_only_owed_; }
  // It was, and has answered: it is to be let go without a pause.
  bool has_paid() const noexcept { return is_only_owed_ && !may_push_; }

  // --- What is sent and answered ---

  // A force was asked for, and no zero that the device has heard since.
  bool may_push() const noexcept { return may_push_; }
  // Before a force goes out.
  void will_push() noexcept;
  // For who drives the motors without the driver, and tells the link itself: afterwards the device has to answer a
  // zero, or it is owed one.
  void lend() noexcept { may_push_ = true; }
  // Whoever waits too long for a reply does not go on pushing. `heard_ns`: when the newest one came.
  bool must_stop(std::int64_t heard_ns) const noexcept;
  // Nothing but zeros is to be sent, whatever answers tell.
  bool is_leaving() const noexcept { return is_leaving_; }
  // A command has gone out. Whether it is the first zero since the last force.
  bool sent(bool pushes, std::int64_t at_ns) noexcept;
  // When that was; empty: a force was last.
  std::optional<std::int64_t> zero_ns() const noexcept { return zero_ns_; }
  // A reply to an older command, one with force, says nothing about a zero that was sent beside it. `asked_ns`: when
  // its command was sent.
  bool answers_zero(std::int64_t asked_ns) const noexcept { return zero_ns_ && asked_ns >= *zero_ns_; }
  // The device has heard a zero: it owes nothing and is owed nothing.
  void zero_answered() noexcept;
  // The device has been told to stop, and may not have heard.
  void note_stop() noexcept;

  // What a driver's report says of all that.
  template <typename Report>
  void tell(Report& report) const noexcept {
    report.has_looked = has_looked_;
    report.serial = serial_;
    report.may_still_push = !debts_->empty();
    // The one that is named stays, whatever is tried first.
    if (!debts_->has(report.owed_serial)) {
      report.owed_serial = debts_->empty() ? DeviceSerial() : debts_->serials().front();
    }
  }

  // --- The end ---

  // Sends zeros until three answers have come, one of them to a zero: the device has heard it, and not only a chip
  // before it. Whether that is so; if not, it is to be told to stop once more. `is_waiting`: for the answer to what was
  // sent before. `exchange(answers, deadline_ns)`: sends a zero where it may, waits until then at the latest, and takes
  // what has come; returns how many answers there are now.
  template <typename Exchange>
  bool say_goodbye(double patience_s, bool is_waiting, const Exchange& exchange) noexcept {
    constexpr std::int64_t longest_wait_ns = 5'000'000;
    const std::int64_t deadline_ns = now_ns() + static_cast<std::int64_t>(patience_s * 1e9);
    int heard = is_waiting ? -1 : 0;
    const auto has_heard = [&] { return heard >= goodbye_answers && !may_push_; };
    is_leaving_ = true;
    while (!has_heard() && link().fault() == LinkFault::none && now_ns() < deadline_ns) {
      heard = exchange(heard, std::min(deadline_ns, now_ns() + longest_wait_ns));
    }
    is_leaving_ = false;
    return has_heard();
  }

  // There is no later. The device is let go, and those that are owed a stop and are plugged in are stopped. One that is
  // just being plugged in may not be listed yet, or may have been found a moment ago: the time counts from the last
  // sign of it. Until this returns an emergency still finds the link.
  template <DriverOfMotors Driver>
  void end(Driver& driver) noexcept {
    driver.shut_down();
    const std::int64_t began_ns = now_ns();
    std::int64_t seen_ns = began_ns;
    pause_s_ = 0.0;
    while (!debts_->empty() && since(began_ns) < last_stops_s) {
      const bool was_busy = opener_.is_busy();  // what it has found is known after the next update()
      driver.update();
      if (is_paying()) seen_ns = now_ns();
      const bool is_looking = was_busy || opener_.is_busy() || stage_ == Stage::opening;
      if (!is_looking && since(seen_ns) >= last_look_s) break;
      opener_.wait_until(now_ns() + 1'000'000);
    }
    driver.shut_down();
    end_for_good();
  }

 private:
  enum class Stage : std::uint8_t { pausing, opening, open };

  Event opened() noexcept;
  bool has_owed_returned() noexcept;
  bool is_paying() const noexcept;
  void end_for_good() noexcept;

  LinkOpener opener_;
  std::shared_ptr<StopDebts> debts_;  // never null
  void (*when_left_pushing_)(const DeviceSerial& serial) noexcept;

  Stage stage_ = Stage::pausing;
  std::int64_t pause_began_ns_;
  double pause_s_ = 0.0;  // what is looked for is looked for at once
  bool has_looked_ = false;
  bool is_there_ = false;  // some device was when it was looked for last, and has not been seen to go
  DeviceSerial serial_;
  bool is_another_ = false;
  DeviceSerial in_use_;  // the last one that was opened to be used
  bool is_only_owed_ = false;
  std::int64_t looked_ns_ = 0;  // for one that is owed a stop, while another is in use
  bool may_push_ = false;
  bool is_leaving_ = false;
  std::optional<std::int64_t> zero_ns_;
};

}  // namespace ghostforce
