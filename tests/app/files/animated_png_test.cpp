// Animated PNG files, read again by a strict reader that shares nothing with the writer.
#include "app/files/clip_file.h"

#include <random>

#include <gtest/gtest.h>

#include "tests/app/files/png_pieces.h"
#include "tests/support/animated_png_reader.h"
#include "tests/support/read_png.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::animated_png_test {
namespace {

constexpr ClipShape shape{.width = 40, .height = 30, .frames_per_second = 25};

Image plain(std::uint8_t grey) {
  return {shape.width, shape.height, std::vector<std::uint8_t>(std::size_t{3} * shape.width * shape.height, grey)};
}

void paint(Image& image, int x, int y, std::uint8_t red) {
  image.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x))] =
      red;
}

void write_clip(const std::string& path, const std::vector<Image>& images, std::string_view text = {}) {
  OutputFile file(path);
  AnimatedPng clip(file, shape, text);
  for (const Image& image : images) clip.add(image);
  clip.finish();
  file.commit();
}

Animation written_and_read(const std::vector<Image>& images, std::string_view text = {}) {
  const TemporaryFolder folder;
  write_clip(folder / "clip.png", images, text);
  return read_animated_png(read_whole(folder / "clip.png"));
}

// A few squares of any size and colour on the picture before, now and then nothing.
std::vector<Image> some_pictures(int count) {
  std::mt19937 dice(15);
  const auto number = [&dice](int least, int most) { return std::uniform_int_distribution(least, most)(dice); };
  std::vector<Image> images;
  Image image = plain(200);
  for (int i = 0; i < count; ++i) {
    for (int square = number(0, 2); square > 0; --square) {
      const int left = number(0, shape.width - 1);
      const int top = number(0, shape.height - 1);
      const int right = number(left, shape.width - 1);
      const int bottom = number(top, shape.height - 1);
      const auto red = static_cast<std::uint8_t>(number(0, 255));
      for (int y = top; y <= bottom; ++y) {
        for (int x = left; x <= right; ++x) paint(image, x, y, red);
      }
    }
    images.push_back(image);
  }
  return images;
}

TEST(AnimatedPng, HoldsThePicturesThatItWasGiven) {
  const std::vector<Image> images = some_pictures(200);
  const Animation animation = written_and_read(images);
  EXPECT_EQ(animation.plays, 0U);
  std::size_t shown = 0;
  for (const AnimatedFrame& frame : animation.frames) {
    EXPECT_EQ(frame.delay_denominator, shape.frames_per_second);
    for (int i = 0; i < frame.delay_numerator; ++i, ++shown) {
      ASSERT_LT(shown, images.size());
      EXPECT_EQ(frame.image, images[shown]) << shown;
    }
  }
  EXPECT_EQ(shown, images.size());
  EXPECT_LT(animation.frames.size(), images.size()) << "equal pictures are one";
}

TEST(AnimatedPng, HasTheSameBytesTwice) {
  const TemporaryFolder folder;
  for (const char* const name : {"a.png", "b.png"}) write_clip(folder / name, some_pictures(50));
  EXPECT_EQ(read_whole(folder / "a.png"), read_whole(folder / "b.png"));
}

TEST(AnimatedPng, StoresTheSmallestRectangleThatHasChanged) {
  std::vector<Image> images{plain(9), plain(9), plain(9)};
  paint(images[1], 3, 7, 1);
  paint(images[1], 12, 20, 1);
  images[2] = images[1];
  paint(images[2], shape.width - 1, shape.height - 1, 2);
  const Animation animation = written_and_read(images);
  ASSERT_EQ(animation.frames.size(), 3U);
  const AnimatedFrame& second = animation.frames[1];
  EXPECT_EQ(std::vector({second.left, second.top, second.width, second.height}), std::vector({3U, 7U, 10U, 14U}));
  const AnimatedFrame& third = animation.frames[2];
  EXPECT_EQ(std::vector({third.left, third.top, third.width, third.height}), std::vector({39U, 29U, 1U, 1U}));
}

