// FalconDsp: the far end of the Falcon's cable. FTDI's serial chip, the serial line behind it at the pace of its baud
// rate, and the processor (DSP) there: hand-shake, boot loader, firmware, homing. It reads no clock and has no thread:
// each call says what time it is, and what has happened on the line up to then has happened. Encoders go in at one
// side, motor counts come out. Allocates and throws nothing; one thread. Times in ns, on any clock that does not go
// back.
//
// What it does is what was seen on real devices; where that leaves something open it is strict, so that a driver that
// works here keeps to what is known to work.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/fixed_queue.h"
#include "device/falcon/falcon_link.h"
#include "device/falcon/frame.h"
#include "device/virtual_falcon/injected_fault.h"

namespace ghostforce {

// The rate that a baud request asks for: 3 MHz by an integer and eighths, in FTDI's coding [1/s].
double baud_of(std::uint16_t value, std::uint16_t index) noexcept;

class FalconDsp {
 public:
  static constexpr std::size_t packet_size = 64;  // the chip's status bytes included
  static constexpr std::size_t status_size = 2;
  static constexpr std::uint8_t cts = 0x10;  // of the first status byte

  // An arm that stands at or below this, counted from the geometry's zero, is pushed in: where homing finds it.
  static constexpr int pushed_in_counts = -1300;
  // Between one arm's being found and the next one's.
  static constexpr std::int64_t homing_interval_ns = 20'000'000;

  struct Options {
    bool starts_with_firmware = false;
    bool starts_homed = false;  // only with firmware
    // After so long without a frame the firmware takes the motors' force away. Whether the real one does, and when, is
    // not known; 0: never.
    int watchdog_ms = 0;
  };

  FalconDsp(const Options& options, std::int64_t now_ns) noexcept;

  // Host → device. What is written while the chip has no room for it is lost; a USB host would wait.
  void control(const VendorRequest& request, std::int64_t now_ns) noexcept;
  void receive(std::span<const std::uint8_t> bytes, std::int64_t now_ns) noexcept;
  std::size_t room() const noexcept { return to_dsp_.room(); }  // [bytes]

  // Device → host. A packet is due when the latency timer says so or a packet is full, whichever is first. Nothing new
  // is due before next_due_ns(); at that time take_packet() may still find that it has to be asked again.
  std::int64_t next_due_ns() const noexcept;
  // Returns the packet's size, status bytes included; 0: none is due.
  std::size_t take_packet(std::span<std::uint8_t, packet_size> into, std::int64_t now_ns) noexcept;

  // The USB chip has been without power, which comes through the cable: all that it was told is forgotten. The DSP has
  // a supply of its own and goes on, as do its motors.
  void power_up_chip(std::int64_t now_ns) noexcept;

  // Lets happen what happens by itself: bytes arrive, the watchdog acts.
  void advance(std::int64_t now_ns) noexcept;

  // Where the arms are, counted from the geometry's zero, and the grip's buttons as in ReplyFrame.
  void set_encoders(const std::array<int, 3>& counts) noexcept { encoders_ = counts; }
  void set_buttons(std::uint8_t buttons) noexcept { buttons_ = buttons; }

  void inject(const InjectedFault& wrong) noexcept;

  // What the motors are driven with [counts], and which lights are on (bits of CommandFrame).
  const std::array<std::int16_t, 3>& motors() const noexcept { return motors_; }
  std::uint8_t lights() const noexcept { return lights_; }

  bool runs_firmware() const noexcept { return stage_ == Stage::firmware; }
  std::uint8_t homed() const noexcept { return homed_; }  // bits of ReplyFrame
  // Somebody asks the firmware to find home, and it has not yet.
  bool wants_homing() const noexcept {
    return (last_command_.info & CommandFrame::homing) != 0 && homed_ != ReplyFrame::homed;
  }
  std::uint64_t frames() const noexcept { return commands_.frames(); }
  const CommandFrame& last_command() const noexcept { return last_command_; }

