// What the address of the page asks for, and that no mistake in it is passed over.
#include "app/shell/page_address.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/files/read_error.h"

namespace ghostforce::page_address_test {
namespace {

PageAddress read(std::string_view query) {
  return read_page_address(query, [](const std::string& value) { return value == "https://course.example.org:8443"; });
}

TEST(PageAddress, AsksForNothingAtFirst) {
  for (const char* query : {"", "?", "?&&"}) {
    const PageAddress address = read(query);
    EXPECT_TRUE(address.problems.empty()) << query;
    EXPECT_EQ(address.lesson + address.language + address.embedder, "");
    EXPECT_FALSE(address.is_kiosk || address.is_for_new_person || address.fits);
  }
}

TEST(PageAddress, IsReadWhole) {
  const PageAddress address =
      read("?kiosk&lesson=my%2Downs&language=es-MX&reset&fit=1&embed=https%3A%2F%2Fcourse.example.org:8443");
  EXPECT_TRUE(address.problems.empty()) << address.problems.front();
  EXPECT_EQ(address.lesson, "my-owns");
  EXPECT_EQ(address.language, "es");
  EXPECT_EQ(address.embedder, "https://course.example.org:8443");
  EXPECT_TRUE(address.is_kiosk && address.is_for_new_person && address.fits);
}

TEST(PageAddress, TellsOfEachMistakeAndUsesTheRest) {
  const std::vector<std::pair<std::string, std::string>> mistakes{
      {"language=\"><script>", "'\"><script>' is not one of en, es"},
      {"language=%22%3E%3Cscript%3E", "'\"><script>' is not one of en, es"},
      {"language=", "language has no value; give en or es"},
      {"language=fr", "'fr' is not one of en, es"},
      {"lesson", "lesson has no value"},
      {"lesson=a%00b", "the control character U+0000 in lesson"},
      {"lesson=%E0%A4%A", "two hexadecimal digits have to follow the % of '%A'"},
      {"lesson=5%", "the % of '%'"},
      {"lesson=%zz", "the % of '%zz'"},
      {"lessons=ghost", "did you mean 'lesson'?"},
      {"step=2", "a kiosk begins each lesson at its first step"},
      {"step=0", "'0' is not the number of a step; give 1 or more"},
      {"step=two", "'two' is not the number of a step"},
      {"script", "is not one of lesson, step, language, kiosk, reset, fit, embed, notices"},
      {"fit&fit", "fit is there twice"},
      {"embed=*", "'*' is not the origin of a page"},
      {"fit=banana", "fit takes no value but 1"},
      {"reset=no", "reset takes no value but 1"},
  };
  for (const auto& [query, words] : mistakes) {
    const PageAddress address = read("?kiosk&" + query);
    ASSERT_EQ(address.problems.size(), 1U) << query;
    EXPECT_NE(address.problems[0].find(words), std::string::npos) << query << ": " << address.problems[0];
    EXPECT_TRUE(address.is_kiosk);
    EXPECT_EQ(address.lesson + address.language + address.embedder, "") << query;
  }
}

TEST(PageAddress, BeginsALessonAtAStep) {
  EXPECT_FALSE(read("lesson=ghost").lesson_step);
  const PageAddress address = read("lesson=ghost&step=3");
  EXPECT_TRUE(address.problems.empty());
  EXPECT_EQ(address.lesson_step, 3U);
  const PageAddress without = read("step=3");
  ASSERT_EQ(without.problems.size(), 1U);
  EXPECT_NE(without.problems.front().find("no lesson is named"), std::string::npos) << without.problems.front();
  EXPECT_FALSE(without.lesson_step);
}

TEST(PageAddress, SwitchesOnWithoutAValueOrWithOneAlone) {
  for (const char* query : {"kiosk&fit&reset", "kiosk=&fit=&reset=", "kiosk=1&fit=1&reset=1"}) {
    const PageAddress address = read(query);
    EXPECT_TRUE(address.problems.empty() && address.is_kiosk && address.fits && address.is_for_new_person) << query;
  }
  const PageAddress address = read("kiosk=false&fit=banana&reset=no");
  EXPECT_FALSE(address.is_kiosk || address.fits || address.is_for_new_person);
  EXPECT_EQ(address.problems.size(), 3U);
}

// Who shared a link has not made a mistake.
TEST(PageAddress, PassesOverWhatOthersAddToLinks) {
  EXPECT_TRUE(read("?utm_source=mail&fbclid=abc").problems.empty());
}

TEST(PageAddress, HasCharactersInPlaceOfPercentSigns) {
  EXPECT_EQ(without_percent_signs("wall45%20--set+a"), "wall45 --set+a");
  EXPECT_EQ(without_percent_signs("%C3%a4%00"), std::string("ä\0", 3));
  EXPECT_THROW(without_percent_signs("100%"), ReadError);
}

}  // namespace
}  // namespace ghostforce::page_address_test
