// The simulated board as a driver sees it: what a SerialPort promises, the faults of the port, and the guard.
#include "device/virtual_haply/virtual_port.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "tests/device/virtual_haply/hapi_bytes.h"

namespace ghostforce::virtual_port_test {
namespace {

using namespace hapi_bytes;
using Clock = VirtualPort::Clock;
using Kind = HaplyBoard::Kind;

Bytes hear(VirtualPort& port, std::int64_t ns) {
  Bytes heard;
  for (const std::int64_t end_ns = port.now_ns() + ns; port.now_ns() < end_ns;) {
    port.wait_until(end_ns);
    std::array<std::uint8_t, 256> bytes{};
    heard.insert(heard.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(port.read(bytes)));
  }
  return heard;
}

Bytes ask(VirtualPort& port, const Bytes& packet, std::int64_t ns = 2 * ms) {
  EXPECT_TRUE(port.write(packet));
  return hear(port, ns);
}

Bytes exchange(VirtualPort& port, double arm_1 = 0.0, double arm_2 = 0.0) {
  return ask(port, exchange_of_arms(port.bench().variant(), arm_1, arm_2));
}

void set_up(VirtualPort& port) {
  ASSERT_EQ(port.open(), LinkFault::none);
  port.hold_zero_pose(true);
  hear(port, 2000 * ms);
  ask(port, set_up_of(port.bench().variant()));
  port.hold_zero_pose(false);
  hear(port, 1000 * ms);
}

TEST(VirtualPort, IsClosedUntilItIsOpened) {
  VirtualPort port({.clock = Clock::stepped});
  EXPECT_EQ(port.fault(), LinkFault::absent);
  EXPECT_TRUE(port.serial().empty());
  EXPECT_FALSE(port.write(exchange_of(0.0, 0.0)));
  EXPECT_EQ(port.open(), LinkFault::none);
  EXPECT_EQ(port.serial(), "VIRTUALHAPLY1");
  EXPECT_EQ(ask(port, exchange_of(0.0, 0.0)), Bytes{5});
  port.close();
  port.close();
  EXPECT_FALSE(port.write(exchange_of(0.0, 0.0)));
  EXPECT_EQ(port.fault(), LinkFault::none);
}

TEST(VirtualPort, TimeMovesOnlyByWaiting) {
  VirtualPort port({.clock = Clock::stepped});
  EXPECT_EQ(port.now_ns(), 1000 * ms);
  port.wait_until(1003 * ms);
  EXPECT_EQ(port.now_ns(), 1003 * ms);
  port.open();
  port.wait_until(1500 * ms);
  EXPECT_EQ(port.now_ns(), 1500 * ms);
  port.wait_until(3 * ms);
  EXPECT_EQ(port.now_ns(), 1500 * ms);
}

TEST(VirtualPort, AnswersTheWorkedBytesInItsTime) {
  for (const auto& [kind, frame_ns] : {std::pair{Kind::m0, 1000 * us}, std::pair{Kind::m3, 125 * us}}) {
    VirtualPort port({.clock = Clock::stepped, .device = {.board = {.kind = kind}, .starts_in_zero_pose = true}});
    port.open();
    hear(port, 10 * ms);
    ask(port, set_up_v31);
    const std::int64_t asked_ns = port.now_ns();
    ASSERT_TRUE(port.write(exchange_at_port_2));
    port.wait_until(asked_ns + 100 * ms);
    EXPECT_EQ(port.now_ns(), asked_ns + VirtualPort::transfer_ns) << "it has gone out";
    std::array<std::uint8_t, 64> bytes{};
    EXPECT_EQ(port.read(bytes), 0U);
    port.wait_until(asked_ns + 100 * ms);
    EXPECT_EQ(port.now_ns(), (asked_ns + VirtualPort::transfer_ns + frame_ns - 1) / frame_ns * frame_ns);
    ASSERT_EQ(port.read(bytes), reply_v31.size());
    EXPECT_EQ(Bytes(bytes.begin(), bytes.begin() + 9), reply_v31);
    EXPECT_NEAR(std::abs(port.duties()[0]), 0.05 / 0.123, 1e-3);
  }
}

TEST(VirtualPort, IsTheSameEveryTime) {
  const auto run = [] {
    VirtualPort port({.clock = Clock::stepped});
    set_up(port);
    Bytes heard;
    for (int i = 0; i < 200; ++i) {
      if (i == 100) port.lead_hand(haply_hand_at({0.03, 0.1}, 0.05));
      const Bytes reply = exchange(port, 0.05 * std::sin(0.1 * i), 0.02);
      heard.insert(heard.end(), reply.begin(), reply.end());
    }
    return std::pair{heard, port.handle()};
  };
  EXPECT_EQ(run(), run());
}

TEST(VirtualPort, TakesWholePacketsAndForgetsInput) {
  VirtualPort port({.clock = Clock::stepped});
  port.open();
  EXPECT_FALSE(port.write({}));
  EXPECT_FALSE(port.write(std::array<std::uint8_t, 65>{}));
  int taken = 0;
  while (taken < 100 && port.write(exchange_of(0.0, 0.0))) ++taken;
  EXPECT_GT(taken, 1);
  EXPECT_LT(taken, 100);
  port.wait_until(port.now_ns() + 10 * ms);
  while (port.now_ns() < 1100 * ms) port.wait_until(1100 * ms);
  port.discard_input();
  std::array<std::uint8_t, 64> bytes{};
  EXPECT_EQ(port.read(bytes), 0U);
  EXPECT_EQ(ask(port, exchange_of(0.0, 0.0)), Bytes{5});
}

TEST(VirtualPort, CannotBeOpenedWhereSomethingIsInTheWay) {
  VirtualPort port({.clock = Clock::stepped});
  for (const auto& [name, fault] :
       {std::pair{"absent", LinkFault::absent}, std::pair{"unplugged", LinkFault::absent},
        std::pair{"not-allowed", LinkFault::not_allowed}, std::pair{"busy", LinkFault::busy}}) {
    port.inject(haply_fault(name));
    EXPECT_EQ(port.open(), fault) << name;
    EXPECT_EQ(port.fault(), fault) << name;
  }
  port.inject({});
  EXPECT_EQ(port.open(), LinkFault::none);
}

TEST(VirtualPort, PulledOutItLeavesTheForceOn) {
  VirtualPort port({.clock = Clock::stepped});
  set_up(port);
  exchange(port, 0.05, 0.0);
  port.inject(haply_fault("unplugged"));
  port.wait_until(port.now_ns() + 10 * ms);
  EXPECT_EQ(port.fault(), LinkFault::unplugged);
  EXPECT_FALSE(port.write(exchange_of(0.0, 0.0)));
  EXPECT_EQ(port.open(), LinkFault::absent);
  port.wait_until(port.now_ns() + 5000 * ms);
  EXPECT_GT(glm::length(port.force()), 0.3);
  port.inject({});
  ASSERT_EQ(port.open(), LinkFault::none);
  EXPECT_EQ(exchange(port).size(), 9U) << "its set up has survived";
  EXPECT_EQ(port.duties(), (std::array{0.0, 0.0}));
}

TEST(VirtualPort, TouchedAt1200BaudItVanishesWhenClosed) {
  VirtualPort port({.clock = Clock::stepped});
  set_up(port);
  port.inject(haply_fault("touched-1200-baud"));
  EXPECT_EQ(exchange(port).size(), 9U);
  port.close();
  EXPECT_EQ(port.open(), LinkFault::absent);
  port.inject({});
  EXPECT_EQ(port.open(), LinkFault::none);
}

TEST(VirtualPort, WhatIsWrittenBeforeClosingGoesOut) {
  VirtualPort port({.clock = Clock::stepped});
  set_up(port);
  exchange(port, 0.05, 0.0);
  EXPECT_TRUE(port.write(exchange_of(0.0, 0.0)));
  port.close();
  port.wait_until(port.now_ns() + 1 * ms);
  EXPECT_EQ(port.duties(), (std::array{0.0, 0.0}));
}

TEST(VirtualPort, StopsAtOnce) {
  VirtualPort port({.clock = Clock::stepped});
  set_up(port);
  exchange(port, 0.05, 0.0);
  ASSERT_NE(port.duties()[0], 0.0);
  port.write_at_once(exchange_of(0.0, 0.0));
  EXPECT_EQ(port.duties(), (std::array{0.0, 0.0}));
  EXPECT_FALSE(port.write(exchange_of(0.05, 0.0)));
  EXPECT_TRUE(port.write(exchange_of(0.0, 0.0)));
  port.wait_until(port.now_ns() + 10 * ms);
  EXPECT_EQ(port.duties(), (std::array{0.0, 0.0}));

  // To another address it stops nothing, and after a reset neither does the right one.
  VirtualPort other({.clock = Clock::stepped});
  set_up(other);
  exchange(other, 0.05, 0.0);
  ask(other, {0x00, 0x05});
  other.write_at_once(exchange_of(0.0, 0.0));
  EXPECT_NE(other.duties()[0], 0.0);

  VirtualPort closed({.clock = Clock::stepped});
  closed.write_at_once(exchange_of(0.0, 0.0));
  EXPECT_EQ(closed.open(), LinkFault::none);
  EXPECT_TRUE(closed.write(set_up_v31)) << "nothing was open";
}

// The rest of the guard needs a program that stands still: virtual_port_guard_test.cpp.
TEST(VirtualPort, IsLeftAloneWhileSomebodyWaits) {
  VirtualPort port({.clock = Clock::stepped});
  set_up(port);
  port.set_may_push(true);
  exchange(port, 0.05, 0.0);
  hear(port, 1000 * ms);
  EXPECT_EQ(port.fault(), LinkFault::none);
  EXPECT_NE(port.duties()[0], 0.0);
}

}  // namespace
}  // namespace ghostforce::virtual_port_test
