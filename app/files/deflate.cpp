#include "app/files/deflate.h"

#include <zlib.h>

#include <new>

namespace ghostforce {
namespace {

const Bytef* bytes_of(std::string_view text) {
  return reinterpret_cast<const Bytef*>(text.data());
}

}  // namespace

std::string deflated(std::string_view bytes, int level) {
  std::string stream(compressBound(bytes.size()), '\0');
  uLongf size = stream.size();
  const int result = compress2(reinterpret_cast<Bytef*>(stream.data()), &size, bytes_of(bytes), bytes.size(), level);
  if (result != Z_OK) throw std::bad_alloc();  // there is room: it was memory
  stream.resize(size);
  return stream;
}

std::uint32_t checksum(std::string_view bytes) noexcept {
  return static_cast<std::uint32_t>(crc32(0, bytes_of(bytes), static_cast<uInt>(bytes.size())));
}

}  // namespace ghostforce
