// The far end of the cable, byte by byte and packet by packet: what a real device was seen to do.
#include "device/virtual_falcon/falcon_dsp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "device/falcon/geometry.h"
#include "device/virtual_falcon/practice_firmware.h"
#include "tests/device/virtual_falcon/dsp_host.h"

namespace ghostforce::falcon_dsp_test {
namespace {

TEST(Baud, IsWhatTheChipsTableSays) {
  EXPECT_DOUBLE_EQ(baud_of(0x4138, 0), 9600.0);
  EXPECT_NEAR(baud_of(0x0015, 0), 142857.1, 0.1);
  EXPECT_NEAR(baud_of(0x0015, 1), 140350.9, 0.1);  // 21.375: three eighths have the code 4
  EXPECT_DOUBLE_EQ(baud_of(0x0002, 0), 1.5e6);
  EXPECT_DOUBLE_EQ(baud_of(0x0000, 0), 3e6);
  EXPECT_DOUBLE_EQ(baud_of(0x0001, 0), 2e6);
}

TEST(FalconDsp, WithNothingToSayThereIsAStatusPacketPerLatency) {
  Host host;
  EXPECT_TRUE(host.listen(160 * ms).empty());
  EXPECT_EQ(host.packets, 10);
  EXPECT_EQ(host.empty_packets, 10);
  EXPECT_EQ(host.status, 0x01);
  EXPECT_EQ(host.line_status, 0x60);
  host.request(latency_1);
  host.listen(160 * ms);
  EXPECT_EQ(host.packets, 170);
}

TEST(FalconDsp, ShakesHandsAtTheRightRateWithDtrHigh) {
  Host host;
  host.begin_hand_shake();
  EXPECT_EQ(host.ask(), answer);
  EXPECT_EQ(host.ask(), answer);
  // With whatever stands before it.
  host.write({0x0A, 0x0A, 0x43});
  EXPECT_TRUE(host.listen(50 * ms).empty());
  host.write({0x0D});
  EXPECT_EQ(host.listen(50 * ms), answer);
  host.request(boot_baud);
  EXPECT_TRUE(host.ask().empty());
  host.request(hand_shake_baud);
  host.request(dtr_low);
  EXPECT_TRUE(host.ask().empty());
}

TEST(FalconDsp, AnswersTheHandShakeAtThePaceOfTheLine) {
  Host host;
  host.begin_hand_shake();
  host.request(latency_1);
  host.write(question);
  // Three bytes there and four back at 9600 baud are 7.3 ms.
  EXPECT_EQ(host.listen(7 * ms).size(), 3U);
  EXPECT_EQ(host.listen(2 * ms).size(), 1U);
}

TEST(FalconDsp, TakesABootTableAndEchoesEachByteOfIt) {
  Host host;
  host.begin_upload();
  EXPECT_EQ(host.status, 0x11);  // clear to send
  host.write({'A'});
  EXPECT_EQ(host.listen(20 * ms), Bytes{'A'});
  Bytes firmware = practice_firmware();
  const std::uint8_t last = firmware.back();
  firmware.pop_back();
  EXPECT_EQ(host.upload(firmware), firmware);
  EXPECT_FALSE(host.dsp.runs_firmware());
  EXPECT_EQ(host.upload({last}), Bytes{last});
  EXPECT_TRUE(host.dsp.runs_firmware());
  host.run();
  const auto reply = host.exchange({});
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->status, 0);
}

TEST(FalconDsp, BootsAtTheRateOfOtherDriversToo) {
  Host host;
  host.begin_upload();
  host.request({0x03, 0x0015, 1});
  host.write({'A'});
  EXPECT_EQ(host.listen(20 * ms), Bytes{'A'});
  EXPECT_EQ(host.upload(practice_firmware()), practice_firmware());
  EXPECT_TRUE(host.dsp.runs_firmware());
}

TEST(FalconDsp, WillNotBootOutOfTurn) {
  // No hand-shake answered.
  Host rash;
  rash.begin_hand_shake();
  rash.request(dtr_low);
  rash.request(boot_baud);
  rash.write({'A'});
  EXPECT_TRUE(rash.listen(50 * ms).empty());
  // No 'A'.
  Host hasty;
  hasty.begin_upload();
  hasty.upload(practice_firmware());
  EXPECT_FALSE(hasty.dsp.runs_firmware());
  // A file of another kind.
  Host mistaken;
  mistaken.begin_upload();
  mistaken.write({'A'});
  mistaken.listen(20 * ms);
  EXPECT_EQ(mistaken.upload({0xAA, 0x09, 0x00, 0x00}), (Bytes{0xAA, 0x09}));
}

TEST(FalconDsp, AFullPacketDoesNotWaitForTheTimer) {
  Host host;
  host.begin_upload();
  host.write({'A'});
  host.listen(20 * ms);
  host.largest = 0;
  const Bytes firmware = practice_firmware(300);
  const std::int64_t start = host.now;
  host.write({firmware.begin(), firmware.begin() + 250});
  // 250 bytes take 17.5 ms: four full packets, each with 62 of them.
  const Bytes heard = host.listen(18 * ms);
  EXPECT_GT(heard.size(), 250U - 62U);
  EXPECT_EQ(host.largest, 64U);
  EXPECT_EQ(host.now, start + 18 * ms);
}

TEST(FalconDsp, WhatDoesNotFitIntoTheChipIsLost) {
  Host host;
  EXPECT_EQ(host.dsp.room(), 256U);
  host.write(Bytes(300, 0x55));
  EXPECT_EQ(host.dsp.room(), 0U);
  host.listen(1000 * ms);
  EXPECT_EQ(host.dsp.room(), 256U);
}

TEST(FalconDsp, AnswersFramesOneByOneAndOnlyAtRunTime) {
  Host host({.starts_with_firmware = true, .starts_homed = true});
  host.dsp.set_encoders({-1447, 0, 100});
  host.dsp.set_buttons(0x0D);
  EXPECT_FALSE(host.exchange({}, 50 * ms));
  host.run();
  const auto reply = host.exchange({{1311, -1453, 4095}, CommandFrame::blue});
  ASSERT_TRUE(reply);
  EXPECT_EQ(*reply, (ReplyFrame{{-1447, 0, 100}, ReplyFrame::homed | 0x0D}));
  EXPECT_EQ(host.dsp.motors(), (std::array<std::int16_t, 3>{1311, -1453, 4095}));
  EXPECT_EQ(host.dsp.lights(), CommandFrame::blue);
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(host.exchange({}));
  EXPECT_EQ(host.dsp.frames(), 21U);
  EXPECT_EQ(host.reader.frames(), 21U);
  EXPECT_EQ(host.reader.discarded_bytes(), 0U);
}

// So many exchanges in a second, each begun when the last one has been answered.
int exchanges_per_second(Host& host) {
  int exchanges = 0;
  for (const std::int64_t end = host.now + 1000 * ms; host.now < end;) {
    const FrameBytes bytes = encode(CommandFrame{});
    host.write({bytes.begin(), bytes.end()});
    const std::uint64_t before = host.reader.frames();
    while (host.reader.frames() == before && host.now < end) {
      host.reader.take(host.listen(std::max<std::int64_t>(host.dsp.next_due_ns() - host.now, 0)));
    }
    ++exchanges;
  }
  return exchanges;
}

TEST(FalconDsp, TheLatencyTimerSetsThePace) {
  Host host({.starts_with_firmware = true});
  host.run();
  EXPECT_NEAR(exchanges_per_second(host), 1000, 2);
  host.request(latency_16);
  EXPECT_NEAR(exchanges_per_second(host), 62.5, 1.5);
}

TEST(FalconDsp, AFrameTakesItsTimeOnTheLineBothWays) {
  Host host({.starts_with_firmware = true});
  host.run();
  host.listen(1 * ms);
  const FrameBytes bytes = encode(CommandFrame{{1, 2, 3}, 0});
  host.write({bytes.begin(), bytes.end()});
  host.dsp.advance(host.now + 106'000);
  EXPECT_EQ(host.dsp.frames(), 0U);
  host.dsp.advance(host.now + 107'500);
  EXPECT_EQ(host.dsp.frames(), 1U);
}

TEST(FalconDsp, AFrameAtAnotherRateOrInAnotherFormatArrivesAsNoise) {
  constexpr VendorRequest format_7e1{0x04, 0x0207, 0};
  for (const VendorRequest& wrong : {hand_shake_baud, boot_baud, format_7e1}) {
    Host host({.starts_with_firmware = true, .starts_homed = true});
    host.run();
    ASSERT_TRUE(host.exchange({{500, 0, 0}, 0}));
    host.request(wrong);
    EXPECT_FALSE(host.exchange({}, 100 * ms));
    EXPECT_EQ(host.dsp.motors(), (MotorNumbers{500, 0, 0})) << "it has heard of no zero";
    host.run();
    EXPECT_TRUE(host.exchange({{0, 0, 0}, CommandFrame::green}));
    EXPECT_EQ(host.dsp.motors(), MotorNumbers{});
  }
}

TEST(FalconDsp, WhatWaitsInTheChipGoesOutAtItsNewRate) {
  Host host({.starts_with_firmware = true, .starts_homed = true});
  host.run();
  ASSERT_TRUE(host.exchange({}));
  host.request(hand_shake_baud);
  const FrameBytes frame = encode(CommandFrame{{500, 0, 0}, 0});
  host.write({frame.begin(), frame.end()});
  host.run();
  EXPECT_TRUE(host.reader.take(host.listen(5 * ms))) << "all of it was still waiting";
  EXPECT_EQ(host.dsp.motors(), (MotorNumbers{500, 0, 0}));
}

TEST(FalconDsp, ThePlugGivesTheChipItsCurrentAndNotTheMotors) {
  Host host({.starts_with_firmware = true, .starts_homed = true});
  host.run();
  ASSERT_TRUE(host.exchange({{500, 0, 0}, 0}));
  host.dsp.power_up_chip(host.now);
  EXPECT_EQ(host.dsp.motors(), (MotorNumbers{500, 0, 0}));
  EXPECT_FALSE(host.exchange({}, 100 * ms)) << "its rate is another one";
  EXPECT_EQ(host.dsp.motors(), (MotorNumbers{500, 0, 0}));
  host.packets = 0;
  host.listen(160 * ms);
  EXPECT_EQ(host.packets, 10) << "its latency is 16 ms";
  host.run();
  EXPECT_TRUE(host.exchange({}));
  EXPECT_EQ(host.dsp.motors(), MotorNumbers{});
  EXPECT_EQ(host.dsp.homed(), ReplyFrame::homed);
}

TEST(FalconDsp, PurgingForgetsWhatHasArrived) {
  Host host({.starts_with_firmware = true});
  host.run();
  const FrameBytes bytes = encode(CommandFrame{});
  host.write({bytes.begin(), bytes.end()});
  host.now += 500'000;
  host.request({0x00, 1, 0});
  EXPECT_TRUE(host.listen(10 * ms).empty());
  EXPECT_EQ(host.dsp.frames(), 1U);
  host.write({bytes.begin(), bytes.end()});
  host.request({0x00, 2, 0});
  host.listen(10 * ms);
  EXPECT_EQ(host.dsp.frames(), 1U);
}

TEST(FalconDsp, ARisingDtrForgetsTheFirmware) {
  Host host({.starts_with_firmware = true, .starts_homed = true});
  host.run();
  EXPECT_TRUE(host.exchange({{100, 100, 100}, 0}));
  host.request(dtr_high);
  EXPECT_FALSE(host.dsp.runs_firmware());
  EXPECT_EQ(host.dsp.homed(), 0);
  EXPECT_EQ(host.dsp.motors(), (std::array<std::int16_t, 3>{}));
  EXPECT_FALSE(host.exchange({}));
}

TEST(FalconDsp, HomesOneArmAfterAnotherWhenPushedIn) {
  Host host({.starts_with_firmware = true});
  host.run();
  const CommandFrame homing{{}, CommandFrame::homing | CommandFrame::red};
  host.dsp.set_encoders({0, 0, 0});
  auto reply = host.exchange(homing);
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->status, 0);
  // Counts mean nothing yet.
  EXPECT_NE(reply->encoders, (std::array<std::int16_t, 3>{}));
  const auto away = reply->encoders;
  host.dsp.set_encoders({500, 500, 500});
  reply = host.exchange(homing);
  EXPECT_EQ(reply->encoders[0], away[0] + 500);

  host.dsp.set_encoders({-1400, -1401, -1402});
  // Not unless it is asked to.
  for (int i = 0; i < 50; ++i) EXPECT_EQ(host.exchange({})->status, 0);
  std::vector<int> seen;
  for (int i = 0; i < 50; ++i) {
    reply = host.exchange(homing);
    if (seen.empty() || seen.back() != reply->status) seen.push_back(reply->status);
  }
  EXPECT_EQ(seen, (std::vector<int>{0x10, 0x30, 0x70}));
  EXPECT_EQ(reply->encoders, (std::array<std::int16_t, 3>{-1400, -1401, -1402}));
  // And it stays, with the bit and without.
  host.dsp.set_encoders({10, 20, 30});
  EXPECT_EQ(*host.exchange({}), (ReplyFrame{{10, 20, 30}, ReplyFrame::homed}));
  EXPECT_EQ(*host.exchange(homing), (ReplyFrame{{10, 20, 30}, ReplyFrame::homed}));
}

TEST(FalconDsp, TheWatchdogBitesOnlyWhereThereIsOne) {
  Host without({.starts_with_firmware = true});
  without.run();
  without.exchange({{500, 500, 500}, 0});
  without.listen(1000 * ms);
  EXPECT_EQ(without.dsp.motors()[0], 500);

  Host with({.starts_with_firmware = true, .watchdog_ms = 20});
  with.run();
  with.exchange({{500, 500, 500}, 0});
  with.listen(14 * ms);
  EXPECT_EQ(with.dsp.motors()[0], 500);
  with.listen(2 * ms);
  EXPECT_EQ(with.dsp.motors()[0], 0);
}

}  // namespace
}  // namespace ghostforce::falcon_dsp_test
