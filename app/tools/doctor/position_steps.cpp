// Which encoder belongs to which leg and which way it counts; and with a ruler, the angle at count zero and the gear.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/common.hpp>

#include "app/base/quoted.h"
#include "app/tools/doctor/encoder_wiring.h"
#include "app/tools/doctor/ruler.h"
#include "app/tools/doctor/steps.h"
#include "core/conventions.h"

namespace ghostforce {
namespace {

constexpr double mm = 1e-3;

OperatorAction go_to(const Vector<3>& place) {
  return {.kind = OperatorAction::Kind::go_to, .place = place};
}

// --- Encoders ---

struct Direction {
  Vector<3> direction;
  std::string_view words;
  std::string_view short_words;
};

constexpr std::array directions{
    Direction{{0.0, 0.0, 1.0}, "Pull it about 3 cm straight towards you", "towards you"},
    Direction{{1.0, 0.0, 0.0}, "Move it about 3 cm to the right", "to the right"},
    Direction{{0.0, 1.0, 0.0}, "Lift it about 3 cm straight up", "up"},
};

EncoderWiring take_wiring(MeasuringRig& rig, std::vector<std::string>& readings) {
  std::array<HandMove, directions.size()> moves;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const Direction& direction = directions[i];
    moves[i].direction = direction.direction;
    moves[i].from = rig.read_still_at(
        go_to(workspace_center),
        "Bring the handle to the middle of its workspace and hold it still. Enter: the encoders are read.");
    moves[i].to =
        rig.read_still_at(go_to(workspace_center + 0.03 * direction.direction),
                          fmt::format("{} and hold it still there. Enter: they are read again.", direction.words));
    readings.push_back(fmt::format("3 cm {}: encoders from {} to {} counts", direction.short_words,
                                   counts_words(moves[i].from), counts_words(moves[i].to)));
  }
  return find_encoder_wiring(moves, rig.calibration().geometry);
}

}  // namespace

std::vector<Finding> measure_encoders(MeasuringRig& rig) {
  Finding finding{.title = "Which encoder is which, and which way it counts",
                  .settles = "the encoders' order and signs"};
  EncoderWiring wiring;
  std::optional<LegNumbers> odd;  // what was found once and was not expected: motors will be driven by it
  for (int i = 0; i < MeasuringRig::tries && !wiring.is_certain(); ++i) {
    if (i > 0) {
      rig.person().tell(odd ? "Other devices are not wired like this. Do it once more, to be sure."
                        : wiring.has_moved
                            ? "These three movements do not agree. Do it once more, along straight lines."
                            : "The encoders hardly changed in one of the movements. Do it once more, 3 cm each.");
    }
    wiring = take_wiring(rig, finding.readings);
    if (!wiring.is_certain() || wiring.encoder_of_leg == legs_in_order || wiring.encoder_of_leg == odd) continue;
    odd = wiring.encoder_of_leg;
    wiring.runner_up = wiring.agreement;
  }
  if (!wiring.has_moved) {
    finding.sentence = "The encoders did not change with the handle. Home the device and start again.";
    return {finding};
  }
  if (!wiring.is_certain()) {
    finding.state = Finding::State::contradicts;
    finding.sentence = fmt::format(
        "No order and signs of the encoders fit all three movements: the best has a cosine of {:.2f}, the next {:.2f}.",
        wiring.agreement, wiring.runner_up);
    return {finding};
  }
  FalconCalibration calibration = rig.calibration();
  calibration.encoder_of_leg = wiring.encoder_of_leg;
  finding.state = Finding::as_assumed_if(wiring.encoder_of_leg == legs_in_order);
  finding.sentence = fmt::format(
      "The encoders of legs 1, 2, 3 are the numbers {} of a reply (a minus sign: it counts the other way); cosine "
      "{:.3f}, the next best order {:.3f}.",
      fmt::join(wiring.encoder_of_leg, ", "), wiring.agreement, wiring.runner_up);

  Finding stop{.title = "Where the encoders stand at the stop", .settles = "the encoders' offsets"};
  const Vector<3> at_stop = rig.read_still_at({.kind = OperatorAction::Kind::push_in},
                                              "Push the handle straight in until it stops, and hold it there. "
                                              "Enter: the encoders are read.");
  stop.readings.push_back(fmt::format("pushed in to the stop: encoders {} counts", counts_words(at_stop)));
  calibration.encoder_offset = offsets_at_stop(at_stop, wiring.encoder_of_leg);
  rig.use(calibration);
  const Vector<3> legs = leg_counts(glm::round(at_stop), calibration);
  const double spread = std::max({legs.x, legs.y, legs.z}) - std::min({legs.x, legs.y, legs.z});
  const bool is_reversed = std::ranges::any_of(wiring.encoder_of_leg, [](int number) { return number < 0; });
  if (spread > crooked_counts) {
    stop.state = Finding::State::contradicts;
    stop.sentence = fmt::format(
        "At the stop, the three arms differ by {:.0f} counts, but they should be equal: the handle was not pushed in "
        "straight, or an arm was homed in the wrong place. Home the device and measure again.",
        spread);
  } else if (is_reversed) {
    stop.state = Finding::State::differs;
    stop.sentence = fmt::format("Offsets {} ± {:.0f} counts, for the encoders that count the other way.",
                                fmt::join(calibration.encoder_offset, ", "), crooked_counts);
  } else {
    stop.state = Finding::State::as_assumed;
    stop.sentence = fmt::format("At the stop, the three arms are equal to within {:.0f} counts: no offsets.", spread);
  }
  return {finding, stop};
}

