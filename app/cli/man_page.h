// Manual pages for man(1), in the macros of man(7). Pure, any thread.
#pragma once

#include <string>
#include <string_view>

#include "app/cli/manual.h"

namespace ghostforce {

// Of the program: NAME.1.
std::string man_page(const Manual& manual);
// Of one of its commands: PROGRAM-NAME.1.
std::string man_page(const Manual& manual, const ManualCommand& command);

// UTF-8 as text that groff and mandoc show as it is, whatever it contains and whatever the system's encoding.
std::string roff_text(std::string_view text);

}  // namespace ghostforce
