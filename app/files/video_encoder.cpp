#include "app/files/video_encoder.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/files/tool_process.h"

namespace ghostforce {
namespace {

constexpr int glance_ms = 50;

std::vector<std::string> words_for(const std::string& path, const ClipShape& shape, const VideoArguments& arguments,
                                   std::string_view text) {
  std::vector<std::string> words{"ffmpeg",
                                 "-nostdin",
                                 "-hide_banner",
                                 "-loglevel",
                                 "error",
                                 "-f",
                                 "rawvideo",
                                 "-pixel_format",
                                 "rgba",
                                 "-video_size",
                                 fmt::format("{}x{}", shape.width, shape.height),
                                 "-framerate",
                                 std::to_string(shape.frames_per_second),
                                 "-i",
                                 "pipe:0"};
  if (!text.empty()) words.insert(words.end(), {"-metadata", fmt::format("comment={}", text)});
  words.insert(words.end(), arguments.begin(), arguments.end());
  words.insert(words.end(), {"-y", "file:" + path});
  return words;
}

// The last lines of what it has said, each on a line of its own.
std::string last_words(int descriptor) {
  constexpr off_t longest = 2000;
  constexpr int most_lines = 5;
  const off_t length = lseek(descriptor, 0, SEEK_END);
  std::array<char, longest> bytes{};
  const off_t begin = std::max<off_t>(0, length - longest);
  const ssize_t count = length > 0 ? pread(descriptor, bytes.data(), bytes.size(), begin) : 0;
  std::string_view text(bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(0, count)));
  std::string lines;
  for (int i = 0; i < most_lines && !text.empty(); ++i) {
    while (text.ends_with('\n')) text.remove_suffix(1);
    const std::size_t before = text.rfind('\n') + 1;  // 0 where there is none
    if (before < text.size()) lines = fmt::format("\n  {}", quoted_text(text.substr(before), longest)) + lines;
    text = text.substr(0, before);
  }
  return lines;
}

std::string as_rgba(const Image& image) {
  std::string bytes;
  bytes.reserve(image.rgb.size() / 3 * 4);
  for (auto pixel = image.rgb.begin(); pixel != image.rgb.end(); pixel += 3) {
    bytes.append(pixel, pixel + 3);
    bytes += '\xFF';
  }
  return bytes;
}

}  // namespace

bool can_make_videos() noexcept {
  return true;
}

VideoEncoder::VideoEncoder(const OutputFile& file, const ClipShape& shape, const VideoArguments& arguments,
                           std::string_view text, VideoWaiting waiting)
    : part_path_(file.part_path()), waiting_(std::move(waiting)), words_(memfd_create("words", MFD_CLOEXEC)) {
  std::array<int, 2> ends{-1, -1};
  if (words_.number() < 0 || pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw Failure(ExitCode::file_trouble, fmt::format("ffmpeg cannot be started: {}", reason_of(errno)));
  }
  const Descriptor read_end(ends[0]);
  frames_.reset(ends[1]);
  const int error = start_tool(words_for(part_path_, shape, arguments, text),
                               {.in = read_end.number(), .err = words_.number()}, child_);
  if (error == 0) {
    fcntl(frames_.number(), F_SETFL, O_NONBLOCK);
    return;
  }
  child_ = -1;
  if (error == ENOENT) {
    throw Failure(ExitCode::wrong_call,
                  "videos are made by ffmpeg, and there is none on the PATH; install the package ffmpeg, or save the "
                  "clip as .png, which needs nothing else");
  }
  throw Failure(ExitCode::file_trouble,
                fmt::format("ffmpeg cannot be started: {}", std::generic_category().message(error)));
}

VideoEncoder::~VideoEncoder() {
  kill_and_bury();
}

void VideoEncoder::add(const Image& image) {
  const std::string bytes = as_rgba(image);
  std::string_view rest = bytes;
  auto last_progress = std::chrono::steady_clock::now();
  while (!rest.empty()) {
    waiting_.look_up();
    const ssize_t written = write(frames_.number(), rest.data(), rest.size());
    if (written > 0) {
      rest.remove_prefix(static_cast<std::size_t>(written));
      last_progress = std::chrono::steady_clock::now();
      continue;
    }
    // It reads no more: its end tells why.
    if (written < 0 && errno == EPIPE) {
      wait_for_end();
      fail("has stopped before the last picture");
    }
    if (written < 0 && errno != EAGAIN && errno != EINTR) fail("takes no pictures");
    if (std::chrono::steady_clock::now() - last_progress > waiting_.patience) fail("takes no more pictures");
    pollfd room{frames_.number(), POLLOUT, 0};
    poll(&room, 1, glance_ms);
  }
}

void VideoEncoder::finish() {
  frames_.reset();
  wait_for_end();
  std::error_code error;
  if (std::filesystem::file_size(part_path_, error) == 0 || error) fail("has written nothing");
}

// Throws Failure where it has failed.
void VideoEncoder::wait_for_end() {
  const auto began = std::chrono::steady_clock::now();
  for (;;) {
    int status = 0;
    const pid_t ended = waitpid(child_, &status, WNOHANG);
    if (ended == child_) {
      child_ = -1;
      if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
      fail(WIFEXITED(status) ? fmt::format("has failed with exit code {}", WEXITSTATUS(status))
                             : fmt::format("was ended by signal {}", WTERMSIG(status)));
    }
    waiting_.look_up();
    if (std::chrono::steady_clock::now() - began > waiting_.patience) fail("does not come to an end");
    poll(nullptr, 0, glance_ms);
  }
}

void VideoEncoder::kill_and_bury() noexcept {
  if (child_ < 0) return;
  kill(child_, SIGKILL);
  while (waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
  }
  child_ = -1;
}

void VideoEncoder::fail(std::string_view what) {
  kill_and_bury();
  const std::string words = last_words(words_.number());
  throw Failure(ExitCode::file_trouble,
                fmt::format("no video was made: ffmpeg {}{}{}\nThe clip can be saved as .png without it.", what,
                            words.empty() ? "" : "; it said last:", words));
}

}  // namespace ghostforce
