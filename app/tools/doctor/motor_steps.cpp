// Which motor drives which leg, and which way; and with a weight, what a motor count is worth.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/geometric.hpp>

#include "app/tools/doctor/motors.h"
#include "app/tools/doctor/steps.h"

namespace ghostforce {
namespace {

constexpr double standard_gravity = 9.80665;  // [m/s²]
constexpr double kg_per_g = 1e-3;

// --- Directions ---

// A pulse of one motor: what the legs did. The force is that of the strongest published motors.
MotorPulse take_pulse(MeasuringRig& rig, std::size_t number, double force) {
  Mean before;
  Mean during;
  double counts = 0.0;
  rig.drive(0.3, MeasuringRig::no_counts, [&](const RigSample& sample) { before.add(sample.legs); });
  rig.drive(
      0.7,
      [&](const RigSample& sample) {
        Vector<3> alone(0.0);
        alone[static_cast<glm::length_t>(number)] = 1.0;
        const Vector<3> of_one =
            force_of_motor_counts(alone, sample.jacobian, Vector<3>(smallest_published_motor_constant));
        counts = force / glm::length(of_one);
        return counts * alone;
      },
      [&](const RigSample& sample) {
        if (sample.time_s > 0.5) during.add(sample.legs);
      });
  rig.let_go(0.2);
  return {.counts = counts, .moved = during.value() - before.value()};
}

}  // namespace

std::vector<Finding> measure_motor_signs(MeasuringRig& rig) {
  Finding finding{.title = "Which motor is which, and which way it pushes", .settles = "the motors' order and signs"};
  FalconCalibration calibration = rig.calibration();
  calibration.motor_of_leg = legs_in_order;
  rig.use(calibration);
  std::array<MotorPulse, 3> pulses;
  for (std::size_t number = 0; number < pulses.size(); ++number) {
    const bool is_done = rig.with_button(
        {.kind = OperatorAction::Kind::hold_button},
        fmt::format(
            "Motor {} of 3. Hold the handle loosely in the middle of its workspace and hold down a button of the grip. "
            "After Enter the motor pushes with less than 2 N for a second. Releasing the button turns it off.",
            number + 1),
        [&] {
          for (const double force : {0.9, MeasuringRig::greatest_force}) {
            pulses[number] = take_pulse(rig, number, force);
            if (pulses[number].has_moved()) return;
          }
        });
    if (!is_done) {
      finding.sentence = fmt::format("Motor {} was interrupted each time.", number + 1);
      return {finding};
    }
    finding.readings.push_back(fmt::format("number {} at {:.0f} counts: the legs moved by {} counts", number + 1,
                                           pulses[number].counts, counts_words(pulses[number].moved)));
  }
  const MotorWiring wiring = find_motor_wiring(pulses);
  if (wiring.problem == MotorProblem::no_movement) {
    finding.sentence =
        "At least one motor did not move anything. Check that the device's power supply is plugged in, hold the handle "
        "more loosely, and measure again.";
    return {finding};
  }
  if (wiring.problem == MotorProblem::same_leg_twice) {
    finding.state = Finding::State::contradicts;
    finding.sentence =
        "Two motors moved the same leg most. Hold the handle more loosely, keep it still, and measure again.";
    return {finding};
  }
  calibration.motor_of_leg = wiring.motor_of_leg;
  rig.use(calibration);
  finding.state = Finding::as_assumed_if(wiring.motor_of_leg == legs_in_order);
  finding.sentence =
      fmt::format("The motors of legs 1, 2, 3 are the numbers {} of a command (a minus sign: it pushes the other way).",
                  fmt::join(wiring.motor_of_leg, ", "));
  return {finding};
}

// --- Strength ---

namespace {

// Where the motors carry the handle. At the second the motor of leg 2, which has little to carry in the middle, has
// more.
constexpr std::array places{workspace_center, Vector<3>{-0.03, -0.025, 0.138}};

// Slowly up and down through the place: friction is then the same both ways, and of opposite sign.
constexpr double sweep_reach = 0.006;   // [m]
constexpr double sweep_period_s = 2.4;  // up and down
constexpr int sweeps = 2;
constexpr double counted_reach = 0.003;  // [m]

constexpr double grip_s = 2.0;     // until the person loosens the grip
constexpr double settle_s = 3.0;   // and until the motors carry all
constexpr double carried = 0.004;  // the handle is then as near as this [m]

// Holds the handle at a place: a soft spring with damping, and what is needed to get there.
class Holder {
 public:
  Vector<3> counts(const RigSample& sample, const Vector<3>& place) {
    constexpr double stiffness = 150.0;  // [N/m]
    constexpr double damping = 3.0;      // [N·s/m]
    constexpr double gain = 300.0;       // [N/(m·s)]
    const Vector<3> off = place - sample.position;
    sum_ += gain * FalconBench::period_s * off;
    // What has piled up is never more than may be pushed with.
    const double most = MeasuringRig::greatest_force;
    if (const double length = glm::length(sum_); length > most) sum_ *= most / length;
    return MeasuringRig::counts_for(stiffness * off - damping * sample.velocity + sum_, sample.jacobian);
  }

