// `ghostforce check --update` for all cases that fail, and numbers beside pictures.
#include <sys/stat.h>

#include <filesystem>
#include <map>
#include <regex>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/picture/glossary.h"
#include "tests/app/tools/check/check_cases.h"

namespace ghostforce::check_update_test {
namespace {

using Json = nlohmann::ordered_json;

// With these words on its standard input.
Outcome update_with(const Cases& cases, std::string_view typed, std::string_view more = "") {
  return run_program("/bin/sh", {"-c", fmt::format("printf '{}' | '{}' check '{}' --update {}", typed,
                                                   ghostforce_program(), cases.path(), more)});
}

class CheckUpdateAll : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(cases_.check({"--update", "changed", "kept"}).exit_code, 0);
    write_whole(cases_ / "changed.toml", replaced(read_whole(cases_ / "changed.toml"), "naive", "full"));
  }

  std::string golden() const { return read_whole(cases_ / "changed.png"); }

  Cases cases_{{{"changed", std::string(small_case) + "strategy = \"naive\"\n"},
                {"kept", std::string(small_case) + "strategy = \"anisotropic\"\n"},
                {"unlike", std::string(small_case) + "strategy = \"full\"\nmatch = \"kept\"\n"}}};
};

TEST_F(CheckUpdateAll, StoresNothingUnlessSomebodyAgrees) {
  const std::string before = golden();
  for (const char* const typed : {"", "n\\n", "\\n", "nyet\\n"}) {
    const Outcome outcome = update_with(cases_, typed);
    EXPECT_EQ(outcome.exit_code, 1) << typed;
    EXPECT_TRUE(contains(outcome.err, "Store a new golden for this case?"));
    EXPECT_TRUE(contains(outcome.out, "FAIL changed"));
    EXPECT_TRUE(contains(outcome.out, "nothing was stored"));
    EXPECT_EQ(golden(), before);
  }
}

TEST_F(CheckUpdateAll, StoresThoseThatFailAndNoOther) {
  const std::string kept = read_whole(cases_ / "kept.png");
  const Outcome outcome = update_with(cases_, "y\\n");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "changed.png; look at it"));
  EXPECT_FALSE(outcome.out.find("kept.png") != std::string::npos) << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "no new golden mends that")) << "of the one that must equal another";
  EXPECT_EQ(read_whole(cases_ / "kept.png"), kept);
  EXPECT_EQ(cases_.check({"--only", "changed", "kept"}).exit_code, 0);
  const Outcome again = update_with(cases_, "");
  EXPECT_EQ(again.exit_code, 1) << "the one that must equal another fails still";
  EXPECT_TRUE(contains(again.out, "no case needs a new golden"));
}

TEST_F(CheckUpdateAll, AgreementNeedsNoNewline) {
  const std::string before = golden();
  EXPECT_EQ(update_with(cases_, "y").exit_code, 0);
  EXPECT_NE(golden(), before);
}

TEST_F(CheckUpdateAll, AsksNothingWhereTheAnswerIsGiven) {
  const Outcome outcome = update_with(cases_, "n\\n", "--yes");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err.find("[y/N]"), std::string::npos);
  EXPECT_EQ(cases_.check({"--only", "changed"}).exit_code, 0);
  EXPECT_EQ(cases_.check({"--yes"}).exit_code, 2) << "there is nothing to agree to";
}

// A word that libraries for options may put in the place of none.
TEST(CheckUpdateTrue, IsACaseLikeAnyOther) {
  const Cases cases({{"other", std::string(small_case)}, {"true", std::string(small_case)}});
  EXPECT_EQ(cases.check({"--update", "true"}).exit_code, 0);
  EXPECT_TRUE(cases.files().contains("true.png"));
  EXPECT_FALSE(cases.files().contains("other.png"));
  EXPECT_TRUE(contains(update_with(cases, "n\\n").err, "[y/N]")) << "the other has none yet";
}

// --- Numbers ---------------------------------------------------------------------------------------------------------

std::string naive_with(std::string_view expected) {
  return fmt::format("{}strategy = \"naive\"\n[expect]\n{}\n", small_case, expected);
}

// As the program tells it.
double number_of(const Outcome& outcome, std::string_view name) {
  const Json report = Json::parse(outcome.out);
  for (const Json& number : report.at("cases").at(0).at("numbers")) {
    if (number.at("name") == name) return number.at("actual");
  }
  ADD_FAILURE() << name << outcome.out;
  return 0.0;
}

TEST(CheckNumbers, MustBeWhatTheCaseStates) {
  const Cases cases({{"wall", naive_with("force_N = 0\nghost_force_N = 0\nproxy_drift_mm = 0\nenergy_mJ = 0\n"
                                         "tolerance = 1000")}});
  cases.update("wall");
  const Outcome lenient = cases.check({"--json"});
  EXPECT_EQ(lenient.exit_code, 0);
  const double ghost = number_of(lenient, "ghost_force_N");
  EXPECT_GT(ghost, 1.0);
  EXPECT_GT(number_of(lenient, "proxy_drift_mm"), 1.0);

  const auto check_with = [&](std::string_view expected) {
    const std::string text = read_whole(cases / "wall.toml");
    const std::size_t begin = text.find("[expect]");
    const std::size_t end = text.find("[golden]");
    write_whole(cases / "wall.toml",
                text.substr(0, begin) + fmt::format("[expect]\n{}\n", expected) + text.substr(end));
    return cases.check();
  };
  EXPECT_EQ(check_with(fmt::format("ghost_force_N = {}", ghost)).exit_code, 0);
  EXPECT_EQ(check_with(fmt::format("ghost_force_N = {}", ghost + 0.9e-6)).exit_code, 0);
  const Outcome wrong = check_with(fmt::format("ghost_force_N = {}", ghost + 1.1e-6));
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_TRUE(contains(wrong.out, fmt::format("FAIL wall  ghost_force_N is {}, not", ghost)));
  EXPECT_EQ(wrong.err.find("--update"), std::string::npos) << "no new golden mends a number";
  EXPECT_EQ(check_with(fmt::format("ghost_force_N = {}\ntolerance = 1e-3", ghost + 0.9e-3)).exit_code, 0);
}

