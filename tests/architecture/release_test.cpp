// A release has one version and one date, wherever they are told.

#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "ghostforce_version.h"
#include "tests/support/places.h"

namespace ghostforce::release_test {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(source_path("/") + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

struct Release {
  std::string version;
  std::string date;

  friend bool operator==(const Release&, const Release&) = default;
};

// What the first match of the pattern says: the version, then the date.
Release first_release(const std::string& text, const char* pattern) {
  std::smatch match;
  return std::regex_search(text, match, std::regex(pattern)) ? Release{match[1], match[2]} : Release{};
}

TEST(Release, IsTheSameInProgramChangelogAndMetainfo) {
  const Release newest = first_release(text_of("CHANGELOG.md"), R"re(\n## \[([0-9.]+)\] - (\d{4}-\d{2}-\d{2})\n)re");
  EXPECT_EQ(newest.version, ghostforce::version);
  EXPECT_FALSE(newest.date.empty());
  EXPECT_EQ(newest, first_release(text_of("assets/desktop/org.ghostforce.ghostforce.metainfo.xml"),
                                  R"re(<release version="([0-9.]+)" date="([0-9-]+)"/>)re"))
      << "software centres show the metainfo's";
}

}  // namespace
}  // namespace ghostforce::release_test
