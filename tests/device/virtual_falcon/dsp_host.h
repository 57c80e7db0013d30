// The near end of the cable: a host that asks the far end byte by byte, with a clock of its own. For tests.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "device/falcon/frame.h"
#include "device/virtual_falcon/falcon_dsp.h"
#include "tests/device/virtual_falcon/link_exchange.h"

namespace ghostforce {

using Bytes = std::vector<std::uint8_t>;

inline const Bytes question{0x0A, 0x43, 0x0D};
inline const Bytes answer{0x0A, 0x44, 0x2C, 0x0D};

// A host with a clock that it moves itself.
struct Host {
  explicit Host(const FalconDsp::Options& options = {}) : dsp(options, 0) {}

  void request(const VendorRequest& request) { dsp.control(request, now); }
  void write(const Bytes& bytes) { dsp.receive(bytes, now); }

  // Takes all that comes within so long.
  Bytes listen(std::int64_t duration_ns) {
    Bytes heard;
    const std::int64_t end = now + duration_ns;
    while (dsp.next_due_ns() <= end) {
      now = std::max(now, dsp.next_due_ns());
      std::array<std::uint8_t, 64> packet{};
      const std::size_t size = dsp.take_packet(packet, now);
      if (size == 0) continue;
      EXPECT_GE(size, 2U);
      status = packet[0];
      line_status = packet[1];
      ++packets;
      if (size == 2) ++empty_packets;
      largest = std::max(largest, size);
      heard.insert(heard.end(), packet.begin() + 2, packet.begin() + static_cast<std::ptrdiff_t>(size));
    }
    now = end;
    dsp.advance(now);
    return heard;
  }

  void begin_hand_shake() {
    request(latency_16);
    request(format_8n1);
    request(hand_shake_baud);
    request(dtr_low);
    request(dtr_high);
  }

  Bytes ask() {
    write(question);
    return listen(100 * ms);
  }

  void begin_upload() {
    begin_hand_shake();
    ASSERT_EQ(ask(), answer);
    request(dtr_low);
    request(boot_baud);
    listen(20 * ms);
  }

  // In pieces of 62; returns the echo.
  Bytes upload(const Bytes& firmware) {
    Bytes echo;
    for (std::size_t i = 0; i < firmware.size(); i += 62) {
      write({firmware.begin() + static_cast<std::ptrdiff_t>(i),
             firmware.begin() + static_cast<std::ptrdiff_t>(std::min(i + 62, firmware.size()))});
      const Bytes part = listen(40 * ms);
      echo.insert(echo.end(), part.begin(), part.end());
    }
    return echo;
  }

  void run() {
    request(latency_1);
    request(format_8n1);
    request(run_baud);
  }

  // One command, and what is answered within so long.
  std::optional<ReplyFrame> exchange(const CommandFrame& command, std::int64_t duration_ns = 5 * ms) {
    const FrameBytes bytes = encode(command);
    write({bytes.begin(), bytes.end()});
    return reader.take(listen(duration_ns));
  }

  FalconDsp dsp;
  std::int64_t now = 0;
  std::uint8_t status = 0;
  std::uint8_t line_status = 0;
  int packets = 0;
  int empty_packets = 0;
  std::size_t largest = 0;
  FrameReader<ReplyFrame> reader;
};

}  // namespace ghostforce
