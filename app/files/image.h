// A picture in memory, and what takes the pictures of a clip, one after another. Not for the servo thread.
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

// What all pictures of a clip have in common.
struct ClipShape {
  int width = 0;  // [px]
  int height = 0;
  int frames_per_second = 30;
};

// One format of clips. Every function may throw what OutputFile (output_file.h) throws.
class ClipEncoder {
 public:
  ClipEncoder() = default;
  virtual ~ClipEncoder() = default;
  ClipEncoder(const ClipEncoder&) = delete;
  ClipEncoder& operator=(const ClipEncoder&) = delete;

  // The next picture, of the clip's size and without transparency.
  virtual void add(const Image& image) = 0;
  // After the last one.
  virtual void finish() = 0;
};

}  // namespace ghostforce
