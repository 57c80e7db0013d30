// The files that a Debian package needs and that are made of the project's own.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/package/project_file.h"

namespace ghostforce::debian_files_test {
namespace {

TEST(DebianCopyright, NamesEveryWorkAndHasTheTextOfEachLicence) {
  const Outcome made = run_script("copyright.py", {project_path("LICENSE"), project_path("THIRD_PARTY_NOTICES.md")});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  for (const std::string& work : works_in_program()) {
    const bool is_inside = work != "DejaVu fonts";  // a package of their own
    EXPECT_EQ(made.out.find("\nComment: " + work + ": ") != std::string::npos, is_inside) << work;
  }
  // A licence that a work has is one whose text follows, and the other way round.
  std::set<std::string> had;
  for (const std::string& licence : all_in(made.out, R"(^License: (\S+)\nComment)")) had.insert(licence);
  had.insert("MIT");
  std::set<std::string> written_out;
  for (const std::string& licence : all_in(made.out, R"(^License: (\S+)\n )")) written_out.insert(licence);
  EXPECT_EQ(had, written_out);
  EXPECT_GE(had.size(), 4U);
  EXPECT_NE(made.out.find(" Redistribution and use in source and binary forms"), std::string::npos);
}

TEST(DebianCopyright, ALicenceWithoutItsTextIsSaid) {
  const TemporaryFolder folder;
  write_whole(folder / "notices.md",
              "\n## In the desktop program\n\n| Work | What | Licence | Copyright |\n| --- | --- | --- | --- |\n"
              "| Something | headers | Beerware | Copyright Somebody |\n\n## In the page\n\n## MIT\n\n```\nDo!\n```\n");
  const Outcome made = run_script("copyright.py", {project_path("LICENSE"), folder / "notices.md"});
  EXPECT_NE(made.exit_code, 0);
  EXPECT_NE(made.err.find("no section '## Beerware'"), std::string::npos) << made.err;
}

TEST(DebianChangelog, HasTheReleasesAndNotWhatIsUnreleased) {
  const TemporaryFolder folder;
  write_whole(folder / "CHANGELOG.md",
              "# Changelog\n\n## [Unreleased]\n\n- Not yet.\n\n## [0.2.0] - 2026-11-23\n\nWords.\n\n### Added\n\n"
              "- One thing,\n  in two lines.\n- Another.\n\n## [0.1.0] - 2026-02-01\n\nThe first one.\n");
  const Outcome made = run_script("changelog.py", {folder / "CHANGELOG.md", "Somebody <her@place.org>"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_EQ(made.out,
            "ghostforce (0.2.0) unstable; urgency=medium\n\n"
            "  * One thing, in two lines.\n"
            "  * Another.\n\n"
            " -- Somebody <her@place.org>  Mon, 23 Nov 2026 00:00:00 +0000\n\n"
            "ghostforce (0.1.0) unstable; urgency=medium\n\n"
            "  * Released.\n\n"
            " -- Somebody <her@place.org>  Sun, 01 Feb 2026 00:00:00 +0000\n");
}

TEST(DebianChangelog, AFileWithoutReleasesIsSaid) {
  const TemporaryFolder folder;
  write_whole(folder / "CHANGELOG.md", "# Changelog\n");
  const Outcome made = run_script("changelog.py", {folder / "CHANGELOG.md", "Somebody <her@place.org>"});
  EXPECT_NE(made.exit_code, 0);
  EXPECT_NE(made.err.find("CHANGELOG.md has no line such as"), std::string::npos) << made.err;
}

}  // namespace
}  // namespace ghostforce::debian_files_test
