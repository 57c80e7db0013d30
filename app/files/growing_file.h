// A file that grows while the program runs, and whose beginning is of use whenever it ends: it is new, and what is in it
// stays. Any one thread.
#pragma once

#include <string>
#include <string_view>

#include "app/base/failure.h"

namespace ghostforce {

// Its descriptor; negative: there is none, and errno says why.
int open_growing_file(const std::string& path) noexcept;

// Why it cannot be had. `kind`: what it would be, as "a recording"; `error`: as errno has it.
Failure no_growing_file(const std::string& path, std::string_view kind, int error);

// 0, or why not all of it is in the file.
int append_whole(int descriptor, std::string_view text) noexcept;

}  // namespace ghostforce