TEST(CheckNumbers, AreTheCasesOwnToMendAndUpdateSaysSo) {
  const Cases cases({{"wall", naive_with("ghost_force_N = 0")}});
  const Outcome stored = cases.check({"--update", "wall"});
  EXPECT_EQ(stored.exit_code, 1) << "the case fails still";
  EXPECT_TRUE(contains(stored.out, "wall.png; look at it before you commit it; wall still fails: ghost_force_N is "));
  EXPECT_TRUE(std::filesystem::exists(cases / "wall.png"));
}

// Pages of an older check would pass for this one's, where a job collects them whatever happens.
TEST(CheckReport, OfAnOlderCheckDoesNotOutliveOneThatFails) {
  const Cases cases({{"wall", std::string(small_case)}});
  cases.update("wall");
  const auto expect_pages = [&](bool are_there) {
    for (const char* const page : {"report/report.html", "report/junit.xml"}) {
      EXPECT_EQ(std::filesystem::exists(cases.beside(page)), are_there) << page;
    }
  };
  EXPECT_EQ(cases.check({"--report", cases.beside("report")}).exit_code, 0);
  expect_pages(true);
  const std::string good = read_whole(cases / "wall.toml");
  write_whole(cases / "wall.toml", replaced(good, "size", "Size"));
  EXPECT_EQ(cases.check({"--report", cases.beside("report")}).exit_code, 2);
  expect_pages(false);
}

TEST(CheckReport, ThatCannotBeMadeRemovesNoFileOfAPersons) {
  const Cases cases({{"wall", std::string("Size = 1")}});
  const std::string report = cases.beside("report");
  std::filesystem::create_directory(report);
  const std::string mine = "<p>my notes on ghostforce check</p>";
  write_whole(report + "/report.html", mine);
  ASSERT_EQ(mkfifo((report + "/junit.xml").c_str(), 0600), 0);  // nobody writes into it
  EXPECT_EQ(cases.check({"--report", report}).exit_code, 2);
  EXPECT_EQ(read_whole(report + "/report.html"), mine);
  EXPECT_TRUE(std::filesystem::exists(report + "/junit.xml"));
  // Whoever names the folder of the cases means another one.
  write_whole(cases / "report.html", "<title>1 case, 0 failed – ghostforce check</title>");
  EXPECT_EQ(cases.check({"--report", cases.path()}).exit_code, 2);
  EXPECT_TRUE(std::filesystem::exists(cases / "report.html"));
}

TEST(Check, SaysThatAnotherVersionMayBeTheCause) {
  const Cases cases({{"wall", std::string(small_case)}});
  cases.update("wall");
  const std::string text = read_whole(cases / "wall.toml");
  write_whole(cases / "wall.toml",
              "strategy = \"full\"\n" + std::regex_replace(text, std::regex("version = .*"), "version = \"0.0.1\""));
  EXPECT_TRUE(contains(cases.check().err, "the golden was drawn by version 0.0.1, this picture by"));
}

// The case of docs/check.md, whose ghost force the README tells too.
TEST(CheckNumbers, AreTheOnesOfTheScreen) {
  const Cases cases({{"a", naive_with("ghost_force_N = 1.2678\ntolerance = 1e-4")}});
  cases.update("a");
  const Outcome outcome = cases.check();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
}

TEST(CheckNumbers, CanBeEachOfTheCatalog) {
  for (const Quantity& quantity : quantity_catalog()) {
    const Cases cases({{"a", naive_with(fmt::format("{} = 12345", quantity.column))}});
    EXPECT_EQ(cases.check({"--update", "a"}).exit_code, 1) << "the number is wrong still";
    EXPECT_TRUE(contains(cases.check().out, fmt::format("FAIL a  {} is ", quantity.column)));
  }
}

TEST(CheckNumbers, AreReadStrictly) {
  for (const auto& [expected, words] : std::map<std::string, std::string>{
           {"tolerance = 1", "the table [expect] states no number"},
           {"ghost_force = 1", "ghost_force_N"},
           {"force_N = \"1\"", "force_N"},
           {"force_N = nan", "force_N"},
           {"force_N = 1\ntolerance = -1", "-1 is out of range"},
       }) {
    const Outcome outcome = Cases({{"a", naive_with(expected)}}).check();
    EXPECT_EQ(outcome.exit_code, 2) << expected;
    EXPECT_TRUE(contains(outcome.err, words)) << expected;
  }
}

}  // namespace
}  // namespace ghostforce::check_update_test
