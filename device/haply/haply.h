// Haply: the driver of a Haply 2DIY, above the port (serial_port.h) and below everything that knows of a scene. It finds
// out whether a board speaks hAPI, lets a person confirm the zero pose, exchanges torques for angles, and finds the board
// again when it was lost. Frame and units as in haply_kinematics.h. Written from the published firmware; not tried on a
// device.
//
// One thread. update() does what can be done now: it never waits, throws or allocates. A separate thread opens and
// closes (link_opener.h).
//
// No published firmware turns its motors off by itself: the last duty stands until the next exchange, set up or loss of
// power. So zeros go out in every way out, and a board that has pushed and has not answered a zero is owed a stop
// (stop_debts.h). It comes before any other: while it is plugged in no other one is used, and when it is plugged in while
// another one is, that one's motors stop and it is closed. Another one may push while it is away.
//
// A reply that is lost is asked for again after 6 ms (reply_matcher.h). After 20 ms without one the motors get zeros,
// again and again until the board answers. A board that answers with its address alone has forgotten how it was set up,
// and may still push: it is set up at once, which stops its motors, and has to be given its zero pose anew.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "device/haply/hapi.h"
#include "device/haply/haply_calibration.h"
#include "device/haply/haply_kinematics.h"
#include "device/haply/haply_report.h"
#include "device/haply/reply_reader.h"
#include "device/haply/serial_port.h"
#include "device/motors/exchange_window.h"
#include "device/motors/link_opener.h"
#include "device/motors/reply_matcher.h"
#include "device/motors/stop_debts.h"

namespace ghostforce {

struct HaplyOptions {
  std::vector<HaplyCalibration> calibrations;                  // by serial number
  HaplyCalibration usual = usual_haply_variant().calibration;  // of a board without one
  bool is_virtual = false;                                     // for the report
  // As FalconOptions has them.
  std::shared_ptr<StopDebts> debts{};
  void (*when_left_pushing)(const DeviceSerial& serial) noexcept = nullptr;
};

class Haply {
 public:
  static constexpr double look_again_s = 0.5;    // while absent
  static constexpr double try_again_s = 1.0;     // after a fault
  static constexpr double soon_s = 0.1;          // after it was unplugged, and while a stop is owed
  static constexpr double settle_s = 0.1;        // after opening, before the first byte
  static constexpr double probe_s = 0.15;        // for the answer to the first question; then it is no such board
  static constexpr double set_up_s = 0.02;       // after a set up, before the next packet
  static constexpr double stop_s = 0.020;        // without a reply: zeros go out
  static constexpr double give_up_s = 1.2;       // without a reply: longer than a board waits for the rest of a packet
  static constexpr double keep_alive_s = 0.003;  // after a reply, if nobody commands anything
  static constexpr double goodbye_s = 0.1;       // for the answers of a board that is let go
  static constexpr double last_stops_s = 3.0;    // at the end of the program, for a board that is owed a stop
  static constexpr double last_look_s = 0.5;     // since the last sign of it
  static constexpr double still_s = 0.3;         // before the zero pose is confirmed
  static constexpr double still_deg = 0.5;       // at most in that time
  static constexpr double zero_pose_deg = 3.0;   // from what was set, right after it was

  // Sines between links from which a force is given less of, and below which nothing [1].
  static constexpr double full_margin = 0.30;
  static constexpr double least_margin = 0.15;

  Haply(std::unique_ptr<SerialPort> port, HaplyOptions options);
  ~Haply();
  Haply(const Haply&) = delete;
  Haply& operator=(const Haply&) = delete;

  void update() noexcept;

  // A person says that the arms are in the zero pose. Has an effect in zero_pose, idle and fault of kinematics, with the
  // motors off.
  void confirm_zero_pose() noexcept;

  // The encoders have been found not to tell where the arms are: the motors go off, and the zero pose is needed anew.
  void lose_count() noexcept;

  // What the motors are to do, from now until the next call: force on the hand, in the device's frame [N]. Only has an
  // effect in idle and active.
  void set_force(const Vector<2>& force, bool is_armed) noexcept;

  // Turns the motors off and tells the board; waits for its answers, goodbye_s at most.
  void shut_down() noexcept;

