// PNG files as others write them: the values are those stored, and what is damaged is told.
#include "app/files/png_file.h"
#include "app/files/png_writer.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "app/files/read_error.h"
#include "tests/app/files/png_pieces.h"
#include "tests/support/read_png.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::png_file_test {
namespace {

Image noise(int width, int height, bool has_alpha) {
  Image image{width, height, {}};
  std::uint32_t random = 1;
  const auto byte = [&] { return static_cast<std::uint8_t>((random = random * 1664525U + 1013904223U) >> 24U); };
  for (int i = 0; i < width * height; ++i) {
    image.rgb.insert(image.rgb.end(), {byte(), byte(), byte()});
    if (has_alpha) image.alpha.push_back(byte());
  }
  return image;
}

class PngFileTest : public testing::Test {
 protected:
  Image read(std::string_view bytes) const {
    write_whole(folder_ / "a.png", bytes);
    return read_png(folder_ / "a.png");
  }
  // What is said of a file that is no good.
  std::string refusal(std::string_view bytes) const {
    try {
      read(bytes);
    } catch (const ReadError& error) {
      EXPECT_EQ(error.kind(), ReadError::Kind::unreadable);
      EXPECT_NE(std::string(error.what()).find("a.png: cannot be read as a PNG picture: "), std::string::npos);
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
};

TEST_F(PngFileTest, ReadsWhatItWrote) {
  for (const bool has_alpha : {false, true}) {
    const Image image = noise(37, 21, has_alpha);
    EXPECT_EQ(read(png_bytes(image)), image);
  }
}

TEST_F(PngFileTest, ForgetsAnAlphaThatSaysNothing) {
  Image image = noise(5, 4, false);
  const Image opaque = image;
  image.alpha.assign(20, 255);
  EXPECT_EQ(read(png_bytes(image)), opaque);
}

TEST_F(PngFileTest, ReadsEveryKindOfPixel) {
  // Two pixels, 0x12 and 0xEF of grey, each way that a PNG can hold them; the stored block of zlib needs no compressor.
  const std::vector<std::uint8_t> grey{0x12, 0x12, 0x12, 0xEF, 0xEF, 0xEF};
  const std::string_view two_bytes_each("\0\x12\x12\xEF\xEF", 5);
  EXPECT_EQ(read(png_of(2, 1, 8, 0, std::string("\0\x12\xEF", 3))).rgb, grey);
  EXPECT_EQ(read(png_of(2, 1, 16, 0, two_bytes_each)).rgb, grey);
  const Image with_alpha = read(png_of(2, 1, 8, 4, std::string("\0\x12\x40\xEF\xFF", 5)));
  EXPECT_EQ(with_alpha.rgb, grey);
  EXPECT_EQ(with_alpha.alpha, (std::vector<std::uint8_t>{0x40, 0xFF}));
  const std::string palette = png_chunk("PLTE", "\x12\x12\x12\xEF\xEF\xEF");
  EXPECT_EQ(read(png_of(2, 1, 1, 3, std::string("\0\x40", 2), palette)).rgb, grey);
  const Image hole = read(png_of(2, 1, 1, 3, std::string("\0\x40", 2), palette + png_chunk("tRNS", std::string(1, 0))));
  EXPECT_EQ(hole.rgb, grey);
  EXPECT_EQ(hole.alpha, (std::vector<std::uint8_t>{0, 255}));
}

TEST_F(PngFileTest, TakesTheStoredValuesWhateverGammaTheyAreMeantWith) {
  const std::string linear = png_chunk("gAMA", std::string("\0\x01\x86\xA0", 4));  // 1.0
  EXPECT_EQ(read(png_of(1, 1, 8, 2, std::string("\0\x12\x80\xEF", 4), linear)).rgb,
            (std::vector<std::uint8_t>{0x12, 0x80, 0xEF}));
}

TEST_F(PngFileTest, KnowsItsSizeBeforeAnyPixelIsThere) {
  // The picture's data begins, and that is all.
  const std::string bytes = png_of(30000, 20000, 8, 2, "");
  write_whole(folder_ / "a.png", bytes);
  PngFile file(folder_ / "a.png");
  EXPECT_EQ(file.width(), 30000);
  EXPECT_EQ(file.height(), 20000);
}

// Once all of them were pictures like any other.
TEST_F(PngFileTest, RefusesAWrongChecksum) {
  const std::string row("\0\x12\x80\xEF", 4);
  const std::string text = png_chunk("tEXt", std::string("a\0b", 3));
  const std::string good = png_of(1, 1, 8, 2, row, text);
  ASSERT_EQ(read(good).rgb.size(), 3U);
  for (const std::string_view name : {"IHDR", "tEXt", "IDAT", "IEND"}) {
    EXPECT_NE(refusal(with_wrong_crc(good, name)).find("CRC error"), std::string::npos) << name;
  }
  EXPECT_NE(refusal(png_of(1, 1, 8, 2, row, text, 1)).find("incorrect data check"), std::string::npos)
      << "the sum of zlib, in a chunk whose own is right";
}

TEST_F(PngFileTest, CarriesTextsBesideTheSamePixels) {
  const Image image = noise(20, 10, false);
  const std::vector<PngText> texts{software_text(), {"Description", "it's 'quoted' \"words\""}, {"Comment", "ρ → ∞"}};
  const std::string bytes = png_bytes(image, texts);
  EXPECT_EQ(png_bytes(image, texts), bytes);
  EXPECT_EQ(read(bytes), image);
  EXPECT_EQ(PngFile(folder_ / "a.png", PngWords::read).texts(), texts);
  EXPECT_TRUE(PngFile(folder_ / "a.png").texts().empty());
  // With no library in between: chunks as the format has them, before the pixels.
  for (const std::string& chunk : {png_chunk("tEXt", "Software" + std::string(1, '\0') + texts[0].text),
                                   png_chunk("iTXt", "Comment" + std::string(5, '\0') + texts[2].text)}) {
    EXPECT_LT(bytes.find(chunk), bytes.find("IDAT"));
  }
  EXPECT_EQ(png_bytes(image, {}), png_bytes(image)) << "no text, no chunk";
  EXPECT_EQ(png_bytes(image).find("tEXt"), std::string::npos);
}

TEST_F(PngFileTest, LooksAtTheSumsOfTextsAndTakesNoBadOnes) {
  const auto texts_of = [&](std::string_view bytes) -> std::size_t {
    write_whole(folder_ / "a.png", bytes);
    try {
      return PngFile(folder_ / "a.png", PngWords::read).texts().size();
    } catch (const ReadError&) {
      return 99;
    }
  };
  const std::string row(4, '\0');
  const std::string good = png_chunk("tEXt", std::string("Comment\0a", 9));
  EXPECT_EQ(texts_of(png_of(1, 1, 8, 2, row, good)), 1);
  EXPECT_EQ(texts_of(with_wrong_crc(png_of(1, 1, 8, 2, row, good), "tEXt")), 99);
  // A keyword of no length or of a hundred letters, packed data that is none, a length beyond the file's end.
  for (const std::string& bad :
       {png_chunk("tEXt", ""), png_chunk("tEXt", std::string(100, 'a')),
        png_chunk("zTXt", std::string("a\0\0not packed", 13)), png_chunk("iTXt", std::string("a\0\1\0\0\0x", 7)),
        std::string("\x7F\xFF\xFF\xFFtEXt", 8)}) {
    const std::size_t found = texts_of(png_of(1, 1, 8, 2, row, bad));
    EXPECT_TRUE(found == 0 || found == 1 || found == 99) << found;
  }
  const std::string whole = png_bytes(noise(2, 2, false), std::vector<PngText>{{"Description", "abc"}});
  for (std::size_t length = 0; length < whole.find("IDAT"); ++length) {
    EXPECT_EQ(texts_of(whole.substr(0, length)), 99) << length;
  }
}

TEST_F(PngFileTest, RefusesWhatIsCutOrNoPng) {
  const std::string good = png_bytes(noise(20, 10, false));
  for (std::size_t length = 0; length < good.size(); length += 7) {
    EXPECT_NE(refusal(good.substr(0, length)), "") << length;
  }
  EXPECT_NE(refusal("version https://git-lfs.github.com/spec/v1\n"), "");
}

TEST_F(PngFileTest, TellsWhyAFileCannotBeRead) {
  const auto why = [](const std::string& path) -> std::string {
    try {
      read_png(path);
    } catch (const ReadError& error) {
      EXPECT_EQ(error.kind(), ReadError::Kind::unreadable);
      return error.what();
    }
    return "";
  };
  EXPECT_NE(why(folder_ / "none.png").find("No such file"), std::string::npos);
  EXPECT_NE(why(folder_.path()).find("Is a directory"), std::string::npos);
  EXPECT_NE(why("/proc/self/mem"), "") << "nothing lies at its beginning: an error of reading";
}

}  // namespace
}  // namespace ghostforce::png_file_test
