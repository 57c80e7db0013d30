// FirmwareImage: the program that a Falcon loses whenever it loses power, read from a file that the person has (it is
// the vendor's property and no part of this program). The device cannot tell a good file from a bad one, so a file is
// taken only if all of it is a well-formed boot table of the device's processor, a TI C28x. Never on the servo thread.
//
// A boot table is 16-bit words, low byte first: the key 0x08AA; eight words of 0; the address where the program begins,
// high word first; then blocks of size [words], address (high word first) and as many words; then a size of 0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace ghostforce {

enum class FirmwareTrouble : std::uint8_t {
  missing,     // there is no such file
  unreadable,  // there is, and it cannot be read, or is no file
  invalid,     // it has been read and is no boot table
};

// what(): complete for a person, what is wrong, at which byte, and what to do.
class FirmwareError : public std::runtime_error {
 public:
  FirmwareError(FirmwareTrouble trouble, const std::string& what_to_say)
      : std::runtime_error(what_to_say), trouble_(trouble) {}
  FirmwareTrouble trouble() const noexcept { return trouble_; }

 private:
  FirmwareTrouble trouble_;
};

struct FirmwareBlock {
  std::uint32_t address = 0;
  std::uint32_t words = 0;

  friend bool operator==(const FirmwareBlock&, const FirmwareBlock&) = default;
};

struct FirmwareImage {
  std::vector<std::uint8_t> bytes;  // as they are sent
  std::uint32_t entry = 0;
  std::vector<FirmwareBlock> blocks;
  std::string sha256;          // of the bytes, 64 lower-case hex digits
  std::filesystem::path path;  // empty: not from a file
};

// More than the processor's memory could hold [bytes].
inline constexpr std::size_t largest_firmware = 65536;

// Pure. Throws FirmwareError(invalid).
FirmwareImage parse_firmware(std::span<const std::uint8_t> bytes);

// Throws FirmwareError; its words begin with the path.
FirmwareImage read_firmware(const std::filesystem::path& path);

// What the file with this SHA-256 is commonly called; empty for all but the four that were ever published. For people
// to compare; any well-formed file is taken.
std::string_view known_firmware(std::string_view sha256) noexcept;

}  // namespace ghostforce