// --- Lengths ---

namespace {

struct RulerMove {
  Vector<3> from;
  Vector<3> to;
  std::string_view begin;
  std::string_view move;
};

// Near and far tell the angle apart from the gear: the one changes with depth what the other changes everywhere.
constexpr std::array ruler_moves{
    RulerMove{{-0.03, 0.0, 0.125},
              {0.03, 0.0, 0.125},
              "Lay the ruler flat in front of the device, from left to right. Hold the handle 3 cm left of the middle, "
              "halfway out.",
              "Move it about 6 cm to the right, along the ruler."},
    RulerMove{{-0.03, 0.0, 0.092},
              {0.03, 0.0, 0.092},
              "Now pushed in: hold the handle 3 cm left of the middle, 2 cm before its inner stop.",
              "Move it about 6 cm to the right, along the ruler."},
    RulerMove{{-0.03, 0.0, 0.153},
              {0.03, 0.0, 0.153},
              "Now pulled out: hold the handle 3 cm left of the middle, 2 cm before its outer stop.",
              "Move it about 6 cm to the right, along the ruler."},
    RulerMove{{0.0, -0.03, 0.125},
              {0.0, 0.03, 0.125},
              "Stand the ruler upright. Hold the handle 3 cm below the middle, halfway out.",
              "Lift it about 6 cm straight up, along the ruler."},
    RulerMove{{0.0, 0.0, 0.095},
              {0.0, 0.0, 0.155},
              "Point the ruler from the device towards you. Hold the handle in the middle, 2 cm before its inner stop.",
              "Pull it about 6 cm straight out, along the ruler."},
};

constexpr std::array published_angles{35.0, 40.0, 50.0};  // at count zero [°]

constexpr double degrees(double radians) {
  return radians / radians_per_degree;
}

std::string fit_words(const RulerFit& fit) {
  if (!fit.is_found) return fmt::format("{}: nothing fits", fit.preset->name);
  return fmt::format("{}: {:.1f} ± {:.1f}° at count zero, gear {:.3f} ± {:.3f}, {:.2f} mm off the ruler on average",
                     fit.preset->name, degrees(fit.angle_at_zero_count), degrees(fit.angle_uncertainty), fit.gear_ratio,
                     fit.gear_uncertainty, fit.misfit / mm);
}

}  // namespace

