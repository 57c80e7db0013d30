#include "app/files/clip_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/files/deflate.h"
#include "app/files/png_writer.h"

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

namespace {

constexpr unsigned int longest_shown = 0xFFFF;  // pictures of the clip: a number of 16 bits
constexpr int rgb_channels = 3;

// What is done with a picture's rectangle before the next one, and how it is put there: the values of the format.
constexpr char leave_it = 0;
constexpr char replace_pixels = 0;
constexpr char draw_over = 1;

std::string word(std::uint32_t number) {
  return in_network_order(number, 4);
}

std::string word(int number) {
  return word(static_cast<std::uint32_t>(number));
}

std::string counts(std::uint32_t frames) {
  constexpr std::uint32_t without_end = 0;
  return word(frames) + word(without_end);
}

std::span<const std::uint8_t> row_of(const Image& image, int y) {
  const std::size_t length = static_cast<std::size_t>(rgb_channels) * static_cast<std::size_t>(image.width);
  return std::span(image.rgb).subspan(static_cast<std::size_t>(y) * length, length);
}

}  // namespace

AnimatedPng::AnimatedPng(OutputFile& file, const ClipShape& shape, std::string_view text) : file_(file), shape_(shape) {
  write(png_signature);
  write(png_header(shape.width, shape.height, PngColour::rgb_and_alpha));
  counts_at_ = written_;
  write(png_chunk("acTL", counts(0)));
  if (!text.empty()) write(png_text_chunk({"Description", std::string(text)}));
}

void AnimatedPng::add(const Image& image) {
  if (image.width != shape_.width || image.height != shape_.height || !image.alpha.empty()) {
    throw std::invalid_argument("a picture of another kind than the clip's");
  }
  PixelBox box{0, 0, image.width, image.height};
  if (pending_shown_ > 0) {
    box = changed_box(image);
    if (box.width == 0 && pending_shown_ < longest_shown) {
      ++pending_shown_;
      return;
    }
    if (box.width == 0) box = {0, 0, 1, 1};  // the format has no empty one
    write_pending();
  }
  pending_ = stored(image, box);
  pending_box_ = box;
  pending_shown_ = 1;
  newest_ = image;
}

void AnimatedPng::finish() {
  if (pending_shown_ == 0) throw std::logic_error("a clip without a picture");
  write_pending();
  write(png_chunk("IEND", {}));
  file_.rewrite(counts_at_, png_chunk("acTL", counts(frames_)));
}

// Of no width where nothing has.
AnimatedPng::PixelBox AnimatedPng::changed_box(const Image& image) const {
  const auto differs = [&](int y) { return !std::ranges::equal(row_of(image, y), row_of(newest_, y)); };
  int top = 0;
  while (top < image.height && !differs(top)) ++top;
  if (top == image.height) return {};
  int bottom = image.height;
  while (!differs(bottom - 1)) --bottom;
  int left = image.width;
  int right = 0;
  for (int y = top; y < bottom; ++y) {
    const auto now = row_of(image, y);
    const auto before = row_of(newest_, y);
    const auto first = std::ranges::mismatch(now, before).in1 - now.begin();
    if (first == static_cast<std::ptrdiff_t>(now.size())) continue;
    const auto last = std::mismatch(now.rbegin(), now.rend(), before.rbegin()).first - now.rbegin();
    left = std::min(left, static_cast<int>(first) / rgb_channels);
    right = std::max(right, static_cast<int>(static_cast<std::ptrdiff_t>(now.size()) - 1 - last) / rgb_channels + 1);
  }
  return {left, top, right - left, bottom - top};
}

// Compressed; what has not changed is transparent.
std::string AnimatedPng::stored(const Image& image, const PixelBox& box) const {
  constexpr int compression_level = 6;
  const bool is_first = newest_.rgb.empty();
  const auto pixels = static_cast<std::size_t>(box.width) * static_cast<std::size_t>(box.height);
  Image changes{box.width, box.height, std::vector<std::uint8_t>(rgb_channels * pixels),
                std::vector<std::uint8_t>(pixels)};
  std::size_t i = 0;
  for (int y = box.top; y < box.top + box.height; ++y) {
    const std::uint8_t* pixel = row_of(image, y).data() + rgb_channels * box.left;
    const std::uint8_t* before = is_first ? nullptr : row_of(newest_, y).data() + rgb_channels * box.left;
    for (int x = 0; x < box.width; ++x, ++i, pixel += rgb_channels) {
      if (before != nullptr && std::equal(pixel, pixel + rgb_channels, before + rgb_channels * x)) continue;
      std::copy_n(pixel, rgb_channels, &changes.rgb[rgb_channels * i]);
      changes.alpha[i] = 0xFF;
    }
  }
  return deflated(png_rows(changes), compression_level);
}

void AnimatedPng::write_pending() {
  const bool is_first = frames_ == 0;
  const PixelBox& box = pending_box_;
  std::string control = word(sequence_++) + word(box.width) + word(box.height) + word(box.left) + word(box.top);
  control += in_network_order(pending_shown_, 2);
  control += in_network_order(static_cast<std::uint32_t>(shape_.frames_per_second), 2);
  control += {leave_it, is_first ? replace_pixels : draw_over};
  write(png_chunk("fcTL", control));
  if (is_first) {
    write(png_chunk("IDAT", pending_));
  } else {
    write(png_chunk("fdAT", word(sequence_++) + pending_));
  }
  ++frames_;
}

void AnimatedPng::write(std::string_view bytes) {
  file_.write(bytes);
  written_ += bytes.size();
}

}  // namespace ghostforce
