// Single frames with a Falcon: on time, as they are, and zeros whatever goes wrong.
#include "app/tools/doctor/bench.h"

#include <memory>
#include <optional>

#include <gtest/gtest.h>

#include "device/virtual_falcon/virtual_link.h"
#include "tests/device/falcon/fake_falcons.h"

namespace ghostforce::bench_test {
namespace {

constexpr CommandFrame push{.motors = {100, -50, 25}, .info = CommandFrame::blue};

std::unique_ptr<VirtualLink> running_link() {
  VirtualLink::Options options{.clock = VirtualLink::Clock::stepped};
  options.device.starts_with_firmware = true;
  options.device.starts_homed = true;
  auto link = std::make_unique<VirtualLink>(options);
  EXPECT_EQ(link->open(), LinkFault::none);
  // As the driver leaves it.
  for (const VendorRequest& request :
       {VendorRequest{0x09, 1, 0}, VendorRequest{0x03, 2, 0}, VendorRequest{0x04, 8, 0}}) {
    while (!link->request(request)) link->wait_until(link->now_ns() + 1'000'000);
    while (link->is_sending()) link->wait_until(link->now_ns() + 1'000'000);
  }
  return link;
}

TEST(FalconBench, ExchangesOnceAMillisecond) {
  const auto link = running_link();
  FalconBench bench(*link);
  const std::int64_t began_ns = link->now_ns();
  for (int i = 0; i < 500; ++i) {
    const auto reply = bench.exchange(push);
    ASSERT_TRUE(reply) << i;
    EXPECT_EQ(reply->status & ReplyFrame::homed, ReplyFrame::homed);
  }
  EXPECT_EQ(link->motors(), push.motors);
  EXPECT_NEAR(static_cast<double>(link->now_ns() - began_ns) * 1e-9, 0.5, 0.3);
  EXPECT_GT(bench.last_exchange_s(), 0.0);
}

TEST(FalconBench, SaysNothingInASilence) {
  const auto link = running_link();
  FalconBench bench(*link);
  ASSERT_TRUE(bench.exchange(push));
  const std::uint64_t frames = link->device().frames();
  const std::int64_t began_ns = link->now_ns();
  bench.be_silent(0.3);
  EXPECT_EQ(link->device().frames(), frames);
  EXPECT_GE(link->now_ns() - began_ns, 300'000'000);
  EXPECT_EQ(link->motors(), push.motors) << "this device has no watchdog";
}

TEST(FalconBench, EndsWithZeros) {
  const auto link = running_link();
  {
    FalconBench bench(*link);
    ASSERT_TRUE(bench.exchange(push));
    EXPECT_EQ(link->motors(), push.motors);
  }
  EXPECT_EQ(link->motors(), MotorNumbers{});
}

TEST(FalconBench, ALostReplyIsFollowedByZeros) {
  const auto link = running_link();
  FalconBench bench(*link);
  ASSERT_TRUE(bench.exchange(push));
  // It hears and is not heard.
  link->inject({.reply_delay_ns = 40'000'000});
  EXPECT_FALSE(bench.exchange(push));
  EXPECT_EQ(link->motors(), MotorNumbers{});
  link->inject({});
  EXPECT_TRUE(bench.exchange(CommandFrame{}));
  link->inject({.link = LinkFault::unplugged});
  EXPECT_FALSE(bench.exchange(push));
  EXPECT_EQ(bench.fault(), LinkFault::unplugged);
  EXPECT_FALSE(bench.stop());
}

// With one that is set up as the driver leaves it.
class FalconBenchTest : public testing::Test {
 protected:
  FalconBenchTest() {
    falcon.rate = ftdi::running_rate;
    falcon.latency_ms = 1;
    EXPECT_EQ(link.open(), LinkFault::none);
    bench.emplace(link);
  }
  void push_for_a_while() {
    for (int i = 0; i < 10; ++i) ASSERT_TRUE(bench->exchange(push));
    ASSERT_TRUE(falcon.pushes());
  }

  static constexpr std::int64_t ms = 1'000'000;
  std::int64_t now_ns = 1000 * ms;
  FakeFalcon falcon{"12PZ657E"};
  FakeFalcons link{{&falcon}, now_ns};
  std::optional<FalconBench> bench;
};

// The process is stopped between a command and its reply, which waits for it: old news, and nobody has watched.
TEST_F(FalconBenchTest, AReplyThatCameLateIsNone) {
  push_for_a_while();
  link.pause(1000 * ms);
  EXPECT_FALSE(bench->exchange(push));
  EXPECT_FALSE(falcon.pushes());
  EXPECT_TRUE(bench->may_still_push()) << "until it answers";
  EXPECT_TRUE(bench->exchange(CommandFrame{}));
  EXPECT_FALSE(bench->may_still_push());
}

TEST_F(FalconBenchTest, APauseBetweenTwoCommandsEndsTheForce) {
  push_for_a_while();
  now_ns += 1000 * ms;
  EXPECT_FALSE(bench->exchange(push));
  EXPECT_FALSE(falcon.pushes());
}

TEST_F(FalconBenchTest, ASilenceThatBecameLongerIsNone) {
  push_for_a_while();
  EXPECT_TRUE(bench->be_silent(0.5));
  EXPECT_TRUE(falcon.pushes());
  ASSERT_TRUE(bench->exchange(push)) << "this one was meant";
  link.pause(1000 * ms);
  EXPECT_FALSE(bench->be_silent(0.5));
  EXPECT_FALSE(falcon.pushes());
}

TEST_F(FalconBenchTest, AChipThatIsResetGetsTheStopInTime) {
  push_for_a_while();
  falcon.reset_chip();
  const std::int64_t began_ns = now_ns;
  EXPECT_FALSE(bench->exchange(push));
  EXPECT_FALSE(falcon.pushes());
  EXPECT_LE(falcon.last_force_ns - began_ns, 25 * ms);
  EXPECT_TRUE(bench->exchange(push)) << "and it is well again";
}

TEST_F(FalconBenchTest, AChipThatIsResetBeforeTheEndIsSetUpForTheStop) {
  push_for_a_while();
  falcon.reset_chip();
  const std::int64_t began_ns = now_ns;
  EXPECT_TRUE(bench->stop());
  EXPECT_FALSE(falcon.pushes());
  EXPECT_LE(falcon.last_force_ns - began_ns, 25 * ms);
}

TEST_F(FalconBenchTest, SaysThatMotorsMayStillPushWhereNobodyHearsTheStop) {
  EXPECT_FALSE(bench->may_still_push());
  push_for_a_while();
  falcon.unplug();
  EXPECT_FALSE(bench->exchange(push));
  EXPECT_TRUE(bench->may_still_push());
  EXPECT_FALSE(bench->stop());
  EXPECT_TRUE(bench->may_still_push());
}

}  // namespace
}  // namespace ghostforce::bench_test
