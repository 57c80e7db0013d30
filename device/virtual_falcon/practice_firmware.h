// Bytes in the form of a Falcon's firmware (a boot table of TI's C28x, as its boot loader takes it) with nothing to run
// in them: what a virtual Falcon is given, which takes any. Nobody here may pass on a real one.
#pragma once

#include <cstdint>
#include <vector>

namespace ghostforce {

// Two blocks; the larger one has `words` words, so that the whole is as long as a test wants it.
inline std::vector<std::uint8_t> practice_firmware(unsigned words = 100) {
  std::vector<std::uint8_t> bytes;
  const auto put = [&](unsigned word) {
    bytes.push_back(static_cast<std::uint8_t>(word));
    bytes.push_back(static_cast<std::uint8_t>(word >> 8U));
  };
  put(0x08AA);
  for (int i = 0; i < 8; ++i) put(0);
  // The address where it begins, high word first.
  put(0x003F);
  put(0x8002);
  // Size, address, words.
  put(words);
  put(0x003F);
  put(0x8002);
  for (unsigned i = 0; i < words; ++i) put((i * 0x9E37U) & 0xFFFFU);
  put(2);
  put(0x003F);
  put(0x8000);
  put(0x0040);
  put(0x8002);
  put(0);
  return bytes;
}

}  // namespace ghostforce
