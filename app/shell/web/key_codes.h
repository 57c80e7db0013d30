// The browser's names of keys.
#pragma once

#include <string_view>

namespace ghostforce {

// KeyboardEvent.code, the place on a US keyboard, as one of app/state/keys.h; 0: it has none.
int key_of_code(std::string_view code) noexcept;

}  // namespace ghostforce