 private:
  enum class Stage : std::uint8_t {
    idle,         // nothing runs that would answer
    hand_shake,   // DTR has risen: waits for the three bytes
    shaken,       // has answered; DTR low begins the boot loader
    boot_loader,  // waits for the 'A' that shows it the baud rate
    boot_table,
    firmware,
  };

  // A byte on the serial line, and when it is through.
  struct Timed {
    std::int64_t at_ns = 0;
    std::uint8_t byte = 0;
  };

  // Walks through a boot table, word by word.
  struct BootTable {
    enum class Part : std::uint8_t { key, reserved, entry, size, address, data, done, refused };
    Part part = Part::key;
    int bytes = 0;            // taken
    std::uint8_t low = 0;     // of a word of which the other half is still to come
    unsigned block = 0;       // words of the data that come next
    unsigned words_left = 1;  // of this part

    void take(std::uint8_t byte) noexcept;
    void take_word(unsigned word) noexcept;
    void go_on(Part next, unsigned words) noexcept;
  };

  void reset(Stage stage) noexcept;
  void set_dtr(bool high) noexcept;
  void set_baud(std::uint16_t value, std::uint16_t index, std::int64_t now_ns) noexcept;
  bool line_is_at(double rate) const noexcept;
  std::int64_t byte_time_ns() const noexcept;
  void send_again_from(std::int64_t now_ns) noexcept;
  std::uint8_t next_noise() noexcept;

  void hear(std::uint8_t byte, std::int64_t at_ns) noexcept;
  void hear_hand_shake(std::uint8_t byte, std::int64_t at_ns) noexcept;
  void hear_boot_table(std::uint8_t byte, std::int64_t at_ns) noexcept;
  void hear_frame(const CommandFrame& frame, std::int64_t at_ns) noexcept;
  void home(std::int64_t now_ns) noexcept;
  void reply(std::int64_t at_ns) noexcept;
  ReplyFault fault_of_reply() noexcept;
  void say(std::uint8_t byte, std::int64_t now_ns) noexcept;

  std::size_t payload_limit() const noexcept;
  std::int64_t packet_due_ns() const noexcept;

  Options options_;
  InjectedFault wrong_;
  int replies_to_lose_ = 0;
  bool echo_is_to_fail_ = false;
  unsigned replies_ = 0;  // since the fault was asked for
  int noise_to_come_ = 0;

  // The chip, as it is when it gets current.
  struct Settings {
    double baud = 9600.0;
    bool is_8n1 = false;  // 8 data bits, no parity, 1 stop bit; what it is before anybody asks is not promised
    std::int64_t latency_ns = 16'000'000;
    bool dtr = false;
  };
  Settings chip_;
  std::int64_t cts_from_ns_ = 0;  // 0: not raised
  bool overrun_ = false;
  std::int64_t last_packet_ns_;
  FixedQueue<Timed, 256> to_dsp_;
  FixedQueue<Timed, 4096> to_host_;
  std::int64_t line_out_free_ns_ = 0;  // when the last byte under way is through
  std::int64_t line_in_free_ns_ = 0;
  std::uint32_t noise_ = 0x2545F491;  // fixed, so that each run has the same noise

  // The DSP.
  Stage stage_ = Stage::idle;
  std::size_t matched_ = 0;  // bytes of the hand-shake
  BootTable table_;
  FrameReader<CommandFrame> commands_;
  CommandFrame last_command_;
  std::int64_t last_frame_ns_ = 0;
  std::array<std::int16_t, 3> motors_{};
  std::uint8_t lights_ = 0;
  std::uint8_t homed_ = 0;
  std::int64_t last_homed_ns_ = 0;
  std::array<int, 3> encoders_{};  // where the arms are
  std::array<int, 3> zeros_{};     // what the firmware takes for 0
  std::array<std::int16_t, 3> reported_{};
  std::uint8_t buttons_ = 0;
};

}  // namespace ghostforce
