// Packets of hAPI byte by byte, and replies out of whatever stream they come in.
#include "device/haply/hapi.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "device/haply/haply_calibration.h"
#include "device/haply/reply_reader.h"

namespace ghostforce::hapi_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

template <typename Packet>
Bytes bytes_of(const Packet& packet) {
  return {packet.begin(), packet.end()};
}

void add(Bytes& bytes, float number) {
  const auto bits = std::bit_cast<std::uint32_t>(number);
  for (unsigned i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(bits >> (8 * i)));
}

Bytes reply_of(float port_1, float port_2) {
  Bytes bytes{5};
  add(bytes, port_1);
  add(bytes, port_2);
  return bytes;
}

float torque_at(const hapi::ExchangePacket& packet, std::size_t port) {
  std::uint32_t bits = 0;
  for (std::size_t i = 4; i-- > 0;) bits = bits << 8U | packet[2 + 4 * port + i];
  return std::bit_cast<float>(bits);
}

// In order of ports; from the driver's own table of variants.
hapi::SetUp set_up_for(std::string_view variant) {
  hapi::SetUp set_up;
  for (const HaplyArm& arm : find_haply_variant(variant)->calibration.arms) {
    set_up.motor_directions[arm.motor_port - 1U] = arm.motor_direction;
    set_up.encoder_directions[arm.encoder_port - 1U] = arm.encoder_direction;
    set_up.offsets_deg[arm.encoder_port - 1U] = static_cast<float>(arm.offset_deg);
    set_up.counts_per_turn[arm.encoder_port - 1U] = static_cast<float>(arm.counts_per_turn);
  }
  return set_up;
}

TEST(Hapi, SetsUpAsThePublishedProgramsDo) {
  EXPECT_EQ(bytes_of(hapi::encode(set_up_for("v3.1"))),
            (Bytes{0x01, 0x05, 0x03, 0x01, 0x01, 0x03, 0x01, 0x01, 0x00, 0x00, 0x00, 0x00, 0x40,
                   0x41, 0x00, 0x80, 0x98, 0x45, 0x00, 0x00, 0x28, 0x43, 0x00, 0x80, 0x98, 0x45}));
  EXPECT_EQ(bytes_of(hapi::encode(set_up_for("v2"))),
            (Bytes{0x01, 0x05, 0x03, 0x00, 0x01, 0x03, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x74,
                   0xc2, 0x00, 0x00, 0x28, 0x46, 0x00, 0x00, 0x71, 0x43, 0x00, 0x00, 0x28, 0x46}));
}

