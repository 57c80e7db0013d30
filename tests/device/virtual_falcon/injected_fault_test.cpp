// The far end of the cable with each of its faults.
#include "device/virtual_falcon/injected_fault.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "device/virtual_falcon/practice_firmware.h"
#include "tests/device/virtual_falcon/dsp_host.h"

namespace ghostforce::injected_fault_test {
namespace {

TEST(InjectedFault, HasOneNameEachAndDoesSomething) {
  for (const InjectedFaultKind& kind : injected_fault_catalog()) {
    EXPECT_EQ(find_injected_fault(kind.name), &kind);
    EXPECT_NE(injected_fault(kind.name), InjectedFault{}) << kind.name;
    EXPECT_TRUE(kind.sentence.ends_with('.')) << kind.name;
  }
  EXPECT_EQ(find_injected_fault("nonsense"), nullptr);
}

TEST(InjectedFault, FirstAnswersAreLost) {
  Host host;
  host.dsp.inject(injected_fault("lost-first-replies"));
  host.begin_hand_shake();
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(host.ask().empty());
  EXPECT_EQ(host.ask(), answer);
}

TEST(InjectedFault, BytesComeBeforeTheAnswers) {
  Host host;
  InjectedFault both = injected_fault("leading-00");
  find_injected_fault("leading-13")->add(both);
  host.dsp.inject(both);
  host.begin_hand_shake();
  EXPECT_EQ(host.ask(), (Bytes{0x00, 0x0A, 0x44, 0x2C, 0x0D}));
  host.request(dtr_low);
  host.request(boot_baud);
  host.write({'A'});
  EXPECT_EQ(host.listen(50 * ms), (Bytes{0x13, 'A'}));
  EXPECT_EQ(host.upload(practice_firmware()), practice_firmware());
}

TEST(InjectedFault, NeverClearToSend) {
  Host host;
  host.dsp.inject(injected_fault("no-cts"));
  host.begin_upload();
  host.listen(200 * ms);
  EXPECT_EQ(host.status, 0x01);
}

// Of the echo of a whole upload, with this fault.
Bytes echo_of(Host& host) {
  host.begin_upload();
  host.write({'A'});
  EXPECT_EQ(host.listen(20 * ms), Bytes{'A'});
  return host.upload(practice_firmware());
}

TEST(InjectedFault, TheEchoIsWrong) {
  const Bytes firmware = practice_firmware();
  Bytes changed = firmware;
  changed[44] ^= 0x04U;
  Bytes shorter = firmware;
  shorter.erase(shorter.begin() + 44);

  Host once;
  once.dsp.inject(injected_fault("corrupted-echo"));
  EXPECT_EQ(echo_of(once), changed);
  EXPECT_EQ(echo_of(once), firmware);

  Host always;
  always.dsp.inject(injected_fault("always-corrupted-echo"));
  EXPECT_EQ(echo_of(always), changed);
  EXPECT_EQ(echo_of(always), changed);

  Host lost;
  lost.dsp.inject(injected_fault("lost-echo"));
  EXPECT_EQ(echo_of(lost), shorter);
  EXPECT_EQ(echo_of(lost), firmware);

  Host stops;
  stops.dsp.inject(injected_fault("upload-stops"));
  EXPECT_EQ(echo_of(stops), Bytes(firmware.begin(), firmware.begin() + 100));
  EXPECT_FALSE(stops.dsp.runs_firmware());
}

Host running(std::string_view fault) {
  Host host({.starts_with_firmware = true, .starts_homed = true});
  host.run();
  host.listen(10 * ms);
  host.dsp.inject(injected_fault(fault));
  return host;
}

TEST(InjectedFault, PacketsAreSplitOrJoined) {
  Host split = running("split-packets");
  split.largest = 0;
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(split.exchange({}));
  EXPECT_EQ(split.largest, 7U);
  EXPECT_EQ(split.reader.discarded_bytes(), 0U);

  Host joined = running("joined-packets");
  const FrameBytes frame = encode(CommandFrame{});
  joined.largest = 0;
  for (int i = 0; i < 40; ++i) {
    joined.write({frame.begin(), frame.end()});
    joined.reader.take(joined.listen(1 * ms));
  }
  EXPECT_GE(joined.largest, 2U + 48U);
  EXPECT_EQ(joined.reader.discarded_bytes(), 0U);
}

TEST(InjectedFault, FramesAreShortOrHaveGarbageBetween) {
  Host shorter = running("short-frames");
  int good = 0;
  for (int i = 0; i < 40; ++i) good += shorter.exchange({}) ? 1 : 0;
  EXPECT_EQ(good, 30);
  EXPECT_GT(shorter.reader.discarded_bytes(), 0U);

  Host garbage = running("garbage");
  for (int i = 0; i < 40; ++i) EXPECT_TRUE(garbage.exchange({}));
  EXPECT_EQ(garbage.reader.discarded_bytes(), 40U * 5U);
}

TEST(InjectedFault, SilenceCanEnd) {
  Host host = running("silence");
  EXPECT_FALSE(host.exchange({}, 100 * ms));
  EXPECT_EQ(host.line_status, 0x60);
  host.dsp.inject({});
  EXPECT_TRUE(host.exchange({}));
}

TEST(InjectedFault, EncodersFreeze) {
  Host host({.starts_with_firmware = true, .starts_homed = true});
  host.run();
  host.dsp.set_encoders({1, 2, 3});
  host.exchange({});
  host.dsp.inject(injected_fault("frozen-encoders"));
  host.dsp.set_encoders({100, 200, 300});
  EXPECT_EQ(host.exchange({})->encoders, (std::array<std::int16_t, 3>{1, 2, 3}));
}

TEST(InjectedFault, TheChipForgetsItsSettings) {
  Host host({.starts_with_firmware = true, .starts_homed = true});
  host.run();
  ASSERT_TRUE(host.exchange({{500, 0, 0}, 0}));
  host.dsp.inject(injected_fault("chip-resets"));
  EXPECT_FALSE(host.exchange({}, 100 * ms));
  EXPECT_EQ(host.dsp.motors(), (std::array<std::int16_t, 3>{500, 0, 0}));
  host.run();
  EXPECT_TRUE(host.exchange({})) << "once";
  EXPECT_EQ(host.dsp.motors(), (std::array<std::int16_t, 3>{}));
}

TEST(InjectedFault, MotorsPushTheOtherWay) {
  Host host({.starts_with_firmware = true, .starts_homed = true});
  host.run();
  host.dsp.inject(injected_fault("reversed-motors"));
  ASSERT_TRUE(host.exchange({{500, -400, 0}, 0}));
  EXPECT_EQ(host.dsp.motors(), (std::array<std::int16_t, 3>{-500, 400, 0}));
}

TEST(InjectedFault, AnswersComeLate) {
  Host host = running("late-5ms");
  EXPECT_FALSE(host.exchange({}, 5 * ms));
  EXPECT_TRUE(host.reader.take(host.listen(2 * ms)));
  host.dsp.inject(injected_fault("late-50ms"));
  EXPECT_FALSE(host.exchange({}, 50 * ms));
  EXPECT_TRUE(host.reader.take(host.listen(2 * ms)));
}

TEST(InjectedFault, AnswersComeLaterAndLater) {
  Host host = running("late-creeping");
  for (int i = 0; i < 30; ++i) EXPECT_TRUE(host.exchange({})) << i;
  // The one after forty comes 4.1 ms late, and more for the way.
  for (int i = 30; i < 40; ++i) host.exchange({});
  EXPECT_FALSE(host.exchange({}, 4 * ms));
  EXPECT_TRUE(host.reader.take(host.listen(2 * ms)));
  host.dsp.inject({});
  EXPECT_TRUE(host.exchange({}, 2 * ms));
}

// Which of the next 40 answers come.
std::vector<int> lost_of_forty(std::string_view fault) {
  Host host = running(fault);
  std::vector<int> lost;
  for (int i = 1; i <= 40; ++i) {
    if (!host.exchange({{}, CommandFrame::blue})) lost.push_back(i);
  }
  EXPECT_EQ(host.dsp.lights(), CommandFrame::blue) << "all are obeyed";
  host.dsp.inject({});
  EXPECT_TRUE(host.exchange({}));
  return lost;
}

TEST(InjectedFault, AnswersAreLost) {
  EXPECT_EQ(lost_of_forty("lost-reply"), (std::vector{1}));
  EXPECT_EQ(lost_of_forty("lost-replies"), (std::vector{10, 20, 30, 40}));
  EXPECT_EQ(lost_of_forty("mute").size(), 40U);
  EXPECT_EQ(lost_of_forty("malformed-reply"), (std::vector{1})) << "it is no frame";
}

TEST(InjectedFault, OneAnswerIsLostEachTimeItIsAskedFor) {
  Host host = running("lost-reply");
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(host.exchange({}));
    EXPECT_TRUE(host.exchange({}));
    host.dsp.inject({});
    EXPECT_TRUE(host.exchange({}));
    host.dsp.inject(injected_fault("lost-reply"));
  }
}

TEST(InjectedFault, AnswersTellOfAnotherPlace) {
  using Encoders = std::array<std::int16_t, 3>;
  const auto asked = [](Host& host) { return host.exchange({})->encoders; };

  Host wrong = running("wrong-reply");
  wrong.dsp.set_encoders({10, 20, 30});
  EXPECT_EQ(asked(wrong), (Encoders{266, 20, 30}));
  EXPECT_EQ(asked(wrong), (Encoders{10, 20, 30}));

  Host glitch = running("encoder-glitch");
  glitch.dsp.set_encoders({10, 20, 30});
  EXPECT_GT(std::abs(asked(glitch)[0]), 10'000);
  EXPECT_EQ(asked(glitch), (Encoders{10, 20, 30}));

  Host impossible = running("impossible-encoders");
  for (int i = 0; i < 100; ++i) EXPECT_GT(std::abs(asked(impossible)[0]), 10'000);
  impossible.dsp.inject({});
  EXPECT_EQ(asked(impossible), (Encoders{0, 0, 0}));
}

TEST(InjectedFault, AnswersComeTwice) {
  Host host = running("duplicated-replies");
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(host.exchange({}));
  EXPECT_EQ(host.reader.frames(), 2U * 10U);
  EXPECT_EQ(host.reader.discarded_bytes(), 0U);
}

TEST(InjectedFault, NoiseComesOnce) {
  Host host = running("line-noise");
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(host.exchange({})) << i;
  EXPECT_EQ(host.reader.discarded_bytes(), 100U);
}

TEST(InjectedFault, HomeIsForgottenAndFoundAgain) {
  Host host = running("forgets-home");
  EXPECT_EQ(host.exchange({})->status, 0);
  EXPECT_TRUE(host.dsp.runs_firmware());
  host.dsp.set_encoders({-1400, -1400, -1400});
  for (int i = 0; i < 50; ++i) host.exchange({{}, CommandFrame::homing});
  EXPECT_EQ(host.exchange({})->status, ReplyFrame::homed);
}

TEST(InjectedFault, NeverHomes) {
  Host host({.starts_with_firmware = true});
  host.run();
  host.dsp.inject(injected_fault("never-homes"));
  host.dsp.set_encoders({-1400, -1400, -1400});
  for (int i = 0; i < 50; ++i) EXPECT_EQ(host.exchange({{}, CommandFrame::homing})->status, 0);
}

TEST(InjectedFault, WithoutPowerAllIsForgotten) {
  Host host = running("power-lost");
  EXPECT_FALSE(host.exchange({}));
  host.begin_hand_shake();
  EXPECT_TRUE(host.ask().empty());
  host.dsp.inject({});
  EXPECT_FALSE(host.dsp.runs_firmware());
  EXPECT_EQ(host.dsp.homed(), 0);
  EXPECT_EQ(echo_of(host), practice_firmware());
  EXPECT_TRUE(host.dsp.runs_firmware());
}

TEST(InjectedFault, PowerBlinks) {
  Host host = running("power-blink");
  EXPECT_FALSE(host.exchange({}));
  EXPECT_FALSE(host.dsp.runs_firmware());
  EXPECT_EQ(host.dsp.motors(), (std::array<std::int16_t, 3>{}));
  EXPECT_EQ(echo_of(host), practice_firmware());
  host.run();
  EXPECT_EQ(host.exchange({})->status, 0);
}

}  // namespace
}  // namespace ghostforce::injected_fault_test
