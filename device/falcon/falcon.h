// Falcon: the driver of a Novint Falcon, above the link (falcon_link.h) and below everything that knows of a scene. It
// finds the device, gives it firmware where it has none, lets the person home it, exchanges frames with it, and finds
// it again when it was lost. Frame: x right, y up, z out of the device towards the user, from the middle of its base;
// m and N.
//
// One thread. attend() does what can be done now: it never waits, throws or allocates (the link may, in opening).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "device/falcon/boot_loader.h"
#include "device/falcon/calibration.h"
#include "device/falcon/conversation.h"
#include "device/falcon/falcon_link.h"
#include "device/falcon/falcon_report.h"
#include "device/falcon/frame.h"
#include "device/falcon/kinematics.h"

namespace ghostforce {

struct FalconOptions {
  std::vector<std::uint8_t> firmware;           // a validated image (firmware_file.h); empty: there is none
  std::vector<FalconCalibration> calibrations;  // by serial number; a device without one gets the default
  bool is_virtual = false;                      // for the report
};

class Falcon {
 public:
  // To load the firmware; the first one after power-up fails more often than not.
  static constexpr int attempts = 10;
  static constexpr double look_again_s = 0.5;  // while absent
  static constexpr double try_again_s = 1.0;   // after a fault
  // After a command without a reply; not sooner than motors go off for want of one (Safety::longest_exchange_s): which
  // of two commands a reply belongs to cannot be told, and one that comes late must never look fresh.
  static constexpr double ask_again_s = 0.020;
  // After that: replies to commands that were given up may still come, and are thrown away for so long.
  static constexpr int forget_ms = 60;
  static constexpr double give_up_s = 1.0;        // without a reply
  static constexpr double keep_alive_s = 0.003;   // after a reply, if nobody commands anything
  static constexpr double first_reply_s = 0.020;  // of a device that may have firmware
  static constexpr int first_questions = 5;

  Falcon(std::unique_ptr<FalconLink> link, FalconOptions options);
  ~Falcon();
  Falcon(const Falcon&) = delete;
  Falcon& operator=(const Falcon&) = delete;

  void attend() noexcept;

  // What the motors are to do, from now until the next call: force on the hand [N]. Goes out at once if the device has
  // answered the last command, else as soon as it does. Heeded in idle and active only.
  void push(const Vector<3>& force, bool is_armed) noexcept;

  // Motors off, and the device told so; waits for its answers, 0.1 s at most.
  void finish() noexcept;

  const FalconReport& report() const noexcept { return report_; }
  const FalconCalibration& calibration() const noexcept { return calibration_; }
  // Of the newest reply that told a position; 0 before the first.
  std::int64_t position_time_ns() const noexcept { return position_time_ns_; }
  bool is_waiting_for_reply() const noexcept { return is_exchanging() && is_reply_due_; }
  FalconLink& link() const noexcept { return *link_; }

 private:
  enum class Phase : std::uint8_t { absent, configuring, asking, loading, exchanging, pausing };

  bool is_exchanging() const noexcept { return phase_ == Phase::asking || phase_ == Phase::exchanging; }
  double since(std::int64_t then_ns) const noexcept;

  void open() noexcept;
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
  void follow_encoders(const ReplyFrame& frame) noexcept;
  void locate(const ReplyFrame& frame) noexcept;
  void send_command() noexcept;
  void measure_rate() noexcept;

  std::unique_ptr<FalconLink> link_;
  FalconOptions options_;
  FalconCalibration calibration_;
  FalconKinematics kinematics_;
  FalconReport report_;

  Phase phase_ = Phase::absent;
  std::int64_t phase_began_ns_ = 0;
  double pause_s_ = 0.0;  // until the next look
  int attempt_ = 0;       // to load the firmware
  bool may_have_firmware_ = true;
  Conversation conversation_;
  BootLoader boot_loader_;
  int questions_left_ = 0;

  FrameReader<ReplyFrame> reader_;
  CommandFrame command_;
  bool is_command_new_ = false;  // not sent yet
  bool is_reply_due_ = false;
  std::int64_t sent_ns_ = 0;   // the last command
  std::int64_t asked_ns_ = 0;  // the first command since the last reply
  std::int64_t heard_ns_ = 0;  // the last reply
  bool is_purging_ = false;
  int unhomed_replies_ = 0;  // in a row
  int homed_replies_ = 0;    // in a row
  MotorNumbers least_{};     // of the encoders, since homing
  MotorNumbers greatest_{};
  std::int64_t position_time_ns_ = 0;
  std::int64_t lost_position_ns_ = 0;  // since when no position could be found; 0: it is known

  // Of the half second that is being measured.
  std::int64_t window_began_ns_ = 0;
  int window_exchanges_ = 0;
  double window_sum_s_ = 0.0;
  double window_worst_s_ = 0.0;
};

}  // namespace ghostforce
