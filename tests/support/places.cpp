#include "tests/support/places.h"

namespace ghostforce {

std::string source_path(std::string_view beneath) {
  return std::string(GHOSTFORCE_SOURCE_DIR).append(beneath);
}

const std::string& ghostforce_program() {
  static const std::string path = GHOSTFORCE_PROGRAM;
  return path;
}

}  // namespace ghostforce
