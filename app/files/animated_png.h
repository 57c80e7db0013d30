// Animated PNG: a PNG file whose further pictures stand in chunks of their own (PNG, third edition, W3C). Programs that
// know nothing of them show the first picture. The same pictures give the same bytes. One thread.
//
// Each picture is stored as what has changed since the one before: the smallest rectangle that contains it, and in that
// only the pixels that have changed, drawn over the old ones. Equal pictures are one that is shown for longer. In memory
// are the newest picture and its stored form, whatever the clip's length.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "app/files/clip_shape.h"
#include "app/files/output_file.h"

namespace ghostforce {

class AnimatedPng : public ClipEncoder {
 public:
  // Writes the file's beginning. `file` must not be written directly (OutputFile::part_path()) and must outlive this;
  // its owner commits it after finish(). `text`: what the file says of itself as its "Description", UTF-8; empty: nothing.
  AnimatedPng(OutputFile& file, const ClipShape& shape, std::string_view text = {});

  void add(const Image& image) override;
  // The file repeats the pictures without end. There must be at least one.
  void finish() override;

 private:
  // Of the picture [px].
  struct PixelBox {
    int left = 0, top = 0, width = 0, height = 0;
  };

  PixelBox changed_box(const Image& image) const;
  std::string stored(const Image& image, const PixelBox& box) const;
  void write_pending();
  void write(std::string_view bytes);

  OutputFile& file_;
  ClipShape shape_;
  std::size_t written_ = 0;    // bytes so far
  std::size_t counts_at_ = 0;  // the chunk that says how many pictures there are
  std::uint32_t frames_ = 0;   // written
  std::uint32_t sequence_ = 0;
  Image newest_;

  // The newest picture that differs from the one before: written once it is known how long it is shown.
  PixelBox pending_box_;
  std::string pending_;
  unsigned int pending_shown_ = 0;  // for so many pictures of the clip; 0: there is none
};

}  // namespace ghostforce