TEST(Hapi, ExchangesInOrderOfPorts) {
  EXPECT_EQ(bytes_of(hapi::exchange({0.0, 0.05})), (Bytes{0x02, 0x05, 0x00, 0x00, 0x00, 0x00, 0xcd, 0xcc, 0x4c, 0x3d}));
  EXPECT_EQ(bytes_of(hapi::exchange({0.05, 0.0})), (Bytes{0x02, 0x05, 0xcd, 0xcc, 0x4c, 0x3d, 0x00, 0x00, 0x00, 0x00}));
  EXPECT_EQ(bytes_of(hapi::zero_exchange()), (Bytes{0x02, 0x05, 0, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(Hapi, SendsNoTorqueThatIsNone) {
  for (const double wrong : {nan, -nan, infinity, -infinity}) {
    EXPECT_EQ(hapi::exchange({wrong, wrong}), hapi::zero_exchange());
    EXPECT_EQ(torque_at(hapi::exchange({wrong, 0.05}), 1), 0.05F);
  }
}

TEST(Hapi, SendsNoTorqueBeyondTheGreatest) {
  for (const double great : {0.123, 0.1230001, 0.2, 1e300}) {
    EXPECT_EQ(torque_at(hapi::exchange({great, 0.0}), 0), 0.123F);
    EXPECT_EQ(torque_at(hapi::exchange({0.0, -great}), 1), -0.123F);
  }
  EXPECT_LT(torque_at(hapi::exchange({0.1229, 0.0}), 0), 0.123F);
}

TEST(Hapi, ReadsTheWorkedReply) {
  const auto angles = hapi::decode_reply(Bytes{0x05, 0x00, 0x00, 0x40, 0x41, 0x00, 0x00, 0x28, 0x43});
  ASSERT_TRUE(angles);
  EXPECT_EQ((*angles)[0], 12.0);
  EXPECT_EQ((*angles)[1], 168.0);
}

TEST(Hapi, ReadsNothingElse) {
  const Bytes whole = reply_of(12.0F, 168.0F);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_FALSE(hapi::decode_reply(std::span(whole).first(size))) << size;
  }
  Bytes longer = whole;
  longer.push_back(0);
  EXPECT_FALSE(hapi::decode_reply(longer));
  for (int id = 0; id < 256; ++id) {
    Bytes other = whole;
    other[0] = static_cast<std::uint8_t>(id);
    EXPECT_EQ(hapi::decode_reply(other).has_value(), id == hapi::address) << id;
  }
  for (const float wrong : {static_cast<float>(nan), static_cast<float>(infinity), -static_cast<float>(infinity)}) {
    EXPECT_FALSE(hapi::decode_reply(reply_of(wrong, 0.0F)));
    EXPECT_FALSE(hapi::decode_reply(reply_of(0.0F, wrong)));
  }
}

// --- ReplyReader ---

TEST(ReplyReader, PutsRepliesTogetherThatCameInPieces) {
  const Bytes reply = reply_of(12.5F, -168.25F);
  for (std::size_t cut = 1; cut < reply.size(); ++cut) {
    ReplyReader reader;
    EXPECT_FALSE(reader.take(std::span(reply).first(cut))) << cut;
    const auto angles = reader.take(std::span(reply).subspan(cut));
    ASSERT_TRUE(angles) << cut;
    EXPECT_EQ((*angles)[0], 12.5);
    EXPECT_EQ((*angles)[1], -168.25);
    EXPECT_EQ(reader.discarded_bytes(), 0U);
  }
}

TEST(ReplyReader, TakesRepliesApartThatCameTogether) {
  Bytes stream;
  for (int i = 0; i < 5; ++i) {
    const Bytes reply = reply_of(static_cast<float>(i), static_cast<float>(100 + i));
    stream.insert(stream.end(), reply.begin(), reply.end());
  }
  ReplyReader reader;
  auto angles = reader.take(stream);
  for (int i = 0; i < 5; ++i, angles = reader.take({})) {
    ASSERT_TRUE(angles) << i;
    EXPECT_EQ((*angles)[0], i);
    EXPECT_EQ((*angles)[1], 100 + i);
  }
  EXPECT_FALSE(angles);
}

TEST(ReplyReader, PassesOverWhatIsNoReply) {
  for (const Bytes& garbage :
       {Bytes{'A', 'T', '+', 'G', 'C', 'A', 'P', '\r'}, Bytes{255}, Bytes(40, 'x'), Bytes{0, 1, 2}}) {
    ReplyReader reader;
    Bytes stream = garbage;
    const Bytes reply = reply_of(12.0F, 168.0F);
    stream.insert(stream.end(), reply.begin(), reply.end());
    const auto angles = reader.take(stream);
    ASSERT_TRUE(angles);
    EXPECT_EQ((*angles)[1], 168.0);
    EXPECT_EQ(reader.discarded_bytes(), garbage.size());
  }
}

TEST(ReplyReader, TakesNoAngleThatNoCounterHas) {
  ReplyReader reader;
  EXPECT_FALSE(reader.take(reply_of(1e6F, 0.0F)));
  reader.reset();
  EXPECT_FALSE(reader.take(reply_of(static_cast<float>(nan), 0.0F)));
  reader.reset();
  EXPECT_TRUE(reader.take(reply_of(0.0F, 0.0F)));
}

TEST(ReplyReader, KnowsTheAddressAlone) {
  ReplyReader reader;
  EXPECT_FALSE(reader.holds_address_alone());
  reader.take(Bytes{5});
  EXPECT_TRUE(reader.holds_address_alone());
  reader.take(Bytes{0});
  EXPECT_FALSE(reader.holds_address_alone());
  reader.reset();
  EXPECT_FALSE(reader.holds_address_alone());
  reader.take(Bytes{255});
  EXPECT_FALSE(reader.holds_address_alone());
}

// Whatever comes in: nothing that is no angle comes out, no byte is lost from the count, and a rest of 9 zeros at the
// latest gets it going again.
TEST(ReplyReader, ComesThroughAnyBytes) {
  std::mt19937_64 random{11};
  for (int trial = 0; trial < 2000; ++trial) {
    ReplyReader reader;
    std::size_t given = 0;
    std::size_t replies = 0;
    for (int piece = 0; piece < 20; ++piece) {
      Bytes bytes(random() % 64);
      for (std::uint8_t& byte : bytes) byte = random() % 3 == 0 ? 5 : static_cast<std::uint8_t>(random());
      given += bytes.size();
      for (auto angles = reader.take(bytes); angles; angles = reader.take({})) {
        ++replies;
        for (const double angle : *angles) ASSERT_LE(std::abs(angle), ReplyReader::greatest_angle_deg);
      }
    }
    reader.reset();
    ASSERT_EQ(reader.discarded_bytes() + hapi::reply_size * replies, given);
    ASSERT_TRUE(reader.take(reply_of(12.0F, 168.0F)));
  }
}

// What is left of a packet that was torn on its way is read as commands.
TEST(Hapi, NoByteOfATorqueIsASetUpAndItIsWithinAStepOfTheDuty) {
  constexpr double m0_step = hapi::greatest_torque / 1023.0;
  constexpr double m3_step = hapi::greatest_torque / 4095.0;
  double worst = 0.0;
  int coarse = 0;
  for (int i = 1; i <= 200'000; ++i) {
    const double torque = (i % 2 == 0 ? 1.0 : -1.0) * hapi::greatest_torque * i / 200'000.0;
    const hapi::ExchangePacket packet = hapi::exchange({torque, 0.0});
    float sent = 0.0F;
    std::memcpy(&sent, packet.data() + 2, sizeof sent);
    for (std::size_t byte = 2; byte < 4; ++byte) ASSERT_GT(packet[byte], 2) << torque;
    for (std::size_t byte = 4; byte < 6; ++byte) ASSERT_NE(packet[byte], 1) << torque;
    ASSERT_LE(std::abs(sent), static_cast<float>(hapi::greatest_torque)) << torque;
    const double off = std::abs(static_cast<double>(sent) - torque);
    worst = std::max(worst, off);
    if (off > m3_step) ++coarse;
  }
  EXPECT_LT(worst, 1.1 * m0_step);
  EXPECT_LT(coarse, 500) << "of 200000";
  const hapi::ExchangePacket zeros = hapi::exchange({0.0, 0.0});
  EXPECT_EQ(std::count(zeros.begin() + 2, zeros.end(), 0), 8);
}

}  // namespace
}  // namespace ghostforce::hapi_test
