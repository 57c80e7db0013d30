#include "device/falcon_usb/firmware_file.h"

#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

namespace ghostforce {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t key = 0x08AA;
constexpr std::size_t reserved_words = 8;
// The processor's addresses have 22 bits.
constexpr std::uint32_t end_of_memory = 0x400000;

constexpr std::string_view what_to_do =
    "; give a published firmware of the Falcon (the firmware folder of libnifalcon has some)";

std::string hex(std::uint32_t number) {
  std::string digits;
  do {
    digits.insert(digits.begin(), "0123456789ABCDEF"[number % 16]);
    number /= 16;
  } while (number > 0);
  return "0x" + digits;
}

class BootTable {
 public:
  explicit BootTable(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  void read_into(FirmwareImage& image) {
    if (bytes_.empty()) refuse(0, "the file is empty");
    if (bytes_.size() > largest_firmware) {
      refuse(largest_firmware,
             "the file is too long: no Falcon has memory for more than " + std::to_string(largest_firmware) + " bytes");
    }
    if (bytes_.size() % 2 != 0) {
      refuse(bytes_.size() - 1, "half a word is left over; the file must have an even number of bytes");
    }
    if (const std::uint32_t found = word("the key"); found != key) {
      refuse(0, "there is " + hex(found) + " where every boot table has " + hex(key));
    }
    for (std::size_t i = 0; i < reserved_words; ++i) {
      const std::size_t start = at_;
      if (const std::uint32_t found = word("a reserved word"); found != 0) {
        refuse(start, "there is " + hex(found) + " in a reserved word, which must be 0");
      }
    }
    const std::size_t entry_start = at_;
    image.entry = address("the address where the program begins");
    read_blocks(image.blocks);
    const bool is_inside = std::any_of(image.blocks.begin(), image.blocks.end(), [&](const FirmwareBlock& block) {
      return image.entry >= block.address && image.entry - block.address < block.words;
    });
    if (!is_inside) refuse(entry_start, "the program begins at " + hex(image.entry) + ", which is in no block");
  }

 private:
  [[noreturn]] static void refuse(std::size_t byte, const std::string& what) {
    throw FirmwareError(FirmwareTrouble::invalid,
                        "byte " + std::to_string(byte) + ": " + what + std::string(what_to_do));
  }

  std::uint32_t word(const char* of_what) {
    if (bytes_.size() - at_ < 2) refuse(at_, std::string("the file ends before ") + of_what);
    const std::uint32_t low = bytes_[at_];
    const std::uint32_t high = bytes_[at_ + 1];
    at_ += 2;
    return high << 8 | low;
  }

  std::uint32_t address(const char* of_what) {
    const std::uint32_t high = word(of_what);
    return high << 16 | word(of_what);
  }

  void read_blocks(std::vector<FirmwareBlock>& blocks) {
    for (;;) {
      const std::size_t start = at_;
      FirmwareBlock block;
      block.words = word("the size of a block, or the 0 at its end");
      if (block.words == 0) break;
      block.address = address("a block's address");
      if (block.address >= end_of_memory || block.words > end_of_memory - block.address) {
        refuse(start + 2, "a block of " + std::to_string(block.words) + " words at " + hex(block.address) +
                              " lies outside the processor's memory");
      }
      for (const FirmwareBlock& other : blocks) {
        if (block.address < other.address + other.words && other.address < block.address + block.words) {
          refuse(start + 2, "the block at " + hex(block.address) + " overlaps the one at " + hex(other.address));
        }
      }
      if ((bytes_.size() - at_) / 2 < block.words) {
        refuse(start,
               "a block of " + std::to_string(block.words) + " words begins here, but the file ends before it does");
      }
      at_ += std::size_t{2} * block.words;
      blocks.push_back(block);
    }
    if (blocks.empty()) refuse(at_ - 2, "there is no block");
    if (at_ != bytes_.size()) refuse(at_, "the table has ended, but the file continues");
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

std::string sha256_of(std::span<const std::uint8_t> bytes) {
  std::array<std::uint8_t, EVP_MAX_MD_SIZE> digest{};
  unsigned length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1) {
    throw FirmwareError(FirmwareTrouble::unreadable, "libcrypto cannot compute a SHA-256; check its configuration");
  }
  std::string text;
  for (unsigned i = 0; i < length; ++i) {
    text += "0123456789abcdef"[digest[i] / 16];
    text += "0123456789abcdef"[digest[i] % 16];
  }
  return text;
}

std::vector<std::uint8_t> bytes_of_file(const fs::path& path) {
  const auto refuse = [](const std::string& what) { throw FirmwareError(FirmwareTrouble::unreadable, what); };
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) {
    throw FirmwareError(FirmwareTrouble::missing, "there is no such file; check the path");
  }
  if (!fs::status_known(status)) refuse("cannot be examined: " + error.message());
  if (status.type() == fs::file_type::directory) refuse("is a folder; give the file in it");
  // Opening a pipe would wait for its other end.
  if (status.type() != fs::file_type::regular) refuse("is not a regular file; give one");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file.is_open()) {
    refuse("cannot be read: " + std::generic_category().message(errno) + "; check its permissions");
  }
  // One more than may be: parse_firmware() refuses it with the right words, and nobody reads a disk image to its end.
  std::vector<char> read(largest_firmware + 1);
  file.read(read.data(), static_cast<std::streamsize>(read.size()));
  if (file.bad()) refuse("cannot be read: " + std::generic_category().message(errno));
  return {read.begin(), read.begin() + static_cast<std::ptrdiff_t>(file.gcount())};
}

}  // namespace

FirmwareImage parse_firmware(std::span<const std::uint8_t> bytes) {
  FirmwareImage image;
  BootTable(bytes).read_into(image);
  image.bytes.assign(bytes.begin(), bytes.end());
  image.sha256 = sha256_of(bytes);
  return image;
}

FirmwareImage read_firmware(const fs::path& path) {
  try {
    FirmwareImage image = parse_firmware(bytes_of_file(path));
    image.path = path;
    return image;
  } catch (const FirmwareError& error) {
    throw FirmwareError(error.trouble(), path.string() + ": " + error.what());
  }
}

std::string_view known_firmware(std::string_view sha256) noexcept {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> published{{
      {"1119e39c39fab1f37678ea62dfc715b23dd86ee7f13d78f88f707d9f09b896a1", "nvent_firmware.bin"},
      {"b2700d5cd5ca217e48565fb4de5a502a636c53f6e01ebd0cad193e9f84856c6a", "test_firmware.bin"},
      {"ae838730af34b5822c9c3949859b446614af0410730b832cc17a6ad627ea64a4", "novint_T0.bin"},
      {"e0ae3598670fa1c8d9277bd6943c99b3152b97c400c46c1c42c60de77ff4e816", "novint_T2.bin"},
  }};
  for (const auto& [sum, name] : published) {
    if (sum == sha256) return name;
  }
  return {};
}

}  // namespace ghostforce
