// A link that takes as long as it likes to open and to close, and a driver that does not wait for it.
#include "device/motors/link_opener.h"

#include <chrono>
#include <memory>
#include <semaphore>
#include <thread>

#include <gtest/gtest.h>

#include "device/input/monotonic_clock.h"

namespace ghostforce::link_opener_test {
namespace {

constexpr std::int64_t ms = 1'000'000;

// Whose every step a test lets happen. Plain members on purpose: that the link is handed over whole is what the thread
// sanitizer sees.
class SlowLink final : public DeviceLink {
 public:
  struct Gates {
    std::binary_semaphore opens{0};
    std::binary_semaphore closes{0};
  };
  explicit SlowLink(Gates& gates, bool needs_thread = true) : gates_(gates), waits_(needs_thread) {}
  ~SlowLink() override { EXPECT_FALSE(is_open); }

  bool waits_to_open() const noexcept override { return waits_; }
  LinkFault open() noexcept override {
    opener = std::this_thread::get_id();
    if (waits_) gates_.opens.acquire();
    ++times_open;
    is_open = true;
    return LinkFault::none;
  }
  LinkFault open_first(const StopDebts& owed) noexcept override {
    was_owed = !owed.empty();
    return open();
  }
  bool is_any_plugged_in(const StopDebts& owed) const noexcept override {
    finder = std::this_thread::get_id();
    return owed.has(*DeviceSerial::from("PLUGGED"));
  }
  void close() noexcept override {
    if (!is_open) return;
    if (waits_) gates_.closes.acquire();
    is_open = false;
  }
  LinkFault fault() const noexcept override { return is_open ? LinkFault::none : LinkFault::absent; }
  std::string_view serial() const noexcept override { return {}; }
  std::int64_t now_ns() const noexcept override { return monotonic_ns(); }
  void wait_until(std::int64_t /*deadline_ns*/) noexcept override { ++waits; }
  void stop_at_once() noexcept override {}

  std::thread::id opener;
  bool is_open = false;
  int times_open = 0;
  bool was_owed = false;
  mutable std::thread::id finder;
  int waits = 0;

 private:
  Gates& gates_;
  bool waits_;
};

struct Opened {
  explicit Opened(bool needs_thread = true) : opener(std::make_unique<SlowLink>(gates, needs_thread)) {}
  ~Opened() { gates.closes.release(); }
  SlowLink& link() { return static_cast<SlowLink&>(opener.link()); }
  void let_finish() {
    while (opener.is_busy()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  SlowLink::Gates gates;
  LinkOpener opener;
};

TEST(LinkOpener, OpensAndClosesOnAThreadOfItsOwn) {
  Opened opened;
  EXPECT_FALSE(opened.opener.is_busy());
  opened.opener.open({});
  EXPECT_TRUE(opened.opener.is_busy()) << "the gate is shut, and the driver goes on";
  opened.gates.opens.release();
  opened.let_finish();
  EXPECT_TRUE(opened.link().is_open);
  EXPECT_NE(opened.link().opener, std::this_thread::get_id());
  opened.opener.close();
  EXPECT_TRUE(opened.opener.is_busy());
  opened.gates.closes.release();
  opened.let_finish();
  EXPECT_FALSE(opened.link().is_open);
}

TEST(LinkOpener, WaitsForTheDeadlineWhileTheLinkIsNotItsOwn) {
  Opened opened;
  opened.opener.open({});
  const std::int64_t deadline_ns = monotonic_ns() + 5 * ms;
  opened.opener.wait_until(deadline_ns);
  EXPECT_GE(monotonic_ns(), deadline_ns);
  opened.gates.opens.release();
  opened.let_finish();
  EXPECT_EQ(opened.link().waits, 0);
  opened.opener.wait_until(0);
  EXPECT_EQ(opened.link().waits, 1);
}

// A device that is owed a stop may be plugged in while another one is in use, which goes on meanwhile.
TEST(LinkOpener, LooksForOwedDevicesWhileTheLinkIsInUse) {
  for (const bool needs_thread : {true, false}) {
    Opened opened(needs_thread);
    opened.gates.opens.release();
    opened.opener.open({});
    opened.let_finish();
    StopDebts owed;
    owed.add(*DeviceSerial::from("PLUGGED"));
    opened.opener.look_for(owed);
    EXPECT_FALSE(opened.opener.is_busy());
    while (!opened.opener.has_found_one()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_FALSE(opened.opener.has_found_one()) << "it says so once";
    EXPECT_EQ(opened.link().finder == std::this_thread::get_id(), !needs_thread);
  }
}

TEST(LinkOpener, OpensWhatIsOwedAStop) {
  Opened opened(false);
  StopDebts owed;
  owed.add(*DeviceSerial::from("PLUGGED"));
  opened.opener.open(owed);
  EXPECT_TRUE(opened.link().was_owed);
  opened.opener.close();
}

// The link outlives the thread, and the thread what it was at.
TEST(LinkOpener, ClosesWhatIsStillOpen) {
  for (const bool is_done : {true, false}) {
    Opened opened;
    opened.opener.open({});
    opened.gates.opens.release();
    if (is_done) opened.let_finish();
  }
}

TEST(LinkOpener, ALinkThatNeverWaitsNeedsNoThread) {
  Opened opened(false);
  opened.opener.open({});
  EXPECT_FALSE(opened.opener.is_busy());
  EXPECT_TRUE(opened.link().is_open);
  EXPECT_EQ(opened.link().opener, std::this_thread::get_id());
  opened.opener.close();
  EXPECT_FALSE(opened.link().is_open);
}

}  // namespace
}  // namespace ghostforce::link_opener_test
