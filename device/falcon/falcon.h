// Falcon: the driver of a Novint Falcon, above the link (falcon_link.h) and below everything that knows of a scene. It
// finds the device, gives it firmware where it has none, lets the person home it, exchanges frames with it, and finds
// it again when it was lost. Frame: x right, y up, z out of the device towards the user, from the middle of its base;
// m and N.
//
// One thread. update() does what can be done now: it never waits, throws or allocates. What all devices with motors
// need is in motor_keeper.h: they are opened and closed on a separate thread, and a stop that is owed comes first.
//
// A reply that is lost or garbled is asked for again after 6 ms, and for up to 18 ms no new force goes out
// (frame.h). After 20 ms without a reply the motors are told to stop, and again once the chip has been set up
// anew (link_setup.h).
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
#include "device/motors/leap_filter.h"
#include "device/motors/motor_keeper.h"
#include "device/motors/position_times.h"
#include "device/motors/reply_matcher.h"

namespace ghostforce {

struct FalconOptions {
  std::vector<std::uint8_t> firmware;           // a validated image (firmware_file.h); empty: there is none
  std::vector<FalconCalibration> calibrations;  // by serial number; a device without one gets the default
  bool is_virtual = false;                      // for the report
  // As MotorKeeper::Options; of a virtual one nobody is told that it was left pushing.
  std::shared_ptr<StopDebts> debts{};
  void (*when_left_pushing)(const DeviceSerial& serial) noexcept = nullptr;
};

class Falcon {
 public:
  // To load the firmware; the first one after power-up often fails.
  static constexpr int attempts = 10;
  static constexpr double load_again_s = 0.1;  // after an attempt that failed
  // Without a reply: motors are told to stop. Replies that come later still must never look fresh.
  static constexpr double stop_s = MotorKeeper::stop_s;
  static constexpr double give_up_s = 1.0;        // without a reply
  static constexpr double keep_alive_s = 0.003;   // after a reply, if nobody commands anything
  static constexpr double first_reply_s = 0.020;  // of a device that may have firmware
  static constexpr int first_questions = 25;
  // The same for one that has answered before, so that a slow device is not taken for one without firmware and reset.
  static constexpr int patient_questions = 100;
  // For the answers of a device that is let go, which may have to be set up anew before it hears anything.
  static constexpr double goodbye_s = 0.25;

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
  std::int64_t position_time_ns() const noexcept { return position_times_.asked_ns(); }
  // When that reply came.
  std::int64_t position_heard_ns() const noexcept { return position_times_.heard_ns(); }
  bool is_waiting_for_reply() const noexcept { return is_exchanging() && replies_.is_waiting(); }
  // Lets the device work until then; returns sooner when something has happened, or the motors are to be told to stop.
  void wait_until(std::int64_t deadline_ns) noexcept;
  FalconLink& link() const noexcept { return link_; }
  // For who drives the motors without this driver, while nobody calls update(): afterwards the device has to answer a
  // zero, or it is owed one.
  FalconLink& lend_link() noexcept {
    keeper_.lend();
    return link();
  }

 private:
  enum class Phase : std::uint8_t { closed, configuring, asking, loading, exchanging };

  bool is_exchanging() const noexcept { return phase_ == Phase::asking || phase_ == Phase::exchanging; }
  double since(std::int64_t then_ns) const noexcept { return keeper_.since(then_ns); }

  void advance() noexcept;
  void note_absence() noexcept;
  void opened() noexcept;
  void begin_asking() noexcept;
  void set_up_chip() noexcept;
  void configure() noexcept;
  void ask() noexcept;
  void load() noexcept;
  void exchange() noexcept;
  void begin_exchanging() noexcept;
  void close(double pause_s) noexcept;
  void end(FalconFault fault, double pause_s = MotorKeeper::try_again_s) noexcept;
  void try_loading_again(FalconFault fault) noexcept;

  bool take_replies() noexcept;
  void take(const ReplyFrame& frame) noexcept;
  void follow_homing(std::uint8_t status) noexcept;
  void follow_encoders(const MotorNumbers& encoders) noexcept;
  void locate(const MotorNumbers& encoders, std::int64_t asked_ns) noexcept;
  bool send_command() noexcept;
  void stop_motors() noexcept;
  bool recover() noexcept;
  void note_stop() noexcept;
  std::int64_t stop_ns() const noexcept;
  void say_goodbye() noexcept;
  void measure_rate() noexcept;

  FalconLink& link_;  // the keeper's
  MotorKeeper keeper_;
  FalconOptions options_;
  FalconCalibration calibration_;
  FalconKinematics kinematics_;
  FalconReport report_;

  Phase phase_ = Phase::closed;
  int attempt_ = 0;  // to load the firmware
  bool may_have_firmware_ = true;
  LinkScript link_script_;
  BootLoader boot_loader_;
  int questions_left_ = 0;
  bool has_answered_ = false;         // since it was plugged in
  std::uint64_t packets_before_ = 0;  // of the chip, before the first question

  FrameReader<ReplyFrame> reader_;
  CommandFrame command_;
  bool is_command_new_ = false;  // not sent yet
  ReplyMatcher replies_;
  std::int64_t sent_ns_ = 0;     // the last command
  std::int64_t asked_ns_ = 0;    // the first command since the last reply, or since the link was set up again
  std::int64_t heard_ns_ = 0;    // the last reply
  std::int64_t awaited_ns_ = 0;  // since then it is to answer: the last reply, or when the link was set up again
  std::optional<std::int64_t> unanswered_ns_;  // since when a command waits for its reply; empty: none does
  bool is_purging_ = false;
  bool wants_latency_ = false;  // the chip is too slow, and has perhaps refused to be faster
  int unhomed_replies_ = 0;     // in a row
  int homed_replies_ = 0;       // in a row
  bool has_home_ = false;       // believed
  MotorNumbers least_{};        // of the encoders, since homing
  MotorNumbers greatest_{};
  // What no hand does: an arm turns by less. At 1 m/s, where motors go off, it is 63 counts per millisecond where the
  // geometry is worst; and a wrong digit of the third place makes more than the greatest reach.
  LeapFilter<MotorNumbers> leap_filter_{{.least = 40.0, .per_s = 65e3, .per_s_squared = 0.0, .greatest = 250.0}};
  PositionTimes position_times_;
  ExchangeWindow window_;
};

}  // namespace ghostforce
