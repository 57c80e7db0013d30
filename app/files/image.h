// A picture in memory. Any thread.
#pragma once

#include <cstdint>
#include <vector>

namespace ghostforce {

// Rows from the top, three bytes (red, green, blue) a pixel.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
  std::vector<std::uint8_t> alpha{};  // a byte a pixel, 255 is opaque; empty: all are, as in everything drawn here

  friend bool operator==(const Image&, const Image&) = default;
};

}  // namespace ghostforce
