// What `ghostforce --version` prints: all that a report of a fault needs. Pure.
#pragma once

#include <string>
#include <string_view>

#include "app/shell/receipt.h"

namespace ghostforce {

// The first line is "ghostforce VERSION", for scripts; then a line each: commit, build, libraries, renderer. `renderer`
// is what draws pictures without a display, or why nothing does.
std::string version_words(std::string_view renderer);

// The same for the receipts of sessions. `firmware`: see ReceiptOrigin.
ReceiptOrigin receipt_origin(std::string firmware);

}  // namespace ghostforce
