#include "app/png_file.h"

#include <fmt/format.h>
#include <png.h>

#include <cerrno>
#include <csetjmp>
#include <cstddef>
#include <cstring>
#include <memory>
#include <new>

#include "app/failure.h"

#define STBI_ONLY_PNG
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>

namespace ghostforce {
namespace {

// libpng comes back from an error by a jump: nothing in here may have a destructor. Rows are stored as they are: what
// is drawn is flat for the most part, and the filters that photographs want make such files larger (that of the window
// by a sixth), in three times the time.
bool write_rows(png_structp png, png_infop info, const Image& image) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  const auto width = static_cast<png_uint_32>(image.width);
  png_set_IHDR(png, info, width, static_cast<png_uint_32>(image.height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
  png_set_compression_level(png, 3);
  png_write_info(png, info);
  for (int y = 0; y < image.height; ++y) {
    png_write_row(png, image.rgb.data() + 3U * width * static_cast<std::size_t>(y));
  }
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

}  // namespace

std::string png_bytes(const Image& image) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  if (png == nullptr) throw std::bad_alloc();
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &bytes, append, flush);
  const bool is_written = info != nullptr && write_rows(png, info, image);
  png_destroy_write_struct(&png, &info);
  if (!is_written) throw std::bad_alloc();  // its sizes are right: it was that
  return bytes;
}

Image read_png(const std::string& path) {
  errno = 0;
  Image image;
  int channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load(path.c_str(), &image.width, &image.height, &channels, 3), stbi_image_free);
  if (!pixels) {
    throw Failure(ExitCode::file_trouble, fmt::format("{}: cannot be read as a PNG picture: {}", path,
                                                      errno != 0 ? std::strerror(errno) : stbi_failure_reason()));
  }
  const std::size_t size = 3U * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  image.rgb.assign(pixels.get(), pixels.get() + size);
  return image;
}

}  // namespace ghostforce
