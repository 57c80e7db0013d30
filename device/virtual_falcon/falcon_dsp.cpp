#include "device/virtual_falcon/falcon_dsp.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ghostforce {
namespace {

constexpr double hand_shake_baud = 9600.0;
constexpr double boot_baud = 3e6 / 21;
constexpr double run_baud = 1.5e6;

constexpr std::array<std::uint8_t, 3> question{0x0A, 0x43, 0x0D};
constexpr std::array<std::uint8_t, 4> answer{0x0A, 0x44, 0x2C, 0x0D};
constexpr std::uint8_t rate_mark = 'A';
constexpr unsigned boot_key = 0x08AA;

// Where the arms stood when a firmware that has run before this began to count: nothing that a driver may build on.
constexpr std::array<int, 3> unknown_zeros{311, -427, 168};

// After the change to the boot loader's rate.
constexpr std::int64_t cts_delay_ns = 5'000'000;

// With split packets: so many bytes in each, and so long from one to the next.
constexpr std::size_t split_payload = 5;
constexpr std::int64_t split_gap_ns = 100'000;
// With joined packets: so many times the latency.
constexpr int joined_latencies = 4;
// A '<' among them, for whom that is enough.
constexpr std::array<std::uint8_t, 5> garbage_bytes{0x00, '<', 'A', 0x13, 0xFF};

// Of an answer: what is changed in it. The numbers are beyond what any arm can reach.
constexpr std::array<std::int16_t, 3> impossible_encoders{16000, -16000, 16000};
constexpr int wrong_bit = 0x0100;
constexpr std::size_t malformed_byte = 6;

namespace chip_code {
constexpr std::uint8_t reset = 0x00;
constexpr std::uint8_t modem_control = 0x01;
constexpr std::uint8_t baud = 0x03;
constexpr std::uint8_t format = 0x04;
constexpr std::uint8_t latency = 0x09;
constexpr std::uint8_t status = 0x01;
constexpr std::uint8_t line_status = 0x60;
constexpr std::uint8_t line_overrun = 0x02;
constexpr std::uint16_t format_8n1 = 0x0008;
}  // namespace chip_code

}  // namespace

double baud_of(std::uint16_t value, std::uint16_t index) noexcept {
  constexpr double base = 3e6;
  // By the code in bits 15, 14 and, as the highest, the index.
  constexpr std::array<int, 8> eighths{0, 4, 2, 1, 3, 5, 6, 7};
  const unsigned whole = value & 0x3FFFU;
  const unsigned code = (value >> 14U) | ((index & 1U) << 2U);
  if (whole == 0 && code == 0) return base;
  if (whole == 1 && code == 0) return base / 1.5;
  return base / std::max(whole + eighths[code] / 8.0, 1.0);
}

FalconDsp::FalconDsp(const Options& options, std::int64_t now_ns) noexcept
    : options_(options), last_packet_ns_(now_ns) {
  if (!options.starts_with_firmware) return;
  stage_ = Stage::firmware;
  if (options.starts_homed) {
    homed_ = ReplyFrame::homed;
  } else {
    zeros_ = unknown_zeros;
  }
}

void FalconDsp::control(const VendorRequest& request, std::int64_t now_ns) noexcept {
  advance(now_ns);
  switch (request.request) {
    case chip_code::reset:
      // 1: what is there for the host; 2: what came from it; 0: both, and more.
      if (request.value != 2) {
        while (!to_host_.empty() && to_host_.front().at_ns <= now_ns) to_host_.pop();
      }
      if (request.value != 1) {
        to_dsp_.clear();
        line_out_free_ns_ = now_ns;
      }
      if (request.value == 0) set_dtr(false);
      break;
    case chip_code::modem_control:
      // The high byte says which of the lines is meant; RTS leads nowhere.
      if ((request.value & 0x0100U) != 0) set_dtr((request.value & 0x0001U) != 0);
      break;
    case chip_code::baud:
      set_baud(request.value, request.index, now_ns);
      break;
    case chip_code::format:
      chip_.is_8n1 = request.value == chip_code::format_8n1;
      break;
    case chip_code::latency:
      chip_.latency_ns = std::clamp<std::int64_t>(request.value, 1, 255) * 1'000'000;
      break;
    default:
      break;
  }
}

