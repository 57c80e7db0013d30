#include "app/run_file.h"

#include <iterator>

#include <fmt/compile.h>

#include "app/scene_file.h"
#include "ghostforce_version.h"

namespace ghostforce {

std::string run_header(const Scene& scene, std::string_view further_columns) {
  std::string header = fmt::format("# ghostforce {}\n{}\n", version, scene_begins);
  const std::string text = scene_text(scene);
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    header += line.empty() ? "#\n" : fmt::format("# {}\n", line);
    rest.remove_prefix(line.size() + 1);
  }
  header += fmt::format(
      "{}\n"
      "# One row per tick and strategy. Units: s, m, N. The force is what the device puts on the hand.\n"
      "{}{}\n",
      scene_ends, run_columns, further_columns);
  return header;
}

void append_run_row(fmt::memory_buffer& rows, const Snapshot& snapshot, StrategyId id) {
  const StrategySnapshot<2>& state = snapshot.strategies[index_of(id)];
  fmt::format_to(std::back_inserter(rows), FMT_COMPILE("{},{},{},{},{},{},{},{},{},{}"), strategy(id).name,
                 snapshot.time_s, snapshot.goal.x, snapshot.goal.y, state.device.x, state.device.y, state.proxy.x,
                 state.proxy.y, state.force.x, state.force.y);
}

}  // namespace ghostforce
