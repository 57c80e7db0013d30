#include "app/files/deflate.h"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <new>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace ghostforce {

std::string deflated(std::string_view bytes, int level) {
  constexpr int least_quality = 5;
  // It only reads them.
  auto* const data = reinterpret_cast<unsigned char*>(const_cast<char*>(bytes.data()));
  int size = 0;
  const std::unique_ptr<unsigned char, void (*)(void*)> stream(
      stbi_zlib_compress(data, static_cast<int>(bytes.size()), &size, std::max(level, least_quality)), std::free);
  if (!stream) throw std::bad_alloc();
  return {reinterpret_cast<const char*>(stream.get()), static_cast<std::size_t>(size)};
}

std::uint32_t checksum(std::string_view bytes) noexcept {
  auto* const data = reinterpret_cast<unsigned char*>(const_cast<char*>(bytes.data()));
  return stbiw__crc32(data, static_cast<int>(bytes.size()));
}

}  // namespace ghostforce
