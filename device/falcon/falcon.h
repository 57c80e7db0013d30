// Falcon: the driver of a Novint Falcon, above the link (falcon_link.h) and below everything that knows of a scene. It
// finds the device, gives it firmware where it has none, lets the person home it, exchanges frames with it, and finds
// it again when it was lost. Frame: x right, y up, z out of the device towards the user, from the middle of its base;
// m and N.
//
// One thread. update() does what can be done now: it never waits, throws or allocates. A separate thread does what
// takes a while, opening and closing (link_opener.h).
//
// A reply that is lost or garbled is asked for again after 6 ms, and for up to 18 ms no new force goes out
// (frame.h). After 20 ms without a reply the motors are told to stop, and again once the chip has been set up
// anew (link_setup.h). Encoders that leap farther than a hand can move are not believed until three replies in a row
// say so.
//
// A device that has pushed and does not answer a zero is owed a stop (stop_debts.h). It comes before any other: while
// it is plugged in no other one is used, and when it is plugged in while another one is, that one's motors stop and it
// is closed. Another one may push while it is away: nothing could be done for it meanwhile.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "device/falcon/boot_loader.h"
#include "device/falcon/calibration.h"
#include "device/falcon/falcon_link.h"
#include "device/falcon/falcon_report.h"
#include "device/falcon/frame.h"
#include "device/falcon/kinematics.h"
#include "device/falcon/link_script.h"
#include "device/motors/exchange_window.h"
#include "device/motors/link_opener.h"
#include "device/motors/reply_matcher.h"
#include "device/motors/stop_debts.h"

namespace ghostforce {

struct FalconOptions {
  std::vector<std::uint8_t> firmware;           // a validated image (firmware_file.h); empty: there is none
  std::vector<FalconCalibration> calibrations;  // by serial number; a device without one gets the default
  bool is_virtual = false;                      // for the report
  // Of the devices of this link; they outlive a driver, so that the next one with these options pays them. One driver runs
  // at a time; the one before ends on the thread that has made the next. Null: those of the driver alone.
  std::shared_ptr<StopDebts> debts{};
  // The driver ends, and this device, a real one, has not answered a stop: it may still push. On the thread that ends the
  // driver; null: nobody wants to hear of it.
  void (*when_left_pushing)(const DeviceSerial& serial) noexcept = nullptr;
};

class Falcon {
 public:
  // To load the firmware; the first one after power-up often fails.
  static constexpr int attempts = 10;
  static constexpr double look_again_s = 0.5;  // while absent
  static constexpr double try_again_s = 1.0;   // after a fault
  static constexpr double soon_s = 0.1;        // after it was unplugged, and while a stop is owed
  // Without a reply: motors are told to stop. Replies that come later still must never look fresh.
  static constexpr double stop_s = 0.020;
  static constexpr double give_up_s = 1.0;        // without a reply
  static constexpr double keep_alive_s = 0.003;   // after a reply, if nobody commands anything
  static constexpr double first_reply_s = 0.020;  // of a device that may have firmware
  static constexpr int first_questions = 25;
  // The same for one that has answered before, so that a slow device is not taken for one without firmware and reset.
  static constexpr int patient_questions = 100;
  // For the answers of a device that is let go, which may have to be set up anew before it hears anything.
  static constexpr double goodbye_s = 0.25;
  // At the end of the program, for devices that are owed a stop and are plugged in.
  static constexpr double last_stops_s = 3.0;
  static constexpr double last_look_s = 0.5;  // since the last sign of one of them

  Falcon(std::unique_ptr<FalconLink> link, FalconOptions options);
  ~Falcon();
  Falcon(const Falcon&) = delete;
  Falcon& operator=(const Falcon&) = delete;

  void update() noexcept;

  // What the motors are to do, from now until the next call: force on the hand [N]. Goes out at once if the device has
  // answered the last command, else as soon as it does. Only has an effect in idle and active.
  void set_force(const Vector<3>& force, bool is_armed) noexcept;

  // Turns the motors off and tells the device; waits for its answers, goodbye_s at most.
  void shut_down() noexcept;

  const FalconReport& report() const noexcept { return report_; }
  const FalconCalibration& calibration() const noexcept { return calibration_; }
  // Of the position in the report; see FalconKinematics.
  std::optional<Matrix<3>> jacobian() const noexcept { return kinematics_.jacobian(report_.position); }
  // Of the newest reply that told a position; 0 before the first.
  std::int64_t position_time_ns() const noexcept { return position_time_ns_; }
  // When that reply came: after a loss the time above may be that of an earlier command.
  std::int64_t position_heard_ns() const noexcept { return position_heard_ns_; }
  bool is_waiting_for_reply() const noexcept { return is_exchanging() && replies_.is_waiting(); }
  // Lets the device work until then; returns sooner when something has happened, or the motors are to be told to stop.
  void wait_until(std::int64_t deadline_ns) noexcept;
  FalconLink& link() const noexcept { return link_; }
  // For who drives the motors without this driver, while nobody calls update(): afterwards the device has to answer a
  // zero, or it is owed one.
  FalconLink& lend_link() noexcept {
    may_push_ = true;
    return link();
  }

