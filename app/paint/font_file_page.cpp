#include "app/paint/font_file.h"

namespace ghostforce {

// The page brings them along in its memory.
std::string font_file(std::string_view name) {
  return "/fonts/" + std::string(name);
}

}  // namespace ghostforce
