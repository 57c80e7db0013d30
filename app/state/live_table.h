// The live values as text for a spreadsheet.
#pragma once

#include <string>

#include "core/snapshot.h"

namespace ghostforce {

// A line of heads with their units, then one for each strategy; columns separated by tabs. What cannot be known is an
// empty cell.
std::string live_table(const Snapshot& snapshot);

}  // namespace ghostforce
