// Which motor drives which arm, and which way; what it is worth; friction, silence, and how hard a wall may be.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/tools/doctor/haply_steps.h"
#include "app/tools/doctor/motors.h"

namespace ghostforce {
namespace {

constexpr double newton_per_g = 9.80665e-3;

HaplyAction hold_in_the_middle(const HaplyRig& rig) {
  return {.kind = HaplyAction::Kind::hold, .place = rig.middle()};
}

// What the arms did while one of them got a torque.
HaplyPulse take_haply_pulse(HaplyRig& rig, std::size_t arm, double torque) {
  Vector<2> alone(0.0);
  alone[static_cast<glm::length_t>(arm)] = torque;
  MeanOf<2> before;
  MeanOf<2> during;
  rig.drive(0.2, HaplyRig::no_torques, [&](const HaplySample& sample) {
    if (sample.time_s > 0.1) before.add(sample.angles);
  });
  rig.drive(
      0.35, [&](const HaplySample&) { return alone; },
      [&](const HaplySample& sample) {
        if (sample.time_s > 0.25) during.add(sample.angles);
      });
  rig.let_go(0.1);
  return {.torque = torque, .moved_deg = (during.value() - before.value()) / radians_per_degree};
}

}  // namespace

std::vector<Finding> measure_haply_motor_signs(HaplyRig& rig) {
  Finding finding{.title = "Motors: which, and which way they push", .settles = "the sign of each motor"};
  std::array<HaplyPulse, 2> pulses;
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const std::string stopped = rig.with_motors(
        hold_in_the_middle(rig),
        fmt::format(
            "Motor {} of 2. Hold the handle loosely in the middle of its workspace. After Enter the motor pushes "
            "with about 0.2 N for a third of a second, and if nothing moves once more with 0.4 N.",
            arm + 1),
        [&] {
          for (const double torque : {0.015, 0.030}) {
            pulses[arm] = take_haply_pulse(rig, arm, torque);
            if (glm::length(pulses[arm].moved_deg) > 0.6) return;
          }
        });
    if (!stopped.empty()) {
      finding.sentence = stopped;
      return {finding};
    }
    finding.readings.push_back(fmt::format("{:.3f} N·m to arm {}: the arms turned by {:.2f}° and {:.2f}°",
                                           pulses[arm].torque, arm + 1, pulses[arm].moved_deg.x,
                                           pulses[arm].moved_deg.y));
  }
  const HaplyMotors found = find_haply_motors(pulses, rig.calibration());
  if (found.problem != HaplyWiringProblem::none) {
    if (found.problem != HaplyWiringProblem::no_movement) finding.state = Finding::State::contradicts;
    finding.sentence = words_of(found.problem);
    return {finding};
  }
  if (found.calibration == rig.calibration()) {
    finding.state = Finding::State::as_assumed;
    finding.sentence = "A positive torque increases the angle of its arm, for both.";
    return {finding};
  }
  std::string what;
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const HaplyArm& was = rig.calibration().arms[arm];
    const HaplyArm& is = found.calibration.arms[arm];
    if (is.motor_port != was.motor_port) what += fmt::format("Arm {}'s motor is at port {}. ", arm + 1, is.motor_port);
    if (is.is_motor_reversed != was.is_motor_reversed) {
      what += fmt::format("Arm {}'s motor pushes the other way than was assumed. ", arm + 1);
    }
  }
  if (!rig.person().says_yes(what + "Take that into the calibration? Without it motors cannot be measured. y or n.")) {
    finding.sentence = what + "It was not taken into the calibration.";
    return {finding};
  }
  rig.use(found.calibration);
  finding.state = Finding::State::differs;
  finding.sentence = what + "The calibration says so now.";
  return {finding};
}

namespace {

// Holds the handle at a place: a soft spring with damping, and what is needed to get there.
class HaplyHolder {
 public:
  Vector<2> torques(const HaplyRig& rig, const HaplySample& sample, const Vector<2>& place) {
    constexpr double stiffness = 150.0;  // [N/m]
    constexpr double damping = 3.0;      // [N·s/m]
    constexpr double gain = 300.0;       // [N/(m·s)]
    const Vector<2> off = place - sample.pose.handle;
    sum_ += gain * HaplyRig::period_s * off;
    if (const double size = glm::length(sum_); size > HaplyRig::greatest_force) {
      sum_ *= HaplyRig::greatest_force / size;
    }
    return rig.torques_of(stiffness * off - damping * sample.velocity + sum_, sample.pose);
  }

