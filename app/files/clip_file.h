// A clip: pictures that follow each other, in a file that is written whole or not at all. The format is the file name's:
// .png is an animated PNG, which the program writes itself; .mp4 and .webm are made by ffmpeg, where it is installed.
// One thread.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "app/base/interruption.h"
#include "app/files/clip_shape.h"
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

}  // namespace ghostforce
