#include "device/falcon/boot_loader.h"

#include <algorithm>
#include <array>

#include "device/falcon/link_setup.h"

namespace ghostforce {
namespace {

using Step = LinkScriptStep;

// The pause around the edge of DTR is not in any description; the edge is what starts the boot loader, and a chip that
// is asked twice within a microsecond may not show it.
constexpr int edge_ms = 10;

constexpr std::array set_up{
    ask(ftdi::forget_received),
    ask(ftdi::forget_unsent),
    ask(ftdi::latency(16)),
    ask(ftdi::handshake_rate),
    ask(ftdi::eight_bits_no_parity_one_stop),
    ask(ftdi::no_flow_control),
    ask(ftdi::request_to_send_low),
    ask(ftdi::data_terminal_ready_low),
    Step{.kind = Step::Kind::wait, .duration_ms = edge_ms},
    ask(ftdi::data_terminal_ready_high),
    Step{.kind = Step::Kind::wait, .duration_ms = edge_ms},
};

// Said once and then listened for: whoever calls again at once finds the answers to two calls in a heap.
constexpr std::array handshake{
    Step{.kind = Step::Kind::flush},
    Step{.kind = Step::Kind::send, .bytes = "\nC\r"},
    Step{.kind = Step::Kind::expect, .bytes = "\nD,\r", .duration_ms = 200},
};

constexpr std::array baud{
    ask(ftdi::data_terminal_ready_low),
    ask(ftdi::upload_rate),
    // Some devices raise CTS when they are ready for the new rate.
    Step{.kind = Step::Kind::await_clear_to_send, .duration_ms = 100},
    Step{.kind = Step::Kind::flush},
    Step{.kind = Step::Kind::send, .bytes = "A"},
    // Some devices say 0x13 before it.
    Step{.kind = Step::Kind::expect, .bytes = "A", .duration_ms = 500},
};

}  // namespace

BootLoader::BootLoader(std::span<const std::uint8_t> firmware) noexcept : firmware_(firmware) {
  enter(Stage::set_up);
}

void BootLoader::enter(Stage stage) noexcept {
  stage_ = stage;
  if (stage == Stage::set_up) link_script_ = LinkScript(set_up);
  if (stage == Stage::handshake) link_script_ = LinkScript(handshake);
  if (stage == Stage::baud) link_script_ = LinkScript(baud);
}

LinkProgress BootLoader::fail(BootFault fault) noexcept {
  fault_ = fault;
  stage_ = Stage::failed;
  return LinkProgress::failed;
}

LinkProgress BootLoader::update(FalconLink& link) noexcept {
  if (stage_ == Stage::done) return LinkProgress::done;
  if (stage_ == Stage::failed) return LinkProgress::failed;
  if (stage_ == Stage::upload) return upload(link);
  switch (link_script_.update(link)) {
    case LinkProgress::running:
      break;
    case LinkProgress::done:
      enter(stage_ == Stage::set_up ? Stage::handshake : stage_ == Stage::handshake ? Stage::baud : Stage::upload);
      break;
    case LinkProgress::failed:
      if (stage_ == Stage::baud) return fail(BootFault::no_baud_answer);
      if (stage_ == Stage::set_up || --handshakes_left_ == 0) return fail(BootFault::no_handshake);
      enter(Stage::handshake);
      break;
  }
  return LinkProgress::running;
}

LinkProgress BootLoader::upload(FalconLink& link) noexcept {
  std::array<std::uint8_t, chunk_size> echo;
  while (const std::size_t came = link.read(std::span(echo).first(std::min(chunk_size, sent_ - echoed_)))) {
    for (std::size_t i = 0; i < came; ++i) {
      if (echo[i] != firmware_[echoed_]) return fail(BootFault::echo_differs);
      ++echoed_;
    }
  }
  if (echoed_ == firmware_.size()) {
    stage_ = Stage::done;
    return LinkProgress::done;
  }
  if (echoed_ < sent_) {
    const bool is_over = link.now_ns() - chunk_began_ns_ >= std::int64_t{longest_echo_ms} * 1'000'000;
    return is_over ? fail(BootFault::echo_missing) : LinkProgress::running;
  }
  const std::size_t size = std::min(chunk_size, firmware_.size() - sent_);
  if (link.write(firmware_.subspan(sent_, size))) {
    sent_ += size;
    chunk_began_ns_ = link.now_ns();
  }
  return LinkProgress::running;
}

}  // namespace ghostforce
