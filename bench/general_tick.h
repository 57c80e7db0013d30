// What a tick of a general scene costs, against the same loop written by hand.
#pragma once

#include "bench/support/report.h"

namespace ghostforce::bench {

void compare_general(Report& report);

}  // namespace ghostforce::bench
