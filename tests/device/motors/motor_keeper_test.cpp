// A device is looked for, opened, let go and found again; and what is owed to one that may push comes before all else.
#include "device/motors/motor_keeper.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace ghostforce::motor_keeper_test {
namespace {

using Event = MotorKeeper::Event;

constexpr std::int64_t ms = 1'000'000;

// Which devices are plugged in, the first of which is opened unless another one is owed a stop.
struct Plugs {
  std::vector<std::string> serials;
  LinkFault fault = LinkFault::none;  // of whichever is opened, or open
  std::int64_t now_ns = 1000 * ms;
  bool is_told_may_push = false;
  int looks = 0;
};

class PlugsLink final : public DeviceLink {
 public:
  explicit PlugsLink(Plugs& plugs) : plugs_(plugs) {}

  bool waits_to_open() const noexcept override { return false; }
  LinkFault open() noexcept override { return open_first({}); }
  LinkFault open_first(const StopDebts& owed) noexcept override {
    serial_.clear();
    for (const std::string& each : plugs_.serials) {
      if (serial_.empty() || owed.has(device_serial_of(each))) serial_ = each;
    }
    is_absent_ = serial_.empty();
    return fault();
  }
  bool is_any_plugged_in(const StopDebts& owed) const noexcept override {
    ++plugs_.looks;
    for (const std::string& each : plugs_.serials) {
      if (owed.has(device_serial_of(each))) return true;
    }
    return false;
  }
  void close() noexcept override {}
  LinkFault fault() const noexcept override { return is_absent_ ? LinkFault::absent : plugs_.fault; }
  std::string_view serial() const noexcept override { return serial_; }
  void set_may_push(bool may_push) noexcept override { plugs_.is_told_may_push = may_push; }
  std::int64_t now_ns() const noexcept override { return plugs_.now_ns; }
  void wait_until(std::int64_t deadline_ns) noexcept override { plugs_.now_ns = std::max(plugs_.now_ns, deadline_ns); }
  void stop_at_once() noexcept override {}

 private:
  Plugs& plugs_;
  std::string serial_;
  bool is_absent_ = true;
};

struct Report {
  bool has_looked = false;
  DeviceSerial serial;
  bool may_still_push = false;
  DeviceSerial owed_serial;
};

// The smallest driver: it answers a zero at once, unless its device is deaf.
struct Driver {
  Driver(Plugs& plugs, MotorKeeper::Options options) : keeper(std::make_unique<PlugsLink>(plugs), std::move(options)) {}
  ~Driver() { keeper.end(*this); }
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;

  void update() noexcept {
    newest = keeper.update();
    switch (newest) {
      case Event::away:
      case Event::absent:
        return;
      case Event::opened:
        is_open = true;
        if (keeper.may_push()) send_zero();
        return;
      case Event::failed:
        return let_go();
      case Event::overtaken:
        send_zero();
        return let_go();
      case Event::open:
        if (keeper.may_push() && keeper.zero_ns()) send_zero();
        if (keeper.has_paid()) let_go(0.0);
        return;
    }
  }
  void shut_down() noexcept {
    const auto exchange = [this](int heard, std::int64_t until_ns) {
      send_zero();
      keeper.link().wait_until(until_ns);
      return is_deaf ? heard : heard + 1;
    };
    if (is_open && !keeper.say_goodbye(0.1, false, exchange)) send_zero();
    let_go();
  }
  void push() {
    keeper.will_push();
    keeper.sent(true, keeper.now_ns());
  }
  void send_zero() noexcept {
    keeper.sent(false, keeper.now_ns());
    keeper.note_stop();
    if (!is_deaf && keeper.answers_zero(keeper.now_ns())) keeper.zero_answered();
  }
  void let_go(double pause_s = MotorKeeper::try_again_s) noexcept {
    is_open = false;
    keeper.let_go(pause_s);
  }
  Report report() const {
    Report told;
    keeper.tell(told);
    return told;
  }

