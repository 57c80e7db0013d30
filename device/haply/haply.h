// Haply: the driver of a Haply 2DIY, above the port (serial_port.h) and below everything that knows of a scene. It finds
// out whether a board speaks hAPI, lets a person confirm the zero pose, exchanges torques for angles, and finds the board
// again when it was lost. Frame and units as in haply_kinematics.h. Written from the published firmware; not tried on a
// device.
//
// One thread. update() does what can be done now: it never waits, throws or allocates. What all devices with motors
// need is in motor_keeper.h: they are opened and closed on a separate thread, and a stop that is owed comes first.
//
// No published firmware turns its motors off by itself: the last duty stands until the next exchange, set up or loss of
// power. So zeros go out in every way out, and a board that has pushed and has not answered a zero is owed a stop.
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
#include "device/motors/leap_filter.h"
#include "device/motors/motor_keeper.h"
#include "device/motors/position_times.h"
#include "device/motors/reply_matcher.h"

namespace ghostforce {

struct HaplyOptions {
  std::vector<HaplyCalibration> calibrations;                  // by serial number
  HaplyCalibration usual = usual_haply_variant().calibration;  // of a board without one
  bool is_virtual = false;                                     // for the report
  // As MotorKeeper::Options; of a virtual one nobody is told that it was left pushing.
  std::shared_ptr<StopDebts> debts{};
  void (*when_left_pushing)(const DeviceSerial& serial) noexcept = nullptr;
};

class Haply {
 public:
  static constexpr double settle_s = 0.1;   // after opening, before the first byte
  static constexpr double probe_s = 0.15;   // for the answer to the first question; then it is no such board
  static constexpr double set_up_s = 0.02;  // after a set up, before the next packet
  static constexpr double stop_s = MotorKeeper::stop_s;  // without a reply: zeros go out
  static constexpr double refused_again_s = 0.001;       // and again, where the port has not taken them
  static constexpr double give_up_s = 1.2;       // without a reply: longer than a board waits for the rest of a packet
  static constexpr double keep_alive_s = 0.003;  // after a reply, if nobody commands anything
  static constexpr double goodbye_s = 0.1;       // for the answers of a board that is let go
  static constexpr double still_s = 0.3;         // before the zero pose is confirmed
  static constexpr double still_deg = 0.5;       // at most in that time
  static constexpr double zero_pose_deg = 3.0;   // from what was set, right after it was

  // Sines between links from which a force is given less of, and below which nothing [1].
  static constexpr double full_margin = 0.30;
  static constexpr double least_margin = 0.15;
  // Of one motor alone: near the base its torque would give many times that. A pulled cable leaves no more standing [N].
  static constexpr double greatest_motor_force = 2.5;

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
  Vector<2> set_force(const Vector<2>& force, bool is_armed) noexcept;

  // Turns the motors off and tells the board; waits for its answers, goodbye_s at most.
  void shut_down() noexcept;

  const HaplyReport& report() const noexcept { return report_; }
  const HaplyCalibration& calibration() const noexcept { return calibration_; }
  // Of the position in the report; empty: unknown, or singular.
  const std::optional<PantographPose>& pose() const noexcept { return pose_; }
  // Of the newest reply that told a position, when it was asked for; 0 before the first.
  std::int64_t position_time_ns() const noexcept { return position_times_.asked_ns(); }
  // When that reply came.
  std::int64_t position_heard_ns() const noexcept { return position_times_.heard_ns(); }
  bool is_waiting_for_reply() const noexcept { return phase_ == Phase::exchanging && replies_.is_waiting(); }
  // Lets the board work until then; returns sooner when something has happened, or zeros are due.
  void wait_until(std::int64_t deadline_ns) noexcept;
  SerialPort& port() const noexcept { return port_; }

 private:
  enum class Phase : std::uint8_t { closed, settling, probing, setting_up, exchanging };

  double since(std::int64_t then_ns) const noexcept { return keeper_.since(then_ns); }
  void enter(Phase phase) noexcept;
  void advance() noexcept;
  void opened() noexcept;
  void ask() noexcept;
  void probe() noexcept;
  void send_set_up() noexcept;
  void begin_exchanging() noexcept;
  void exchange() noexcept;
  bool take_replies() noexcept;
  void take(const hapi::PerPort<double>& degrees) noexcept;
  void locate(std::int64_t asked_ns) noexcept;
  void follow_stillness() noexcept;
  void judge_zero_pose() noexcept;
  bool send(const hapi::PerPort<double>& torques) noexcept;
  bool send_command() noexcept;
  void send_zeros() noexcept;
  void forget_home() noexcept;
  void stop_motors() noexcept;
  void close(double pause_s) noexcept;
  void end(HaplyFault fault) noexcept;
  std::int64_t stop_ns() const noexcept;
  void note_stop() noexcept;
  void note_zero_answered() noexcept;
  void say_goodbye() noexcept;
  void measure_rate() noexcept;

  SerialPort& port_;  // the keeper's
  MotorKeeper keeper_;
  HaplyOptions options_;
  HaplyCalibration calibration_;
  HaplyReport report_;

  Phase phase_ = Phase::closed;
  std::int64_t phase_began_ns_ = 0;

  ReplyReader reader_;
  ReplyMatcher replies_;
  std::array<double, 2> command_{};  // torques of the arms [N·m]
  bool is_command_new_ = false;      // not sent yet
  bool has_answered_ = false;        // this board, as one that speaks hAPI
  bool is_unwritten_ = false;        // the port did not take the last packet,
  bool wants_zero_pose_ = false;     // a person has confirmed it
  int short_replies_ = 0;            // that were the address alone, in a row
  int slow_replies_ = 0;             // in a row
  int set_ups_ = 0;                  // since the last answer to a zero
  int unclear_probes_ = 0;           // in a row
  int in_flight_ = 0;                // exchanges that may still be answered
  int in_flight_before_zero_ = 0;    // of them, how many are older than the first zero
  std::int64_t unwritten_ns_ = 0;    // and the first one since it took one
  std::int64_t sent_ns_ = 0;
  std::int64_t heard_ns_ = 0;
  std::int64_t awaited_ns_ = 0;  // since then it is to answer
  std::int64_t zeros_ns_ = 0;    // when zeros went out last, for want of a reply

  std::optional<PantographPose> pose_;
  // What no hand does. At 1 m/s, where motors go off, an arm turns by 0.8° per millisecond in the workspace; one that is
  // stopped from twice that is believed, and so are 500 m/s².
  LeapFilter<std::array<double, 2>> leap_filter_{{.least = 1.5 * radians_per_degree,
                                                  .per_s = 0.0,
                                                  .per_s_squared = 4e5 * radians_per_degree,
                                                  .greatest = 15.0 * radians_per_degree}};
  bool has_leapt_ = false;         // since the zero pose was confirmed
  std::array<double, 2> least_{};  // since the zero pose was confirmed, or the arms were still [rad]
  std::array<double, 2> greatest_{};
  std::array<double, 2> still_least_{};
  std::array<double, 2> still_greatest_{};
  std::int64_t still_ns_ = 0;  // since when they are
  PositionTimes position_times_;
  ExchangeWindow window_;
};

}  // namespace ghostforce
