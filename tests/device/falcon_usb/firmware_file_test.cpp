// Boot tables that are made here, whole and broken in every way.
#include "device/falcon_usb/firmware_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "tests/core/random_setting.h"
#include "tests/support/long_run.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::firmware_file_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

void append(Bytes& bytes, std::uint32_t word) {
  bytes.push_back(static_cast<std::uint8_t>(word & 0xFF));
  bytes.push_back(static_cast<std::uint8_t>(word >> 8));
}

constexpr std::uint32_t entry = 0x3F8002;

// As long as a firmware's skeleton, and no program.
Bytes boot_table(const std::vector<FirmwareBlock>& blocks = {{entry, 20}, {0x93A2, 7}, {0x3F8000, 2}}) {
  Bytes bytes;
  append(bytes, 0x08AA);
  for (int i = 0; i < 8; ++i) append(bytes, 0);
  append(bytes, entry >> 16);
  append(bytes, entry & 0xFFFF);
  for (const FirmwareBlock& block : blocks) {
    append(bytes, block.words);
    append(bytes, block.address >> 16);
    append(bytes, block.address & 0xFFFF);
    for (std::uint32_t i = 0; i < block.words; ++i) append(bytes, 0x1000 + i);
  }
  append(bytes, 0);
  return bytes;
}

// Its words; empty if it was taken.
std::string refusal(const Bytes& bytes) {
  try {
    parse_firmware(bytes);
    return {};
  } catch (const FirmwareError& error) {
    EXPECT_EQ(error.trouble(), FirmwareTrouble::invalid);
    return error.what();
  }
}

void set_word(Bytes& bytes, std::size_t word, std::uint32_t value) {
  bytes[2 * word] = static_cast<std::uint8_t>(value & 0xFF);
  bytes[2 * word + 1] = static_cast<std::uint8_t>(value >> 8);
}

TEST(FirmwareFile, ReadsABootTable) {
  const Bytes bytes = boot_table();
  const FirmwareImage image = parse_firmware(bytes);
  EXPECT_EQ(image.bytes, bytes);
  EXPECT_EQ(image.entry, entry);
  EXPECT_EQ(image.blocks, (std::vector<FirmwareBlock>{{entry, 20}, {0x93A2, 7}, {0x3F8000, 2}}));
  EXPECT_TRUE(image.path.empty());
  EXPECT_EQ(known_firmware(image.sha256), "");
}

// Computed by sha256sum.
TEST(FirmwareFile, HasTheSumThatPeopleCompare) {
  EXPECT_EQ(parse_firmware(boot_table({{entry, 1}})).sha256,
            "c31c19896f120c0c7ca652198f038c076c8e2f688da8ee540e2728827f469164");
}

TEST(FirmwareFile, KnowsThePublishedFiles) {
  EXPECT_EQ(known_firmware("1119e39c39fab1f37678ea62dfc715b23dd86ee7f13d78f88f707d9f09b896a1"), "nvent_firmware.bin");
  EXPECT_EQ(known_firmware(""), "");
}

TEST(FirmwareFile, RefusesWhatIsCutShortAnywhere) {
  const Bytes whole = boot_table();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_NE(refusal({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)}), "") << length;
  }
}

TEST(FirmwareFile, RefusesWhatGoesOn) {
  Bytes bytes = boot_table();
  bytes.push_back(0);
  EXPECT_NE(refusal(bytes), "");
  bytes.push_back(0);
  EXPECT_NE(refusal(bytes).find("the file continues"), std::string::npos);
}

// Every word that is not the program itself, with every single bit of it flipped.
TEST(FirmwareFile, RefusesEveryFieldThatIsWrong) {
  const Bytes whole = boot_table();
  std::vector<std::size_t> fields;
  for (std::size_t word = 0; word < 11; ++word) fields.push_back(word);
  fields.push_back(11);  // sizes
  fields.push_back(11 + 23);
  fields.push_back(11 + 23 + 10);
  fields.push_back(whole.size() / 2 - 1);
  for (const std::size_t field : fields) {
    for (unsigned bit = 0; bit < 16; ++bit) {
      // Another word of the same block is as good a place to begin as far as a table can tell.
      if (field == 10 && bit <= 4) continue;
      Bytes bytes = whole;
      const std::uint32_t value = bytes[2 * field] | static_cast<std::uint32_t>(bytes[2 * field + 1]) << 8;
      set_word(bytes, field, value ^ (1U << bit));
      EXPECT_NE(refusal(bytes), "") << "word " << field << ", bit " << bit;
    }
  }
}