  MotorKeeper keeper;
  bool is_open = false;
  bool is_deaf = false;
  Event newest = Event::away;
};

class Kept : public testing::Test {
 protected:
  void run(int duration_ms) {
    for (int i = 0; i < duration_ms; ++i) {
      driver->update();
      plugs.now_ns += ms;
    }
  }
  // Until it is so [ms]; -1: it was not.
  template <typename Condition>
  int ms_until(const Condition& is_so) {
    for (int passed = 0; passed < 5000; ++passed) {
      if (is_so()) return passed;
      run(1);
    }
    return -1;
  }
  void make(MotorKeeper::Options options = {}) { driver = std::make_unique<Driver>(plugs, std::move(options)); }
  std::string_view in_use() const { return driver->is_open ? driver->keeper.serial().text() : std::string_view(); }
  void push_and_lose(const std::string& serial) {
    plugs.serials = {serial};
    ASSERT_GE(ms_until([&] { return in_use() == serial; }), 0);
    run(1);
    driver->push();
    driver->is_deaf = true;
    plugs.fault = LinkFault::unplugged;
    driver->send_zero();
    run(1);
    driver->is_deaf = false;
    plugs.serials.clear();
    plugs.fault = LinkFault::none;
  }

  Plugs plugs;
  std::unique_ptr<Driver> driver;
};

TEST_F(Kept, IsLookedForUntilItIsThere) {
  make();
  driver->update();
  EXPECT_EQ(driver->newest, Event::absent);
  EXPECT_TRUE(driver->report().has_looked);
  driver->update();
  EXPECT_EQ(driver->newest, Event::away) << "it is looked for twice a second";
  plugs.serials = {"A"};
  EXPECT_EQ(ms_until([&] { return in_use() == "A"; }), 501);
  EXPECT_TRUE(driver->keeper.is_another());
  run(1);
  EXPECT_EQ(driver->newest, Event::open);
  plugs.fault = LinkFault::broken;
  run(1);
  EXPECT_EQ(driver->newest, Event::failed);
  plugs.fault = LinkFault::none;
  EXPECT_GE(ms_until([&] { return in_use() == "A"; }), 999) << "after a fault, once a second";
  EXPECT_FALSE(driver->keeper.is_another());
  plugs.fault = LinkFault::unplugged;
  run(1);
  plugs.fault = LinkFault::none;
  EXPECT_LE(ms_until([&] { return in_use() == "A"; }), 101) << "who plugs it in again is not made to wait";
}

TEST_F(Kept, OnlyAnAnswerToAZeroThatCameAfterTheForceEndsThePush) {
  plugs.serials = {"A"};
  make();
  run(2);
  MotorKeeper& keeper = driver->keeper;
  EXPECT_TRUE(keeper.sent(false, 10));
  EXPECT_FALSE(keeper.sent(false, 11)) << "the first one counts";
  EXPECT_FALSE(plugs.is_told_may_push);
  keeper.will_push();
  EXPECT_TRUE(plugs.is_told_may_push) << "before the force";
  EXPECT_FALSE(keeper.sent(true, 20));
  EXPECT_FALSE(keeper.answers_zero(20));
  EXPECT_TRUE(keeper.sent(false, 30));
  EXPECT_FALSE(keeper.answers_zero(20)) << "the reply to the force";
  EXPECT_TRUE(keeper.answers_zero(30));
  keeper.note_stop();
  EXPECT_TRUE(driver->report().may_still_push);
  EXPECT_EQ(driver->report().owed_serial.text(), "A");
  keeper.zero_answered();
  EXPECT_FALSE(driver->report().may_still_push);
  EXPECT_FALSE(plugs.is_told_may_push);
}

TEST_F(Kept, WhoHasNotPushedIsOwedNothing) {
  plugs.serials = {"A"};
  make();
  run(2);
  driver->keeper.note_stop();
  EXPECT_FALSE(driver->report().may_still_push);
  run(1000);
  EXPECT_EQ(plugs.looks, 0);
}

TEST_F(Kept, NoForceGoesOutAfterALongSilence) {
  plugs.serials = {"A"};
  make();
  run(2);
  const std::int64_t heard_ns = plugs.now_ns;
  EXPECT_FALSE(driver->keeper.must_stop(heard_ns));
  plugs.now_ns += 20 * ms;
  EXPECT_FALSE(driver->keeper.must_stop(heard_ns));
  plugs.now_ns += 1;
  EXPECT_TRUE(driver->keeper.must_stop(heard_ns));
}

TEST_F(Kept, TheOwedOneComesFirstAndIsNotUsedForThat) {
  make();
  push_and_lose("A");
  plugs.serials = {"B"};
  ASSERT_GE(ms_until([&] { return in_use() == "B"; }), 0);
  run(500);
  EXPECT_TRUE(driver->report().may_still_push);
  EXPECT_GE(plugs.looks, 4) << "ten times a second";
  plugs.serials = {"B", "A"};
  const int took_ms = ms_until([&] { return in_use() == "A"; });
  EXPECT_GE(took_ms, 0);
  EXPECT_LE(took_ms, 210);
  EXPECT_TRUE(driver->keeper.is_only_owed());
  EXPECT_LE(ms_until([&] { return in_use() == "B"; }), 3);
  EXPECT_FALSE(driver->report().may_still_push);
  const int looks = plugs.looks;
  run(500);
  EXPECT_EQ(plugs.looks, looks);
}

TEST_F(Kept, TheOwedOneThatWasInUseIsUsedOn) {
  make();
  push_and_lose("A");
  plugs.serials = {"A"};
  ASSERT_GE(ms_until([&] { return in_use() == "A"; }), 0);
  EXPECT_FALSE(driver->keeper.is_only_owed());
  run(10);
  EXPECT_EQ(in_use(), "A");
  EXPECT_FALSE(driver->report().may_still_push);
}

TEST_F(Kept, ADebtOutlivesItsDriver) {
  MotorKeeper::Options options;
  options.debts = std::make_shared<StopDebts>();
  make(options);
  push_and_lose("A");
  make(options);
  EXPECT_TRUE(driver->report().may_still_push) << "from the first moment";
  plugs.serials = {"B", "A"};
  EXPECT_GE(ms_until([&] { return in_use() == "B"; }), 0);
  EXPECT_TRUE(options.debts->empty());
}

// --- The end ---

std::vector<std::string> left_pushing;

TEST_F(Kept, TheEndSaysWhichOneIsLeftPushingAndDoesNotWaitForEver) {
  left_pushing.clear();
  make({.when_left_pushing = [](const DeviceSerial& serial) noexcept { left_pushing.emplace_back(serial.text()); }});
  push_and_lose("A");
  const std::int64_t began_ns = plugs.now_ns;
  driver.reset();
  EXPECT_EQ(left_pushing, std::vector<std::string>{"A"});
  EXPECT_GE(plugs.now_ns - began_ns, 400 * ms) << "it may just be on its way";
  EXPECT_LE(plugs.now_ns - began_ns, 700 * ms);
}

TEST_F(Kept, TheEndStopsOneThatIsThereAndTriesForLongerWhereItCannotBeHad) {
  left_pushing.clear();
  const MotorKeeper::Options options{
      .when_left_pushing = [](const DeviceSerial& serial) noexcept { left_pushing.emplace_back(serial.text()); }};
  make(options);
  push_and_lose("A");
  plugs.serials = {"A"};
  driver.reset();
  EXPECT_TRUE(left_pushing.empty());

  make(options);
  push_and_lose("A");
  plugs.serials = {"A"};
  plugs.fault = LinkFault::busy;
  const std::int64_t began_ns = plugs.now_ns;
  driver.reset();
  EXPECT_EQ(left_pushing, std::vector<std::string>{"A"});
  EXPECT_GE(plugs.now_ns - began_ns, 2900 * ms);
}

TEST_F(Kept, TheGoodbyeEndsWithTheThirdAnswer) {
  plugs.serials = {"A"};
  make();
  run(2);
  driver->push();
  const std::int64_t began_ns = plugs.now_ns;
  driver->shut_down();
  EXPECT_EQ(plugs.now_ns - began_ns, 15 * ms);
  EXPECT_FALSE(driver->report().may_still_push);
}

TEST_F(Kept, ADeviceThatHearsNoGoodbyeIsOwedAStop) {
  plugs.serials = {"A"};
  make();
  run(2);
  driver->push();
  driver->is_deaf = true;
  const std::int64_t began_ns = plugs.now_ns;
  driver->shut_down();
  EXPECT_EQ(plugs.now_ns - began_ns, 100 * ms);
  EXPECT_TRUE(driver->report().may_still_push);
}

}  // namespace
}  // namespace ghostforce::motor_keeper_test
