// PNG files that are read. Any thread.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/files/image.h"
#include "app/files/png_writer.h"

namespace ghostforce {

// Whether the texts in a file are read. Many programs write them slightly wrong, and no pixel depends on them.
enum class PngWords : std::uint8_t { skipped, read };

// A PNG file that is open. Its size is known at once, so that nobody has to decode a picture that is too large. Each
// function throws ReadError(unreadable) where the file cannot be read, is no PNG, or is damaged: each checksum of the
// format is looked at.
class PngFile {
 public:
  explicit PngFile(const std::string& path, PngWords words = PngWords::skipped);
  ~PngFile();

  int width() const noexcept;  // [px]
  int height() const noexcept;

  // Those that stand before the pixels, in their order; none where they are skipped.
  std::vector<PngText> texts() const;

  // The stored values, eight bits each: a gamma or a colour profile in the file changes none. Once only.
  Image read();

 private:
  struct Reading;
  std::unique_ptr<Reading> reading_;
};

}  // namespace ghostforce
