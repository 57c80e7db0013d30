// The points of a sweep: each value of the first key with each of the second, the second one running faster. Immutable;
// any thread.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/sweep/range.h"
#include "core/scene.h"

namespace ghostforce {

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

// Gives the scene the values that it has at a point.
void put_point(const Grid& grid, std::int64_t point, Scene& scene) noexcept;

}  // namespace ghostforce
