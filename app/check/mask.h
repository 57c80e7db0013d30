// Mask: the pixels of a picture that are not compared. Pure, any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ghostforce {

// Pixels of a picture [px]; x and y are its upper left one's, from the picture's upper left corner.
struct PixelBox {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

class Mask {
 public:
  Mask() = default;  // covers nothing
  // The boxes may overlap; each lies within the picture, whose size this is.
  Mask(int width, int height, std::span<const PixelBox> boxes);

  bool covers(int x, int y) const noexcept {
    return x < width_ && y < height_ &&
           is_covered_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
  }
  // How many pixels.
  std::int64_t count() const noexcept { return count_; }

 private:
  int width_ = 0;
  int height_ = 0;
  std::vector<bool> is_covered_;
  std::int64_t count_ = 0;
};

}  // namespace ghostforce
