// The bench with each of its faults: what their sentences say. Those of the port are in virtual_port_test.cpp.
#include "device/virtual_haply/haply_fault.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/device/virtual_haply/bench_host.h"

namespace ghostforce::haply_fault_test {
namespace {

using namespace hapi_bytes;

TEST(HaplyFault, HasOneNameEachAndDoesSomething) {
  for (const InjectedHaplyFaultKind& kind : injected_haply_fault_catalog()) {
    EXPECT_EQ(find_injected_haply_fault(kind.name), &kind);
    EXPECT_NE(haply_fault(kind.name), InjectedHaplyFault{}) << kind.name;
    EXPECT_TRUE(kind.sentence.ends_with('.')) << kind.name;
  }
  EXPECT_EQ(injected_haply_fault_catalog().size(), 32U);
  EXPECT_EQ(find_injected_haply_fault("nonsense"), nullptr);
}

// A board that has been set up, with a fault afterwards.
struct Set : BenchHost {
  explicit Set(std::string_view fault = {}, const HaplyBench::Options& options = {}) : BenchHost(options) {
    set_up();
    if (!fault.empty()) inject(fault);
  }
};

TEST(HaplyFault, WithoutPowerNothingTurnsAndNothingCounts) {
  Set host;
  host.exchange(0.05, 0.0);
  host.inject("power-lost");
  const double angle = host.angle(host.exchange(0.05, 0.0), 0);
  EXPECT_EQ(host.bench.truth().duties, (std::array{0.0, 0.0}));
  EXPECT_EQ(host.bench.truth().torques, Vector<2>{0.0});
  host.bench.lead_hand(haply_hand_at({0.04, 0.1}));
  host.hear(500 * ms);
  EXPECT_EQ(host.angle(host.exchange(), 0), angle);
  EXPECT_GT(std::abs(host.true_angle(0) - angle), 5.0);
}

TEST(HaplyFault, TheBoardTakesNoSetUp) {
  Set host("unconfigured");
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(host.exchange(), Bytes{5});
    host.ask(set_up_v31);
  }
  host.inject(InjectedHaplyFault{});
  host.ask(set_up_v31);
  EXPECT_EQ(host.exchange().size(), 9U);
}

TEST(HaplyFault, AnotherProgramHasSetUpTheBoardAndPushes) {
  Set host("other-id");
  EXPECT_NE(host.bench.truth().duties[0], 0.0);
  EXPECT_EQ(host.bench.truth().address, 9);
  EXPECT_EQ(host.exchange(), Bytes{5});
  EXPECT_NE(host.bench.truth().duties[0], 0.0) << "zeros for another address stop nothing";
  host.ask(set_up_v31);
  EXPECT_EQ(host.bench.truth().duties[0], 0.0);
  EXPECT_EQ(host.exchange().size(), 9U);
}

TEST(HaplyFault, APacketIsTornOnce) {
  Set host("torn-packet");
  EXPECT_EQ(host.ask(exchange_of(0.0, 0.0)), Bytes{255});
  EXPECT_FALSE(host.bench.truth().is_configured) << "zeros were resets";
  host.ask(set_up_v31);
  EXPECT_EQ(host.exchange().size(), 9U) << "once";
}

TEST(HaplyFault, RepliesComeLate) {
  for (const auto& [name, delay_ns] : {std::pair{"late-5ms", 5 * ms}, std::pair{"late-50ms", 50 * ms}}) {
    Set host(name);
    EXPECT_TRUE(host.ask(exchange_of(0.0, 0.0), delay_ns - 100 * us).empty()) << name;
    EXPECT_EQ(host.hear(1 * ms).size(), 9U) << name;
  }
  Set creeping("late-creeping");
  for (int i = 0; i < 9; ++i) EXPECT_EQ(creeping.ask(exchange_of(0.0, 0.0), 1100 * us).size(), 9U) << i;
  for (int i = 9; i < 30; ++i) creeping.ask(exchange_of(0.0, 0.0), 5 * ms);
  EXPECT_TRUE(creeping.ask(exchange_of(0.0, 0.0), 3 * ms).empty());
}

// Which of the next 40 replies are not 9 bytes long.
std::vector<int> spoilt_of_forty(std::string_view fault) {
  Set host(fault);
  std::vector<int> spoilt;
  for (int i = 1; i <= 40; ++i) {
    if (host.exchange(0.01, 0.0).size() != 9) spoilt.push_back(i);
  }
  EXPECT_NEAR(host.bench.truth().torques.x, 0.01, 1e-4) << "all are obeyed";
  host.inject(InjectedHaplyFault{});
  EXPECT_EQ(host.exchange().size(), 9U);
  return spoilt;
}

TEST(HaplyFault, RepliesAreLostOrShort) {
  EXPECT_EQ(spoilt_of_forty("lost-reply"), (std::vector{1}));
  EXPECT_EQ(spoilt_of_forty("lost-replies"), (std::vector{10, 20, 30, 40}));
  EXPECT_EQ(spoilt_of_forty("mute").size(), 40U);
  EXPECT_EQ(spoilt_of_forty("short-reply"), (std::vector{1}));
  EXPECT_EQ(spoilt_of_forty("no-dtr").size(), 40U);
  EXPECT_EQ(Set("short-reply").exchange().size(), 6U);
}

TEST(HaplyFault, RepliesComeTwice) {
  Set host("duplicated-replies");
  const Bytes replies = host.exchange();
  ASSERT_EQ(replies.size(), 18U);
  EXPECT_TRUE(std::equal(replies.begin(), replies.begin() + 9, replies.begin() + 9));
}

TEST(HaplyFault, AModemManagerTalksBothWays) {
  Set host("garbage");
  const std::uint64_t dropped = host.bench.board().dropped_bytes();
  int longer = 0;
  for (int i = 0; i < 40; ++i) {
    const Bytes reply = host.exchange();
    longer += reply.size() == 17 && reply[0] == 'A' ? 1 : 0;
  }
  EXPECT_EQ(longer, 4);
  EXPECT_EQ(host.bench.board().dropped_bytes() - dropped, 4U * 8U);
}

TEST(HaplyFault, AMotorPushesTheOtherWay) {
  Set first("wrong-sign-1");
  first.exchange(0.05, 0.04);
  EXPECT_NEAR(first.bench.truth().torques.x, -0.05, 1e-4);
  EXPECT_NEAR(first.bench.truth().torques.y, 0.04, 1e-4);
  Set second("wrong-sign-2");
  second.exchange(0.05, 0.04);
  EXPECT_NEAR(second.bench.truth().torques.x, 0.05, 1e-4);
  EXPECT_NEAR(second.bench.truth().torques.y, -0.04, 1e-4);
}

TEST(HaplyFault, EncodersCountHalf) {
  BenchHost host({.fault = haply_fault("half-resolution")});
  host.set_up();
  EXPECT_NEAR(host.angle(host.exchange(), 0) - 168.0, 0.5 * (host.true_angle(0) - 168.0), 0.2);
}

TEST(HaplyFault, ThePersonHoldsTheArmsWrong) {
  for (const VirtualHaplyVariant& variant : virtual_haply_variants()) {
    BenchHost host({.variant = variant.name, .fault = haply_fault("wrong-zero-pose")});
    host.set_up();
    const Bytes reply = host.exchange();
    EXPECT_NEAR(host.angle(reply, 0) - host.true_angle(0), -8.0, 0.3) << variant.name;
    EXPECT_NEAR(host.angle(reply, 1) - host.true_angle(1), 8.0, 0.3) << variant.name;
  }
}

TEST(HaplyFault, AnglesAreImpossibleOrNoNumbers) {
  Set impossible("impossible-angles");
  for (int i = 0; i < 3; ++i) {
    const Bytes reply = impossible.exchange();
    const Vector<2> said = radians_per_degree * Vector<2>{impossible.angle(reply, 0), impossible.angle(reply, 1)};
    EXPECT_LT(std::ranges::min(HaplyArms::room(impossible.bench.variant().geometry, said)), 0.0);
  }
  Set none("not-a-number");
  const Bytes reply = none.exchange();
  EXPECT_TRUE(std::isnan(none.angle(reply, 0)) != std::isnan(none.angle(reply, 1)));
  EXPECT_FALSE(std::isnan(none.angle(none.exchange(), 0))) << "once";
}

TEST(HaplyFault, EncodersFreezeOrJump) {
  const auto moved = [](std::string_view fault) {
    Set host(fault);
    const Bytes before = host.exchange();
    host.bench.lead_hand(haply_hand_at({0.019, 0.11}));
    host.hear(500 * ms);
    const Bytes after = host.exchange();
    return std::array{host.angle(after, 0) != host.angle(before, 0), host.angle(after, 1) != host.angle(before, 1)};
  };
  EXPECT_EQ(moved("frozen-encoder"), (std::array{false, true}));
  EXPECT_EQ(moved("frozen-encoders"), (std::array{false, false}));

  Set host;
  const double before = host.angle(host.exchange(), 0);
  host.inject("encoder-jump");
  EXPECT_NEAR(host.angle(host.exchange(), 0), before, 0.2) << "no motor pushes";
  host.exchange(0.02, 0.0);
  EXPECT_NEAR(host.angle(host.exchange(), 0), before + 20.0, 0.2);
  EXPECT_NEAR(host.angle(host.exchange(), 0), before + 20.0, 0.2) << "once";
}

TEST(HaplyFault, TheBoardRestarts) {
  Set host;
  host.exchange(0.05, 0.0);
  host.inject("restarts");
  EXPECT_EQ(host.bench.truth().duties, (std::array{0.0, 0.0}));
  EXPECT_EQ(host.exchange(), Bytes{5});
  host.ask(set_up_v31);
  EXPECT_EQ(host.exchange().size(), 9U) << "once";
}

TEST(HaplyFault, OneTorqueIsTakenForANegativeOne) {
  Set host("garbage-float");
  host.exchange(-0.05, 0.0);
  EXPECT_NEAR(host.bench.truth().torques.x, -0.05, 1e-4) << "nothing is added to a sign that is there";
  host.exchange(0.05, 0.0);
  EXPECT_NEAR(host.bench.truth().torques.x, -0.05, 1e-4);
  host.exchange(0.05, 0.0);
  EXPECT_NEAR(host.bench.truth().torques.x, 0.05, 1e-4) << "once";
}

TEST(HaplyFault, NoSuchBoardIsThere) {
  Set silent("silent");
  EXPECT_TRUE(silent.ask(exchange_of(0.05, 0.05), 1000 * ms).empty());
  EXPECT_EQ(silent.bench.truth().torques, Vector<2>{0.0});

  Set chatty("chatty");
  const Bytes heard = chatty.ask(exchange_of(0.05, 0.05), 100 * ms);
  EXPECT_EQ(std::ranges::count(heard, '\n'), 10);
  EXPECT_EQ(chatty.bench.truth().torques, Vector<2>{0.0});
}

}  // namespace
}  // namespace ghostforce::haply_fault_test
