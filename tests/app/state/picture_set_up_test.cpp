#include "app/state/set_up_of.h"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "app/files/png_writer.h"
#include "app/files/read_error.h"
#include "app/files/xml_text.h"
#include "app/state/set_up.h"
#include "tests/support/random_set_up.h"
#include "tests/support/set_up_values.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::picture_set_up_test {
namespace {

class PictureSetUp : public testing::Test {
 protected:
  std::vector<std::string> values_in(std::string_view bytes) {
    write_whole(path_, bytes);
    return set_up_values(read_picture_set_up(path_));
  }
  std::string refusal_of(std::string_view bytes) {
    write_whole(path_, bytes);
    try {
      read_picture_set_up(path_);
    } catch (const ReadError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(path_)) << error.what();
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
  std::string path_ = folder_ / "picture";
  Image image_{1, 1, {1, 2, 3}};
};

TEST_F(PictureSetUp, ComesBackFromEachFormat) {
  Random random(19);
  for (int i = 0; i < 100; ++i) {
    const auto set_up = random_set_up(random);
    const auto expected = set_up_values(set_up);
    ASSERT_EQ(values_in(png_bytes(image_, picture_texts(set_up))), expected);
    const std::string title = picture_title("a: ghostforce run b", set_up);
    ASSERT_EQ(values_in("<svg><title>" + xml_text(title) + "</title></svg>"), expected);
    std::string escaped;
    for (const char c : title) escaped += c == '(' || c == ')' || c == '\\' ? std::string{'\\', c} : std::string{c};
    ASSERT_EQ(values_in("%PDF-1.4 /Title (" + escaped + ")"), expected);
  }
}

TEST_F(PictureSetUp, IsSaidToBeMissing) {
  for (const std::string& bytes :
       {png_bytes(image_), png_bytes(image_, std::vector{PngText{"Description", "a holiday"}}),
        std::string("<svg><title>a holiday</title></svg>"), std::string("%PDF-1.4"), std::string("GIF89a"),
        std::string()}) {
    EXPECT_NE(refusal_of(bytes).find("the picture does not say what it shows"), std::string::npos);
  }
  EXPECT_NE(refusal_of("<title>ghostforce run wal45</title>").find("did you mean 'wall45'?"), std::string::npos);
  EXPECT_NE(refusal_of("<title>ghostforce run --record x</title>").find("--record is not part of a set-up"),
            std::string::npos);
}

TEST_F(PictureSetUp, IsNotReadFromADamagedFile) {
  auto set_up = read_set_up_line("ghostforce run fig1");
  const std::string good = png_bytes(image_, picture_texts(set_up));
  std::string changed = good;
  changed[changed.find("fig1")] = 'g';
  EXPECT_NE(refusal_of(changed).find("CRC error"), std::string::npos);
  for (std::size_t length = 0; length < good.find("IDAT"); length += 3)
    EXPECT_NE(refusal_of(good.substr(0, length)), "");
  std::filesystem::remove(path_);
  EXPECT_THROW(read_picture_set_up(path_), ReadError);
}

}  // namespace
}  // namespace ghostforce::picture_set_up_test
