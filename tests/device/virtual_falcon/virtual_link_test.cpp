// The virtual Falcon as a driver sees it: what a FalconLink promises, and arm and hand behind the cable.
#include "device/virtual_falcon/virtual_link.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "device/virtual_falcon/practice_firmware.h"
#include "tests/device/virtual_falcon/link_exchange.h"

namespace ghostforce::virtual_link_test {
namespace {

TEST(VirtualLink, IsClosedUntilItIsOpened) {
  VirtualLink link({.clock = VirtualLink::Clock::stepped});
  EXPECT_EQ(link.fault(), LinkFault::absent);
  EXPECT_TRUE(link.serial().empty());
  EXPECT_FALSE(link.request(run_baud));
  EXPECT_FALSE(link.write(std::array<std::uint8_t, 1>{0x41}));
  EXPECT_EQ(link.open(), LinkFault::none);
  EXPECT_EQ(link.fault(), LinkFault::none);
  EXPECT_FALSE(link.serial().empty());
  EXPECT_EQ(link.modem_status(), 0);
  link.close();
  link.close();
  EXPECT_EQ(link.fault(), LinkFault::none);
  EXPECT_FALSE(link.request(run_baud));
  EXPECT_FALSE(link.serial().empty());
}

TEST(VirtualLink, CannotBeOpenedWhereSomethingIsInTheWay) {
  VirtualLink link({.clock = VirtualLink::Clock::stepped});
  for (const auto& [name, fault] :
       {std::pair{"absent", LinkFault::absent}, std::pair{"unplugged", LinkFault::absent},
        std::pair{"not-allowed", LinkFault::not_allowed}, std::pair{"busy", LinkFault::busy}}) {
    link.inject(injected_fault(name));
    EXPECT_EQ(link.open(), fault) << name;
    EXPECT_EQ(link.fault(), fault) << name;
    EXPECT_FALSE(link.request(run_baud)) << name;
  }
  link.inject({});
  EXPECT_EQ(link.open(), LinkFault::none);
}

TEST(VirtualLink, TimeMovesOnlyByWaiting) {
  VirtualLink link({.clock = VirtualLink::Clock::stepped});
  const std::int64_t start = link.now_ns();
  EXPECT_GT(start, 0);
  link.wait_until(start + 3 * ms);
  EXPECT_EQ(link.now_ns(), start + 3 * ms);
  link.open();
  link.wait_until(start + 50 * ms);
  // There was nothing but status.
  EXPECT_EQ(link.now_ns(), start + 50 * ms);
  EXPECT_GE(link.counters().status_packets, 2U);
  EXPECT_EQ(link.modem_status(), 0x01);
  link.wait_until(start);
  EXPECT_EQ(link.now_ns(), start + 50 * ms);
}

TEST(VirtualLink, SendsOneThingAtATimeInOrder) {
  VirtualLink link({.clock = VirtualLink::Clock::stepped, .device = {.starts_with_firmware = true}});
  link.open();
  request(link, format_8n1);
  EXPECT_FALSE(link.is_sending());
  EXPECT_TRUE(link.request(run_baud));
  EXPECT_TRUE(link.is_sending());
  EXPECT_FALSE(link.request(latency_1));
  EXPECT_FALSE(link.write(encode(CommandFrame{})));
  const std::int64_t start = link.now_ns();
  link.wait_until(start + 100 * ms);
  EXPECT_FALSE(link.is_sending());
  EXPECT_LE(link.now_ns(), start + 1 * ms);
  EXPECT_TRUE(link.write(encode(CommandFrame{})));
  EXPECT_FALSE(link.request(latency_1));
  EXPECT_FALSE(link.write(std::array<std::uint8_t, 65>{}));
  link.wait_until(link.now_ns() + 100 * ms);
  // The answer comes with the timer's next packet, and wakes whoever waits.
  const std::int64_t asked = link.now_ns();
  link.wait_until(asked + 100 * ms);
  EXPECT_LE(link.now_ns(), asked + 17 * ms);
  std::array<std::uint8_t, 64> heard{};
  EXPECT_EQ(link.read(std::span{heard}.first(10)), 10U);
  EXPECT_EQ(link.read(heard), 6U);
  EXPECT_EQ(link.read(heard), 0U);
  EXPECT_EQ(link.counters().bytes_out, 16U);
  EXPECT_EQ(link.counters().bytes_in, 16U);
  EXPECT_FALSE(link.write(std::array<std::uint8_t, 65>{}));
}

TEST(VirtualLink, AFullChipKeepsTheHostWaiting) {
  VirtualLink link({.clock = VirtualLink::Clock::stepped});
  link.open();
  const std::int64_t start = link.now_ns();
  // At 9600 baud 640 bytes are 667 ms, of which the chip holds 256.
  for (int i = 0; i < 10; ++i) {
    ASSERT_TRUE(link.write(std::array<std::uint8_t, 64>{}));
    send(link);
  }
  EXPECT_GT(link.now_ns() - start, 390 * ms);
  EXPECT_LT(link.now_ns() - start, 420 * ms);
}

TEST(VirtualLink, AnUnpluggedCableEndsItAndItCanBeOpenedAgain) {
  VirtualLink link({.clock = VirtualLink::Clock::stepped, .device = {.starts_with_firmware = true}});
  link.open();
  begin_run_time(link);
  ASSERT_TRUE(exchange(link, {}));
  ASSERT_TRUE(link.write(encode(CommandFrame{{900, 900, 900}, 0})));
  link.inject(injected_fault("unplugged"));
  const std::int64_t start = link.now_ns();
  link.wait_until(start + 1000 * ms);
  EXPECT_EQ(link.now_ns(), start);
  EXPECT_EQ(link.fault(), LinkFault::unplugged);
  EXPECT_FALSE(link.is_sending());
  EXPECT_FALSE(link.write(encode(CommandFrame{})));
  EXPECT_EQ(link.device().motors(), MotorNumbers{});
  // Nothing to wait for, and no endless loop either.
  link.wait_until(start + 10 * ms);
  EXPECT_EQ(link.now_ns(), start + 10 * ms);
  link.close();
  EXPECT_EQ(link.fault(), LinkFault::unplugged);
  EXPECT_EQ(link.open(), LinkFault::absent);
  link.inject({});
  EXPECT_EQ(link.open(), LinkFault::none);
  EXPECT_EQ(link.counters().bytes_out, 0U);
  // The USB chip has its current from the cable, and the processor behind it has not.
  EXPECT_FALSE(exchange(link, {}));
  begin_run_time(link);
  EXPECT_TRUE(exchange(link, {}));
}

TEST(VirtualLink, ClosingForgetsNothingThatTheDeviceKnows) {
  VirtualLink link(
      {.clock = VirtualLink::Clock::stepped, .device = {.starts_with_firmware = true, .starts_homed = true}});
  link.open();
  begin_run_time(link);
  ASSERT_TRUE(exchange(link, {}));
  link.close();
  link.wait_until(link.now_ns() + 5000 * ms);
  ASSERT_EQ(link.open(), LinkFault::none);
  const auto reply = exchange(link, {});
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->status, ReplyFrame::homed);
  // No backlog of the time meanwhile.
  EXPECT_LE(link.counters().status_packets, 5U);
}

TEST(VirtualLink, ShakesHandsLoadsHomesAndHoldsTheHandle) {
  VirtualLink link({.clock = VirtualLink::Clock::stepped, .hand = {.homes_when_asked = true}});
  link.open();
  ASSERT_TRUE(load_firmware(link, practice_firmware(1000)));
  begin_run_time(link);
  int seconds_ms = 0;
  std::optional<ReplyFrame> reply;
  do {
    reply = exchange(link, {{}, CommandFrame::homing | CommandFrame::red});
    ASSERT_TRUE(reply);
  } while (reply->status != ReplyFrame::homed && ++seconds_ms < 5000);
  EXPECT_EQ(reply->status, ReplyFrame::homed);
  EXPECT_EQ(link.device().lights(), CommandFrame::red);
  // The hand brings it back to the middle.
  for (int i = 0; i < 2000; ++i) reply = exchange(link, {{}, CommandFrame::green});
  EXPECT_LT(glm::length(link.arm().position() - HandPlan::centre), 1e-6);
  EXPECT_EQ(reply->encoders, (std::array<std::int16_t, 3>{-200, -200, -200}));
}

TEST(VirtualLink, TheMotorsMoveTheHandleAgainstTheHand) {
  VirtualLink link(
      {.clock = VirtualLink::Clock::stepped, .device = {.starts_with_firmware = true, .starts_homed = true}});
  link.open();
  begin_run_time(link);
  const CommandFrame command{{400, 100, 0}, CommandFrame::blue};
  std::optional<ReplyFrame> reply;
  for (int i = 0; i < 2000; ++i) reply = exchange(link, command);
  ASSERT_TRUE(reply);
  EXPECT_EQ(link.motors(), command.motors);
  EXPECT_EQ(link.device().last_command(), command);
  EXPECT_EQ(link.device().frames(), 2000U);
  const Vector<3> pull = link.hand().stiffness() * (link.hand().goal() - link.arm().position());
  EXPECT_GT(glm::length(pull), 0.5);
  // One count is 0.015 mm, and at 100 N/m that is 1.5 mN; at rest it is far less.
  EXPECT_LT(glm::length(pull + link.arm().force()), 1e-4);
  // What a driver makes of the counts is where the handle is, as near as counts can say.
  const FalconGeometry geometry;
  const Vector<3> counts{reply->encoders[0], reply->encoders[1], reply->encoders[2]};
  const ForwardKinematics seen = FalconKinematics(geometry).position(angles_of_counts(counts, geometry));
  EXPECT_TRUE(seen.has_converged);
  EXPECT_LT(glm::length(seen.position - link.arm().position()), 5e-5);
}

TEST(VirtualLink, TheHandsButtonsReachTheDriver) {
  VirtualLink link({.clock = VirtualLink::Clock::stepped, .device = {.starts_with_firmware = true}});
  link.open();
  begin_run_time(link);
  EXPECT_EQ(exchange(link, {})->status, 0);
  HandPlan plan;
  plan.waypoints[0].buttons = ReplyFrame::button_centre;
  link.lead_hand(plan);
  exchange(link, {});
  EXPECT_EQ(exchange(link, {})->status, ReplyFrame::button_centre);
}

TEST(VirtualLink, ExchangesAtTheRateOfTheRealOne) {
  VirtualLink link({.clock = VirtualLink::Clock::stepped, .device = {.starts_with_firmware = true}});
  link.open();
  begin_run_time(link);
  exchange(link, {});
  const std::int64_t start = link.now_ns();
  for (int i = 0; i < 1000; ++i) ASSERT_TRUE(exchange(link, {}));
  EXPECT_NEAR(static_cast<double>(link.now_ns() - start), 1e9, 5e6);
}

TEST(VirtualLink, TheSameHappensEveryTime) {
  const auto run = [] {
    VirtualLink link({.clock = VirtualLink::Clock::stepped, .device = {.starts_with_firmware = true}});
    link.open();
    begin_run_time(link);
    for (int i = 0; i < 500; ++i) exchange(link, {{static_cast<std::int16_t>(i), 0, -200}, 0});
    return std::pair{link.arm().position(), link.now_ns()};
  };
  EXPECT_EQ(run(), run());
}

TEST(VirtualLink, TheEmergencyStopReachesTheMotorsPastTheLine) {
  VirtualLink link({.clock = VirtualLink::Clock::stepped, .device = {.starts_with_firmware = true}});
  link.open();
  begin_run_time(link);
  exchange(link, {{2000, -2000, 2000}, 0});
  EXPECT_EQ(link.motors(), (MotorNumbers{2000, -2000, 2000}));
  link.send_at_once(encode(CommandFrame{{-3, 2, 1}, 0}));
  EXPECT_EQ(link.motors(), (MotorNumbers{-3, 2, 1}));
  link.send_at_once(encode(CommandFrame{}));
  EXPECT_EQ(link.motors(), MotorNumbers{});
}

TEST(VirtualLink, BytesThatNobodyTakesAreCountedWhenThereAreTooMany) {
  VirtualLink link({.clock = VirtualLink::Clock::stepped, .device = {.starts_with_firmware = true}});
  link.open();
  begin_run_time(link);
  constexpr int frames = 1100;
  for (int i = 0; i < frames; ++i) {
    ASSERT_TRUE(link.write(encode(CommandFrame{})));
    send(link);
    link.wait_until(link.now_ns() + 1 * ms);
  }
  link.wait_until(link.now_ns() + 3 * ms);
  EXPECT_EQ(link.counters().bytes_in, frames * 16U);
  EXPECT_EQ(link.counters().discarded_bytes, frames * 16U - 16384U);
}

// The one test with a real clock: that it is CLOCK_MONOTONIC's, and moves by itself.
TEST(VirtualLink, CanLiveByTheClockOfEverybody) {
  VirtualLink link({.device = {.starts_with_firmware = true}});
  link.open();
  begin_run_time(link);
  const std::int64_t start = link.now_ns();
  int answered = 0;
  for (int i = 0; i < 10; ++i) answered += exchange(link, {}) ? 1 : 0;
  EXPECT_EQ(answered, 10);
  // Not before the timer lets it; how much later is this machine's business.
  EXPECT_GE(link.now_ns() - start, 8 * ms);
}

}  // namespace
}  // namespace ghostforce::virtual_link_test
