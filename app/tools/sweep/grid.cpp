#include "app/tools/sweep/grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <fmt/compile.h>
#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/number.h"
#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/files/scene_keys.h"

namespace ghostforce {
namespace {

std::vector<std::string_view> parts_of(std::string_view text) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t colon = text.find(':');
    parts.push_back(trimmed(text.substr(0, colon)));
    if (colon == std::string_view::npos) return parts;
    text.remove_prefix(colon + 1);
  }
}

std::string shown(std::string_view part) {
  return part.empty() ? "empty" : fmt::format("'{}'", quoted_text(part));
}

// What is wrong with one end of the range, if something is.
std::optional<std::string> find_problem_of_end(std::string_view which, std::string_view text, std::string_view key_name,
                                               const NumberLimits& limits, double& end) {
  const std::optional<double> number = signed_number_in<double>(text);
  if (!number || !std::isfinite(*number)) {
    const bool is_infinite = number && std::isinf(*number) && limits.may_be_infinite;
    return fmt::format(
        "{} is {}; give a finite number such as 1.5 or 1e5{}", which, shown(text),
        is_infinite ? fmt::format("; for the value inf, make a separate call with --set {}=inf", key_name) : "");
  }
  end = *number + 0.0;  // −0 is a zero too
  if (end >= limits.least && end <= limits.greatest) return std::nullopt;
  return fmt::format("{} is {}, out of the key's range; give {}", which, end,
                     range_words({limits.least, limits.greatest, limits.unit}));
}

std::optional<std::string> find_fraction(const std::vector<double>& values) {
  const auto found = std::ranges::find_if(values, [](double value) { return value != std::trunc(value); });
  if (found == values.end()) return std::nullopt;
  return fmt::format(
      "it takes only whole numbers, but number {} of {} would be {}; choose FROM, TO and COUNT so that all are whole",
      found - values.begin() + 1, values.size(), *found);
}

// To 15 digits, which every double has: 0.6 and not 0.6000000000000001, as a person would write it and compare with it.
double without_rounding_noise(double value) {
  std::array<char, 32> digits;
  const auto end = fmt::format_to_n(digits.data(), digits.size(), FMT_COMPILE("{:.14e}"), value).out;
  return read_number({digits.data(), end}).value_or(value);
}

std::vector<double> spaced(double from, double to, std::int64_t count, bool logarithmic) {
  std::vector<double> values(static_cast<std::size_t>(count), from);
  if (count == 1) return values;
  const double first = logarithmic ? std::log10(from) : from;
  const double last = logarithmic ? std::log10(to) : to;
  for (std::int64_t i = 1; i < count - 1; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    const double between = std::lerp(first, last, share);
    const double value = without_rounding_noise(logarithmic ? std::pow(10.0, between) : between);
    values[static_cast<std::size_t>(i)] = std::clamp(value, std::min(from, to), std::max(from, to)) + 0.0;
  }
  values.back() = to;
  return values;
}

}  // namespace

std::variant<Range, std::string> parse_range(std::string_view argument) {
  constexpr std::string_view form =
      "give KEY=FROM:TO:COUNT or KEY=FROM:TO:COUNT:log, for example wall.normal_deg=90:180:91";
  const std::size_t equals = argument.find('=');
  const std::string_view name = trimmed(argument.substr(0, equals));
  if (name.empty()) return std::string(form);
  const SceneKey* const key = find_scene_key(name);
  if (key == nullptr) return fmt::format("the key {} is unknown{}", quoted_text(name), suggest_scene_key(name));
  const std::optional<NumberLimits> limits = limits_of(*key);
  if (!limits) {
    return fmt::format("the key {} is not a single number; a sweep can vary {}", name,
                       fmt::join(dotted_names(KeyKind::number), ", "));
  }
  if (equals == std::string_view::npos) return std::string(form);
  const std::vector<std::string_view> parts = parts_of(argument.substr(equals + 1));
  if (parts.size() < 3 || parts.size() > 4) {
    return fmt::format("the key {}: the range is {}; {}", name, shown(trimmed(argument.substr(equals + 1))), form);
  }

  const auto problem = [name](const std::string& what) { return fmt::format("the key {}: {}", name, what); };
  double from = 0.0;
  double to = 0.0;
  if (const auto what = find_problem_of_end("FROM", parts[0], name, *limits, from)) return problem(*what);
  if (const auto what = find_problem_of_end("TO", parts[1], name, *limits, to)) return problem(*what);
  const std::optional<std::int64_t> count = signed_number_in<std::int64_t>(parts[2]);
  if (!count || *count < 1 || *count > most_points) {
    return problem(fmt::format("COUNT is {}; give a whole number from 1 to {}", shown(parts[2]), most_points));
  }
  const bool logarithmic = parts.size() == 4;
  if (logarithmic) {
    if (parts[3] != "log") {
      return problem(fmt::format("the spacing is {}; write log, or leave out the spacing and its colon for equal steps",
                                 shown(parts[3])));
    }
    if (!(from > 0.0 && to > 0.0)) {
      return problem(fmt::format("log needs FROM and TO greater than 0, but {} is {}; leave out :log, or start above 0",
                                 from > 0.0 ? "TO" : "FROM", from > 0.0 ? to : from));
    }
  }
  Range range{key, spaced(from, to, *count, logarithmic), logarithmic};
  if (limits->whole) {
    if (const auto what = find_fraction(range.values)) return problem(*what);
  }
  return range;
}

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
    std::optional<SceneProblem> problem = find_problem(scene);
    if (!problem) problem = find_workspace_problem(scene);
    if (problem) {
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
    if (!belongs(*range.key, scene)) {
      const std::string_view kind = kind_of(range.key->table, scene);
      const std::string key = dotted_name(*range.key);
      refuse(argument, belongs_to_kind(*range.key, kind)
                           ? fmt::format("the scene has no key {}", key)
                           : fmt::format("the key {} {}", key, wrong_kind_text(*range.key, kind)));
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

bool has_general_points(const Scene& scene, const Grid& grid) noexcept {
  return is_general(scene.settings) ||
         std::ranges::any_of(grid.ranges, [](const Range& range) { return range.key->format > 1; });
}

void put_point(const Grid& grid, std::int64_t point, Scene& scene) noexcept {
  for (std::size_t i = 0; i < grid.ranges.size(); ++i) set_number(scene, *grid.ranges[i].key, value_at(grid, i, point));
}

}  // namespace ghostforce
