#include "app/files/png_text.h"

#include <fmt/format.h>

#include "ghostforce_version.h"

namespace ghostforce {

PngText software_text() {
  return {"Software", fmt::format("ghostforce {}", version)};
}

}  // namespace ghostforce