void FalconDsp::receive(std::span<const std::uint8_t> bytes, std::int64_t now_ns) noexcept {
  advance(now_ns);
  for (const std::uint8_t byte : bytes.first(std::min(bytes.size(), to_dsp_.room()))) {
    line_out_free_ns_ = std::max(line_out_free_ns_, now_ns) + byte_time_ns();
    to_dsp_.push({line_out_free_ns_, byte});
  }
}

std::int64_t FalconDsp::next_due_ns() const noexcept {
  std::int64_t due = packet_due_ns();
  // Bytes that have yet to reach the DSP bring the packet forward only where their answers may fill one.
  if (!to_dsp_.empty() && to_host_.size() + to_dsp_.size() >= payload_limit()) {
    due = std::min(due, to_dsp_.front().at_ns);
  }
  return due;
}

std::size_t FalconDsp::take_packet(std::span<std::uint8_t, packet_size> into, std::int64_t now_ns) noexcept {
  advance(now_ns);
  const std::int64_t due = packet_due_ns();
  if (due > now_ns) return 0;
  // The timer is not let down by a host that looks a little late; one that was away for long gets no backlog.
  last_packet_ns_ = now_ns - due < chip_.latency_ns ? due : now_ns;
  into[0] = static_cast<std::uint8_t>(chip_code::status | (cts_from_ns_ != 0 && cts_from_ns_ <= now_ns ? cts : 0));
  into[1] = static_cast<std::uint8_t>(chip_code::line_status | (overrun_ ? chip_code::line_overrun : 0));
  overrun_ = false;
  std::size_t size = status_size;
  const std::size_t limit = status_size + payload_limit();
  while (size < limit && !to_host_.empty() && to_host_.front().at_ns <= now_ns) into[size++] = to_host_.pop().byte;
  return size;
}

void FalconDsp::advance(std::int64_t now_ns) noexcept {
  while (!to_dsp_.empty() && to_dsp_.front().at_ns <= now_ns) {
    const Timed timed = to_dsp_.pop();
    hear(timed.byte, timed.at_ns);
  }
  if (options_.watchdog_ms > 0 && now_ns - last_frame_ns_ >= options_.watchdog_ms * std::int64_t{1'000'000}) {
    motors_ = {};
  }
}

void FalconDsp::inject(const InjectedFault& wrong) noexcept {
  if (wrong == wrong_) return;
  wrong_ = wrong;
  replies_to_lose_ = wrong.lost_replies;
  echo_is_to_fail_ = wrong.echo != EchoFault::none;
  replies_ = 0;
  noise_to_come_ = wrong.noise_bytes;
  if (wrong.forgets_home) homed_ = 0;
  if (wrong.power_lost || wrong.power_blinks) reset(Stage::idle);
  if (wrong.chip_resets || wrong.is_off_the_cable()) power_up_chip(last_packet_ns_);
}

// --- The chip --------------------------------------------------------------------------------------------------------

void FalconDsp::power_up_chip(std::int64_t now_ns) noexcept {
  chip_ = {};
  cts_from_ns_ = 0;
  to_dsp_.clear();
  to_host_.clear();
  line_out_free_ns_ = line_in_free_ns_ = last_packet_ns_ = now_ns;
}

void FalconDsp::set_dtr(bool high) noexcept {
  if (high == chip_.dtr) return;
  chip_.dtr = high;
  if (wrong_.power_lost) return;
  if (high) {
    reset(Stage::hand_shake);
  } else {
    stage_ = stage_ == Stage::shaken ? Stage::boot_loader : Stage::idle;
  }
}

void FalconDsp::set_baud(std::uint16_t value, std::uint16_t index, std::int64_t now_ns) noexcept {
  chip_.baud = baud_of(value, index);
  send_again_from(now_ns);
  if (stage_ == Stage::boot_loader && line_is_at(boot_baud) && !wrong_.without_cts) {
    cts_from_ns_ = now_ns + cts_delay_ns;
  }
}

// As far as a serial line forgives.
bool FalconDsp::line_is_at(double rate) const noexcept {
  return chip_.is_8n1 && std::abs(chip_.baud - rate) < 0.03 * rate;
}

// A start bit, eight, and a stop bit.
std::int64_t FalconDsp::byte_time_ns() const noexcept {
  return std::llround(10e9 / chip_.baud);
}

// What still waits in the chip when its rate changes goes out at the new one.
void FalconDsp::send_again_from(std::int64_t now_ns) noexcept {
  line_out_free_ns_ = now_ns;
  for (std::size_t i = to_dsp_.size(); i > 0; --i) {
    line_out_free_ns_ += byte_time_ns();
    to_dsp_.push({line_out_free_ns_, to_dsp_.pop().byte});
  }
}

