#include "app/files/run_line.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>

namespace ghostforce {
namespace {

// What is read of a row; those after the needed ones may be missing: `simulate` and `replay` do not write them.
enum Column : std::size_t {
  strategy_column,
  time_column,
  goal_x_column,
  goal_y_column,
  device_x_column,
  device_y_column,
  proxy_x_column,
  proxy_y_column,
  force_x_column,
  force_y_column,
  needed_columns,
  goal_kind_column = needed_columns,
  device_kind_column,
  active_column,
  saturated_column,
  sent_x_column,
  sent_y_column,
  loop_column,
  all_columns,
};
constexpr std::array<std::string_view, all_columns> column_names{
    "strategy",  "t_s",       "goal_x_m",  "goal_y_m",  "device_x_m", "device_y_m",
    "proxy_x_m", "proxy_y_m", "force_x_N", "force_y_N", "goal_kind",  "device_kind",
    "active",    "saturated", "sent_x_N",  "sent_y_N",  "loop_s"};
// Where one of them is not sound, nobody can tell what else in the row is not.
constexpr std::array yes_or_no_columns{active_column, saturated_column};
constexpr std::array further_numbers{sent_x_column, sent_y_column, loop_column};

constexpr std::size_t absent = SIZE_MAX;

// A finite number, and nothing but it.
enum class Number : std::uint8_t { good, not_finite, damaged };  // from good to bad
Number read_number(std::string_view text, double& value) noexcept {
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return Number::damaged;
  return std::isfinite(value) ? Number::good : Number::not_finite;
}

}  // namespace

std::string_view take_until(std::string_view& rest, char separator) noexcept {
  const std::size_t end = rest.find(separator);
  const std::string_view piece = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  return piece;
}

bool take_time(std::string_view& rest) noexcept {
  if (!rest.starts_with(time_begins)) return false;
  rest.remove_prefix(time_begins.size());
  double time_s = 0.0;
  return read_number(take_until(rest, ' '), time_s) == Number::good;
}

std::optional<RunState> read_state(std::string_view words) {
  if (!take_time(words)) return std::nullopt;
  RunState state;
  PerStrategy<bool> is_told{};
  while (!words.empty()) {
    std::string_view numbers = take_until(words, ' ');
    const std::optional<StrategyId> id = find_strategy(take_until(numbers, '='));
    if (!id || std::exchange(is_told[index_of(*id)], true)) return std::nullopt;
    double x = 0.0;
    double y = 0.0;
    if (read_number(take_until(numbers, ','), x) != Number::good ||
        read_number(take_until(numbers, ','), y) != Number::good ||
        read_number(numbers, state.energy[index_of(*id)]) != Number::good) {
      return std::nullopt;
    }
    state.velocity[index_of(*id)] = {x, y};
  }
  if (!std::ranges::all_of(is_told, std::identity{})) return std::nullopt;
  return state;
}

bool RunColumns::may_be_names(std::span<const std::string_view> values) {
  return std::ranges::find(values, column_names[time_column]) != values.end();
}

std::vector<std::string_view> RunColumns::find(std::span<const std::string_view> names) {
  static_assert(column_count == all_columns);
  std::vector<std::string_view> missing;
  for (std::size_t i = 0; i < column_count; ++i) {
    const auto found = std::ranges::find(names, column_names[i]);
    place_[i] = found == names.end() ? absent : static_cast<std::size_t>(found - names.begin());
    if (i < needed_columns && place_[i] == absent) missing.push_back(column_names[i]);
  }
  if (missing.empty()) values_per_row_ = names.size();
  return missing;
}

void RunColumns::assume_usual(std::size_t values_per_row) {
  for (std::size_t i = 0; i < column_count; ++i) place_[i] = i < needed_columns ? i : absent;
  values_per_row_ = std::max<std::size_t>(values_per_row, needed_columns);
}

std::optional<RunFault> RunColumns::read(std::span<const std::string_view> values, RunLine& line) const {
  if (values.size() != values_per_row_) return RunFault::damaged;
  const std::optional<StrategyId> id = find_strategy(values[place_[strategy_column]]);
  if (!id) return RunFault::damaged;
  std::array<double, needed_columns> number{};
  Number worst = Number::good;
  for (std::size_t i = time_column; i < needed_columns; ++i) {
    worst = std::max(worst, read_number(values[place_[i]], number[i]));
  }
  std::array<double, all_columns> further{};
  for (const Column column : further_numbers) {
    if (place_[column] != absent) worst = std::max(worst, read_number(values[place_[column]], further[column]));
  }
  for (const Column column : yes_or_no_columns) {
    double& yes = further[column];
    if (place_[column] != absent) worst = std::max(worst, read_number(values[place_[column]], yes));
    if (worst == Number::good && yes != 0.0 && yes != 1.0) return RunFault::damaged;
  }
  if (worst != Number::good) return worst == Number::damaged ? RunFault::damaged : RunFault::not_finite;

  const auto word_at = [&](Column column, std::string_view otherwise) {
    return place_[column] == absent ? otherwise : values[place_[column]];
  };
  const std::string_view device_kind = word_at(device_kind_column, "simulated");
  const std::string_view goal_kind = word_at(goal_kind_column, "given");
  line.is_measured = device_kind == "measured";
  line.is_estimated = goal_kind == "estimated";
  if ((!line.is_measured && device_kind != "simulated") || (!line.is_estimated && goal_kind != "given")) {
    return RunFault::damaged;
  }
  line.strategy = *id;
  line.time_s = number[time_column];
  line.goal = {number[goal_x_column], number[goal_y_column]};
  line.row = {{number[device_x_column], number[device_y_column]},
              {number[proxy_x_column], number[proxy_y_column]},
              {number[force_x_column], number[force_y_column]},
              {},
              false};
  // The others have no motors.
  if (line.is_measured) {
    const bool is_told = place_[sent_x_column] != absent && place_[sent_y_column] != absent;
    if (is_told) line.row.sent = {further[sent_x_column], further[sent_y_column]};
    line.row.is_saturated = further[saturated_column] != 0.0;
  }
  return std::nullopt;
}

}  // namespace ghostforce
