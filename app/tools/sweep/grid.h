// The points of a sweep: each value of the first key with each of the second, the second one running faster. Immutable;
// any thread.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/scene.h"

namespace ghostforce {

// Points that a sweep may have at most, over all its keys, so that a slip of the keyboard does not fill a disk.
inline constexpr std::int64_t most_points = 10'000'000;

// One argument of --over: a key of the scene that holds a number, and the values that it takes.
struct Range {
  const SceneKey* key;         // its value is a NumberKey or an OptionalNumberKey
  std::vector<double> values;  // in the file's unit, one or more; the first and the last are FROM and TO exactly, and
                               // no other lies beyond them
  bool logarithmic;            // equal ratios from value to value instead of equal steps
};

// KEY=FROM:TO:COUNT or KEY=FROM:TO:COUNT:log, blanks around each part allowed. All values lie in the key's range.
// Returns what is wrong if something is.
std::variant<Range, std::string> parse_range(std::string_view argument);

inline constexpr std::size_t most_swept_keys = 2;

struct Grid {
  std::vector<Range> ranges;  // one or two; the last one runs fastest
};

// From the arguments of --over. Throws Failure(wrong_call), with "--over ARGUMENT: " before what is wrong, also where
// single points of the grid make no scene of `scene`.
Grid make_grid(std::span<const std::string> arguments, const Scene& scene);

std::int64_t size_of(const Grid& grid) noexcept;

// What the range at `which` of grid.ranges has at a point, in the file's unit.
double value_at(const Grid& grid, std::size_t which, std::int64_t point) noexcept;

// Whether the points are general scenes, all of them: the scene is one, or a key of the grid makes one of it.
bool has_general_points(const Scene& scene, const Grid& grid) noexcept;

// Gives the scene the values that it has at a point.
void put_point(const Grid& grid, std::int64_t point, Scene& scene) noexcept;

}  // namespace ghostforce
