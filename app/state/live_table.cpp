#include "app/state/live_table.h"

#include <fmt/format.h>

#include "app/picture/glossary.h"
#include "core/strategy.h"

namespace ghostforce {

std::string live_table(const Snapshot& snapshot) {
  std::string text = "strategy";
  for (const Quantity& quantity : quantity_catalog()) {
    const bool is_against_target = quantity.is_against_goal && snapshot.has_target;
    text +=
        fmt::format("\t{}{} [{}]", quantity.title, is_against_target ? " relative to the target" : "", quantity.unit);
  }
  text += '\n';
  for (const Strategy& entry : strategy_catalog()) {
    text += entry.title;
    for (const Quantity& quantity : quantity_catalog()) {
      text += '\t';
      // More digits than on the screen, and a minus sign that spreadsheets read.
      if (is_known(quantity, snapshot, entry.id))
        text += fmt::format("{:.6g}", quantity.value(snapshot.strategies[index_of(entry.id)]) + 0.0);
    }
    text += '\n';
  }
  return text;
}

}  // namespace ghostforce