 private:
  Vector<3> sum_{0.0};
};

struct HoldTaken {
  HoldReading hold;
  Matrix<3> jacobian{1.0};
  bool is_carried = false;
};

HoldTaken take_hold(MeasuringRig& rig, const Vector<3>& place) {
  HoldTaken taken;
  Holder holder;
  std::optional<Vector<3>> begin;
  const auto towards_place = [&](const RigSample& sample) {
    if (!begin) begin = sample.position;
    return holder.counts(sample, glm::mix(*begin, place, std::min(1.0, sample.time_s / grip_s)));
  };
  rig.drive(grip_s, towards_place);
  rig.person().cue({.kind = OperatorAction::Kind::loosen});
  Vector<3> position{0.0};
  rig.drive(settle_s, [&](const RigSample& sample) {
    position = sample.position;
    return holder.counts(sample, place);
  });
  taken.is_carried = glm::distance(position, place) <= carried;
  if (taken.is_carried) {
    Mean up;
    Mean down;
    // From the middle up, down, up again: how high, and whether it is on its way up.
    const auto sweep_at = [](double time_s) {
      const double turn = std::fmod(time_s / sweep_period_s, 1.0);
      return std::pair(turn < 0.25   ? 4.0 * turn
                       : turn < 0.75 ? 2.0 - 4.0 * turn
                                     : 4.0 * turn - 4.0,
                       turn < 0.25 || turn >= 0.75);
    };
    rig.drive(
        sweeps * sweep_period_s,
        [&](const RigSample& sample) {
          return holder.counts(sample, place + Vector<3>(0.0, sweep_reach * sweep_at(sample.time_s).first, 0.0));
        },
        [&](const RigSample& sample) {
          const auto [height, goes_up] = sweep_at(sample.time_s);
          // The first quarter begins at rest.
          if (sample.time_s < 0.25 * sweep_period_s || std::abs(sweep_reach * height) > counted_reach) return;
          const Vector<3> strongest(smallest_published_motor_constant);
          const double force = glm::length(force_of_motor_counts(sample.counts, sample.jacobian, strongest));
          if (force > 0.98 * MeasuringRig::greatest_force) taken.is_carried = false;  // they might need more
          (goes_up ? up : down).add(sample.counts);
        });
    taken.hold = {.up = up.value(), .down = down.value()};
    if (const auto jacobian = FalconKinematics(rig.calibration().geometry).jacobian(place)) taken.jacobian = *jacobian;
  }
  rig.person().cue({.kind = OperatorAction::Kind::hold_button, .place = place});
  rig.let_go(1.0);
  return taken;
}

// Empty: the motors could not carry it, or it was interrupted each time.
std::optional<HoldTaken> hold_at(MeasuringRig& rig, const Vector<3>& place, std::string_view load_words) {
  HoldTaken taken;
  const std::string words = fmt::format(
      "Hold the handle {}{} and hold down a button of the grip. After Enter the motors hold it with less than 2 N. "
      "Count to two, then let go of the handle except for one fingertip that holds the button down. Let the motors "
      "carry the handle for eight seconds; they move it slowly up and down. Then take it in your hand again.",
      place == workspace_center ? "in the middle of its workspace"
                                : "3 cm to the left of the middle, 3 cm lower and 1 cm further out",
      load_words);
  const bool is_done = rig.with_button({.kind = OperatorAction::Kind::hold_button, .place = place}, words,
                                       [&] { taken = take_hold(rig, place); });
  if (!is_done || !taken.is_carried) return std::nullopt;
  return taken;
}

std::string hold_words(std::string_view place, std::string_view load, const HoldReading& hold) {
  return fmt::format("{}, {}: motors {} counts going up, {} going down", place, load, counts_words(hold.up),
                     counts_words(hold.down));
}

constexpr std::array published_constants{3530.0, 6600.0, 10000.0};  // [counts per N·m]

using WeightReadings = std::array<WeightReading, places.size()>;

// Empty: the motors could not carry the handle, which has been told.
std::optional<WeightReadings> take_weights(MeasuringRig& rig, double grams, std::vector<std::string>& words) {
  const double weight = grams * kg_per_g * standard_gravity;
  WeightReadings readings;
  for (const bool has_weight : {false, true}) {
    rig.ask({.kind = OperatorAction::Kind::hang_weight, .weight = has_weight ? weight : 0.0},
            has_weight ? "Hang the weight on the grip by its thread, so that it hangs freely, and hold the handle. "
                         "Enter: continue. The motors are still off."
                       : "Do not hang the weight on the grip yet. If a rubber band supports the handle, leave it on "
                         "until the end of this step. Enter: continue. The motors are still off.");
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto taken = hold_at(rig, places[i], has_weight ? ", with the weight hanging," : "");
      if (!taken) {
        rig.person().tell(has_weight
                              ? "The motors did not carry the handle with this weight. Take a lighter one, or hang "
                                "the handle higher on its rubber band."
                              : "The motors did not carry the handle alone. Hang it from above on a long, soft "
                                "rubber band that supports most of it, or loosen your grip more.");
        return std::nullopt;
      }
      readings[i].weight = weight;
      readings[i].jacobian = taken->jacobian;
      (has_weight ? readings[i].with_weight : readings[i].without) = taken->hold;
      words.push_back(hold_words(i == 0 ? "in the middle" : "left and low",
                                 has_weight ? fmt::format("{:g} g", grams) : "nothing", taken->hold));
    }
  }
  rig.ask({.kind = OperatorAction::Kind::hang_weight, .weight = 0.0},
          "Take off the weight, and the rubber band if there is one. Enter: continue. The motors are off.");
  return readings;
}

}  // namespace