std::vector<Finding> measure_lengths(MeasuringRig& rig) {
  Finding angle{.title = "Angle of the arms at count zero", .settles = "the angle at count zero (35°, 40° or 50°)"};
  Finding gear{.title = "Gear ratio", .settles = "the gear ratio (7.62 or 7.72)"};
  Finding lengths{.title = "Lengths of the legs", .settles = "which set of lengths is more accurate"};
  std::vector<RulerReading> readings;
  for (const RulerMove& move : ruler_moves) {
    RulerReading reading;
    const FalconCalibration& calibration = rig.calibration();
    reading.from = leg_counts(
        rig.read_still_at(go_to(move.from),
                          fmt::format("{} Note the mark on the ruler. Enter: the encoders are read.", move.begin)),
        calibration);
    reading.to = leg_counts(
        rig.read_still_at(go_to(move.to), fmt::format("{} Hold it there. Enter: they are read again.", move.move)),
        calibration);
    reading.distance =
        mm * rig.ask_number({.kind = OperatorAction::Kind::say_distance},
                            "How far did the handle move along the ruler, in mm, to the nearest half millimetre?", 20.0,
                            110.0, "mm");
    angle.readings.push_back(
        fmt::format("{:.1f} mm by the ruler, {:.1f} mm with the values assumed so far; legs from {} to {} "
                    "counts",
                    reading.distance / mm, distance_of(reading, calibration.geometry) / mm, counts_words(reading.from),
                    counts_words(reading.to)));
    readings.push_back(reading);
  }
  const GeometryPreset& assumed = geometry_catalog().front();
  const RulerVerdict verdict = judge_rulers(readings, assumed);
  for (const RulerFit& fit : verdict.others) lengths.readings.push_back(fit_words(fit));
  if (!verdict.is_consistent) {
    angle.state = Finding::State::contradicts;
    angle.sentence = fmt::format(
        "No angle and gear ratio fit these distances: the best are {:.1f} mm off the ruler on average. Measure again, "
        "and measure every distance at the same point of the handle.",
        verdict.fit.is_found ? verdict.fit.misfit / mm : 0.0);
    gear.sentence = lengths.sentence = "The distances contradict each other.";
    return {angle, gear, lengths};
  }
  const RulerFit& fit = verdict.fit;
  FalconCalibration calibration = rig.calibration();
  calibration.geometry = fit.preset->geometry;
  const double assumed_angle = fit.preset->geometry.angle_at_zero_count;
  const bool has_angle = fit.has_gear || std::abs(fit.angle_at_zero_count - assumed_angle) > fit.angle_uncertainty;
  if (has_angle) calibration.geometry.angle_at_zero_count = fit.angle_at_zero_count;
  if (fit.has_gear) calibration.geometry.gear_ratio = fit.gear_ratio;
  rig.use(calibration);

  angle.state = Finding::as_assumed_if(std::abs(fit.angle_at_zero_count - assumed.geometry.angle_at_zero_count) <=
                                       fit.angle_uncertainty);
  angle.sentence =
      fmt::format("{:.1f} ± {:.1f}°; {}.", degrees(fit.angle_at_zero_count), degrees(fit.angle_uncertainty),
                  published_within("angles", published_angles, "°", degrees(fit.angle_at_zero_count),
                                   degrees(fit.angle_uncertainty)));
  gear.state = Finding::as_assumed_if(std::abs(fit.gear_ratio - assumed.geometry.gear_ratio) <= fit.gear_uncertainty);
  gear.sentence = fit.has_gear ? fmt::format("{:.3f} ± {:.3f}.", fit.gear_ratio, fit.gear_uncertainty)
                               : fmt::format("{:.3f}, as published with these lengths, fits within ± {:.3f}.",
                                             fit.gear_ratio, fit.gear_uncertainty);
  lengths.state = Finding::as_assumed_if(fit.preset == &assumed);
  lengths.sentence = verdict.rivals.empty() ? fmt::format("Only \"{}\" fits the ruler.", fit.preset->name)
                                            : fmt::format(
                                                  "\"{}\" fits the ruler, but so does {}, with another angle and gear "
                                                  "ratio: these distances do not tell them apart.",
                                                  fit.preset->name, listed(verdict.rivals));
  if (!verdict.rivals.empty()) lengths.state = Finding::State::measured;
  return {angle, gear, lengths};
}

}  // namespace ghostforce
