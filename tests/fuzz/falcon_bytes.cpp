// A Falcon that says anything at any time, or stops: the driver goes on, what it reads is a place, and no motor gets
// more than its most, or anything at all while nobody has armed it.
#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "device/falcon/falcon_input.h"
#include "device/virtual_falcon/practice_firmware.h"
#include "tests/fuzz/fuzz.h"

using namespace ghostforce;

namespace {

constexpr std::int64_t ms = 1'000'000;

// Each time that the driver waits, the next bytes of the input tell what happens.
class FuzzedLink final : public FalconLink {
 public:
  FuzzedLink(Bytes& bytes, const bool& is_armed) : bytes_(bytes), is_armed_(is_armed) {}

  bool waits_to_open() const noexcept override { return false; }
  LinkFault open() noexcept override { return fault_ = LinkFault::none; }
  void close() noexcept override {}
  LinkFault fault() const noexcept override { return fault_; }
  std::string_view serial() const noexcept override { return "FUZZED"; }
  bool request(const VendorRequest& /*request*/) noexcept override { return !is_sending_; }
  RequestOutcome request_outcome() const noexcept override { return RequestOutcome::done; }
  void stop(std::span<const std::uint8_t> bytes) noexcept override {
    is_sending_ = false;
    write(bytes);
  }
  bool owes_stop() const noexcept override { return is_sending_; }
  bool write(std::span<const std::uint8_t> bytes) noexcept override {
    if (is_sending_) return false;
    require(bytes.size() <= 64, "no more is written at once than a link takes");
    written_.assign(bytes.begin(), bytes.end());
    if (const std::optional<CommandFrame> command = commands_.take(bytes)) {
      for (const std::int16_t count : command->motors) {
        require(std::abs(int{count}) <= most_motor_counts, "no motor gets more than its most");
        require(is_armed_ || count == 0, "no motor gets anything while nobody has armed it");
      }
    }
    return true;
  }
  bool is_sending() const noexcept override { return is_sending_; }
  std::size_t read(std::span<std::uint8_t> into) noexcept override {
    const std::size_t count = std::min(into.size(), incoming_.size());
    std::copy_n(incoming_.begin(), count, into.begin());
    incoming_.erase(incoming_.begin(), incoming_.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }
  std::uint8_t modem_status() const noexcept override { return modem_status_; }
  LinkCounters counters() const noexcept override { return {.packets_in = packets_}; }
  std::int64_t now_ns() const noexcept override { return now_ns_; }
  void wait_until(std::int64_t deadline_ns) noexcept override {
    is_sending_ = false;
    ++packets_;
    std::int64_t wait_ns = ms / 4;
    switch (const std::uint8_t what = bytes_.next(); what % 16) {
      case 0:
        wait_ns = 1000 * ms;
        break;
      case 1: {
        const auto any = bytes_.take(what / 4U);
        incoming_.insert(incoming_.end(), any.begin(), any.end());
        break;
      }
      case 2:
        modem_status_ = bytes_.next();
        break;
      case 3:
        is_sending_ = true;
        break;
      case 4:
        if (what >= 0xC0) fault_ = static_cast<LinkFault>(bytes_.next() % 7);
        break;
      default:
        answer();
    }
    now_ns_ = std::max(now_ns_, std::min(deadline_ns, now_ns_ + wait_ns));
  }
  void send_at_once(std::span<const std::uint8_t> /*bytes*/) noexcept override {}

 private:
  // As a device that is well: the hand-shake, the echo, and a frame for a frame.
  void answer() noexcept {
    if (written_.empty()) return;
    if (written_.front() == '<') {
      ReplyFrame reply;
      for (std::int16_t& encoder : reply.encoders) {
        encoder = static_cast<std::int16_t>(16 * static_cast<std::int8_t>(bytes_.next()));
      }
      reply.status = bytes_.next() & 0x7F;
      const FrameBytes frame = encode(reply);
      incoming_.insert(incoming_.end(), frame.begin(), frame.end());
    } else {
      if (written_.size() == 3 && written_[1] == 'C') written_ = {'\n', 'D', ',', '\r'};
      incoming_.insert(incoming_.end(), written_.begin(), written_.end());
    }
    written_.clear();
  }

  Bytes& bytes_;
  const bool& is_armed_;
  LinkFault fault_ = LinkFault::absent;
  std::deque<std::uint8_t> incoming_;
  std::vector<std::uint8_t> written_;
  FrameReader<CommandFrame> commands_;
  std::uint8_t modem_status_ = 0;
  bool is_sending_ = false;
  std::uint64_t packets_ = 0;
  std::int64_t now_ns_ = 1000 * ms;
};

// However a stream is cut into packets, the same frames are in it.
void read_frames(std::span<const std::uint8_t> bytes) {
  FrameReader<ReplyFrame> at_once;
  FrameReader<ReplyFrame> one_by_one;
  std::optional<ReplyFrame> last;
  const std::optional<ReplyFrame> newest = at_once.take(bytes);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (const auto frame = one_by_one.take(bytes.subspan(i, 1))) last = frame;
  }
  require(newest == last, "the newest frame is the last");
  require(at_once.frames() == one_by_one.frames() && at_once.discarded_bytes() == one_by_one.discarded_bytes(),
          "packets make no difference");
  require(16 * at_once.frames() + at_once.discarded_bytes() <= bytes.size(), "no byte counts twice");
  if (!newest) return;
  FrameReader<ReplyFrame> again;
  require(again.take(encode(*newest)) == newest, "a frame that is written reads back");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  read_frames({data, size});

  Bytes bytes({data, size});
  bool is_armed = false;
  FalconOptions options;
  options.firmware = practice_firmware(20);
  FalconInput input(std::make_unique<FuzzedLink>(bytes, is_armed), std::move(options), Vector<2>(0.0));
  for (int tick = 0, ticks_left = 50; ticks_left > 0; ++tick) {
    if (bytes.empty()) --ticks_left;
    input.wait_until(input.now_ns() + ms);
    const HandleReading reading = input.read();
    const Vector<2> goal = input.goal(tick, 1000.0);
    require(std::isfinite(reading.position.x) && std::isfinite(reading.position.y), "the handle is at a place");
    require(std::isfinite(reading.speed) && reading.speed >= 0.0, "its speed is one");
    require(std::isfinite(goal.x) && std::isfinite(goal.y), "so is the goal");
    const std::uint8_t force = bytes.next();
    is_armed = force % 4 != 0;
    input.set_force({(force - 128) / 8.0, (force % 32 - 16) / 2.0}, is_armed);
  }
  is_armed = false;
  input.shut_down();
  return 0;
}
