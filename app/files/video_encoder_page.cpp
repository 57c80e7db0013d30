#include "app/base/failure.h"
#include "app/files/video_encoder.h"

namespace ghostforce {

bool can_make_videos() noexcept {
  return false;
}

VideoEncoder::VideoEncoder(const OutputFile&, const ClipShape&, const VideoArguments&, std::string_view, VideoWaiting) {
  throw Failure(
      ExitCode::wrong_call,
      "videos are made by ffmpeg, which a page cannot start; save the clip as .png, which needs nothing else");
}

VideoEncoder::~VideoEncoder() = default;

void VideoEncoder::add(const Image&) {}

void VideoEncoder::finish() {}

}  // namespace ghostforce
