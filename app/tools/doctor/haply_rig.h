// HaplyRig: what every measurement of a Haply 2DIY needs: a person who is asked, arms that are read when they are still,
// and motors that are watched. It exchanges single packets over the driver's port while the driver rests, once a
// millisecond. UI thread; SI units, the device's frame; by arm, but for what says port.
//
// Motors: the force at the handle stays below `greatest_force` with motors as strong as the calibration says, or as the
// firmware takes them for, so below 1.5 N where they give half as much again. They are off at once when the handle goes
// faster than `fastest` or farther than `farthest` from where it was when they came on, when its angles belong to no place
// of the handle, and when a reply is missing. There is no button that a person could let go of.
//
// Everything may throw Failure: interrupted; absent, failed, where the board has gone or does not answer; and Leave or
// Skip (operator.h). What moves motors throws HaplyStop once they are off.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "app/tools/doctor/haply_readings.h"
#include "app/tools/doctor/operator.h"
#include "device/haply/haply.h"
#include "device/virtual_haply/measured_haply_person.h"

namespace ghostforce {

using HaplyOperator = OperatorFor<HaplyAction>;

// Why motors went off before their time.
enum class HaplyStop : std::uint8_t { too_fast, too_far, no_place, no_reply };

// What is so at one tick, with motors on or off.
struct HaplySample {
  double time_s = 0.0;    // since the drive began
  Vector<2> angles{0.0};  // [rad]
  PantographPose pose;
  Vector<2> velocity{0.0};  // of the handle
  Vector<2> torques{0.0};   // as sent while this was so; positive is to increase the angle [N·m]
};

class HaplyRig {
 public:
  static constexpr double period_s = 0.001;
  static constexpr double greatest_force = 1.0;       // [N]
  static constexpr double usual_steepest = 0.4;       // of a torque [N·m/s]
  static constexpr double fastest = 0.5;              // [m/s]
  static constexpr double farthest = 0.040;           // [m]
  static constexpr double longest_exchange_s = 0.02;  // as Haply::stop_s
  static constexpr int tries = 3;

  using Law = std::function<Vector<2>(const HaplySample&)>;  // the torques of the arms [N·m]
  using Watch = std::function<void(const HaplySample&)>;
  static Vector<2> no_torques(const HaplySample& /*sample*/) noexcept { return Vector<2>{0.0}; }

  // Nobody calls the driver's update() while this lives. `debts`: where a board is noted that may push when this ends.
  HaplyRig(HaplyOperator& person, Haply& haply, const HaplyCalibration& calibration, StopDebts* debts);
  ~HaplyRig();
  HaplyRig(const HaplyRig&) = delete;
  HaplyRig& operator=(const HaplyRig&) = delete;

  const HaplyCalibration& calibration() const noexcept { return calibration_; }
  // What the board knows of it, it knows after the next set_up().
  void use(const HaplyCalibration& calibration) noexcept { calibration_ = calibration; }
  const HaplyReport& found() const noexcept { return found_; }  // by the driver, before
  HaplyOperator& person() noexcept { return person_; }
  double now_s() const noexcept { return static_cast<double>(port_.now_ns()) * 1e-9; }
  double last_exchange_s() const noexcept { return last_exchange_s_; }
  Vector<2> middle() const noexcept { return calibration_.center; }

  std::string ask(const HaplyAction& action, std::string_view words) { return ask_person(person_, action, words); }
  double ask_number(const HaplyAction& action, std::string_view words, double least, double greatest,
                    std::string_view unit) {
    return ask_person_number(person_, action, words, least, greatest, unit);
  }
  // Has it done, and returns the mean of the encoders by port [degrees], once the arms are still.
  hapi::PerPort<double> read_still_at(const HaplyAction& action, std::string_view words);
  // Tells the board its set up: where the arms are now is the zero pose. Motors off.
  bool set_up();  // whether the port has taken it
  // Motors off: one exchange, or so many seconds of them. Angles by port [degrees].
  hapi::PerPort<double> poll(bool is_paced = true);
  void rest(double seconds);

  // Has the person do it, waits until the handle is near the middle and slow, does what is to be done, and turns the
  // motors off. Whatever stops it is told, and it is begun again, `tries` times in all. Empty: it came to its end; else
  // why it did not, in a sentence.
  std::string with_motors(const HaplyAction& action, std::string_view words, const std::function<void()>& what);

  // For what is called by with_motors(). Goes on from whatever the motors do. `steepest`: of each torque [N·m/s].
  void drive(double seconds, const Law& law, const Watch& watch = {}, double steepest = usual_steepest);
  void let_go(double seconds);
  void turn_off();
  // Says nothing to the board, and then looks with a command of zeros.
  void be_silent(double seconds, const Watch& after);
  // The torques as sent that make this force at the handle, as far as the calibration knows.
  Vector<2> torques_of(const Vector<2>& force, const PantographPose& pose) const noexcept;

  std::optional<HaplyHold> free_hold{};  // without a weight; for steps

 private:
  std::optional<hapi::PerPort<double>> ask_board(const hapi::PerPort<double>& torques);
  hapi::PerPort<double> exchange(const Vector<2>& torques, bool is_paced = true);
  void recover();
  bool stop();
  void wait_until(std::int64_t deadline_ns);
  void forget_replies();
  [[noreturn]] void fail(LinkFault fault);
  std::optional<HaplyStop> see(const hapi::PerPort<double>& degrees, HaplySample& sample);
  bool await_ready();
  Vector<2> within_limits(Vector<2> torques, const PantographPose& pose) const noexcept;

  HaplyOperator& person_;
  SerialPort& port_;
  HaplyCalibration calibration_;
  HaplyReport found_;
  StopDebts* debts_;
  ReplyReader reader_;
  std::int64_t next_ns_ = 0;
  std::int64_t watched_ns_ = 0;  // up to when the motors were not left alone
  bool may_push_ = false;
  bool was_lost_ = false;  // an exchange, since it was last looked at
  double last_exchange_s_ = 0.0;
  Vector<2> sent_{0.0};               // the torques that the motors have or are to get next
  std::optional<Vector<2>> start_{};  // of the handle when motors came on
  struct Place {
    double time_s = 0.0;
    Vector<2> place{0.0};
  };
  std::array<Place, 8> places_{};  // a ring, one a tick
  std::size_t place_count_ = 0;
};

}  // namespace ghostforce