// What a receiver makes of a byte that was sent at another rate or in another format.
std::uint8_t FalconDsp::next_noise() noexcept {
  noise_ = noise_ * 1664525U + 1013904223U;
  return static_cast<std::uint8_t>(noise_ >> 24U);
}

std::size_t FalconDsp::payload_limit() const noexcept {
  return wrong_.split_packets ? split_payload : packet_size - status_size;
}

std::int64_t FalconDsp::packet_due_ns() const noexcept {
  std::int64_t due = last_packet_ns_ + chip_.latency_ns * (wrong_.joined_packets ? joined_latencies : 1);
  if (const std::size_t full = payload_limit(); to_host_.size() >= full) {
    const std::int64_t gap = wrong_.split_packets ? split_gap_ns : 0;
    due = std::min(due, std::max(to_host_[full - 1].at_ns, last_packet_ns_ + gap));
  }
  return due;
}

void FalconDsp::say(std::uint8_t byte, std::int64_t now_ns) noexcept {
  if (to_host_.room() == 0) {
    overrun_ = true;
    return;
  }
  line_in_free_ns_ = std::max(line_in_free_ns_, now_ns) + byte_time_ns();
  to_host_.push({line_in_free_ns_, byte});
}

// --- The DSP ---------------------------------------------------------------------------------------------------------

// What was in its memory is gone.
void FalconDsp::reset(Stage stage) noexcept {
  stage_ = stage;
  matched_ = 0;
  table_ = {};
  commands_.reset();
  last_command_ = {};
  motors_ = {};
  lights_ = 0;
  homed_ = 0;
  cts_from_ns_ = 0;
}

void FalconDsp::hear(std::uint8_t byte, std::int64_t at_ns) noexcept {
  if (wrong_.power_lost || wrong_.silence) return;
  switch (stage_) {
    case Stage::idle:
      break;
    case Stage::hand_shake:
    case Stage::shaken:
      hear_hand_shake(line_is_at(hand_shake_baud) ? byte : next_noise(), at_ns);
      break;
    case Stage::boot_loader:
      if (byte != rate_mark || !line_is_at(boot_baud)) break;
      if (wrong_.leading_13) say(0x13, at_ns);
      say(byte, at_ns);
      table_ = {};
      stage_ = Stage::boot_table;
      break;
    case Stage::boot_table:
      hear_boot_table(line_is_at(boot_baud) ? byte : next_noise(), at_ns);
      break;
    case Stage::firmware: {
      const std::uint8_t heard = line_is_at(run_baud) ? byte : next_noise();
      if (const auto frame = commands_.take({&heard, 1})) hear_frame(*frame, at_ns);
      break;
    }
  }
}

void FalconDsp::hear_hand_shake(std::uint8_t byte, std::int64_t at_ns) noexcept {
  if (byte != question[matched_]) matched_ = 0;
  if (byte == question[matched_]) ++matched_;
  if (matched_ < question.size()) return;
  matched_ = 0;
  if (replies_to_lose_ > 0) {
    --replies_to_lose_;
    return;
  }
  if (wrong_.leading_00) say(0x00, at_ns);
  for (const std::uint8_t part : answer) say(part, at_ns);
  stage_ = Stage::shaken;
}

void FalconDsp::hear_boot_table(std::uint8_t byte, std::int64_t at_ns) noexcept {
  if (wrong_.upload_stops > 0 && table_.bytes >= wrong_.upload_stops) return;
  const bool fails = echo_is_to_fail_ && table_.bytes == wrong_.echo_byte;
  if (fails && wrong_.echo != EchoFault::corrupted_always) echo_is_to_fail_ = false;
  if (!fails) {
    say(byte, at_ns);
  } else if (wrong_.echo != EchoFault::lost_once) {
    say(static_cast<std::uint8_t>(byte ^ 0x04U), at_ns);
  }
  table_.take(byte);
  if (table_.part == BootTable::Part::refused) stage_ = Stage::idle;
  if (table_.part != BootTable::Part::done) return;
  stage_ = Stage::firmware;
  last_frame_ns_ = at_ns;
  // Nobody knows where the arms stand now: this is where counting begins.
  zeros_ = encoders_;
}

void FalconDsp::BootTable::take(std::uint8_t byte) noexcept {
  if (bytes++ % 2 == 0) {
    low = byte;
  } else {
    take_word(low | static_cast<unsigned>(byte) << 8U);
  }
}

