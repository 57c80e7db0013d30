// Random values for the keys of a scene, over all that each may hold, its ends included.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/scene.h"
#include "tests/core/random_setting.h"

namespace ghostforce {

// Any value that the key may have; where there is no end to them, some turns.
inline double any_between(Random& random, double least, double greatest) {
  if (random.once_in(10)) return least > -1e300 ? least : 0.0;
  if (random.once_in(10)) return greatest < 1e300 ? greatest : 0.0;
  if (least >= 0.0) return std::clamp(random.over_decades(std::max(least, 1e-3), greatest), least, greatest);
  return random.uniform(-1000.0, 1000.0);
}

// Visits the value of a SceneKey. Texts, paths with their times, bands and what several numbers make up stay as
// they are.
struct AnyValue {
  Scene& scene;
  Random& random;

  void operator()(const NumberKey& key) const {
    double value = any_between(random, key.least, key.greatest);
    if (key.whole) value = std::round(value);
    if (key.may_be_infinite && random.once_in(4)) value = std::numeric_limits<double>::infinity();
    key.in(scene) = value / key.per_si;
  }
  void operator()(const OptionalNumberKey& key) const {
    key.in(scene).reset();
    if (!random.once_in(3)) key.in(scene) = any_between(random, key.least, key.greatest);
  }
  void operator()(const ChoiceKey& key) const {
    key.set(scene, static_cast<std::size_t>(random.below(static_cast<int>(key.words.size()))));
  }
  void operator()(const PointKey& key) const { key.in(scene) = random.in_box<2>(random.once_in(2) ? 1.0 : 0.01); }
  void operator()(const TextKey&) const {}
  void operator()(const PointsKey&) const {}
  void operator()(const TimesKey&) const {}
  void operator()(const NumbersKey&) const {}
  void operator()(const RangeKey&) const {}
  void operator()(const PairKey&) const {}
  void operator()(const PointPairKey&) const {}
  void operator()(const AnchorsKey&) const {}
};

}  // namespace ghostforce
