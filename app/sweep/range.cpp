#include "app/sweep/range.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <system_error>
#include <vector>

#include <fmt/compile.h>

#include "app/console/quoted.h"
#include "app/files/scene_keys.h"

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
  return part.empty() ? "nothing" : fmt::format("'{}'", quoted_text(part));
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

std::optional<std::string> find_fraction(const std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] == std::trunc(values[i])) continue;
    return fmt::format(
        "it takes whole numbers only, and number {} of {} would be {}; choose FROM, TO and COUNT so that all are whole",
        i + 1, values.size(), values[i]);
  }
  return std::nullopt;
}

// To 15 digits, which every double has: 0.6 and not 0.6000000000000001, as a person would write it and compare with it.
double without_rounding_noise(double value) {
  std::array<char, 32> digits;
  const auto end = fmt::format_to_n(digits.data(), digits.size(), FMT_COMPILE("{:.14e}"), value).out;
  std::from_chars(digits.data(), end, value);
  return value;
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
  double from = 0.0;
  double to = 0.0;
  if (const auto what = find_problem_of_end("FROM", parts[0], name, *limits, from)) return problem(*what);
  if (const auto what = find_problem_of_end("TO", parts[1], name, *limits, to)) return problem(*what);
  const std::optional<std::int64_t> count = parse_number<std::int64_t>(parts[2]);
  if (!count || *count < 1 || *count > most_points) {
    return problem(fmt::format("COUNT is {}; give a whole number from 1 to {}", shown(parts[2]), most_points));
  }
  const bool logarithmic = parts.size() == 4;
  if (logarithmic) {
    if (parts[3] != "log") {
      return problem(
          fmt::format("the spacing is {}; write log, or leave it and its colon out for equal steps", shown(parts[3])));
    }
    if (!(from > 0.0 && to > 0.0)) {
      return problem(fmt::format("log needs FROM and TO greater than 0, and {} is {}; leave :log out, or begin above 0",
                                 from > 0.0 ? "TO" : "FROM", from > 0.0 ? to : from));
    }
  }
  Range range{key, spaced(from, to, *count, logarithmic), logarithmic};
  if (limits->whole) {
    if (const auto what = find_fraction(range.values)) return problem(*what);
  }
  return range;
}

void put(const Range& range, double value, Scene& scene) noexcept {
  std::visit(Put{scene, value}, range.key->value);
}

}  // namespace ghostforce