  const HaplyReport& report() const noexcept { return report_; }
  const HaplyCalibration& calibration() const noexcept { return calibration_; }
  // Of the position in the report; empty: unknown, or singular.
  const std::optional<PantographPose>& pose() const noexcept { return pose_; }
  // Of the newest reply that told a position, when it was asked for; 0 before the first.
  std::int64_t position_time_ns() const noexcept { return position_time_ns_; }
  // When that reply came.
  std::int64_t position_heard_ns() const noexcept { return position_heard_ns_; }
  bool is_waiting_for_reply() const noexcept { return phase_ == Phase::exchanging && replies_.is_waiting(); }
  // Lets the board work until then; returns sooner when something has happened, or zeros are due.
  void wait_until(std::int64_t deadline_ns) noexcept;
  SerialPort& port() const noexcept { return port_; }

 private:
  enum class Phase : std::uint8_t { pausing, opening, settling, probing, setting_up, exchanging };

  double since(std::int64_t then_ns) const noexcept;
  void enter(Phase phase) noexcept;
  void opened(LinkFault fault) noexcept;
  void ask() noexcept;
  void probe() noexcept;
  void send_set_up() noexcept;
  void begin_exchanging() noexcept;
  void exchange() noexcept;
  bool take_replies() noexcept;
  void take(const hapi::PerPort<double>& degrees) noexcept;
  bool believes(const std::array<double, 2>& angles) noexcept;
  void locate(std::int64_t asked_ns) noexcept;
  void follow_stillness() noexcept;
  void judge_zero_pose() noexcept;
  bool send(const hapi::PerPort<double>& torques) noexcept;
  bool send_command() noexcept;
  void send_zeros() noexcept;
  void forget_home() noexcept;
  void end(HaplyFault fault) noexcept;
  std::int64_t stop_ns() const noexcept;
  void note_stop() noexcept;
  void note_zero_answered() noexcept;
  void note_debts() noexcept;
  bool has_owed_returned() noexcept;
  bool is_paying() const noexcept;
  void leave_owed() noexcept;
  void pay_debts() noexcept;
  void say_goodbye() noexcept;
  void measure_rate() noexcept;

  SerialPort& port_;  // the opener's
  LinkOpener opener_;
  HaplyOptions options_;
  StopDebts& debts_;  // the options'
  HaplyCalibration calibration_;
  HaplyReport report_;

  Phase phase_ = Phase::pausing;
  std::int64_t phase_began_ns_ = 0;
  double pause_s_ = 0.0;        // until the next look
  DeviceSerial in_use_;         // the last one that was opened to be used
  bool is_only_owed_ = false;   // this one is open for its stop alone
  std::int64_t looked_ns_ = 0;  // for one that is owed a stop, while another is in use

  ReplyReader reader_;
  ReplyMatcher replies_;
  std::array<double, 2> command_{};  // torques of the arms [N·m]
  bool is_command_new_ = false;      // not sent yet
  bool has_answered_ = false;        // this board, as one that speaks hAPI
  bool is_leaving_ = false;          // nothing but zeros goes out
  bool may_push_ = false;            // a torque was sent, and no zero that the board has answered since
  bool is_unwritten_ = false;        // the port did not take the last packet,
  bool wants_zero_pose_ = false;     // a person has confirmed it
  int short_replies_ = 0;            // that were the address alone, in a row
  int slow_replies_ = 0;             // in a row
  int set_ups_ = 0;                  // since the last answer to a zero
  int in_flight_ = 0;                // exchanges that may still be answered
  int in_flight_before_zero_ = 0;    // of them, how many are older than the first zero
  std::int64_t unwritten_ns_ = 0;    // and the first one since it took one
  std::int64_t sent_ns_ = 0;
  std::int64_t heard_ns_ = 0;
  std::int64_t awaited_ns_ = 0;          // since then it is to answer
  std::int64_t zeros_ns_ = 0;            // when zeros went out last, for want of a reply
  std::optional<std::int64_t> zero_ns_;  // the first zero since the last force; empty: a force was last

  std::optional<PantographPose> pose_;
  std::array<double, 2> believed_{};  // the newest angles that were believed [rad]
  std::array<double, 2> odd_{};       // and the newest that were not
  int odd_replies_ = 0;
  std::int64_t believed_ns_ = 0;
  std::array<double, 2> least_{};  // since the zero pose was confirmed, or the arms were still [rad]
  std::array<double, 2> greatest_{};
  std::array<double, 2> still_least_{};
  std::array<double, 2> still_greatest_{};
  std::int64_t still_ns_ = 0;  // since when they are
  std::int64_t position_time_ns_ = 0;
  std::int64_t position_heard_ns_ = 0;
  std::int64_t lost_position_ns_ = 0;  // since when no position could be found; 0: it is known
  ExchangeWindow window_;
};

}  // namespace ghostforce
