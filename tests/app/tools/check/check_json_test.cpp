// `ghostforce check --json`: what programs read.
#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/files/png_writer.h"
#include "ghostforce_version.h"
#include "tests/app/tools/check/check_cases.h"
#include "tests/support/places.h"
#include "tests/support/read_png.h"

namespace ghostforce::check_json_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

TEST(CheckJson, IsOneDocumentOfAllVerdicts) {
  const std::string text(small_case);
  const Cases cases({{"changed", text + "mask = [[0, 0, 32, 24]]\n[tolerance]\nchannel = 3\nshare = 0.25\n"},
                     {"equal", text + "match = \"good\"\n"},
                     {"good", text},
                     {"larger", text},
                     {"new", text}});
  ASSERT_EQ(cases.check({"--update", "changed", "good"}).exit_code, 0);
  Image golden = read_png(cases / "good.png");
  for (int i = 0; i < 30'000; ++i) golden.rgb[static_cast<std::size_t>(3 * (320 * 200 - i))] ^= 0x80U;
  write_whole(cases / "changed.png", png_bytes(golden));
  write_whole(cases / "larger.png", png_bytes(Image{1, 1, {0, 0, 0}}));
  const std::string report = cases.beside("report");
  const Outcome outcome = cases.check({"--json", "--report", report, "--jobs", "2"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.err, "changed: ")) << "people are told as ever";

  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json.at("format"), 1);
  EXPECT_EQ(json.at("version"), version);
  EXPECT_EQ(json.at("folder"), cases.path());
  EXPECT_EQ(json.at("total").at("cases"), 5);
  EXPECT_EQ(json.at("total").at("failed"), 3);
  EXPECT_GE(json.at("total").at("duration_s"), 0.0);
  EXPECT_EQ(json.at("report").at("html"), report + "/report.html");
  EXPECT_EQ(json.at("report").at("junit"), report + "/junit.xml");
  ASSERT_EQ(json.at("cases").size(), 5U);

  const Json& changed = json.at("cases").at(0);
  EXPECT_EQ(changed.at("name"), "changed");
  EXPECT_EQ(changed.at("pass"), false);
  EXPECT_TRUE(contains(outcome.err, changed.at("reason").get<std::string>()));
  EXPECT_EQ(changed.at("remark"), nullptr);
  EXPECT_EQ(changed.at("update"), "ghostforce check " + cases.path() + " --update changed");
  EXPECT_EQ(changed.at("compared_with"), "golden");
  EXPECT_EQ(changed.at("other"), nullptr);
  const Json& difference = changed.at("difference");
  EXPECT_EQ(difference.at("pixels"), 30'000);
  EXPECT_EQ(difference.at("masked_pixels"), 32 * 24);
  EXPECT_EQ(difference.at("compared_pixels"), 320 * 240 - 32 * 24);
  EXPECT_NEAR(difference.at("share"), 30'000.0 / (320 * 240 - 32 * 24), 1e-12);
  EXPECT_EQ(difference.at("greatest"), 128);
  EXPECT_EQ(difference.at("box"), Json::parse("[0, 106, 320, 95]"));
  EXPECT_EQ(changed.at("tolerance"), Json::parse(R"({"channel": 3, "share": 0.25})"));
  EXPECT_TRUE(changed.at("renderer").get<std::string>().starts_with("llvmpipe"));
  EXPECT_FALSE(changed.at("mesa").get<std::string>().empty());
  EXPECT_GE(changed.at("duration_s"), 0.0);
  for (const auto& [word, file] : {std::pair("expected", "expected"), {"actual", "actual"}, {"difference", "diff"}}) {
    const std::string path = changed.at("files").at(word);
    EXPECT_EQ(path, report + "/changed." + file + ".png");
    EXPECT_TRUE(fs::exists(path));
  }

  const Json& equal = json.at("cases").at(1);
  EXPECT_EQ(equal.at("pass"), true);
  EXPECT_EQ(equal.at("compared_with"), "match");
  EXPECT_EQ(equal.at("other"), "good");
  EXPECT_EQ(equal.at("update"), nullptr);
  EXPECT_EQ(equal.at("difference").at("box"), nullptr);
  EXPECT_EQ(equal.at("files"), Json::object());

  for (const std::size_t i : {3U, 4U}) {
    EXPECT_EQ(json.at("cases").at(i).at("difference"), nullptr) << "there is nothing to compare with";
    EXPECT_EQ(json.at("cases").at(i).at("files").size(), 1U);
  }
  EXPECT_EQ(Json::parse(cases.check({"--json"}).out).at("report"), nullptr);
}

TEST(CheckJson, IsJsonWhateverNamesAre) {
  const std::map<std::string, std::string> odd{
      {"a \"b\" \\ \xC3\xBC \xFF", std::string(small_case)}};  // the last is no UTF-8
  const Cases cases(odd);
  const Json json = Json::parse(cases.check({"--json"}).out);
  EXPECT_EQ(json.at("cases").at(0).at("name"), "a \"b\" \\ \xC3\xBC \xEF\xBF\xBD");
}

TEST(CheckJson, IsNotPrintedWhereNothingWasChecked) {
  const Cases cases({{"a", std::string("scene = \"wal45\"\n")}});
  const Outcome outcome = cases.check({"--json"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(cases.check({"--json", "--update", "a"}).exit_code, 2);
  EXPECT_EQ(run_ghostforce({"check", "ghost", "--json"}).exit_code, 2);
}

TEST(CheckJson, KeepsTheExitCodeWhenNobodyReadsIt) {
  const Cases cases({{"new", std::string(small_case)}});
  const std::string pipe = cases.beside("pipe");
  // A pipe that nobody reads any more.
  EXPECT_EQ(run_program("/bin/sh", {"-c", "mkfifo " + pipe + "; exec 3<>" + pipe + " 4>" + pipe + " 3<&-; " +
                                              ghostforce_program() + " check " + cases.path() + " --json >&4"})
                .exit_code,
            1);
}

}  // namespace
}  // namespace ghostforce::check_json_test
