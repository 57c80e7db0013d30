#include "app/paint/font_file.h"

#include <string>

namespace ghostforce {

// The page brings them along in its memory.
std::string font_file(std::string_view name) {
  return "/fonts/" + std::string(name);
}

}  // namespace ghostforce
