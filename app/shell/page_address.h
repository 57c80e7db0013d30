// PageAddress: what the address of the page asks for (docs/web.md), and what in it cannot be used. Pure; any thread.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ghostforce {

struct PageAddress {
  std::string lesson{};                      // by name; empty: none
  std::optional<std::size_t> lesson_step{};  // to begin it with, from 1; empty: the first
  std::string language{};                    // its code; empty: as the person prefers
  std::string embedder{};          // origin of the page around this one, for their messages; empty: there are none
  bool is_kiosk = false;           // for visitors
  bool is_for_new_person = false;  // nothing that is kept is used, and nothing is kept
  bool fits = false;               // all is in sight, again whenever the picture's size changes
  std::vector<std::string> problems{};
};

// Whether this is the origin of a page, as a browser writes it. To anything else a browser sends no message, or throws.
using IsOrigin = std::function<bool(const std::string& value)>;

// `query`: what stands from the ? to the #, as it is written there. Also told is what stands there and means nothing.
PageAddress read_page_address(std::string_view query, const IsOrigin& is_origin);

// What such a text says, with characters in place of %XX. Throws ReadError where something else follows a percent sign.
std::string without_percent_signs(std::string_view text);

}  // namespace ghostforce
