// The inputs of the page: those of every system, and a SpaceMouse where the browser has one to give. A Falcon is not
// among them. Main thread; making an input allocates and may throw.
#pragma once

#include <string_view>
#include <vector>

#include "app/shell/input_link.h"

namespace ghostforce {

// In the order in which people see them.
std::vector<InputEntry> page_inputs();

inline constexpr std::string_view why_no_falcon_in_page =
    "A Falcon needs the desktop program: a browser may put a tab to sleep, and its motors with it. The Virtual Falcon "
    "rehearses it.";

}  // namespace ghostforce
