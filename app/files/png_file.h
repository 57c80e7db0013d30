// PNG files: the same image gives the same bytes. Any thread.
#pragma once

#include <memory>
#include <string>

#include "app/files/image.h"

namespace ghostforce {

// The whole file's content.
std::string png_bytes(const Image& image);

// A PNG file that is open. Its size is known at once, so that nobody has to decode a picture that is too large. Each
// function throws ReadError(unreadable) where the file cannot be read, is no PNG, or is damaged: each checksum of the
// format is looked at.
class PngFile {
 public:
  explicit PngFile(const std::string& path);
  ~PngFile();

  int width() const noexcept;  // [px]
  int height() const noexcept;

  // The stored values, eight bits each: a gamma or a colour profile in the file changes none. Once only.
  Image read();

 private:
  struct Reading;
  std::unique_ptr<Reading> reading_;
};

}  // namespace ghostforce
