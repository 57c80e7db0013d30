// Files as the desktop's dialogs name them.
#include "app/files/file_uri.h"

#include <gtest/gtest.h>

namespace ghostforce::file_uri_test {
namespace {

TEST(FileUri, StandsForThePath) {
  EXPECT_EQ(path_of_file_uri("file:///home/ana/wall.toml"), "/home/ana/wall.toml");
  EXPECT_EQ(path_of_file_uri("file://localhost/tmp/a"), "/tmp/a");
  EXPECT_EQ(path_of_file_uri("file:///a%20b%25c%C3%B1+d"), "/a b%cñ+d");
  EXPECT_EQ(path_of_file_uri("file:///%2e%2E/x"), "/../x");
}

TEST(FileUri, OtherKindsOtherComputersAndDamagedOnesAreNone) {
  for (const char* const uri : {"", "file:", "file:/a", "file://host/a", "sftp://host/a", "https://a/b", "/home/ana/a",
                                "file:///a%", "file:///a%2", "file:///a%2g", "file:///a%-1", "file:///a%00b"}) {
    EXPECT_EQ(path_of_file_uri(uri), std::nullopt) << uri;
  }
}

}  // namespace
}  // namespace ghostforce::file_uri_test
