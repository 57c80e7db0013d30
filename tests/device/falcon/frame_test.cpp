// The bytes of known frames, and frames taken out of whatever a cable delivers.
#include "device/falcon/frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace ghostforce::frame_test {
namespace {

std::string text(const FrameBytes& bytes) {
  return {bytes.begin(), bytes.end()};
}

std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

TEST(CommandFrame, HasTheBytesThatWereSeenOnTheCable) {
  EXPECT_EQ(text(encode(CommandFrame{})), "<AAAAAAAAAAAAAA>");
  EXPECT_EQ(text(encode(CommandFrame{{0, 0, 0}, CommandFrame::homing | CommandFrame::green})), "<AAAAAAAAAAAADA>");
  EXPECT_EQ(text(encode(CommandFrame{{0, 0, 0}, CommandFrame::red})), "<AAAAAAAAAAAAIA>");
  EXPECT_EQ(text(encode(CommandFrame{{1311, 1453, 1526}, CommandFrame::blue})), "<PBFANKFAGPFAEA>");
  EXPECT_EQ(text(encode(CommandFrame{{-2900, 27, 929}, CommandFrame::blue})), "<MKEPLBAABKDAEA>");
  EXPECT_EQ(text(encode(CommandFrame{{4095, -4095, 1}, CommandFrame::green})), "<PPPABAAPBAAACA>");
}

TEST(ReplyFrame, IsReadFromTheBytesThatWereSeenOnTheCable) {
  constexpr std::array<std::uint8_t, 16> bytes{0x3C, 0x4A, 0x46, 0x4B, 0x50, 0x41, 0x41, 0x41,
                                               0x41, 0x45, 0x47, 0x41, 0x41, 0xBE, 0x41, 0x3E};
  FrameReader<ReplyFrame> reader;
  const auto frame = reader.take(bytes);
  ASSERT_TRUE(frame);
  EXPECT_EQ(*frame, (ReplyFrame{{-1447, 0, 100}, ReplyFrame::homed | 0x0D}));
  EXPECT_EQ(reader.discarded_bytes(), 0U);
  EXPECT_EQ(encode(*frame), bytes);
}

TEST(FrameReader, EveryFrameComesBackAsItWas) {
  std::mt19937 random{1};
  std::uniform_int_distribution<int> number(-32768, 32767);
  std::uniform_int_distribution<int> info(0, 0x7F);
  const auto any = [&] { return static_cast<std::int16_t>(number(random)); };
  for (int i = 0; i < 2000; ++i) {
    const ReplyFrame frame{{any(), any(), any()}, static_cast<std::uint8_t>(info(random))};
    FrameReader<ReplyFrame> reader;
    EXPECT_EQ(reader.take(encode(frame)), frame);
  }
}

TEST(FrameReader, FindsFramesHoweverTheyAreCutAndGlued) {
  std::mt19937 random{2};
  std::vector<std::uint8_t> stream;
  constexpr int count = 300;
  for (int i = 0; i < count; ++i) {
    const FrameBytes bytes = encode(ReplyFrame{{static_cast<std::int16_t>(i), 0, -1}, ReplyFrame::homed});
    stream.insert(stream.end(), bytes.begin(), bytes.end());
  }
  FrameReader<ReplyFrame> reader;
  std::optional<ReplyFrame> newest;
  for (std::size_t at = 0; at < stream.size();) {
    const std::size_t piece = std::min(stream.size() - at, std::uniform_int_distribution<std::size_t>(0, 50)(random));
    const auto frame = reader.take(std::span(stream).subspan(at, piece));
    if (frame) newest = frame;
    at += piece;
  }
  EXPECT_EQ(reader.frames(), static_cast<std::uint64_t>(count));
  EXPECT_EQ(reader.discarded_bytes(), 0U);
  ASSERT_TRUE(newest);
  EXPECT_EQ(newest->encoders[0], count - 1);
}

TEST(FrameReader, GivesTheNewestOfSeveral) {
  FrameReader<CommandFrame> reader;
  const auto frame = reader.take(bytes_of("<AAAAAAAAAAAAAA><BAAAAAAAAAAAAA>"));
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->motors[0], 1);
  EXPECT_EQ(reader.frames(), 2U);
}

// A frame that lost bytes must not be taken for one with other numbers: that would be a jump of the handle.
TEST(FrameReader, PassesOverShortFramesAndGarbage) {
  FrameReader<ReplyFrame> reader;
  EXPECT_FALSE(reader.take(bytes_of("<AAAAAAAAAAAA>")));  // two bytes short
  EXPECT_FALSE(reader.take(bytes_of("xy>>\xFF<<AAQ")));   // 'Q' is no nibble
  EXPECT_FALSE(reader.take(bytes_of("<AAAA")));
  const auto frame = reader.take(bytes_of("<CAAAAAAAAAAAAA>"));
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->encoders[0], 2);
  EXPECT_EQ(reader.frames(), 1U);
  EXPECT_EQ(reader.discarded_bytes(), 14U + 5U + 5U + 5U);
}

TEST(FrameReader, GarbageNeverMakesAFrameThatWasNotThere) {
  std::mt19937 random{3};
  std::uniform_int_distribution<int> byte(0, 255);
  FrameReader<ReplyFrame> reader;
  std::uint64_t given = 0;
  for (int i = 0; i < 20000; ++i) {
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(i % 40));
    std::ranges::generate(bytes, [&] { return static_cast<std::uint8_t>(byte(random)); });
    const auto frame = reader.take(bytes);
    given += bytes.size();
    EXPECT_FALSE(frame);
  }
  EXPECT_GE(reader.discarded_bytes() + frame_size, given);
}

}  // namespace
}  // namespace ghostforce::frame_test