 private:
  Vector<2> sum_{0.0};
};

// Empty: they could not carry the handle.
std::optional<HaplyHold> take_haply_hold(HaplyRig& rig) {
  constexpr double grip_s = 2.0;    // until the person lets go
  constexpr double settle_s = 3.0;  // and until the motors carry all
  constexpr double carried = 0.004;
  constexpr double sweep_reach = 0.006;
  constexpr double counted_reach = 0.003;
  constexpr double sweep_period_s = 2.4;  // to and fro
  constexpr int sweeps = 2;
  const Vector<2> place = rig.middle();
  HaplyHolder holder;
  std::optional<Vector<2>> begin;
  rig.drive(grip_s, [&](const HaplySample& sample) {
    if (!begin) begin = sample.pose.handle;
    return holder.torques(rig, sample, glm::mix(*begin, place, std::min(1.0, sample.time_s / grip_s)));
  });
  rig.person().cue({.kind = HaplyAction::Kind::let_go, .place = place});
  HaplyHold hold;
  rig.drive(settle_s, [&](const HaplySample& sample) {
    hold.pose = sample.pose;
    return holder.torques(rig, sample, place);
  });
  bool is_carried = glm::distance(hold.pose.handle, place) <= carried;
  if (is_carried) {
    MeanOf<2> in;
    MeanOf<2> out;
    // Out, in, out again: where, and whether on the way out.
    const auto phase = [](double time_s) { return std::fmod(time_s / sweep_period_s, 1.0); };
    const auto at = [](double turn) {
      return sweep_reach * (turn < 0.25 ? 4.0 * turn : turn < 0.75 ? 2.0 - 4.0 * turn : 4.0 * turn - 4.0);
    };
    rig.drive(
        sweeps * sweep_period_s,
        [&](const HaplySample& sample) {
          return holder.torques(rig, sample, place + Vector<2>{0.0, at(phase(sample.time_s))});
        },
        [&](const HaplySample& sample) {
          const double turn = phase(sample.time_s);
          // The first quarter begins at rest.
          if (sample.time_s < 0.25 * sweep_period_s || std::abs(at(turn)) > counted_reach) return;
          const auto force = force_of(sample.pose, {sample.torques.x, sample.torques.y});
          if (!force || glm::length(*force) > 0.98 * HaplyRig::greatest_force) is_carried = false;
          (turn < 0.25 || turn >= 0.75 ? out : in).add(sample.torques);
        });
    hold.inwards = in.value();
    hold.outwards = out.value();
    if (const auto angles = angles_at(rig.calibration().geometry, place)) {
      hold.pose = pose_at(rig.calibration().geometry, *angles).value_or(hold.pose);
    }
  }
  rig.person().cue(hold_in_the_middle(rig));
  rig.let_go(1.0);
  return is_carried ? std::optional(hold) : std::nullopt;
}

constexpr std::string_view haply_hold_words =
    "After Enter the motors hold it with less than 1 N. Count to two, then let go and keep your hand near. For eight "
    "seconds they carry it slowly to and fro. Then take it in your hand again.";

std::string haply_hold_reading(std::string_view load, const HaplyHold& hold) {
  return fmt::format("{}: sent {:.4f} and {:.4f} N·m going inwards, {:.4f} and {:.4f} N·m outwards", load,
                     hold.inwards.x, hold.inwards.y, hold.outwards.x, hold.outwards.y);
}

}  // namespace

std::vector<Finding> measure_haply_friction(HaplyRig& rig) {
  Finding finding{.title = "Friction of the arms", .settles = "friction and drag of the arm without power"};
  std::optional<HaplyHold> hold;
  finding.sentence = rig.with_motors(
      hold_in_the_middle(rig),
      fmt::format("Hold the handle in the middle of its workspace, with nothing hanging on it. {}", haply_hold_words),
      [&] { hold = take_haply_hold(rig); });
  if (!finding.sentence.empty()) return {finding};
  if (!hold) {
    finding.sentence =
        "The motors did not carry the handle: let go of it entirely, and put the device on a level table.";
    return {finding};
  }
  rig.free_hold = hold;
  finding.readings.push_back(haply_hold_reading("without a weight", *hold));
  // Half the width of the hysteresis.
  const Vector<2> half = 0.5 * glm::abs(hold->inwards - hold->outwards);
  const auto felt = [&](const Vector<2>& torques) {
    return glm::length(force_of(hold->pose, {torques.x, torques.y}).value_or(Vector<2>(0.0)));
  };
  finding.state = Finding::State::measured;
  finding.sentence = fmt::format(
      "Arm 1 {:.4f} N·m, arm 2 {:.4f} N·m, as the firmware counts them: pushed by the other motor alone, a dead arm 2 "
      "is "
      "felt as {:.2f} N, a dead arm 1 as {:.2f} N.",
      half.x, half.y, felt({0.0, half.y}), felt({half.x, 0.0}));
  return {finding};
}

