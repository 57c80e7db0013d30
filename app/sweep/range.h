// One argument of --over: a key of the scene that holds a number, and the values that it takes. Pure, any thread.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/scene.h"

namespace ghostforce {

// Points that a sweep may have at most, over all its keys, so that a slip of the keyboard does not fill a disk.
inline constexpr std::int64_t most_points = 10'000'000;

struct Range {
  const SceneKey* key;         // its value is a NumberKey or an OptionalNumberKey
  std::vector<double> values;  // in the file's unit, one or more; the first and the last are FROM and TO exactly, and
                               // no other lies beyond them
  bool logarithmic;            // the same ratio from value to value, not the same step
};

// KEY=FROM:TO:COUNT or KEY=FROM:TO:COUNT:log, blanks around each part allowed. All values lie in the key's range.
// Returns what is wrong if something is.
std::variant<Range, std::string> parse_range(std::string_view argument);

}  // namespace ghostforce
