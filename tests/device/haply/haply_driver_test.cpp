// The Haply's driver, from a board that is not there to one that pushes, with a person who confirms the zero pose: each
// variant on each board, and boards that are found in another state.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/device/haply/held_haply.h"

namespace ghostforce::haply_driver_test {
namespace {

using Kind = HaplyBoard::Kind;

TEST(HaplyDriver, ComesFromNothingToContactByHand) {
  HeldHaply::Options options;
  options.device.fault.link = LinkFault::absent;
  HeldHaply haply(options);
  haply.run(2.0);
  EXPECT_EQ(haply.haply().state, HaplyState::absent);
  EXPECT_TRUE(haply.haply().has_looked);
  EXPECT_EQ(haply.haply().faults, 0U);
  EXPECT_EQ(haply.truth().packets, 0U);

  haply.mend();
  std::vector<HaplyState> seen;
  EXPECT_TRUE(haply.run_until(2.0, [&] {
    if (seen.empty() || seen.back() != haply.haply().state) seen.push_back(haply.haply().state);
    return seen.back() == HaplyState::zero_pose;
  }));
  EXPECT_EQ(seen, (std::vector{HaplyState::absent, HaplyState::opening, HaplyState::zero_pose}));
  EXPECT_EQ(haply.haply().serial.text(), VirtualPort::serial_number);
  EXPECT_TRUE(haply.motors().waits_for_zero_pose);
  EXPECT_FALSE(haply.motors().is_handle_known);

  ASSERT_TRUE(haply.set_zero_pose());
  EXPECT_EQ(haply.haply().state, HaplyState::idle);
  EXPECT_FALSE(haply.motors().waits_for_zero_pose);
  ASSERT_TRUE(haply.move_a_little());
  EXPECT_TRUE(haply.haply().encoders_move());
  EXPECT_GE(haply.haply().exchange_hz, HaplyReport::fast_enough_hz);
  // Half a step of each encoder is 60 µm.
  EXPECT_LT(haply.misplaced(), 150e-6);
  ASSERT_TRUE(haply.arm());
  haply.lead(HeldHaply::deep_place, 0.5);
  haply.run(1.5);
  EXPECT_EQ(haply.motors().state, SafetyState::on) << haply.reason();
  EXPECT_GT(haply.force(), 1.0);
  EXPECT_EQ(haply.haply().faults, 0U);
  EXPECT_EQ(haply.haply().lost_exchanges, 0U);
  EXPECT_EQ(haply.haply().discarded_bytes, 1U) << "the address alone, before it was set up";
}

TEST(HaplyDriver, IsNotArmedBeforeTheZeroPose) {
  HeldHaply haply;
  ASSERT_TRUE(haply.run_until(1.0, [&] { return haply.haply().state == HaplyState::zero_pose; }));
  haply.ask_to_arm();
  haply.run(2.0);
  EXPECT_EQ(haply.motors().state, SafetyState::off);
  EXPECT_EQ(haply.motors().reason, OffReason::not_homed);
  EXPECT_EQ(haply.truth().set_ups, 1U);
}

TEST(HaplyDriver, IsNotArmedBeforeBothEncodersHaveMoved) {
  HeldHaply haply;
  haply.board().hold_zero_pose(true);
  ASSERT_TRUE(haply.run_until(2.0, [&] { return haply.board().bench().hand().is_in_zero_pose(); }));
  haply.run(0.5);
  haply.input().confirm_zero_pose();
  ASSERT_TRUE(haply.run_until(1.0, [&] { return haply.haply().state == HaplyState::idle; }));
  haply.ask_to_arm();
  haply.run(1.0);
  EXPECT_NE(haply.motors().state, SafetyState::ramp);
  EXPECT_FALSE(haply.motors().is_ready);
}

TEST(HaplyDriver, DoesNotTakeItsWordFromAPersonWhoMoves) {
  HeldHaply haply;
  ASSERT_TRUE(haply.run_until(1.0, [&] { return haply.haply().state == HaplyState::zero_pose; }));
  const std::uint64_t set_ups = haply.truth().set_ups;
  haply.lead({0.02, 0.02}, 1.0);
  haply.run(0.5);
  haply.input().confirm_zero_pose();
  haply.run(0.1);
  EXPECT_EQ(haply.haply().zero_pose, ZeroPose::moving);
  EXPECT_EQ(haply.haply().state, HaplyState::zero_pose);
  haply.run(2.0);
  EXPECT_EQ(haply.truth().set_ups, set_ups) << "nor later, when the arms rest anywhere";
  EXPECT_TRUE(haply.set_zero_pose()) << "a person may say it again";
}

// The first answers after the set up are then to questions that were asked before it.
TEST(HaplyDriver, ABoardWhoseAnswersAreLateIsNotSaidToCountWrongly) {
  HeldHaply haply;
  ASSERT_TRUE(haply.run_until(1.0, [&] { return haply.haply().state == HaplyState::zero_pose; }));
  haply.inject("late-50ms");
  EXPECT_TRUE(haply.set_zero_pose());
  // Nobody knows what moment a late answer is of.
  haply.lead({0.03, 0.02}, 0.1);
  haply.run(0.5);
  EXPECT_EQ(haply.haply().state, HaplyState::idle) << static_cast<int>(haply.haply().fault);
  EXPECT_FALSE(haply.motors().is_ready) << "but nobody may arm it";
}

// Nobody would notice later.
TEST(HaplyDriver, AnEncoderThatLeapsWhileAnswersAreLateHasLostItsCountOnceTheyAreNot) {
  HeldHaply haply;
  ASSERT_TRUE(haply.get_ready());
  haply.inject("late-50ms");
  haply.run(0.5);
  ASSERT_TRUE(haply.haply().is_lagging);
  haply.hold_with(2000.0);
  haply.lead({0.03, 0.02}, 0.0);  // as quick as no hand is
  haply.run(0.5);
  EXPECT_EQ(haply.haply().state, HaplyState::idle);
  haply.mend();
  haply.run(0.2);
  EXPECT_EQ(haply.haply().state, HaplyState::zero_pose);
  EXPECT_EQ(haply.haply().fault, HaplyFault::lost_count);
}

// Once, wrongly, and once more: all that follows counts from the newest.
TEST(HaplyDriver, TheZeroPoseMayBeSetAgain) {
  HeldHaply haply;
  haply.inject("wrong-zero-pose");
  ASSERT_TRUE(haply.get_ready());
  EXPECT_GT(haply.misplaced(), 2e-3);
  haply.mend();
  ASSERT_TRUE(haply.set_zero_pose());
  ASSERT_TRUE(haply.move_a_little());
  EXPECT_LT(haply.misplaced(), 150e-6);
}

TEST(HaplyDriver, WhileMotorsAreOnTheZeroPoseIsNotSet) {
  HeldHaply haply;
  ASSERT_TRUE(haply.press());
  const std::uint64_t set_ups = haply.truth().set_ups;
  haply.input().confirm_zero_pose();
  haply.run(1.0);
  EXPECT_EQ(haply.truth().set_ups, set_ups);
  haply.disarm();
  haply.run(2.0);
  EXPECT_EQ(haply.motors().state, SafetyState::off);
  EXPECT_EQ(haply.truth().set_ups, set_ups) << "nor when they have gone off";
  EXPECT_LT(haply.misplaced(), 150e-6);
}

// Each of them with the bytes that are right for it: the force is the one that is asked for, in the end on the handle.
TEST(HaplyDriver, EveryVariantOnEveryBoardPushesAsAsked) {
  for (const HaplyVariant& variant : haply_variant_catalog()) {
    for (const Kind kind : {Kind::m0, Kind::m3, Kind::dev_kit}) {
      SCOPED_TRACE(std::string(variant.name) + " on board " + std::to_string(static_cast<int>(kind)));
      HeldHaply::Options options;
      options.device.board.kind = kind;
      options.device.variant = variant.name;
      options.calibration = right_calibration(variant.name, kind);
      HeldHaply haply(options);
      ASSERT_TRUE(haply.get_ready());
      ASSERT_TRUE(haply.arm()) << haply.reason();
      haply.lead({0.008, -0.008}, 0.5);
      haply.run(1.5);
      ASSERT_EQ(haply.motors().state, SafetyState::on) << haply.reason();
      EXPECT_GT(haply.force(), 0.5);
      EXPECT_EQ(haply.haply().lost_exchanges, 0U);
      // Over a second, since a hand at rest is asked now and then whether its encoders count.
      double off_angle = 0.0;
      int compared = 0;
      Vector<2> before(0.0);
      for (int i = 0; i < 1000; ++i) {
        haply.step();
        const Vector<2> wanted = std::exchange(before, haply.motors().sent);
        const Vector<2> got = -haply.truth().force;
        if (glm::length(wanted) < 0.5) continue;
        ++compared;
        off_angle =
            std::max(off_angle, std::abs(wanted.x * got.y - wanted.y * got.x) / glm::length(wanted) / glm::length(got));
        // A step of the duty is 1/1023 at worst, and an encoder's step turns a lever by a hundredth.
        ASSERT_NEAR(glm::length(got), glm::length(wanted), 0.02 * glm::length(wanted) + 0.01);
        ASSERT_GT(glm::dot(got, wanted), 0.0);
      }
      EXPECT_GT(compared, 500);
      EXPECT_LT(off_angle, 0.01);
      EXPECT_LT(haply.misplaced(), 300e-6);
    }
  }
}

// As after the end of another program, or of this one before it.
TEST(HaplyDriver, ABoardThatNobodyHasSetUpIsSetUp) {
  HeldHaply haply;
  ASSERT_TRUE(haply.run_until(1.0, [&] { return haply.haply().state == HaplyState::zero_pose; }));
  EXPECT_FALSE(haply.haply().was_set_up);
  EXPECT_EQ(haply.truth().set_ups, 1U);
  EXPECT_TRUE(haply.truth().is_configured);
  EXPECT_EQ(haply.truth().address, hapi::address);
}

// A driver that did not end in order: another one on the same board finds it set up, and pushing.
TEST(HaplyDriver, ABoardThatIsSetUpForThisProgramIsStoppedWithinAQuarterOfASecond) {
  HeldHaply haply;
  ASSERT_TRUE(haply.press());
  // Its port loses the cable, and the motors keep what they have; that is how a killed program leaves them.
  haply.inject("unplugged");
  haply.run(0.5);
  ASSERT_GT(haply.force(), 1.0);
  haply.port().packets.clear();
  haply.port().keeps_packets = true;
  const std::uint64_t set_ups = haply.truth().set_ups;
  haply.mend();
  PushWatch watch(haply);
  haply.run(1.0);
  EXPECT_LE(watch.ms_pushing(), 250.0);
  RecordProperty("ms_to_zero", std::to_string(watch.ms_pushing()));
  EXPECT_TRUE(haply.haply().was_set_up);
  EXPECT_EQ(haply.truth().set_ups, set_ups) << "it keeps its counters until a person holds the zero pose";
  EXPECT_EQ(haply.haply().state, HaplyState::zero_pose);
  EXPECT_FALSE(haply.motors().is_handle_known) << "counters that may have missed something are no home";
}

// The same for a driver that knows nothing of it: it was another program's.
TEST(HaplyDriver, AForceUnderAnotherAddressIsStoppedWithinAQuarterOfASecond) {
  HeldHaply haply;
  haply.inject("other-id");
  PushWatch watch(haply);
  ASSERT_TRUE(haply.run_until(1.0, [&] { return haply.haply().state == HaplyState::zero_pose; }));
  EXPECT_GT(watch.greatest_force(), 0.2) << "there was a force";
  EXPECT_GT(watch.ms_pushing(), 0.0);
  EXPECT_LE(watch.ms_pushing(), 250.0);
  RecordProperty("ms_to_zero", std::to_string(watch.ms_pushing()));
  EXPECT_FALSE(haply.haply().was_set_up);
  EXPECT_EQ(haply.truth().address, hapi::address);
}

// As an Arduino with a sketch for its first day: it sends back what it is sent.
class EchoPort final : public SerialPort {
 public:
  explicit EchoPort(std::vector<std::vector<std::uint8_t>>& packets) : packets_(packets) {}
  bool waits_to_open() const noexcept override { return false; }
  LinkFault open() noexcept override { return LinkFault::none; }
  void close() noexcept override { unread_.clear(); }
  LinkFault fault() const noexcept override { return LinkFault::none; }
  std::string_view serial() const noexcept override { return "echo"; }
  bool write(std::span<const std::uint8_t> packet) noexcept override {
    packets_.emplace_back(packet.begin(), packet.end());
    unread_.insert(unread_.end(), packet.begin(), packet.end());
    return true;
  }
  std::size_t read(std::span<std::uint8_t> into) noexcept override {
    const std::size_t count = std::min(into.size(), unread_.size());
    std::copy_n(unread_.begin(), count, into.begin());
    unread_.erase(unread_.begin(), unread_.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }
  void discard_input() noexcept override { unread_.clear(); }
  void write_at_once(std::span<const std::uint8_t>) noexcept override {}
  std::int64_t now_ns() const noexcept override { return now_ns_; }
  void wait_until(std::int64_t deadline_ns) noexcept override { now_ns_ = std::max(now_ns_, deadline_ns); }

 private:
  std::vector<std::vector<std::uint8_t>>& packets_;
  std::vector<std::uint8_t> unread_{};
  std::int64_t now_ns_ = 1'000'000'000;
};

TEST(HaplyDriver, WhatSendsBackWhatItIsSentIsNoBoard) {
  std::vector<std::vector<std::uint8_t>> packets;
  auto owned = std::make_unique<EchoPort>(packets);
  EchoPort& port = *owned;
  Haply haply(std::move(owned), HaplyOptions{});
  for (int i = 0; i < 1000; ++i) {
    haply.update();
    haply.wait_until(port.now_ns() + 1'000'000);
    ASSERT_NE(haply.report().state, HaplyState::zero_pose);
  }
  EXPECT_EQ(haply.report().fault, HaplyFault::no_board);
  EXPECT_GT(packets.size(), 0U);
  for (const auto& packet : packets) EXPECT_EQ(packet, (std::vector<std::uint8_t>{2, 5, 0, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(HaplyDriver, WhatIsNoBoardGetsNothingButZeros) {
  for (const char* name : {"silent", "chatty"}) {
    SCOPED_TRACE(name);
    HeldHaply haply;
    haply.port().keeps_packets = true;
    haply.inject(name);
    ASSERT_TRUE(haply.run_until(1.0, [&] { return haply.haply().state == HaplyState::fault; }));
    EXPECT_EQ(haply.haply().fault, HaplyFault::no_board);
    haply.run(5.0);
    for (const WatchedPort::Packet& packet : haply.port().packets) {
      EXPECT_TRUE(is_exchange(packet.bytes)) << "no set up for what is perhaps another program";
      EXPECT_EQ(packet.bytes, (std::vector<std::uint8_t>{2, 5, 0, 0, 0, 0, 0, 0, 0, 0}));
    }
    EXPECT_LE(haply.port().packets.size(), 12U) << "two questions each time at most";
    EXPECT_FALSE(haply.haply().may_still_push) << "this program has never pushed";
    haply.mend();
    EXPECT_TRUE(haply.run_until(3.0, [&] { return haply.haply().state == HaplyState::zero_pose; }));
    EXPECT_TRUE(haply.set_zero_pose());
    EXPECT_EQ(haply.haply().fault, HaplyFault::none);
  }
}

TEST(HaplyDriver, TellsWhyItCannotOpen) {
  for (const auto& [name, fault] :
       {std::pair{"not-allowed", HaplyFault::not_allowed}, std::pair{"busy", HaplyFault::busy}}) {
    HeldHaply::Options options;
    options.device.fault = haply_fault_named(name);
    HeldHaply haply(options);
    haply.run(3.0);
    EXPECT_EQ(haply.haply().state, HaplyState::fault) << name;
    EXPECT_EQ(haply.haply().fault, fault) << name;
    haply.mend();
    EXPECT_TRUE(haply.run_until(3.0, [&] { return haply.haply().state == HaplyState::zero_pose; })) << name;
    EXPECT_TRUE(haply.set_zero_pose()) << name;
    EXPECT_EQ(haply.haply().fault, HaplyFault::none) << name;
  }
}

// Set-ups are not free: each takes memory that the firmware never gives back.
TEST(HaplyDriver, ABoardThatTakesNoSetUpIsNotSetUpForEver) {
  HeldHaply::Options options;
  options.device.fault = haply_fault_named("unconfigured");
  HeldHaply haply(options);
  haply.run(60.0);
  EXPECT_EQ(haply.haply().fault, HaplyFault::restarted);
  EXPECT_LE(haply.truth().set_ups, 3U * 60U);
  haply.mend();
  EXPECT_TRUE(haply.run_until(3.0, [&] { return haply.haply().state == HaplyState::zero_pose; }));
  haply.run(2.0);
  EXPECT_EQ(haply.haply().state, HaplyState::zero_pose);
}

// A host that adds to what is in the counter truncates a fraction of a count, perhaps.
TEST(HaplyDriver, ABoardThatCutsOffsetsIsAccepted) {
  HeldHaply::Options options;
  options.device.board.cuts_offsets = true;
  HeldHaply haply(options);
  EXPECT_TRUE(haply.set_zero_pose());
  EXPECT_LT(haply.misplaced(), 0.5e-3);
}

TEST(HaplyDriver, WithoutAGuardMotorsStayOff) {
  HeldHaply haply;
  haply.port().is_with_guard = false;
  EXPECT_FALSE(haply.get_ready());
  haply.ask_to_arm();
  haply.run(3.0);
  EXPECT_EQ(haply.motors().state, SafetyState::arming);
  EXPECT_FALSE(haply.haply().is_guarded);
}

// From before the first force until a zero was answered.
TEST(HaplyDriver, TheGuardKnowsWhenMotorsMayPush) {
  HeldHaply haply;
  haply.port().on_write = [&](std::span<const std::uint8_t> packet) {
    if (!is_exchange(packet)) return;
    const bool pushes = torque_in(packet, 0) != 0.0F || torque_in(packet, 1) != 0.0F;
    EXPECT_TRUE(!pushes || haply.port().told_may_push);
  };
  ASSERT_TRUE(haply.press());
  EXPECT_TRUE(haply.port().told_may_push);
  haply.disarm();
  haply.run(1.0);
  EXPECT_EQ(haply.motors().state, SafetyState::off);
  EXPECT_FALSE(haply.port().told_may_push);
  EXPECT_FALSE(haply.motors().may_still_push);
}

}  // namespace
}  // namespace ghostforce::haply_driver_test
