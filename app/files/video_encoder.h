// A video by ffmpeg, which gets the pictures through a pipe while they are made. It is found on PATH and started without
// a shell. A page can start no other program, so there is none. One thread.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/descriptor.h"
#include "app/files/image.h"
#include "app/files/output_file.h"

namespace ghostforce {

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

// Whether there can be any here, if ffmpeg is installed.
bool can_make_videos() noexcept;

// How ffmpeg is to encode and to pack.
using VideoArguments = std::vector<std::string>;

struct VideoWaiting {
  // Called many times a second while ffmpeg is waited for; what it throws ends the wait.
  std::function<void()> look_up;
  // How long ffmpeg may take no data, or take for the end, until it is given up.
  std::chrono::milliseconds patience = std::chrono::minutes(2);
};

// Throws Failure, besides what VideoWaiting::look_up throws: wrong_call where there is no ffmpeg; file_trouble where it
// cannot be started, fails or does nothing for too long, with the last of its own words. It never outlives this.
class VideoEncoder : public ClipEncoder {
 public:
  // ffmpeg writes to the file's part_path(), which must not be empty. `text`: what the file says of itself, UTF-8.
  VideoEncoder(const OutputFile& file, const ClipShape& shape, const VideoArguments& arguments, std::string_view text,
               VideoWaiting waiting);
  ~VideoEncoder() override;

  void add(const Image& image) override;
  void finish() override;

 private:
  void wait_for_end();
  // Of this child only.
  void kill_and_bury() noexcept;
  [[noreturn]] void fail(std::string_view what);

  std::string part_path_;
  VideoWaiting waiting_;
  Descriptor words_;  // what it says
  Descriptor frames_;
  pid_t child_ = -1;  // -1: has been buried
};

}  // namespace ghostforce
