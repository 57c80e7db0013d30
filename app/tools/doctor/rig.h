// MeasuringRig: what every measurement of a Falcon needs: a person who is asked (Operator), a handle that is read when
// it is still, and motors that push only as long as a button of the grip is held down. UI thread; SI units, device
// frame.
//
// Motors: whatever asks for them, the force at the handle stays below `greatest_force` even with the strongest motors
// that were published, and grows by `steepest` at most. They are off at once when the button is let go of, when the
// handle goes faster than `fastest` or leaves the workspace, and when a reply is missing.
//
// Everything may throw Failure: interrupted; absent, failed, where the device has gone or does not answer; safety_stop;
// and Leave or Skip, where the person wants to. What moves motors throws MotorStop once they are off.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "app/tools/doctor/bench.h"
#include "app/tools/doctor/finding.h"
#include "app/tools/doctor/operator.h"
#include "device/falcon/calibration.h"
#include "device/virtual_falcon/measured_person.h"

namespace ghostforce {

using Operator = OperatorFor<OperatorAction>;

// Three numbers of counts, for a reading.
std::string counts_words(const Vector<3>& counts);

// For a finding's sentence: which of the published values, "angles" or the like, what was found may be.
std::string published_within(std::string_view what, std::span<const double> published, std::string_view unit,
                             double found, double uncertainty);

using Mean = MeanOf<3>;

// Why motors went off before their time.
enum class MotorStop : std::uint8_t { released, too_fast, left_workspace, no_reply };

// What is so at one tick, with motors on or off.
struct RigSample {
  double time_s = 0.0;  // since the drive began
  Vector<3> legs{0.0};  // where they stand [counts]
  Vector<3> position{0.0};
  Vector<3> velocity{0.0};
  Matrix<3> jacobian{1.0};
  Vector<3> counts{0.0};  // the motors', by leg, while this was so
};

class MeasuringRig {
 public:
  static constexpr double greatest_force = 1.8;  // [N]
  static constexpr double steepest = 8.0;        // [N/s]
  static constexpr double fastest = 0.3;         // [m/s]
  static constexpr int tries = 3;

  using Law = std::function<Vector<3>(const RigSample&)>;  // the motor counts to drive each leg with
  using Watch = std::function<void(const RigSample&)>;
  static Vector<3> no_counts(const RigSample& /*sample*/) noexcept { return Vector<3>(0.0); }

  MeasuringRig(Operator& person, FalconLink& link, const FalconCalibration& calibration);

  const FalconCalibration& calibration() const noexcept { return calibration_; }
  void use(const FalconCalibration& calibration);

  Operator& person() noexcept { return person_; }
  const FalconBench& bench() const noexcept { return bench_; }

  // The line that was typed, without spaces around it.
  std::string ask(const OperatorAction& action, const std::string& words);
  // Asks until the answer is a number from `least` to `greatest`.
  double ask_number(const OperatorAction& action, const std::string& words, double least, double greatest,
                    std::string_view unit);

  // Has it done, and returns the mean of the encoders, in a frame's order, once the handle is still.
  Vector<3> read_still_at(const OperatorAction& action, const std::string& words);

  // Motors off: one exchange, or so many seconds of them.
  ReplyFrame poll(std::uint8_t info = CommandFrame::green);
  void rest(double seconds);

  // Has the person hold a button near the action's place, does what is to be done, and turns the motors off. Whatever
  // stops it is told, and it is begun again, `tries` times in all. False: it never came to its end. Throws
  // Failure(safety_stop) where the handle was too fast or out of its workspace each time.
  bool with_button(const OperatorAction& action, const std::string& words, const std::function<void()>& what);

  // For what is called by with_button(). Goes on from whatever the motors do.
  void drive(double seconds, const Law& law, const Watch& watch = {});
  void let_go(double seconds);
  // Says nothing to the device, and then looks with a command of zeros: the reply tells where the handle was when that
  // came, and a button that was let go of meanwhile waits no longer.
  void be_silent(double seconds, const Watch& after);

  // The motor counts, by leg, with which the strongest published motors make this force; weaker ones make less.
  static Vector<3> counts_for(const Vector<3>& force, const Matrix<3>& jacobian) noexcept;

 private:
  ReplyFrame exchange(const CommandFrame& command);
  // Empty: nothing is against motors.
  std::optional<MotorStop> see(const ReplyFrame& reply, RigSample& sample);
  void turn_off();
  bool await_ready(const Vector<3>& place);

  Operator& person_;
  FalconBench bench_;
  FalconCalibration calibration_;
  FalconKinematics kinematics_;
  Vector<3> sent_{0.0};  // the motors' counts, by leg
  int unhomed_ = 0;
  bool was_lost_ = false;  // since it was last looked at
  RigSample last_;
  std::array<Vector<3>, 8> places_{};  // a ring, one a tick
  std::size_t place_count_ = 0;
};

}  // namespace ghostforce