TEST(AnimatedPng, ShowsAPictureLongerThanItsNumberCanSay) {
  const std::vector<Image> images(65'540, plain(9));
  const Animation animation = written_and_read(images);
  ASSERT_EQ(animation.frames.size(), 2U);
  EXPECT_EQ(animation.frames[0].delay_numerator, 65'535);
  EXPECT_EQ(animation.frames[1].delay_numerator, 5);
  EXPECT_EQ(animation.frames[1].image, images.back());
}

TEST(AnimatedPng, IsAPictureForProgramsThatKnowNoAnimation) {
  const TemporaryFolder folder;
  const std::vector<Image> images = some_pictures(5);
  write_clip(folder / "clip.png", images);
  EXPECT_EQ(read_png(folder / "clip.png"), images.front());
}

TEST(AnimatedPng, SaysOfItselfWhatItIsGiven) {
  EXPECT_EQ(written_and_read({plain(1)}, "ghostforce run – ρ").comment, "ghostforce run – ρ");
  EXPECT_EQ(written_and_read({plain(1)}).comment, "");
}

TEST(AnimatedPng, RefusesPicturesOfAnotherKind) {
  const TemporaryFolder folder;
  OutputFile file(folder / "clip.png");
  AnimatedPng clip(file, shape);
  EXPECT_THROW(clip.finish(), std::logic_error);
  EXPECT_THROW(clip.add(Image{1, 1, {1, 2, 3}}), std::invalid_argument);
  Image translucent = plain(1);
  translucent.alpha.assign(translucent.rgb.size() / 3, 7);
  EXPECT_THROW(clip.add(translucent), std::invalid_argument);
}

// --- The reader itself: it must be able to fail ----------------------------------------------------------------------

TEST(AnimatedPngReader, RefusesWhatTheSpecificationForbids) {
  const TemporaryFolder folder;
  write_clip(folder / "clip.png", some_pictures(6));
  const std::string good = read_whole(folder / "clip.png");
  ASSERT_NO_THROW(read_animated_png(good));
  for (const char* const name : {"IHDR", "acTL", "fcTL", "IDAT", "fdAT", "IEND"}) {
    EXPECT_THROW(read_animated_png(with_wrong_crc(good, name)), std::runtime_error) << name;
  }
  EXPECT_THROW(read_animated_png(good.substr(0, good.size() - 1)), std::runtime_error);
  EXPECT_THROW(read_animated_png(good + "x"), std::runtime_error);
  EXPECT_THROW(read_animated_png(""), std::runtime_error);

  // With one byte of a chunk's data changed, and the checksum to go with it.
  const auto with_byte = [&good](std::string_view name, std::size_t at, char byte) {
    const std::size_t begin = good.find(name);
    std::size_t length = 0;
    for (std::size_t i = begin - 4; i < begin; ++i) length = length << 8U | static_cast<unsigned char>(good.at(i));
    std::string data = good.substr(begin + 4, length);
    data.at(at) = byte;
    return good.substr(0, begin - 4) + png_chunk(name, data) + good.substr(begin + 8 + length);
  };
  EXPECT_NO_THROW(read_animated_png(with_byte("acTL", 7, 3))) << "three times";
  EXPECT_THROW(read_animated_png(with_byte("acTL", 3, 9)), std::runtime_error) << "the number of pictures";
  EXPECT_THROW(read_animated_png(with_byte("fcTL", 3, 1)), std::runtime_error) << "the sequence";
  EXPECT_THROW(read_animated_png(with_byte("fcTL", 15, 1)), std::runtime_error) << "the rectangle";
  EXPECT_THROW(read_animated_png(with_byte("fcTL", 24, 3)), std::runtime_error) << "how to leave it";
  EXPECT_THROW(read_animated_png(with_byte("fdAT", 3, 0)), std::runtime_error) << "the sequence";
  EXPECT_THROW(read_animated_png(with_byte("fdAT", 8, 0)), std::runtime_error) << "the data";
}

}  // namespace
}  // namespace ghostforce::animated_png_test
