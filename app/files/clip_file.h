// A clip: pictures that follow each other, in a file that is written whole or not at all. The format is the file
// name's: .png is an animated PNG, which the program writes itself (AnimatedPng); .mp4 and .webm are made by ffmpeg,
// where it is installed. One thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "app/base/interruption.h"
#include "app/files/image.h"
#include "app/files/output_file.h"
#include "app/files/video_encoder.h"

namespace ghostforce {

// A minute of 60 pictures a second; and as many pixels as those have at 1920 × 1080.
inline constexpr std::int64_t most_clip_frames = 3600;
inline constexpr std::int64_t most_clip_pixels = most_clip_frames * 1920 * 1080;
inline constexpr int most_frames_per_second = 60;

// Throws Failure(wrong_call) where a clip would be longer or larger than that.
void check_clip_limits(std::int64_t frames, const ClipShape& shape);

// Every function may throw what OutputFile and VideoEncoder throw; the name's ending and what is no plain file are a
// Failure(wrong_call).
class ClipFile {
 public:
  // Fails at once where the file can never come to be. `text`: what the file says of itself; empty: nothing.
  ClipFile(const std::string& path, const ClipShape& shape, std::string_view text = {},
           VideoWaiting waiting = {.look_up = stop_if_interrupted});

  void add(const Image& image) { encoder_->add(image); }
  // After at least one picture. Without it there is no file.
  void commit();

 private:
  OutputFile file_;
  std::unique_ptr<ClipEncoder> encoder_;
};

// A PNG file whose further pictures stand in chunks of their own (PNG, third edition, W3C). Programs that know nothing
// of them show the first picture. The same pictures give the same bytes.
//
// Each picture is stored as what has changed since the one before: the smallest rectangle that contains it, and in that
// only the pixels that have changed, drawn over the old ones. Equal pictures are one that is shown for longer. In
// memory are the newest picture and its stored form, whatever the clip's length.
class AnimatedPng : public ClipEncoder {
 public:
  // Writes the file's beginning. `file` must not be written directly (OutputFile::part_path()) and must outlive this;
  // its owner commits it after finish(). `text`: what the file says of itself as its "Description", UTF-8; may be
  // empty.
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