std::vector<Finding> measure_haply_strength(HaplyRig& rig) {
  Finding finding{.title = "Torque of the motors", .settles = "newtons per unit of torque"};
  std::optional<HaplyHold> hold;
  double weight = 0.0;
  for (int i = 0; i < HaplyRig::tries && !hold; ++i) {
    const double grams = rig.ask_number(
        {.kind = HaplyAction::Kind::say_weight},
        "How heavy is the weight with its thread, in g? 30 to 60 g is best; or what a spring balance will show.", 5.0,
        150.0, "g");
    finding.readings.push_back(fmt::format("the weight is {:g} g", grams));
    weight = grams * newton_per_g;
    rig.ask({.kind = HaplyAction::Kind::hang_weight, .place = rig.middle(), .weight = weight},
            "Tie the thread to the handle and lead it straight away from the base, level, over a smooth round edge of "
            "the table (a pencil), so that the weight hangs freely. Hold the handle in the middle. Enter: continue.");
    const std::string stopped = rig.with_motors(
        hold_in_the_middle(rig),
        fmt::format("Hold the handle in the middle of its workspace, with the weight pulling. {}", haply_hold_words),
        [&] { hold = take_haply_hold(rig); });
    if (!hold)
      finding.sentence = stopped.empty() ? "The motors did not carry the weight. Take a lighter one." : stopped;
    if (!hold) rig.person().tell(finding.sentence);
    if (!stopped.empty()) break;
  }
  rig.ask({.kind = HaplyAction::Kind::hang_weight, .place = rig.middle()}, "Take off the weight. Enter: continue.");
  if (!hold) return {finding};
  finding.readings.push_back(haply_hold_reading("with the weight", *hold));
  const auto scales = find_torque_scales(*rig.free_hold, *hold, weight);
  if (!scales) {
    finding.state = Finding::State::contradicts;
    finding.sentence = "At least one motor gave nothing against the weight, or far too much. Let it hang freely.";
    return {finding};
  }
  HaplyCalibration calibration = rig.calibration();
  bool is_as_assumed = true;
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const double scale = (*scales)[static_cast<glm::length_t>(arm)];
    is_as_assumed = is_as_assumed && std::abs(scale / calibration.arms[arm].torque_scale - 1.0) <= 0.05;
    calibration.arms[arm].torque_scale = scale;
  }
  rig.use(calibration);
  finding.state = Finding::as_assumed_if(is_as_assumed);
  finding.sentence = fmt::format("For each N·m that is sent: {:.2f} N·m at arm 1, {:.2f} N·m at arm 2; about ± 5 %.",
                                 scales->x, scales->y);
  return {finding};
}

std::vector<Finding> measure_haply_silence(HaplyRig& rig) {
  Finding finding{.title = "Does the board drop a force by itself", .settles = "whether this firmware has a watchdog"};
  std::vector<SilenceReading> readings;
  const auto push = [&](const HaplySample& sample) { return rig.torques_of({0.0, 0.5}, sample.pose); };
  finding.sentence = rig.with_motors(
      hold_in_the_middle(rig),
      "Hold the handle loosely in the middle of its workspace. After Enter you feel up to four pushes towards you, "
      "each "
      "of 0.5 N. During each the program sends nothing for 0.1 or 0.2 s. Let yourself be pushed; keep your grip as it "
      "is.",
      [&] {
        readings.clear();
        for (const double silence_s : {0.1, 0.1, 0.2, 0.2}) {
          MeanOf<2> rest;
          MeanOf<2> held;
          double least = 1.0;
          double greatest = -1.0;
          rig.drive(0.3, HaplyRig::no_torques, [&](const HaplySample& sample) { rest.add(sample.pose.handle); });
          rig.drive(0.7, push, [&](const HaplySample& sample) {
            if (sample.time_s < 0.5) return;
            held.add(sample.pose.handle);
            least = std::min(least, sample.pose.handle.y);
            greatest = std::max(greatest, sample.pose.handle.y);
          });
          const double resting = rest.value().y;
          SilenceReading reading{.silence_s = silence_s, .held = held.value().y - resting, .tremor = greatest - least};
          rig.be_silent(silence_s, [&](const HaplySample& sample) { reading.after = sample.pose.handle.y - resting; });
          readings.push_back(reading);
          rig.drive(0.4, HaplyRig::no_torques);
        }
      });
  for (const SilenceReading& reading : readings) {
    finding.readings.push_back(fmt::format("silent for {:.0f} ms: pushed {:.2f} mm before, {:.2f} mm after",
                                           reading.silence_s * 1e3, 1e3 * reading.held, 1e3 * reading.after));
  }
  if (!finding.sentence.empty()) return {finding};
  const SilenceVerdict verdict = judge_silences(readings);
  if (verdict.outcome == SilenceOutcome::undecidable) {
    finding.sentence = "The hand moved too much on top of the push, so nothing can be concluded.";
    return {finding};
  }
  finding.state = Finding::State::measured;
  finding.sentence =
      verdict.outcome == SilenceOutcome::drops
          ? fmt::format(
                "Yes: it was gone after {:.0f} ms without a command. If the program or its computer fails, so "
                "does the force.",
                verdict.gone_s * 1e3)
          : "No: it was still there after 200 ms. If the program is killed, the computer freezes or the USB cable is "
            "pulled out, the last force stands until the power supply is unplugged: keep its plug within reach.";
  return {finding};
}

