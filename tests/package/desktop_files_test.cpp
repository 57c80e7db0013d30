// What a desktop is told of the program: checked by the tools that desktops have for it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/package/project_file.h"

namespace ghostforce::desktop_files_test {
namespace {

const std::string metainfo = "assets/desktop/org.ghostforce.ghostforce.metainfo.xml";

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
  return text;
}

// The words of one of the desktop's tools; none where it has nothing to complain of.
std::string complaint_of(std::vector<std::string> tool) {
  const Outcome outcome = run_program("/usr/bin/env", std::move(tool));
  return outcome.exit_code == 0 ? "" : outcome.out + outcome.err;
}

TEST(DesktopFiles, TheEntryIsValid) {
  EXPECT_EQ(complaint_of({"desktop-file-validate", project_path("assets/desktop/ghostforce.desktop")}), "");
}

TEST(DesktopFiles, TheMetainfoIsValid) {
  const Outcome outcome =
      run_program("/usr/bin/env", {"appstreamcli", "validate", "--no-net", "--no-color", project_path(metainfo)});
  EXPECT_NE((outcome.out + outcome.err).find("Validation "), std::string::npos) << outcome.out << outcome.err;
  for (const std::string& complaint : all_in(outcome.out + outcome.err, "^([EW]: .*)")) {
    // Newer versions miss an address in the web; there is none.
    EXPECT_NE(complaint.find(": url-homepage-missing"), std::string::npos) << complaint;
  }
}

TEST(DesktopFiles, OnlyNamesThatSayGhostforceAreItsScenes) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "mime/packages");
  std::filesystem::copy(project_path("assets/desktop/ghostforce-mime.xml"), folder / "mime/packages/ghostforce.xml");
  ASSERT_EQ(complaint_of({"update-mime-database", folder / "mime"}), "");
  const std::string globs = read_whole(folder / "mime/globs2");
  EXPECT_EQ(all_in(globs, "^([0-9].*)"),
            std::vector<std::string>{"50:application/x-ghostforce-scene+toml:*.ghostforce.toml"});
}

TEST(DesktopFiles, NameTheSameThings) {
  const std::string entry = project_file("assets/desktop/ghostforce.desktop");
  const std::string words = project_file(metainfo);
  const std::string type = "application/x-ghostforce-scene+toml";
  EXPECT_NE(entry.find("\nMimeType=" + type + ";\n"), std::string::npos);
  EXPECT_NE(words.find("<mediatype>" + type + "</mediatype>"), std::string::npos);
  EXPECT_NE(project_file("assets/desktop/ghostforce-mime.xml").find("\"" + type + "\""), std::string::npos);
  // The window's own name, by which a desktop finds the entry.
  const std::string window = project_file("app/shell/desktop/opengl_window.cpp");
  EXPECT_EQ(all_in(window, R"re((?:CLASS_NAME|APP_ID), "([^"]+)"\))re"), std::vector<std::string>(2, "ghostforce"));
  EXPECT_NE(entry.find("\nStartupWMClass=ghostforce\n"), std::string::npos);
}

// A software centre proposes the program when one of these is plugged in.
TEST(DesktopFiles, TheMetainfoNamesTheDevicesOfTheUdevRule) {
  const std::string rule = project_file("assets/udev/70-ghostforce.rules");
  const std::string words = project_file(metainfo);
  std::set<std::string> named;
  for (const std::string& device : all_in(words, R"(<modalias>(usb:\S+)</modalias>)")) named.insert(device);
  std::set<std::string> ruled;
  for (const std::string& line : all_in(rule, "^(SUBSYSTEM.*idVendor.*)")) {
    // Boards that anything may run on: nobody with an Arduino wants to hear of this program.
    if (line.find("ID_MM_DEVICE_IGNORE") != std::string::npos) continue;
    std::string vendor = all_in(line, R"re(idVendor\}=="(\w+)")re").at(0);
    std::vector<std::string> products = all_in(line, R"re(idProduct\}=="([^"]+)")re");
    products = products.empty() ? std::vector<std::string>{"*"} : all_in(products.at(0), R"((\w+))");
    for (const std::string& product : products) ruled.insert(upper("v" + vendor + "p" + product));
  }
  std::set<std::string> both;
  for (const std::string& device : named) both.insert(upper(all_in(device, R"(usb:(v\w+p[\w*]+?)d[*]$)").at(0)));
  EXPECT_EQ(both, ruled);
  EXPECT_GE(ruled.size(), 10U);
}

}  // namespace
}  // namespace ghostforce::desktop_files_test
