// What a driver does with a link, in as few words as a test can bear: no second tries, no time-outs of its own. For
// tests of the virtual link; allocates only where it says so.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "device/falcon/falcon_link.h"
#include "device/falcon/frame.h"
#include "device/virtual_falcon/injected_fault.h"

namespace ghostforce {

inline constexpr std::int64_t ms = 1'000'000;

inline constexpr VendorRequest dtr_low{0x01, 0x0100, 0};
inline constexpr VendorRequest dtr_high{0x01, 0x0101, 0};
inline constexpr VendorRequest hand_shake_baud{0x03, 0x4138, 0};
inline constexpr VendorRequest boot_baud{0x03, 0x0015, 0};
inline constexpr VendorRequest run_baud{0x03, 0x0002, 0};
inline constexpr VendorRequest format_8n1{0x04, 0x0008, 0};
inline constexpr VendorRequest latency_1{0x09, 1, 0};
inline constexpr VendorRequest latency_16{0x09, 16, 0};

inline InjectedFault injected_fault(std::string_view name) {
  InjectedFault wrong;
  find_injected_fault(name)->add(wrong);
  return wrong;
}

// Until what was begun has been sent.
inline void send(FalconLink& link) {
  while (link.is_sending()) link.wait_until(link.now_ns() + 100 * ms);
}

inline void request(FalconLink& link, const VendorRequest& request) {
  link.request(request);
  send(link);
}

inline void begin_run_time(FalconLink& link) {
  request(link, latency_1);
  request(link, format_8n1);
  request(link, run_baud);
}

// Whether so many bytes come that are these, within a second.
inline bool hears(FalconLink& link, std::span<const std::uint8_t> wanted) {
  std::size_t heard = 0;
  for (const std::int64_t deadline = link.now_ns() + 1000 * ms; heard < wanted.size() && link.now_ns() < deadline;) {
    link.wait_until(deadline);
    std::array<std::uint8_t, 64> bytes{};
    const std::size_t count = link.read(std::span{bytes}.first(std::min(bytes.size(), wanted.size() - heard)));
    if (!std::ranges::equal(std::span{bytes}.first(count), wanted.subspan(heard, count))) return false;
    heard += count;
  }
  return heard == wanted.size();
}

inline bool load_firmware(FalconLink& link, std::span<const std::uint8_t> firmware) {
  constexpr std::array<std::uint8_t, 3> question{0x0A, 0x43, 0x0D};
  constexpr std::array<std::uint8_t, 4> answer{0x0A, 0x44, 0x2C, 0x0D};
  constexpr std::array<std::uint8_t, 1> rate_mark{'A'};
  for (const VendorRequest& setting : {latency_16, format_8n1, hand_shake_baud, dtr_low, dtr_high})
    request(link, setting);
  link.write(question);
  if (!hears(link, answer)) return false;
  request(link, dtr_low);
  request(link, boot_baud);
  link.write(rate_mark);
  if (!hears(link, rate_mark)) return false;
  while (!firmware.empty()) {
    const auto part = firmware.first(std::min<std::size_t>(firmware.size(), 62));
    link.write(part);
    if (!hears(link, part)) return false;
    firmware = firmware.subspan(part.size());
  }
  return true;
}

// One command and its answer; empty if there is none within 20 ms.
inline std::optional<ReplyFrame> exchange(FalconLink& link, const CommandFrame& command) {
  if (!link.write(encode(command))) return std::nullopt;
  FrameReader<ReplyFrame> reader;
  for (const std::int64_t deadline = link.now_ns() + 20 * ms; link.now_ns() < deadline;) {
    link.wait_until(deadline);
    std::array<std::uint8_t, 64> bytes{};
    const std::size_t count = link.read(bytes);
    if (const auto reply = reader.take(std::span{bytes}.first(count))) return reply;
  }
  return std::nullopt;
}

}  // namespace ghostforce
