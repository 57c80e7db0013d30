// Which board, its zero pose, and which encoder is which and how it counts. Motors stay off.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "app/tools/doctor/haply_steps.h"

namespace ghostforce {
namespace {

constexpr double haply_ms = 1e-3;
constexpr double most_zero_pose_deg = 3.0;

std::string haply_pose_words(const HaplyRig& rig) {
  const HaplyVariant* const variant = find_haply_variant(rig.calibration().variant);
  return std::string((variant != nullptr ? *variant : usual_haply_variant()).zero_pose);
}

}  // namespace

std::vector<Finding> measure_haply_port(HaplyRig& rig) {
  constexpr std::size_t count = 1000;
  const HaplyReport& found = rig.found();
  Finding board{.state = Finding::State::measured, .title = "Port and board", .settles = {}};
  board.sentence = fmt::format(
      "{}: it speaks hAPI, and had {} for this program's address before. Which firmware it has, no board tells.",
      found.serial.text().empty() ? "A board without a serial number" : found.serial.text(),
      found.was_set_up ? "been set up" : "not been set up");
  rig.ask({}, "Leave the handle alone for two seconds. Enter: the exchanges are counted. The motors stay off.");
  rig.rest(0.1);
  std::vector<double> times;
  const double began_s = rig.now_s();
  while (times.size() < count) {
    rig.poll(false);
    times.push_back(rig.last_exchange_s());
  }
  const double rate = count / (rig.now_s() - began_s);
  std::ranges::sort(times);
  Finding exchanges{.state = Finding::as_assumed_if(rate >= HaplyReport::fast_enough_hz),
                    .title = "Exchanges a second",
                    .settles = "the round-trip time"};
  exchanges.sentence =
      fmt::format("{:.0f} a second at most; an answer takes {:.2f} ms (median), and {:.2f} ms at worst.", rate,
                  times[count / 2] / haply_ms, times.back() / haply_ms);
  exchanges.readings.push_back(fmt::format("{} exchanges, one right after the other", count));
  return {board, exchanges};
}

namespace {

// Where the arms are held now is the zero pose from here on. Returns by how much the board tells something else [degrees].
double confirm_haply_zero_pose(HaplyRig& rig, std::string_view words) {
  rig.read_still_at({.kind = HaplyAction::Kind::hold_zero_pose}, words);
  rig.set_up();
  const hapi::PerPort<double> told = rig.poll();
  double off = 0.0;
  for (const HaplyArm& arm : rig.calibration().arms) {
    off = std::max(off, std::abs(told[arm.encoder_port - 1U] - arm.offset_deg));
  }
  return off;
}

}  // namespace

std::vector<Finding> measure_haply_zero_pose(HaplyRig& rig) {
  Finding finding{.title = "Repeatability of the zero pose", .settles = "how well the zero pose repeats"};
  const std::string pose = haply_pose_words(rig);
  if (confirm_haply_zero_pose(rig, fmt::format("{} Hold them there. Enter: this is the zero pose.", pose)) >
      most_zero_pose_deg) {
    finding.sentence = "The board reports other angles than it was given. Check the encoders' plugs, and start again.";
    return {finding};
  }
  Vector<2> least(std::numeric_limits<double>::max());
  Vector<2> greatest(std::numeric_limits<double>::lowest());
  for (int i = 0; i < 3; ++i) {
    const hapi::PerPort<double> read = i == 0
                                           ? rig.poll()
                                           : rig.read_still_at({.kind = HaplyAction::Kind::hold_zero_pose},
                                                               "Let go and move the handle about. Then hold the "
                                                               "zero pose again, and keep still. Enter: it is read.");
    Vector<2> angles;
    for (std::size_t arm = 0; arm < 2; ++arm) {
      angles[static_cast<glm::length_t>(arm)] = read[rig.calibration().arms[arm].encoder_port - 1U];
    }
    least = glm::min(least, angles);
    greatest = glm::max(greatest, angles);
    finding.readings.push_back(fmt::format("zero pose {}: {:.2f}° and {:.2f}°", i + 1, angles.x, angles.y));
  }
  const Vector<2> spread = greatest - least;
  finding.state =
      std::max(spread.x, spread.y) <= most_zero_pose_deg ? Finding::State::measured : Finding::State::contradicts;
  finding.sentence = fmt::format("Three times it was within {:.2f}° (arm 1) and {:.2f}° (arm 2).", spread.x, spread.y);
  return {finding};
}

namespace {

std::string haply_arm_words(std::size_t arm, const HaplyEncoders& found, const HaplyCalibration& before) {
  const HaplyArm& known = found.calibration.arms[arm];
  std::string words = fmt::format("Arm {}: port {}, a right angle reads {:.1f}°", arm + 1, known.encoder_port,
                                  90.0 * std::abs(found.ratios[arm]));
  if (known.encoder_port != before.arms[arm].encoder_port) words += ", at the other port than was assumed";
  if (found.ratios[arm] < 0.0) words += ", counted the other way: its direction is changed";
  if (found.factors[arm] == 0.5) words += ", half of it: the counts per turn are halved";
  if (found.factors[arm] == 2.0) words += ", twice of it: the counts per turn are doubled";
  if (found.factors[arm] != 1.0) words += fmt::format(" ({:.0f} counts per turn)", known.counts_per_turn);
  if (known.offset_deg != before.arms[arm].offset_deg) {
    words += fmt::format("; the zero pose is at {:.1f}°, {:+.1f}° from what was assumed", known.offset_deg,
                         known.offset_deg - before.arms[arm].offset_deg);
  }
  return words + ".";
}

}  // namespace

std::vector<Finding> measure_haply_encoders(HaplyRig& rig) {
  Finding finding{.title = "Encoders: which, which way, how many counts", .settles = "counts per turn of this variant"};
  const HaplyCalibration before = rig.calibration();
  std::array<HaplyTurn, 2> turns;
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const std::string_view side = arm == 0 ? "right" : "left";
    HaplyAction action{.kind = HaplyAction::Kind::turn_arm, .arm = arm, .angle = 0.5 * std::numbers::pi};
    turns[arm].straight = rig.read_still_at(
        action,
        fmt::format("Arm {} is on your {} as you sit opposite the base. Turn its driven link, the one on the motor, "
                    "until it points straight at you, at a right angle to the base's edge; a set square helps. Keep "
                    "the other driven link halfway between that and outwards. Hold still. Enter: it is read.",
                    arm + 1, side));
    action.angle = arm == 0 ? std::numbers::pi : 0.0;
    turns[arm].outwards = rig.read_still_at(
        action, fmt::format("Turn the same link outwards by a right angle, until it lies along the base's edge and "
                            "points to your {}. Keep the other one where it is. Hold still. Enter: it is read.",
                            side));
    finding.readings.push_back(fmt::format("arm {}: port 1 from {:.2f}° to {:.2f}°, port 2 from {:.2f}° to {:.2f}°",
                                           arm + 1, turns[arm].straight[0], turns[arm].outwards[0],
                                           turns[arm].straight[1], turns[arm].outwards[1]));
  }
  const HaplyEncoders found = find_haply_encoders(turns, before);
  if (found.problem != HaplyWiringProblem::none) {
    finding.state =
        found.problem == HaplyWiringProblem::no_movement ? Finding::State::not_measured : Finding::State::contradicts;
    finding.sentence = words_of(found.problem);
    return {finding};
  }
  finding.state = Finding::as_assumed_if(found.calibration == before);
  finding.sentence = fmt::format("{} {} By eye, to about ± 4 %.", haply_arm_words(0, found, before),
                                 haply_arm_words(1, found, before));
  if (found.calibration == before) return {finding};
  rig.use(found.calibration);
  if (confirm_haply_zero_pose(rig, fmt::format("The encoders are different from what was assumed ({}), so the board is "
                                               "set up anew. {} Hold them there. Enter: this is the zero pose.",
                                               finding.sentence, haply_pose_words(rig))) > most_zero_pose_deg) {
    finding.state = Finding::State::contradicts;
    finding.sentence += " But the board, set up with that, reports other angles.";
  }
  return {finding};
}

}  // namespace ghostforce
