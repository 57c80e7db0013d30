// A picture in memory: rows from the top, three bytes (red, green, blue) a pixel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ghostforce {

struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;

  friend bool operator==(const Image&, const Image&) = default;
};

}  // namespace ghostforce