namespace {

struct HaplySwings {};  // it does: motors go off at once

}  // namespace

std::vector<Finding> measure_haply_stiffness(HaplyRig& rig) {
  constexpr double first = 50.0;  // [N/m]
  constexpr double step = 50.0;
  constexpr double last = 800.0;
  constexpr double press_s = 1.0;
  constexpr double level_s = 0.6;
  constexpr double steep = 8.0;  // a wall that is softened is none [N·m/s]
  Finding finding{.title = "Highest stable k_r", .settles = "the highest stable k_r"};
  double stiffness = 0.0;
  bool swings = false;
  int touching = 0;
  int ticks = 0;
  finding.sentence = rig.with_motors(
      hold_in_the_middle(rig),
      "Hold the handle lightly, with two fingers, in the middle of its workspace. After Enter there is a wall right "
      "behind it, towards the base: press gently against it, all the time. It becomes harder for ten seconds. If it "
      "begins to hum, the motors go off by themselves.",
      [&] {
        SwingCounter swing;
        std::optional<double> wall;
        stiffness = first;
        swings = false;
        touching = ticks = 0;
        rig.person().cue({.kind = HaplyAction::Kind::press, .place = rig.middle()});
        try {
          rig.drive(
              press_s + level_s * (1.0 + (last - first) / step),
              [&](const HaplySample& sample) {
                if (!wall) wall = sample.pose.handle.y;
                const double depth = *wall - sample.pose.handle.y;
                if (sample.time_s > press_s) {
                  ++ticks;
                  touching += depth > 0.0 ? 1 : 0;
                  stiffness = std::min(last, first + step * std::floor((sample.time_s - press_s) / level_s));
                }
                return rig.torques_of({0.0, stiffness * std::max(0.0, depth)}, sample.pose);
              },
              [&](const HaplySample& sample) {
                if (sample.time_s > press_s && swing.add(sample.time_s, sample.velocity.y)) throw HaplySwings{};
              },
              steep);
        } catch (const HaplySwings&) {
          rig.turn_off();
          swings = true;
        }
      });
  if (!finding.sentence.empty()) return {finding};
  finding.readings.push_back(fmt::format("pressed against the wall in {:.0f} % of the time; {} at {:.0f} N/m",
                                         100.0 * touching / std::max(ticks, 1), swings ? "oscillated" : "steady",
                                         stiffness));
  if (!swings && touching < 0.6 * ticks) {
    finding.sentence = "The handle was not pressed against the wall. Press gently, all the time.";
    return {finding};
  }
  const double stable = swings ? stiffness - step : last;
  finding.state = Finding::State::measured;
  if (stable <= 0.0) {
    finding.sentence = "It oscillated with the softest wall, 50 N/m. Check the exchanges, and the motors' signs.";
    return {finding};
  }
  finding.sentence =
      swings ? fmt::format("{:.0f} N/m; at {:.0f} N/m the handle oscillated, held lightly. ", stable, stiffness)
             : fmt::format("{:.0f} N/m or more: no oscillation up to there. ", last);
  finding.sentence += fmt::format("Half of it, {:.0f} N/m, is recommended.", 0.5 * stable);
  return {finding};
}

}  // namespace ghostforce