TEST(FirmwareFile, RefusesBlocksThatCannotBe) {
  EXPECT_NE(refusal(boot_table({})).find("there is no block"), std::string::npos);
  EXPECT_NE(refusal(boot_table({{0x3F8000, 2}})).find("which is in no block"), std::string::npos);
  EXPECT_NE(refusal(boot_table({{entry, 4}, {entry + 3, 4}})).find("overlaps the one at"), std::string::npos);
  EXPECT_NE(refusal(boot_table({{entry, 4}, {0x3FFFFF, 2}})).find("outside"), std::string::npos);
  EXPECT_NE(refusal(boot_table({{entry, 4}, {0xFFFFFFFF, 2}})).find("outside"), std::string::npos);
  EXPECT_EQ(refusal(boot_table({{entry, 4}, {entry + 4, 4}})), "");
  EXPECT_NE(refusal(boot_table({{entry, 40000}})).find("the file is too long"), std::string::npos);  // 80 kB
}

TEST(FirmwareFile, SaysAtWhichByteAndWhatToDo) {
  Bytes bytes = boot_table();
  bytes[6] = 1;
  EXPECT_EQ(refusal(bytes).find("byte 6: there is 0x1 in a reserved word"), 0U) << refusal(bytes);
  EXPECT_NE(refusal(bytes).find("; give"), std::string::npos);
  bytes = boot_table();
  bytes[0] = 'M';
  bytes[1] = 'Z';
  EXPECT_EQ(refusal(bytes).find("byte 0: there is 0x5A4D where every boot table has 0x8AA"), 0U) << refusal(bytes);
}

TEST(FirmwareFile, NothingBreaksIt) {
  Random random(1);
  const Bytes whole = boot_table();
  int taken = 0;
  for (int i = 0; i < trials(100'000); ++i) {
    Bytes bytes = whole;
    const int changes = 1 + random.below(6);
    for (int j = 0; j < changes && !bytes.empty(); ++j) {
      const auto at = static_cast<std::size_t>(random.below(static_cast<int>(bytes.size())));
      switch (random.below(4)) {
        case 0:
          bytes.resize(at);
          break;
        case 1:
          bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), static_cast<std::uint8_t>(random.below(256)));
          break;
        default:
          bytes[at] = static_cast<std::uint8_t>(random.below(256));
      }
    }
    if (!refusal(bytes).empty()) continue;
    ++taken;
    // What was taken can be sent: it has blocks, and they account for every byte.
    const FirmwareImage image = parse_firmware(bytes);
    std::size_t words = 12;
    for (const FirmwareBlock& block : image.blocks) words += 3 + block.words;
    ASSERT_EQ(2 * words, bytes.size());
  }
  EXPECT_GT(taken, 0);
  EXPECT_LT(taken, trials(60'000));
}

class FirmwareOnDiskTest : public testing::Test {
 protected:
  static FirmwareTrouble trouble_of(const std::string& path) {
    try {
      read_firmware(path);
    } catch (const FirmwareError& error) {
      EXPECT_EQ(std::string(error.what()).find(path + ": "), 0U) << error.what();
      return error.trouble();
    }
    ADD_FAILURE() << path << " was taken";
    return {};
  }

  static std::string text(const Bytes& bytes) { return {bytes.begin(), bytes.end()}; }

  TemporaryFolder folder_;
};

TEST_F(FirmwareOnDiskTest, IsReadWhole) {
  const std::string path = folder_ / "firmware.bin";
  write_whole(path, text(boot_table()));
  const FirmwareImage image = read_firmware(path);
  EXPECT_EQ(image.bytes, boot_table());
  EXPECT_EQ(image.path, path);
}

TEST_F(FirmwareOnDiskTest, TellsApartWhyNot) {
  EXPECT_EQ(trouble_of(folder_ / "none"), FirmwareTrouble::missing);
  EXPECT_EQ(trouble_of(folder_.path()), FirmwareTrouble::unreadable);
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(trouble_of(folder_ / "pipe"), FirmwareTrouble::unreadable);
  write_whole(folder_ / "empty", "");
  EXPECT_EQ(trouble_of(folder_ / "empty"), FirmwareTrouble::invalid);
  EXPECT_EQ(trouble_of(folder_ / "empty/below"), FirmwareTrouble::missing);
  Bytes large = boot_table();
  large.resize(10 * largest_firmware);
  write_whole(folder_ / "large", text(large));
  EXPECT_EQ(trouble_of(folder_ / "large"), FirmwareTrouble::invalid);
  if (geteuid() != 0) {  // who may read everything
    write_whole(folder_ / "locked", text(boot_table()));
    ASSERT_EQ(chmod((folder_ / "locked").c_str(), 0), 0);
    EXPECT_EQ(trouble_of(folder_ / "locked"), FirmwareTrouble::unreadable);
  }
}

}  // namespace
}  // namespace ghostforce::firmware_file_test