std::vector<Finding> measure_motor_constant(MeasuringRig& rig) {
  Finding constant{.title = "Counts per N·m of the motors",
                   .settles = "what a motor count is worth (3530, 6600 or 10000)"};
  Finding alike{.title = "Whether the motors are alike", .settles = "differences between the motors"};
  Finding friction{.title = "Friction and weight of the handle",
                   .settles = "the handle's weight (0.09 kg was published)"};
  std::optional<WeightReadings> taken;
  for (int i = 0; i < MeasuringRig::tries && !taken; ++i) {
    const double grams = rig.ask_number(
        {.kind = OperatorAction::Kind::say_weight},
        "How heavy is the weight with its thread, in g? 20 to 50 g is best. The motors push with less than 2 N here "
        "and also carry the handle. If the handle is heavy, hang it from above on a long, soft rubber band.",
        5.0, 300.0, "g");
    constant.readings.push_back(fmt::format("the weight is {:g} g", grams));
    taken = take_weights(rig, grams, constant.readings);
  }
  if (!taken) {
    constant.sentence = "The motors did not carry the handle with the force that is allowed here.";
    alike.sentence = friction.sentence = "The motors' strength was not measured.";
    return {constant, alike, friction};
  }
  const WeightReadings& readings = *taken;
  const MotorConstants found = find_motor_constants(readings);
  if (!found.is_found) {
    constant.state = Finding::State::contradicts;
    constant.sentence = fmt::format(
        "The forces with and without the weight do not agree: they are {:.2f} N off on average. Let the weight hang "
        "still, and do not support anything with your finger.",
        found.misfit);
    alike.sentence = friction.sentence = "The readings of the weight contradict each other.";
    return {constant, alike, friction};
  }
  FalconCalibration calibration = rig.calibration();
  const bool is_as_assumed = std::abs(found.counts_per_newton_metre - measured_motor_constant) <= found.uncertainty;
  if (!is_as_assumed || !found.are_alike) {
    calibration.counts_per_newton_metre = std::clamp(found.counts_per_newton_metre, 1000.0, 100000.0);
  }
  calibration.motor_strengths = glm::clamp(found.strengths, 0.2, 2.0);
  rig.use(calibration);
  constant.state = Finding::as_assumed_if(is_as_assumed);
  constant.sentence = fmt::format(
      "{:.0f} ± {:.0f} counts per N·m{}; {}.", found.counts_per_newton_metre, found.uncertainty,
      found.are_alike ? "" : " for the strongest motor",
      published_within("numbers", published_constants, "", found.counts_per_newton_metre, found.uncertainty));
  alike.state = Finding::as_assumed_if(found.are_alike);
  const Vector<3>& off = found.strength_uncertainties;
  alike.sentence =
      found.are_alike
          ? fmt::format("The motors of legs 1, 2, 3 are alike within {:.0f}, {:.0f}, {:.0f} %.", 100.0 * off.x,
                        100.0 * off.y, 100.0 * off.z)
          : fmt::format(
                "Legs 1, 2, 3 relative to the strongest motor: {:.2f} ± {:.2f}, {:.2f} ± {:.2f}, {:.2f} ± {:.2f}.",
                found.strengths.x, off.x, found.strengths.y, off.y, found.strengths.z, off.z);
  friction.state = Finding::State::measured;
  friction.sentence = fmt::format(
      "Friction: {:.2f} N at 1 cm/s, felt at the handle. Weight of the handle, less what the finger supported: {:.2f} "
      "N.",
      found.friction, found.handle_weight);
  return {constant, alike, friction};
}

}  // namespace ghostforce
