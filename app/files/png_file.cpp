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
#include <vector>

#include "app/console/quoted.h"
#include "app/files/read_error.h"

namespace ghostforce {
namespace {

// libpng comes back from an error by a jump: no function that calls setjmp() may have anything with a destructor.

// ---- Writing --------------------------------------------------------------------------------------------------------

// Rows are stored as they are: what is drawn is flat for the most part, and the filters that photographs want make such
// files larger (that of the window by a sixth), in three times the time.
bool write_rows(png_structp png, png_infop info, png_uint_32 width, png_uint_32 height, int colour_type,
                const png_byte* pixels, png_textp texts, int text_count) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_IHDR(png, info, width, height, 8, colour_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
  png_set_compression_level(png, 3);
  png_set_text(png, info, texts, text_count);
  png_write_info(png, info);
  const std::size_t row = png_get_rowbytes(png, info);
  for (png_uint_32 y = 0; y < height; ++y) png_write_row(png, pixels + row * y);
  png_write_end(png, info);
  return true;
}

// Called by libpng, through which no exception may fly.
void append(png_structp png, png_bytep data, std::size_t size) {
  bool has_room = true;
  try {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
  } catch (const std::bad_alloc&) {
    has_room = false;
  }
  if (!has_room) png_error(png, "out of memory");
}

// libpng's own would take the string for a file.
void flush(png_structp) {}

// As libpng takes them; they refer to the texts. Those of plain letters need no more than the oldest kind of chunk.
std::vector<png_text> texts_for_libpng(std::span<const PngText> texts) {
  std::vector<png_text> result;
  for (const PngText& text : texts) {
    const bool is_ascii = std::ranges::all_of(text.text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
    png_text one{};
    one.compression = is_ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    // It only reads them.
    one.key = const_cast<char*>(text.keyword.c_str());
    one.text = const_cast<char*>(text.text.c_str());
    (is_ascii ? one.text_length : one.itxt_length) = text.text.size();
    result.push_back(one);
  }
  return result;
}

std::vector<png_byte> with_alpha(const Image& image) {
  std::vector<png_byte> pixels;
  pixels.reserve(4 * image.alpha.size());
  for (std::size_t i = 0; i < image.alpha.size(); ++i) {
    pixels.insert(pixels.end(), {image.rgb[3 * i], image.rgb[3 * i + 1], image.rgb[3 * i + 2], image.alpha[i]});
  }
  return pixels;
}

// ---- Reading --------------------------------------------------------------------------------------------------------

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

std::string png_bytes(const Image& image, std::span<const PngText> texts) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  if (png == nullptr) throw std::bad_alloc();
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &bytes, append, flush);
  const bool is_opaque = image.alpha.empty();
  const std::vector<png_byte> translucent = with_alpha(image);
  std::vector<png_text> words = texts_for_libpng(texts);
  const bool is_written =
      info != nullptr &&
      write_rows(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height),
                 is_opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA,
                 is_opaque ? image.rgb.data() : translucent.data(), words.data(), static_cast<int>(words.size()));
  png_destroy_write_struct(&png, &info);
  if (!is_written) throw std::bad_alloc();  // its sizes are right: it was that
  return bytes;
}

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
