// BootLoader: puts the firmware into a Falcon, which forgets it whenever it loses power. The loader in the device's ROM
// echoes every byte; that echo is the only proof that it arrived. One attempt takes 3 s; the first one after power-up
// often fails, as everybody who has written such a driver has found, so the driver tries again.
//
// update() does what can be done now and never waits, allocates or throws. The driver's thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "device/falcon/link_script.h"

namespace ghostforce {

enum class BootFault : std::uint8_t {
  none,
  no_handshake,    // the device does not answer the call to its boot loader
  no_baud_answer,  // the boot loader does not find the upload's baud rate
  echo_missing,    // a byte did not come back
  echo_differs,    // another byte came back
};

class BootLoader {
 public:
  static constexpr std::size_t chunk_size = 62;  // its echo fits into one packet
  static constexpr int handshakes = 10;          // in one attempt
  static constexpr int longest_echo_ms = 500;    // of a chunk

  BootLoader() noexcept : BootLoader(std::span<const std::uint8_t>()) {}
  // A validated image (firmware_file.h), which must outlive the loader.
  explicit BootLoader(std::span<const std::uint8_t> firmware) noexcept;

  LinkProgress update(FalconLink& link) noexcept;

  BootFault fault() const noexcept { return fault_; }
  std::size_t bytes_echoed() const noexcept { return echoed_; }  // of the firmware; where a fault occurred

 private:
  enum class Stage : std::uint8_t { set_up, handshake, baud, upload, done, failed };

  void enter(Stage stage) noexcept;
  LinkProgress fail(BootFault fault) noexcept;
  LinkProgress upload(FalconLink& link) noexcept;

  std::span<const std::uint8_t> firmware_;
  Stage stage_ = Stage::set_up;
  LinkScript link_script_;
  int handshakes_left_ = handshakes;
  std::size_t sent_ = 0;
  std::size_t echoed_ = 0;
  std::int64_t chunk_began_ns_ = 0;
  BootFault fault_ = BootFault::none;
};

}  // namespace ghostforce
