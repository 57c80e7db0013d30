// The firmware of a board: the protocol's worked bytes, and all that is awkward about it.
#include "device/virtual_haply/haply_board.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/device/virtual_haply/hapi_bytes.h"

namespace ghostforce::haply_board_test {
namespace {

using namespace hapi_bytes;
using Kind = HaplyBoard::Kind;

// A board, and a clock that moves as it is told.
struct Host {
  explicit Host(Kind kind = Kind::m3, bool cuts_offsets = false) : board({kind, cuts_offsets}) {}

  void send(const Bytes& bytes) { board.receive(bytes, now_ns); }
  void wait(std::int64_t ns) {
    now_ns += ns;
    board.run_until(now_ns);
  }
  Bytes hear(std::int64_t ns = 1 * ms) {
    wait(ns);
    Bytes heard;
    while (const auto reply = board.take_reply()) {
      heard.insert(heard.end(), reply->bytes.begin(), reply->bytes.begin() + static_cast<std::ptrdiff_t>(reply->size));
      left_ns = reply->left_ns;
    }
    return heard;
  }
  Bytes ask(const Bytes& bytes, std::int64_t ns = 1 * ms) {
    send(bytes);
    return hear(ns);
  }

  HaplyBoard board;
  std::int64_t now_ns = 1'000'000'010;  // beside the grid of its passes
  std::int64_t left_ns = 0;
};

constexpr double one_step = 1.0 / 4095.0;

TEST(HaplyBoard, AnswersTheWorkedBytes) {
  Host host;
  EXPECT_TRUE(host.ask(set_up_v31).empty());
  EXPECT_EQ(host.ask(exchange_at_port_2), reply_v31);
  EXPECT_EQ(host.board.duty(0), 0.0);
  // Direction 1: the pin is high.
  EXPECT_NEAR(host.board.duty(1), -0.05 / 0.123, one_step);

  Host v2;
  v2.send(set_up_v2);
  EXPECT_EQ(v2.ask(exchange_at_port_2), (Bytes{0x05, 0x00, 0x00, 0x74, 0xc2, 0x00, 0x00, 0x71, 0x43}));
  EXPECT_EQ(set_up_of(*find_virtual_haply_variant("v2")), set_up_v2);
  EXPECT_EQ(set_up_of(*find_virtual_haply_variant("v3.1")), set_up_v31);
}

TEST(HaplyBoard, LooksForACommandEvery50Microseconds) {
  Host host;
  host.ask(set_up_v31);
  host.send(exchange_at_port_2);
  EXPECT_TRUE(host.hear(39 * us).empty());
  EXPECT_EQ(host.hear(11 * us), reply_v31);
  EXPECT_EQ(host.left_ns % HaplyBoard::pass_ns, 0);
}

TEST(HaplyBoard, CutsOffsetsToWholeCountsIfItIsToldTo) {
  Host host(Kind::m3, true);
  host.send(set_up_v31);
  const Bytes reply = host.ask(exchange_at_port_2);
  EXPECT_FLOAT_EQ(number_of(reply, 1), 162.0F * 360.0F / 4880.0F);
  EXPECT_FLOAT_EQ(number_of(reply, 5), 2277.0F * 360.0F / 4880.0F);
}

TEST(HaplyBoard, CountsEdgesByDirectionAndBoard) {
  for (const Kind kind : {Kind::m0, Kind::m3, Kind::dev_kit}) {
    Host host(kind);
    host.send({0x01, 5, 0x03, 0, 0, 0x03, 0, 1, 0, 0});
    Bytes numbers;
    for (const double number : {10.0, 1000.0, 20.0, 1000.0}) add_number(numbers, number);
    host.send(numbers);
    host.wait(1 * ms);
    host.board.count(0, 100);
    host.board.count(1, 100);
    const Bytes reply = host.ask(exchange_of(0.0, 0.0));
    // On an M0 half of the edges are reckoned with half of the counts.
    EXPECT_FLOAT_EQ(number_of(reply, 1), 46.0F);
    EXPECT_FLOAT_EQ(number_of(reply, 5), -16.0F);
    host.board.count(0, 1);
    EXPECT_EQ(number_of(host.ask(exchange_of(0.0, 0.0)), 1) > 46.0F, kind != Kind::m0) << "one edge";
  }
}

TEST(HaplyBoard, PushesByDirectionAndBoard) {
  const auto duties = [](Kind kind, std::uint8_t direction, double torque) {
    Host host(kind);
    Bytes set_up{0x01, 5, 0x03, direction, direction, 0, 0, 0};
    host.ask(set_up);
    host.ask(exchange_of(torque, torque));
    return std::array{host.board.duty(0), host.board.duty(1)};
  };
  for (const Kind kind : {Kind::m0, Kind::m3}) {
    EXPECT_GT(duties(kind, 0, 0.05)[0], 0.4);
    EXPECT_GT(duties(kind, 0, 0.05)[1], 0.4);
    EXPECT_LT(duties(kind, 1, 0.05)[0], -0.4);
    EXPECT_LT(duties(kind, 0, -0.05)[1], -0.4);
    EXPECT_GT(duties(kind, 1, -0.05)[1], 0.4);
  }
  // Only the first port, and the third, are the other way round.
  EXPECT_LT(duties(Kind::dev_kit, 0, 0.05)[0], -0.4);
  EXPECT_GT(duties(Kind::dev_kit, 0, 0.05)[1], 0.4);
}

TEST(HaplyBoard, ClipsAndStepsTheDuty) {
  for (const auto& [kind, steps] : {std::pair{Kind::m0, 1023.0}, std::pair{Kind::m3, 4095.0}}) {
    Host host(kind);
    host.ask({0x01, 5, 0x03, 0, 0, 0, 0, 0});
    host.ask(exchange_of(0.2, -7.0));
    EXPECT_EQ(host.board.duty(0), 1.0);
    EXPECT_EQ(host.board.duty(1), -1.0);
    host.ask(exchange_of(0.123 / steps * 0.9, 0.123 / steps * 2.5));
    EXPECT_EQ(host.board.duty(0), 0.0);
    EXPECT_DOUBLE_EQ(host.board.duty(1), 2.0 / steps);
    host.ask(exchange_of(std::numeric_limits<double>::quiet_NaN(), 0.0));
    EXPECT_EQ(std::abs(host.board.duty(0)), 1.0) << "the worst that is left open";
  }
}

TEST(HaplyBoard, ResetForgetsAddressesAndLeavesTheDuty) {
  Host host;
  host.ask(set_up_v31);
  host.ask(exchange_at_port_2);
  const double pushing = host.board.duty(1);
  ASSERT_NE(pushing, 0.0);
  host.ask({0x00, 0x05});
  EXPECT_EQ(host.board.motor_address(1), 0);
  EXPECT_EQ(host.board.duty(1), pushing);
  // No exchange of the host's reaches the motor any more: the address is all that comes back.
  EXPECT_EQ(host.ask(exchange_of(0.0, 0.0)), Bytes{5});
  EXPECT_EQ(host.board.duty(1), pushing);
  host.wait(100'000 * ms);
  EXPECT_EQ(host.board.duty(1), pushing) << "nobody watches";
  // The set up stops it.
  host.ask(set_up_v31);
  EXPECT_EQ(host.board.duty(1), 0.0);
  EXPECT_EQ(host.ask(exchange_of(0.0, 0.0)), reply_v31);
}

TEST(HaplyBoard, AProbeOfAnUnconfiguredBoardIsFourResets) {
  Host host;
  EXPECT_EQ(host.ask(exchange_of(0.0, 0.0, 7)), Bytes{7});
  EXPECT_EQ(host.board.resets(), 4U);
  host.ask(set_up_v31);
  EXPECT_EQ(host.ask(exchange_of(0.0, 0.0, 7)), Bytes{7}) << "another one's";
  EXPECT_EQ(host.board.resets(), 8U);
  EXPECT_EQ(host.board.motor_address(0), 0);
}

TEST(HaplyBoard, AddressZeroMeansAllThatIsUnused) {
  Host host;
  // It wants 14 bytes for pins and four torques; 10 bytes are not enough.
  host.send(exchange_of(0.0, 0.0, 0));
  EXPECT_TRUE(host.hear(900 * ms).empty());
  EXPECT_TRUE(host.board.is_waiting());
  host.send(Bytes(14 + 16 - 8, 0));
  const Bytes reply = host.hear();
  ASSERT_EQ(reply.size(), 1U + 4U * 12U + 4U * 4U);
  EXPECT_TRUE(std::isnan(number_of(reply, 1 + 4 * 12)));

  // After a reset it drives the motors that somebody has set up before.
  host.ask(set_up_v31);
  host.ask({0x00, 0x05});
  Bytes all{0x02, 0x00};
  all.insert(all.end(), 14, 0);
  for (int i = 0; i < 4; ++i) add_number(all, 0.1);
  host.ask(all);
  EXPECT_NEAR(std::abs(host.board.duty(0)), 0.1 / 0.123, one_step);
  EXPECT_EQ(host.board.duty(2), 0.0) << "this one has no pins";
}

TEST(HaplyBoard, DropsWhatIsNoCommandByteByByte) {
  Host host;
  host.ask(set_up_v31);
  host.wait(40 * us);  // to the next pass but 0
  host.send(Bytes(100, 0x41));
  host.send(exchange_of(0.0, 0.0));
  EXPECT_TRUE(host.hear(99 * 50 * us).empty());
  EXPECT_EQ(host.hear(2 * 50 * us), reply_v31);
  EXPECT_EQ(host.board.dropped_bytes(), 100U);
}

TEST(HaplyBoard, ATornPacketIsReadAsCommands) {
  Host host;
  host.ask(set_up_v31);
  host.ask(exchange_at_port_2);
  // The command alone: the address counts as 255, which is nobody's.
  EXPECT_EQ(host.ask({0x02}), Bytes{255});
  // The address is no command; the first four bytes of the torques are two resets, and the rest is nothing.
  EXPECT_TRUE(host.ask({0x05, 0x00, 0x00, 0x00, 0x00, 0xcd, 0xcc, 0x4c, 0x3d}).empty());
  EXPECT_EQ(host.board.motor_address(0), 0);
  EXPECT_NE(host.board.duty(1), 0.0) << "and the motor goes on";
}

TEST(HaplyBoard, WaitsASecondForTorquesAndDoesNothingElse) {
  Host host;
  host.ask(set_up_v31);
  host.ask(exchange_at_port_2);
  const std::int64_t asked_ns = host.now_ns;
  EXPECT_TRUE(host.ask({0x02, 0x05, 0x00, 0x00}, 900 * ms).empty());
  EXPECT_TRUE(host.board.is_waiting());
  // What comes meanwhile is taken for torques: the first six bytes of a packet of zeros.
  EXPECT_EQ(host.ask(exchange_of(0.0, 0.0)), reply_v31);
  EXPECT_FLOAT_EQ(static_cast<float>(host.board.duty(0)), 0.0F) << "02 05 is small";
  EXPECT_EQ(host.board.resets(), 2U) << "and the rest for resets";

  host.ask(set_up_v31);
  EXPECT_TRUE(host.ask({0x02, 0x05}, 999 * ms).empty());
  EXPECT_EQ(host.hear(2 * ms), reply_v31) << "then it goes on with what was in memory";
  EXPECT_GT(host.left_ns, asked_ns + HaplyBoard::patience_ns);
}

TEST(HaplyBoard, DirectionsGoByOrdinalNotByPort) {
  // Only port 2, direction 1: that lands at port 1.
  Host host;
  host.ask({0x01, 5, 0x02, 1, 0, 0, 0});
  Bytes push{0x02, 5};
  add_number(push, 0.1);
  host.ask(push);
  EXPECT_GT(host.board.duty(1), 0.0);
  // The dev kit turns port 2 round at each set up.
  Host kit(Kind::dev_kit);
  std::vector<bool> signs;
  for (int i = 0; i < 4; ++i) {
    kit.ask({0x01, 5, 0x02, 0, 0, 0, 0});
    EXPECT_EQ(kit.board.duty(1), 0.0);
    kit.ask(push);
    signs.push_back(kit.board.duty(1) > 0.0);
  }
  EXPECT_EQ(signs, (std::vector{true, false, true, false}));
}

TEST(HaplyBoard, TakesAnaloguePinsAndOutputsIntoAccount) {
  Host host;
  Bytes set_up{0x01, 5, 0x03, 0, 0, 0x01, 0, 2, 54, 55, 1, 9};
  add_number(set_up, 90.0);
  add_number(set_up, 1000.0);
  host.ask(set_up);
  Bytes exchange{0x02, 5, 200};
  add_number(exchange, 0.123);
  add_number(exchange, 0.0);
  const Bytes reply = host.ask(exchange);
  ASSERT_EQ(reply.size(), 1U + 8U + 4U);
  EXPECT_FLOAT_EQ(number_of(reply, 9), 90.0F);
  EXPECT_EQ(host.board.duty(0), 1.0);
}

TEST(HaplyBoard, ARestartForgetsAllAndStopsTheMotors) {
  Host host;
  host.ask(set_up_v31);
  host.ask(exchange_at_port_2);
  host.board.restart();
  EXPECT_EQ(host.board.duty(1), 0.0);
  EXPECT_EQ(host.ask(exchange_of(0.0, 0.0)), Bytes{5});
}

}  // namespace
}  // namespace ghostforce::haply_board_test
