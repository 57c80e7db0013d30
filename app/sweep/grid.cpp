#include "app/sweep/grid.h"

#include <cstddef>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include "app/console/failure.h"
#include "app/console/quoted.h"
#include "app/files/scene_keys.h"

namespace ghostforce {
namespace {

[[noreturn]] void refuse(const std::string& argument, const std::string& what) {
  throw Failure(ExitCode::wrong_call, fmt::format("--over {}: {}", quoted_text(argument), what));
}

std::string words_about(const Grid& grid, std::int64_t point) {
  std::string words;
  for (std::size_t i = 0; i < grid.ranges.size(); ++i) {
    words += fmt::format("{}{}={}", i == 0 ? "" : " and ", dotted_name(*grid.ranges[i].key), value_at(grid, i, point));
  }
  return words;
}

// What no key can tell by itself: the other one may be swept too, or the scene's.
void refuse_unsound_points(const Grid& grid, const std::string& last_argument, Scene scene) {
  for (std::int64_t point = 0; point < size_of(grid); ++point) {
    put_point(grid, point, scene);
    if (const auto problem = find_problem(scene)) {
      refuse(last_argument, fmt::format("with {} the key {}: {}; {}", words_about(grid, point),
                                        dotted_name(problem->table, problem->name), problem->what, problem->remedy));
    }
  }
}

}  // namespace

Grid make_grid(std::span<const std::string> arguments, const Scene& scene) {
  Grid grid;
  for (const std::string& argument : arguments) {
    std::variant<Range, std::string> parsed = parse_range(argument);
    if (const std::string* const what = std::get_if<std::string>(&parsed)) refuse(argument, *what);
    Range& range = std::get<Range>(parsed);
    for (const Range& other : grid.ranges) {
      if (other.key == range.key) {
        refuse(argument, fmt::format("the key {} already has a range; give only one", dotted_name(*range.key)));
      }
    }
    // Rows would name a stiffness that the hand does not have.
    if (!scene.stiffness_path.is_empty() && dotted_name(*range.key) == "user.k_u_N_per_m") {
      refuse(argument, "the scene's hand changes its stiffness, by user.k_u_path_N_per_m; sweep a scene without that");
    }
    if (grid.ranges.size() == most_swept_keys) {
      refuse(argument, "a sweep varies one or two keys; set the others with --set");
    }
    grid.ranges.push_back(std::move(range));
    if (size_of(grid) > most_points) {
      refuse(argument, fmt::format("the sweep would have {} points; the limit is {}, so lower a COUNT", size_of(grid),
                                   most_points));
    }
  }
  refuse_unsound_points(grid, arguments.back(), scene);
  return grid;
}

std::int64_t size_of(const Grid& grid) noexcept {
  std::size_t size = 1;
  for (const Range& range : grid.ranges) size *= range.values.size();
  return static_cast<std::int64_t>(size);
}

double value_at(const Grid& grid, std::size_t which, std::int64_t point) noexcept {
  auto index = static_cast<std::size_t>(point);
  for (std::size_t i = grid.ranges.size() - 1; i > which; --i) index /= grid.ranges[i].values.size();
  const std::vector<double>& values = grid.ranges[which].values;
  return values[index % values.size()];
}

void put_point(const Grid& grid, std::int64_t point, Scene& scene) noexcept {
  for (std::size_t i = 0; i < grid.ranges.size(); ++i) set_number(scene, *grid.ranges[i].key, value_at(grid, i, point));
}

}  // namespace ghostforce
