// One line of a run as values: a row by the names of its columns, and the comment that tells of a state. Pure, any
// thread.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "app/files/run_reader.h"
#include "app/files/run_remarks.h"

namespace ghostforce {

// The text up to the separator, which is taken off `rest` with it.
std::string_view take_until(std::string_view& rest, char separator) noexcept;

// "t_s=T " is taken off `rest`, and thrown away. False: it does not begin with a time.
bool take_time(std::string_view& rest) noexcept;

// What stands after "# state ".
std::optional<RunState> read_state(std::string_view words);

struct RunLine {
  StrategyId strategy = StrategyId::full;
  double time_s = 0.0;
  Vector<2> goal{0.0};        // q_u [m]
  bool is_estimated = false;  // the goal
  bool is_measured = false;   // the device
  RunRow row;
};

// Where in a row each value stands.
class RunColumns {
 public:
  // Whether one of the values is the name of the column that no run is without.
  static bool may_be_names(std::span<const std::string_view> values);

  // Returns the needed ones that are missing; if there are any, nothing is known as before.
  std::vector<std::string_view> find(std::span<const std::string_view> names);
  // For a file whose line of names is damaged.
  void assume_usual(std::size_t values_per_row);
  bool are_known() const noexcept { return values_per_row_ > 0; }

  // Why the row is left out; none: it is sound, and `line` holds it.
  std::optional<RunFault> read(std::span<const std::string_view> values, RunLine& line) const;

 private:
  static constexpr std::size_t column_count = 17;

  std::array<std::size_t, column_count> place_{};
  std::size_t values_per_row_ = 0;
};

}  // namespace ghostforce
