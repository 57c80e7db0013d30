#include "app/files/png_file.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csetjmp>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <new>

#include "app/base/quoted.h"
#include "app/files/read_error.h"

namespace ghostforce {
namespace {

// libpng comes back from an error by a jump: no function that calls setjmp() may have anything with a destructor.

using Words = std::array<char, 256>;

// Called by libpng.
[[noreturn]] void keep_words(png_structp png, png_const_charp words) {
  Words& kept = *static_cast<Words*>(png_get_error_ptr(png));
  std::snprintf(kept.data(), kept.size(), "%s", words);
  png_longjmp(png, 1);
}

void ignore_words(png_structp, png_const_charp) {}

void read_bytes(png_structp png, png_bytep data, std::size_t size) {
  auto* const file = static_cast<std::FILE*>(png_get_io_ptr(png));
  errno = 0;
  if (std::fread(data, 1, size, file) == size) return;
  png_error(png, std::ferror(file) != 0 ? std::strerror(errno) : "the file ends too early");
}

bool read_header(png_structp png, png_infop info, PngWords words) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  // A wrong checksum is an error wherever it stands, and so is what libpng would otherwise overlook.
  png_set_crc_action(png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
  png_set_benign_errors(png, 0);
  // Words, profiles and dates are skipped: they change no pixel, and many programs write them slightly wrong.
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
  if (words == PngWords::read) {
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_AS_DEFAULT,
                                reinterpret_cast<const png_byte*>("tEXt\0zTXt\0iTXt\0"), 3);
  }
  png_read_info(png, info);
  return true;
}

// Whatever the file holds, as red, green, blue, and alpha where it has one, eight bits each. Returns how many bytes a
// pixel has then; 0: an error.
std::size_t unify(png_structp png, png_infop info) {
  if (setjmp(png_jmpbuf(png)) != 0) return 0;
  png_set_expand(png);
  png_set_scale_16(png);
  png_set_gray_to_rgb(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  return png_get_channels(png, info);
}

bool read_rows(png_structp png, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_read_image(png, rows);
  png_read_end(png, nullptr);
  return true;
}

}  // namespace

struct PngFile::Reading {
  std::string path;
  Words words{};
  std::FILE* file = nullptr;
  png_structp png = nullptr;
  png_infop info = nullptr;

  ~Reading() {
    png_destroy_read_struct(&png, &info, nullptr);
    if (file != nullptr) std::fclose(file);
  }

  void require(bool is_good, const char* why) const {
    if (is_good) return;
    throw ReadError(ReadError::Kind::unreadable, {{.file = quoted_text(path, longest_path),
                                                   .what = fmt::format("cannot be read as a PNG picture: {}", why)}});
  }
};

PngFile::PngFile(const std::string& path, PngWords words) : reading_(std::make_unique<Reading>()) {
  Reading& reading = *reading_;
  reading.path = path;
  reading.file = std::fopen(path.c_str(), "rbe");
  reading.require(reading.file != nullptr, std::strerror(errno));
  reading.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading.words, keep_words, ignore_words);
  if (reading.png != nullptr) reading.info = png_create_info_struct(reading.png);
  if (reading.info == nullptr) throw std::bad_alloc();
  png_set_read_fn(reading.png, reading.file, read_bytes);
  reading.require(read_header(reading.png, reading.info, words), reading.words.data());
}

PngFile::~PngFile() = default;

int PngFile::width() const noexcept {
  return static_cast<int>(png_get_image_width(reading_->png, reading_->info));
}

int PngFile::height() const noexcept {
  return static_cast<int>(png_get_image_height(reading_->png, reading_->info));
}

std::vector<PngText> PngFile::texts() const {
  png_textp found = nullptr;
  const int count = png_get_text(reading_->png, reading_->info, &found, nullptr);
  std::vector<PngText> texts;
  for (int i = 0; i < count; ++i) texts.push_back({found[i].key, found[i].text});
  return texts;
}

Image PngFile::read() {
  Image image{width(), height(), {}};
  const std::size_t channels = unify(reading_->png, reading_->info);
  reading_->require(channels != 0, reading_->words.data());
  const auto columns = static_cast<std::size_t>(image.width);
  std::vector<png_byte> pixels(channels * columns * static_cast<std::size_t>(image.height));
  std::vector<png_bytep> rows;
  for (std::size_t begin = 0; begin < pixels.size(); begin += channels * columns) rows.push_back(&pixels[begin]);
  reading_->require(read_rows(reading_->png, rows.data()), reading_->words.data());
  if (channels == 3) {
    image.rgb = std::move(pixels);
    return image;
  }
  image.rgb.reserve(pixels.size() / 4 * 3);
  image.alpha.reserve(pixels.size() / 4);
  for (auto pixel = pixels.begin(); pixel != pixels.end(); pixel += 4) {
    image.rgb.insert(image.rgb.end(), pixel, pixel + 3);
    image.alpha.push_back(pixel[3]);
  }
  if (std::ranges::all_of(image.alpha, [](png_byte alpha) { return alpha == 255; })) image.alpha.clear();
  return image;
}

}  // namespace ghostforce
