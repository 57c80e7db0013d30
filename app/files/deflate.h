// Bytes made smaller, and checked, as the PNG format has it. Pure, any thread.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace ghostforce {

// A zlib stream (RFC 1950). `level`: from 1, fast, to 9, small.
std::string deflated(std::string_view bytes, int level);

// CRC-32.
std::uint32_t checksum(std::string_view bytes) noexcept;

}  // namespace ghostforce
