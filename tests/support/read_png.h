// A PNG file as a picture. For tests.
#pragma once

#include <string>

#include "app/files/png_file.h"

namespace ghostforce {

inline Image read_png(const std::string& path) {
  return PngFile(path).read();
}

}  // namespace ghostforce
