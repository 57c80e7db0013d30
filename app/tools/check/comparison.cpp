#include "app/tools/check/comparison.h"

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include <fmt/format.h>

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

namespace {

using Pixel = std::array<std::uint8_t, 3>;

constexpr Pixel over_colour{255, 0, 190};
constexpr Pixel slight_colour{255, 165, 0};
constexpr Pixel frame_colour{0, 90, 255};
constexpr Pixel hatch_colour{150, 150, 150};
constexpr int hatch_distance = 8;  // of one line from the next, across [px]
// Between the frame and what it surrounds, so that it covers nothing that differs [px].
constexpr int frame_distance = 5;

std::size_t place_of(const Image& image, int x, int y) {
  return 3U * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
}

bool has(const Image& image, int x, int y) {
  return x < image.width && y < image.height;
}

int alpha_at(const Image& image, std::size_t place) {
  return image.alpha.empty() ? 255 : int{image.alpha[place / 3]};
}

// The greatest of its four channels.
int difference_at(const Image& a, const Image& b, int x, int y) {
  const std::size_t in_a = place_of(a, x, y);
  const std::size_t in_b = place_of(b, x, y);
  int greatest = std::abs(alpha_at(a, in_a) - alpha_at(b, in_b));
  for (std::size_t i = 0; i < 3; ++i)
    greatest = std::max(greatest, std::abs(int{a.rgb[in_a + i]} - int{b.rgb[in_b + i]}));
  return greatest;
}

void put(Image& image, int x, int y, const Pixel& pixel) {
  std::copy(pixel.begin(), pixel.end(), image.rgb.begin() + static_cast<std::ptrdiff_t>(place_of(image, x, y)));
}

Pixel faded(const Image& image, int x, int y) {
  const std::size_t at = place_of(image, x, y);
  // A fifth of its brightness on white, as sRGB's luma has it.
  const int luma = (299 * image.rgb[at] + 587 * image.rgb[at + 1] + 114 * image.rgb[at + 2]) / 1000;
  const auto grey = static_cast<std::uint8_t>(204 + luma / 5);
  return {grey, grey, grey};
}

bool is_on_hatch(int x, int y) {
  return (x + y) % hatch_distance == 0;
}

void put_frame(Image& image, const Comparison& around) {
  const int left = std::max(0, around.left - frame_distance);
  const int top = std::max(0, around.top - frame_distance);
  const int right = std::min(image.width - 1, around.right + frame_distance);
  const int bottom = std::min(image.height - 1, around.bottom + frame_distance);
  // A difference at the picture's edge leaves the frame no room but over it.
  const auto put_beside = [&](int x, int y) {
    const bool is_inside = x >= around.left && x <= around.right && y >= around.top && y <= around.bottom;
    if (!is_inside) put(image, x, y, frame_colour);
  };
  for (int x = left; x <= right; ++x) {
    put_beside(x, top);
    put_beside(x, bottom);
  }
  for (int y = top; y <= bottom; ++y) {
    put_beside(left, y);
    put_beside(right, y);
  }
}

}  // namespace

Comparison compare_pictures(const Image& expected, const Image& actual, const Tolerance& tolerance, const Mask& mask) {
  Comparison result;
  result.has_one_size = expected.width == actual.width && expected.height == actual.height;
  if (!result.has_one_size) return result;
  result.masked = mask.count();
  result.pixels = std::int64_t{actual.width} * actual.height - result.masked;
  if (expected == actual) return result;
  const bool are_opaque = expected.alpha.empty() && actual.alpha.empty();
  result.left = actual.width;
  result.top = actual.height;
  const std::size_t row = place_of(actual, 0, 1);
  for (int y = 0; y < actual.height; ++y) {
    const std::size_t begin = place_of(actual, 0, y);
    if (are_opaque && std::memcmp(&expected.rgb[begin], &actual.rgb[begin], row) == 0) continue;  // most are
    for (int x = 0; x < actual.width; ++x) {
      if (mask.covers(x, y)) continue;
      const int difference = difference_at(expected, actual, x, y);
      result.greatest = std::max(result.greatest, difference);
      if (difference <= tolerance.channel) continue;
      ++result.over;
      result.left = std::min(result.left, x);
      result.top = std::min(result.top, y);
      result.right = std::max(result.right, x);
      result.bottom = std::max(result.bottom, y);
    }
  }
  return result;
}

bool is_within(const Comparison& comparison, const Tolerance& tolerance) noexcept {
  return comparison.has_one_size && comparison.share() <= tolerance.share;
}

std::string difference_words(const Comparison& comparison, const Tolerance& tolerance) {
  const double all = static_cast<double>(comparison.pixels + comparison.masked);
  const std::string end = comparison.masked == 0 ? ""
                                                 : fmt::format("; {:.3g} % of the picture is masked",
                                                               100.0 * static_cast<double>(comparison.masked) / all);
  if (comparison.over == 0) {
    return (comparison.greatest == 0
                ? "no pixel differs"
                : fmt::format("no pixel differs by more than {} of 255; the greatest difference is {}",
                              tolerance.channel, comparison.greatest)) +
           end;
  }
  const std::string by = tolerance.channel == 0 ? "" : fmt::format("by more than {} of 255, ", tolerance.channel);
  const PixelBox box = comparison.box();
  return fmt::format("{} of {} pixels ({:.3g} %) differ {}by up to {}, all of them in {}x{} pixels at x {}, y {}{}",
                     comparison.over, comparison.pixels, 100.0 * comparison.share(), by, comparison.greatest, box.width,
                     box.height, box.x, box.y, end);
}

Image difference_picture(const Image& expected, const Image& actual, const Tolerance& tolerance, const Mask& mask) {
  Image picture{std::max(expected.width, actual.width), std::max(expected.height, actual.height), {}};
  picture.rgb.resize(place_of(picture, 0, picture.height));
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (mask.covers(x, y)) {
        put(picture, x, y, is_on_hatch(x, y) ? hatch_colour : faded(actual, x, y));
        continue;
      }
      const bool is_in_both = has(expected, x, y) && has(actual, x, y);
      const int difference = is_in_both ? difference_at(expected, actual, x, y) : INT_MAX;
      const Pixel& differing = difference > tolerance.channel ? over_colour : slight_colour;
      put(picture, x, y, difference == 0 ? faded(actual, x, y) : differing);
    }
  }
  if (const Comparison comparison = compare_pictures(expected, actual, tolerance, mask); comparison.over > 0) {
    put_frame(picture, comparison);
  }
  return picture;
}

}  // namespace ghostforce
