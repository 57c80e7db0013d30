#include "app/files/clip_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/files/animated_png.h"

namespace ghostforce {
namespace {

struct ClipFormat {
  std::string_view ending;
  VideoArguments arguments;  // for ffmpeg; empty: it is not needed
};

// Encoders want even numbers of rows and columns: the last one may be lost. The colours are those of the screen, which
// players take for granted in pictures of this size.
VideoArguments video_arguments(VideoArguments encoder, VideoArguments container) {
  VideoArguments all{"-vf",
                     "crop=trunc(iw/2)*2:trunc(ih/2)*2:0:0,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p",
                     "-colorspace",
                     "bt709",
                     "-color_primaries",
                     "bt709",
                     "-color_trc",
                     "bt709",
                     "-color_range",
                     "tv"};
  for (const VideoArguments& some : {std::move(encoder), std::move(container)}) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

const std::array<ClipFormat, 3>& clip_formats() {
  static const std::array<ClipFormat, 3> formats{
      ClipFormat{".png", {}},
      ClipFormat{".mp4", video_arguments({"-c:v", "libx264", "-crf", "18"}, {"-movflags", "+faststart", "-f", "mp4"})},
      ClipFormat{".webm",
                 video_arguments({"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-row-mt", "1"}, {"-f", "webm"})}};
  return formats;
}

bool ends_in(std::string_view path, std::string_view ending) {
  if (path.size() <= ending.size()) return false;
  return std::ranges::equal(path.substr(path.size() - ending.size()), ending,
                            [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

const ClipFormat& format_of_clip(const std::string& path) {
  for (const ClipFormat& format : clip_formats()) {
    if (ends_in(path, format.ending)) return format;
  }
  throw Failure(ExitCode::wrong_call, fmt::format("{}: a clip's name ends in .png, .mp4 or .webm; the last two need "
                                                  "ffmpeg",
                                                  quoted_text(path, longest_path)));
}

}  // namespace

void check_clip_limits(std::int64_t frames, const ClipShape& shape) {
  if (frames > most_clip_frames) {
    throw Failure(
        ExitCode::wrong_call,
        fmt::format("this clip would have {} pictures; {} is the most: choose a shorter time or fewer a second", frames,
                    most_clip_frames));
  }
  const std::int64_t pixels = std::int64_t{shape.width} * shape.height;
  if (frames * pixels <= most_clip_pixels) return;
  throw Failure(
      ExitCode::wrong_call,
      fmt::format("{} pictures of {}x{} pixels are too large for a clip; at this size {} is the most: choose a "
                  "smaller size, a shorter time or fewer a second",
                  frames, shape.width, shape.height, most_clip_pixels / pixels));
}

ClipFile::ClipFile(const std::string& path, const ClipShape& shape, std::string_view text, VideoWaiting waiting)
    : file_(path) {
  if (file_.part_path().empty()) {
    throw Failure(ExitCode::wrong_call, fmt::format("{}: a clip cannot go into a pipe or a device; name a file",
                                                    quoted_text(path, longest_path)));
  }
  const ClipFormat& format = format_of_clip(path);
  if (format.arguments.empty()) {
    encoder_ = std::make_unique<AnimatedPng>(file_, shape, text);
  } else {
    encoder_ = std::make_unique<VideoEncoder>(file_, shape, format.arguments, text, std::move(waiting));
  }
}

void ClipFile::commit() {
  encoder_->finish();
  file_.commit();
}

}  // namespace ghostforce
