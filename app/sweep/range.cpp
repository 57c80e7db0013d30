#include "app/sweep/range.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <system_error>
#include <vector>

#include <fmt/core.h>

#include "app/printable.h"
#include "app/scene_key_name.h"

namespace ghostforce {
namespace {

// What a key lets its number be.
struct Limits {
  double least;
  double greatest;
  bool may_be_infinite;
  bool whole;
};

struct LimitsOf {
  std::optional<Limits> operator()(const NumberKey& key) const {
    return Limits{key.least, key.greatest, key.may_be_infinite, key.whole};
  }
  std::optional<Limits> operator()(const OptionalNumberKey& key) const {
    return Limits{key.least, key.greatest, false, false};
  }
  template <typename Other>
  std::optional<Limits> operator()(const Other&) const {
    return std::nullopt;
  }
};

struct Put {
  Scene& scene;
  double value;
  void operator()(const NumberKey& key) const noexcept { key.in(scene) = value / key.per_si; }
  void operator()(const OptionalNumberKey& key) const noexcept { key.in(scene) = value; }
  template <typename Other>
  void operator()(const Other&) const noexcept {}  // no Range has such a key
};

std::string keys_with_a_number() {
  std::vector<std::string> names;
  for (const SceneKey& key : scene_keys()) {
    if (std::visit(LimitsOf{}, key.value)) names.push_back(dotted_name(key.table, key.name));
  }
  return listed(std::vector<std::string_view>(names.begin(), names.end()));
}

std::string_view trimmed(std::string_view text) noexcept {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::vector<std::string_view> parts_of(std::string_view text) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t colon = text.find(':');
    parts.push_back(trimmed(text.substr(0, colon)));
    if (colon == std::string_view::npos) return parts;
    text.remove_prefix(colon + 1);
  }
}

template <typename Number>
std::optional<Number> parse_number(std::string_view text) noexcept {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [after, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || after != end) return std::nullopt;
  return number;
}

std::string shown(std::string_view part) {
  return part.empty() ? "nothing" : fmt::format("'{}'", printable(part));
}

// What is wrong with one end of the range, if something is.
std::optional<std::string> find_problem_of_end(std::string_view which, std::string_view text, std::string_view key_name,
                                               const Limits& limits, double& end) {
  const std::optional<double> number = parse_number<double>(text);
  if (!number || !std::isfinite(*number)) {
    const bool is_infinite = number && std::isinf(*number) && limits.may_be_infinite;
    return fmt::format(
        "{} is {}; give a finite number such as 1.5 or 1e5{}", which, shown(text),
        is_infinite ? fmt::format(", and for the one value inf another call with --set {}=inf", key_name) : "");
  }
  end = *number + 0.0;  // −0 is a zero too
  if (end >= limits.least && end <= limits.greatest) return std::nullopt;
  const std::string_view unit = unit_of(key_name);
  return fmt::format("{} is {}, out of the key's range; give {} to {}{}{}", which, end, limits.least, limits.greatest,
                     unit.empty() ? "" : " ", unit);
}

std::optional<std::string> find_fraction(const Range& range) {
  for (std::int64_t i = 0; i < range.count; ++i) {
    const double value = value_at(range, i);
    if (value == std::trunc(value)) continue;
    return fmt::format(
        "it takes whole numbers only, and number {} of {} would be {}; choose FROM, TO and COUNT so that "
        "all are whole",
        i + 1, range.count, value);
  }
  return std::nullopt;
}

}  // namespace

std::variant<Range, std::string> parse_range(std::string_view argument) {
  constexpr std::string_view form =
      "give KEY=FROM:TO:COUNT or KEY=FROM:TO:COUNT:log, for example wall.normal_deg=90:180:91";
  const std::size_t equals = argument.find('=');
  const std::string_view name = trimmed(argument.substr(0, equals));
  if (name.empty()) return std::string(form);
  const SceneKey* const key = find_scene_key(name);
  if (key == nullptr) return fmt::format("the key {} is unknown{}", printable(name), suggest_scene_key(name));
  const std::optional<Limits> limits = std::visit(LimitsOf{}, key->value);
  if (!limits) {
    return fmt::format("the key {} is not one number; a sweep can go over {}", name, keys_with_a_number());
  }
  if (equals == std::string_view::npos) return std::string(form);
  const std::vector<std::string_view> parts = parts_of(argument.substr(equals + 1));
  if (parts.size() < 3 || parts.size() > 4) {
    return fmt::format("the key {}: {} is no range; {}", name, shown(trimmed(argument.substr(equals + 1))), form);
  }

  const auto problem = [name](const std::string& what) { return fmt::format("the key {}: {}", name, what); };
  Range range{key, 0.0, 0.0, 0, parts.size() == 4};
  if (const auto what = find_problem_of_end("FROM", parts[0], name, *limits, range.from)) return problem(*what);
  if (const auto what = find_problem_of_end("TO", parts[1], name, *limits, range.to)) return problem(*what);
  const std::optional<std::int64_t> count = parse_number<std::int64_t>(parts[2]);
  if (!count || *count < 1 || *count > most_points) {
    return problem(fmt::format("COUNT is {}; give a whole number from 1 to {}", shown(parts[2]), most_points));
  }
  range.count = *count;
  if (range.logarithmic) {
    if (parts[3] != "log") {
      return problem(
          fmt::format("the spacing is {}; write log, or leave it and its colon out for equal steps", shown(parts[3])));
    }
    if (!(range.from > 0.0 && range.to > 0.0)) {
      return problem(fmt::format("log needs FROM and TO greater than 0, and {} is {}; leave :log out, or begin above 0",
                                 range.from > 0.0 ? "TO" : "FROM", range.from > 0.0 ? range.to : range.from));
    }
  }
  if (limits->whole) {
    if (const auto what = find_fraction(range)) return problem(*what);
  }
  return range;
}

double value_at(const Range& range, std::int64_t index) noexcept {
  const std::int64_t last = range.count - 1;
  if (index <= 0) return range.from;
  if (index >= last) return range.to;
  // One division at the end: whole and short decimals come out as a person would write them (0.1:1:10 holds 0.3).
  const auto between = [after = static_cast<double>(index), before = static_cast<double>(last - index),
                        steps = static_cast<double>(last)](double from, double to) {
    const double weighted = (from * before + to * after) / steps;
    return std::isfinite(weighted) ? weighted : from * (before / steps) + to * (after / steps);
  };
  const double value = range.logarithmic ? std::pow(10.0, between(std::log10(range.from), std::log10(range.to)))
                                         : between(range.from, range.to);
  return std::clamp(value, std::min(range.from, range.to), std::max(range.from, range.to)) + 0.0;
}

void put(const Range& range, double value, Scene& scene) noexcept {
  std::visit(Put{scene, value}, range.key->value);
}

}  // namespace ghostforce