void FalconDsp::BootTable::take_word(unsigned word) noexcept {
  --words_left;
  switch (part) {
    case Part::key:
      if (word == boot_key) {
        go_on(Part::reserved, 8);
      } else {
        part = Part::refused;
      }
      break;
    case Part::reserved:
      if (words_left == 0) go_on(Part::entry, 2);
      break;
    case Part::entry:
    case Part::data:
      if (words_left == 0) go_on(Part::size, 1);
      break;
    case Part::size:
      block = word;
      if (word == 0) {
        part = Part::done;
      } else {
        go_on(Part::address, 2);
      }
      break;
    case Part::address:
      if (words_left == 0) go_on(Part::data, block);
      break;
    case Part::done:
    case Part::refused:
      break;
  }
}

void FalconDsp::BootTable::go_on(Part next, unsigned words) noexcept {
  part = next;
  words_left = words;
}

// --- The firmware ----------------------------------------------------------------------------------------------------

void FalconDsp::hear_frame(const CommandFrame& frame, std::int64_t at_ns) noexcept {
  last_command_ = frame;
  last_frame_ns_ = at_ns;
  motors_ = frame.motors;
  if (wrong_.motors_are_reversed) {
    for (std::int16_t& motor : motors_) motor = static_cast<std::int16_t>(-motor);
  }
  lights_ = frame.info & (CommandFrame::green | CommandFrame::blue | CommandFrame::red);
  home(at_ns);
  if (!wrong_.frozen_encoders) {
    for (std::size_t i = 0; i < reported_.size(); ++i) {
      reported_[i] =
          static_cast<std::int16_t>(std::clamp<int>(encoders_[i] - zeros_[i], std::numeric_limits<std::int16_t>::min(),
                                                    std::numeric_limits<std::int16_t>::max()));
    }
  }
  reply(at_ns);
}

void FalconDsp::reply(std::int64_t at_ns) noexcept {
  const ReplyFault fault = fault_of_reply();
  const std::int64_t answer_ns = at_ns + wrong_.reply_delay_ns + replies_ * wrong_.reply_creep_ns;
  ReplyFrame frame{reported_, static_cast<std::uint8_t>(homed_ | buttons_)};
  if (fault == ReplyFault::impossible) frame.encoders = impossible_encoders;
  if (fault == ReplyFault::wrong) frame.encoders[0] = static_cast<std::int16_t>(frame.encoders[0] ^ wrong_bit);
  FrameBytes bytes = encode(frame);
  if (fault == ReplyFault::malformed) bytes[malformed_byte] ^= 0x20U;
  for (; noise_to_come_ > 0; --noise_to_come_) {
    say(garbage_bytes[static_cast<std::size_t>(noise_to_come_) % garbage_bytes.size()], answer_ns);
  }
  if (wrong_.garbage) {
    for (const std::uint8_t byte : garbage_bytes) say(byte, answer_ns);
  }
  if (fault == ReplyFault::lost) return;
  const bool is_short = wrong_.short_frames != 0 && commands_.frames() % wrong_.short_frames == 0;
  for (int copies = wrong_.duplicated_replies ? 2 : 1; copies > 0; --copies) {
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      // From the middle, so that it still has both ends.
      if (!is_short || (i != 5 && i != 6)) say(bytes[i], answer_ns);
    }
  }
}

// Of the one that comes next.
ReplyFault FalconDsp::fault_of_reply() noexcept {
  ++replies_;
  const unsigned interval = wrong_.reply_interval;
  const bool is_its_turn = replies_ % interval == 0;
  const bool are_over = wrong_.faulty_replies > 0 && std::cmp_greater(replies_ / interval, wrong_.faulty_replies);
  return is_its_turn && !are_over ? wrong_.reply : ReplyFault::none;
}

void FalconDsp::home(std::int64_t now_ns) noexcept {
  if ((last_command_.info & CommandFrame::homing) == 0 || wrong_.never_homes) return;
  for (std::size_t i = 0; i < encoders_.size(); ++i) {
    const auto bit = static_cast<std::uint8_t>(0x10U << i);
    if ((homed_ & bit) != 0) continue;
    if (encoders_[i] > pushed_in_counts || now_ns - last_homed_ns_ < homing_interval_ns) return;
    homed_ |= bit;
    zeros_[i] = 0;
    last_homed_ns_ = now_ns;
    return;
  }
}

}  // namespace ghostforce
