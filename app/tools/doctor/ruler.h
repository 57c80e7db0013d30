// The angle of the arms at count zero and the gear's ratio, from distances that a person has read off a ruler: the
// values with which the legs' kinematics gives the same distances. Pure; judge_rulers() allocates, any thread. m, rad,
// leg counts.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "device/falcon/geometry.h"

namespace ghostforce {

struct RulerReading {
  Vector<3> from{0.0};    // where the legs stood at the ruler's first mark [counts, need not be whole]
  Vector<3> to{0.0};      // and at the second
  double distance = 0.0;  // what the ruler says [m]
};

// Two standard deviations of one distance, each end of which is read to about a millimetre [m]. All uncertainties here
// are two standard deviations.
inline constexpr double ruler_uncertainty = 0.001;

struct RulerFit {
  const GeometryPreset* preset = nullptr;  // whose lengths these are
  bool has_gear = false;                   // the gear was looked for too, and is not the preset's
  double angle_at_zero_count = 0.0;        // [rad]
  double angle_uncertainty = 0.0;
  double gear_ratio = 0.0;
  double gear_uncertainty = 0.0;
  double misfit = 0.0;   // root mean square of ruler less kinematics [m]
  double badness = 0.0;  // sum of squares of (ruler less kinematics) in standard deviations
  bool is_found = false;
};

// What the kinematics of a geometry says a reading's distance is [m]; 0 where no such position exists.
double distance_of(const RulerReading& reading, const FalconGeometry& geometry) noexcept;

// With the lengths of a preset. `with_gear` false: the gear stays the preset's too.
RulerFit fit_ruler(std::span<const RulerReading> readings, const GeometryPreset& preset, bool with_gear) noexcept;

// What to use of all this. As long as the ruler allows it, that is the assumed geometry, and then the assumed gear: a
// fit of more than the readings need is a worse one.
struct RulerVerdict {
  RulerFit fit;                            // to take
  std::vector<RulerFit> others;            // all presets with a free gear, for the report
  bool is_consistent = false;              // false: no geometry fits what was read
  std::vector<std::string_view> rivals{};  // presets that fit as well, by chance, with an angle and gear of their own
};

RulerVerdict judge_rulers(std::span<const RulerReading> readings, const GeometryPreset& assumed);

}  // namespace ghostforce
