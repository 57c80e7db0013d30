// Two pictures, pixel by pixel: how far apart they are, and a picture of where. Pure, any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/files/image.h"

namespace ghostforce {

// Pixels of a picture [px]; x and y are its upper left one's, from the picture's upper left corner.
struct PixelBox {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

// The pixels of a picture that are not compared.
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

// What counts as the same picture; the default is each pixel alike.
struct Tolerance {
  int channel = 0;     // greatest difference of a red, green, blue or alpha that counts as none, 0-255
  double share = 0.0;  // of the pixels that may differ by more, 0-1
};

struct Comparison {
  bool has_one_size = true;  // if not, nothing else was looked at
  std::int64_t pixels = 0;   // that were compared: without those that are masked
  std::int64_t masked = 0;
  std::int64_t over = 0;  // how many pixels have a channel that differs by more than the tolerance's
  int greatest = 0;       // difference of a channel anywhere
  // The rectangle around the pixels that are over, all four included [px]; of no meaning where there is none.
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;

  PixelBox box() const noexcept { return {left, top, right - left + 1, bottom - top + 1}; }
  double share() const noexcept { return pixels > 0 ? static_cast<double>(over) / static_cast<double>(pixels) : 0.0; }
};

// `mask` is of the pictures' size.
Comparison compare_pictures(const Image& expected, const Image& actual, const Tolerance& tolerance,
                            const Mask& mask = {});

bool is_within(const Comparison& comparison, const Tolerance& tolerance) noexcept;

// "512 of 307200 pixels (0.167 %) differ by more than 2 of 255, by up to 90, all of them in 31x40 pixels
// at x 12, y 20"; and then, where there is a mask, "; 3.1 % of the picture is masked"
std::string difference_words(const Comparison& comparison, const Tolerance& tolerance);

// What both show, faded to greys; pixels over the tolerance's channel in magenta and inside a blue frame, smaller
// differences in orange; hatched where masked. As large as the larger of the two each way; what only one of them has
// counts as different.
Image difference_picture(const Image& expected, const Image& actual, const Tolerance& tolerance, const Mask& mask = {});

}  // namespace ghostforce
