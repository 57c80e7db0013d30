// Reads animated PNG files strictly, by the specification (PNG, third edition), independently of the program's writer:
// each checksum, each sequence number and each rectangle is looked at, and the order of the chunks. For tests.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/image.h"

namespace ghostforce {

struct AnimatedFrame {
  Image image;             // all that is to be seen while it is shown
  std::uint32_t left = 0;  // its own rectangle [px]
  std::uint32_t top = 0;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  int delay_numerator = 0;
  int delay_denominator = 0;
};

struct Animation {
  std::uint32_t plays = 0;  // 0: without end
  std::string comment;      // of an uncompressed iTXt chunk
  std::vector<AnimatedFrame> frames;
};

// `bytes`: the whole file. Throws std::runtime_error: what is wrong with it. Of the kinds of pictures that PNG knows
// only those of eight bits a channel without a palette, not interlaced.
Animation read_animated_png(std::string_view bytes);

}  // namespace ghostforce