 private:
  enum class Phase : std::uint8_t { pausing, opening, configuring, asking, loading, exchanging };

  bool is_exchanging() const noexcept { return phase_ == Phase::asking || phase_ == Phase::exchanging; }
  double since(std::int64_t then_ns) const noexcept;

  void poll() noexcept;
  void opened(LinkFault fault) noexcept;
  void begin_asking() noexcept;
  void set_up_chip() noexcept;
  void configure() noexcept;
  void ask() noexcept;
  void load() noexcept;
  void exchange() noexcept;
  void begin_exchanging() noexcept;
  void end(FalconFault fault) noexcept;
  void try_loading_again(FalconFault fault) noexcept;

  bool take_replies() noexcept;
  void take(const ReplyFrame& frame) noexcept;
  void follow_homing(std::uint8_t status) noexcept;
  bool believes(const MotorNumbers& encoders) noexcept;
  void follow_encoders(const MotorNumbers& encoders) noexcept;
  void locate(const MotorNumbers& encoders, std::int64_t asked_ns) noexcept;
  bool send_command() noexcept;
  void stop_motors() noexcept;
  bool recover() noexcept;
  void note_stop() noexcept;
  std::int64_t stop_ns() const noexcept;
  void note_debts() noexcept;
  bool has_owed_returned() noexcept;
  void pay_debts() noexcept;
  bool is_paying() const noexcept;
  void say_goodbye() noexcept;
  void measure_rate() noexcept;

  FalconLink& link_;  // the opener's
  LinkOpener opener_;
  FalconOptions options_;
  StopDebts& debts_;  // the options'
  FalconCalibration calibration_;
  FalconKinematics kinematics_;
  FalconReport report_;

  Phase phase_ = Phase::pausing;
  std::int64_t phase_began_ns_ = 0;
  double pause_s_ = 0.0;        // until the next look
  int attempt_ = 0;             // to load the firmware
  DeviceSerial in_use_;         // the last one that was opened to be used
  bool is_only_owed_ = false;   // this one is open for its stop alone
  std::int64_t looked_ns_ = 0;  // for one that is owed a stop, while another is in use
  bool may_have_firmware_ = true;
  LinkScript link_script_;
  BootLoader boot_loader_;
  int questions_left_ = 0;
  bool has_answered_ = false;         // since it was plugged in
  std::uint64_t packets_before_ = 0;  // of the chip, before the first question

  FrameReader<ReplyFrame> reader_;
  CommandFrame command_;
  bool is_command_new_ = false;  // not sent yet
  bool is_leaving_ = false;      // whatever answers tell, no force, light or homing is asked for
  bool may_push_ = false;        // a force was asked for, and no zero that the device has heard since
  ReplyMatcher replies_;
  std::int64_t sent_ns_ = 0;     // the last command
  std::int64_t asked_ns_ = 0;    // the first command since the last reply, or since the link was set up again
  std::int64_t heard_ns_ = 0;    // the last reply
  std::int64_t awaited_ns_ = 0;  // since then it is to answer: the last reply, or when the link was set up again
  std::optional<std::int64_t> zero_ns_;        // the first zero since the last force; empty: a force was last
  std::optional<std::int64_t> unanswered_ns_;  // since when a command waits for its reply; empty: none does
  bool is_purging_ = false;
  bool wants_latency_ = false;  // the chip is too slow, and has perhaps refused to be faster
  int unhomed_replies_ = 0;     // in a row
  int homed_replies_ = 0;       // in a row
  bool has_home_ = false;       // believed
  MotorNumbers least_{};        // of the encoders, since homing
  MotorNumbers greatest_{};
  MotorNumbers believed_{};       // the newest encoders that were believed
  MotorNumbers odd_{};            // and the newest that were not
  int odd_replies_ = 0;           // like these, in a row
  std::int64_t believed_ns_ = 0;  // 0: none yet
  std::int64_t position_time_ns_ = 0;
  std::int64_t position_heard_ns_ = 0;
  std::int64_t lost_position_ns_ = 0;  // since when no position could be found; 0: it is known
  ExchangeWindow window_;
};

}  // namespace ghostforce
