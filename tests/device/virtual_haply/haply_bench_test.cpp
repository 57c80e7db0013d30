// Board, arms and hand together: signs and angles of each variant on each board, the zero pose, forces.
#include "device/virtual_haply/haply_bench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "tests/device/virtual_haply/bench_host.h"

namespace ghostforce::haply_bench_test {
namespace {

using namespace hapi_bytes;
using Kind = HaplyBoard::Kind;

TEST(HaplyBench, GivesTrueAnglesAfterTheZeroPose) {
  for (const VirtualHaplyVariant& variant : virtual_haply_variants()) {
    for (const Kind kind : {Kind::m0, Kind::m3, Kind::dev_kit}) {
      SCOPED_TRACE(std::string(variant.name) + " " + std::to_string(static_cast<int>(kind)));
      BenchHost host({.board = {.kind = kind}, .variant = variant.name});
      host.set_up();
      EXPECT_TRUE(host.bench.truth().is_configured);
      const Bytes reply = host.exchange();
      ASSERT_EQ(reply.size(), 9U);
      for (const std::size_t arm : {0U, 1U}) EXPECT_NEAR(host.angle(reply, arm), host.true_angle(arm), 0.2);
    }
  }
}

TEST(HaplyBench, APositiveTorqueIncreasesTheAngleOnM0AndM3) {
  for (const VirtualHaplyVariant& variant : virtual_haply_variants()) {
    for (const Kind kind : {Kind::m0, Kind::m3}) {
      for (const std::size_t arm : {0U, 1U}) {
        SCOPED_TRACE(std::string(variant.name));
        BenchHost host({.board = {.kind = kind}, .variant = variant.name});
        host.set_up();
        const double before = host.angle(host.exchange(), arm);
        for (int i = 0; i < 100; ++i) host.exchange(arm == 0 ? 0.03 : 0.0, arm == 1 ? 0.03 : 0.0);
        EXPECT_GT(host.angle(host.exchange(), arm), before + 1.0);
      }
    }
  }
}

TEST(HaplyBench, ADevKitPushesTheOtherWayAtItsFirstPort) {
  BenchHost host({.board = {.kind = Kind::dev_kit}});
  host.set_up();
  host.exchange(0.05, 0.05);
  EXPECT_NEAR(host.bench.truth().torques.x, 0.05, 1e-4) << "port 2";
  EXPECT_NEAR(host.bench.truth().torques.y, -0.05, 1e-4) << "port 1";
  BenchHost rewired({.board = {.kind = Kind::dev_kit}, .wiring_signs = {1.0, -1.0}});
  rewired.set_up();
  rewired.exchange(0.05, 0.05);
  EXPECT_NEAR(rewired.bench.truth().torques.y, 0.05, 1e-4);
}

TEST(HaplyBench, HasTheTorquesAndCountsThatItIsGiven) {
  BenchHost host({.full_torques = {0.1, 0.2}, .counts_per_turn = Vector<2>{2440.0, 9760.0}});
  host.set_up();
  const Bytes reply = host.exchange(0.123, -0.123);
  EXPECT_NEAR(host.bench.truth().torques.x, 0.1, 1e-12);
  EXPECT_NEAR(host.bench.truth().torques.y, -0.2, 1e-12);
  EXPECT_NEAR(host.angle(reply, 0) - 168.0, 0.5 * (host.true_angle(0) - 168.0), 1.0);
  EXPECT_NEAR(host.angle(reply, 1) - 12.0, 2.0 * (host.true_angle(1) - 12.0), 1.0);
}

TEST(HaplyBench, OneMotorPushesAlongItsArmsDistalLink) {
  BenchHost host;
  host.set_up();
  for (int i = 0; i < 500; ++i) host.exchange(0.05, 0.0);
  const auto place = *host.bench.variant().geometry.place(host.bench.arms().angles());
  const Vector<2> force = host.bench.truth().force;
  const Vector<2> link = (place.handle - place.elbow_1) / 0.09;
  EXPECT_NEAR(force.x * link.y - force.y * link.x, 0.0, 1e-9);
  EXPECT_GT(glm::length(force), 0.5);
  // The hand has yielded.
  EXPECT_NEAR(glm::length(host.bench.arms().handle() - host.bench.hand().pull().goal), glm::length(force) / 100.0,
              5e-4);
}

TEST(HaplyBench, TheForceStandsWhenTheHostFallsSilent) {
  BenchHost host;
  host.set_up();
  host.exchange(0.05, 0.0);
  host.hear(10'000 * ms);
  EXPECT_NEAR(host.bench.truth().torques.x, 0.05, 1e-4);
  EXPECT_GE(host.bench.truth().silence_ns(), 10'000 * ms);
  host.bench.lose_cable();
  host.hear(1000 * ms);
  EXPECT_NEAR(host.bench.truth().torques.x, 0.05, 1e-4);
}

TEST(HaplyBench, StartsInTheZeroPoseIfItIsToldTo) {
  BenchHost host({.variant = "v2", .starts_in_zero_pose = true});
  host.hear(1 * ms);
  EXPECT_TRUE(host.bench.hand().is_in_zero_pose());
  EXPECT_NEAR(host.true_angle(0), 241.0, 0.01);
  EXPECT_EQ(BenchHost({.variant = "nonsense"}).bench.variant().name, "v3.1");
}

TEST(HaplyBench, RepliesComeInFramesOfUsb) {
  for (const auto& [kind, frame_ns] : {std::pair{Kind::m0, 1000 * us}, std::pair{Kind::m3, 125 * us}}) {
    BenchHost host({.board = {.kind = kind}});
    host.hear(10 * us);
    EXPECT_TRUE(host.ask(exchange_of(0.0, 0.0), frame_ns - 11 * us).empty());
    EXPECT_EQ(host.hear(1 * us), Bytes{5});
  }
}

}  // namespace
}  // namespace ghostforce::haply_bench_test
