// A firmware file: one that is taken is what the processor's boot loader takes, and arrives there byte for byte.
#include <vector>

#include "device/falcon/boot_loader.h"
#include "device/falcon_usb/firmware_file.h"
#include "device/virtual_falcon/virtual_link.h"
#include "tests/fuzz/fuzz.h"

using namespace ghostforce;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FirmwareImage image;
  try {
    image = parse_firmware({data, size});
  } catch (const FirmwareError& error) {
    require(error.trouble() == FirmwareTrouble::invalid && *error.what() != '\0', "it is said what is wrong");
    return 0;
  }
  require(image.bytes == std::vector<std::uint8_t>(data, data + size), "it is sent as it is");
  require(image.sha256.size() == 64, "a SHA-256 has 64 digits");
  std::size_t words = 11 + 1;  // key, reserved and entry; the 0 at the end
  for (const FirmwareBlock& block : image.blocks) {
    require(block.words > 0 && block.address + block.words <= 0x400000, "a block lies in the processor's memory");
    words += 3 + block.words;
  }
  require(2 * words == size, "the blocks are all that there is");

  VirtualLink link({.clock = VirtualLink::Clock::stepped});
  require(link.open() == LinkFault::none, "the virtual Falcon is plugged in");
  BootLoader loader(image.bytes);
  LinkProgress progress = LinkProgress::running;
  const std::int64_t latest_ns = link.now_ns() + 60'000'000'000;
  while (progress == LinkProgress::running && link.now_ns() < latest_ns) {
    progress = loader.update(link);
    link.wait_until(link.now_ns() + 10'000'000);
  }
  require(progress == LinkProgress::done && loader.bytes_echoed() == size, "the device echoes every byte");
  require(link.device().runs_firmware(), "and runs what it was given");
  return 0;
}
