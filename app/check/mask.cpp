#include "app/check/mask.h"

#include <algorithm>

namespace ghostforce {

Mask::Mask(int width, int height, std::span<const PixelBox> boxes) {
  if (boxes.empty()) return;
  width_ = width;
  height_ = height;
  is_covered_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (const PixelBox& box : boxes) {
    for (int y = box.y; y < box.y + box.height; ++y) {
      const auto begin = is_covered_.begin() + std::ptrdiff_t{y} * width + box.x;
      std::fill(begin, begin + box.width, true);
    }
  }
  count_ = std::ranges::count(is_covered_, true);
}

}  // namespace ghostforce
