// docs/check.md is followed by people who have nothing but the installed program: its first steps, its job for a
// runner and its JSON are tried with that, as they are written.
#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/tools/check/check_cases.h"
#include "tests/support/places.h"

namespace ghostforce::check_doc_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// What stands in each ``` of that kind.
std::vector<std::string> blocks(std::string_view kind) {
  const std::string doc = read_whole(source_path("/docs/check.md"));
  const std::string fence = fmt::format("\n```{}\n", kind);
  std::vector<std::string> found;
  for (std::size_t at = doc.find(fence); at != std::string::npos; at = doc.find(fence, at + 1)) {
    const std::size_t begin = at + fence.size();
    found.push_back(doc.substr(begin, doc.find("\n```", begin) + 1 - begin));
  }
  return found;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

std::vector<std::string> lines_beginning(const std::vector<std::string>& lines, std::string_view word) {
  std::vector<std::string> found;
  std::ranges::copy_if(lines, std::back_inserter(found),
                       [&](const std::string& line) { return line.starts_with(word); });
  return found;
}

// The items of the list `script` in the job, which is all of YAML that the example uses.
std::vector<std::string> script_of(const std::string& yaml) {
  constexpr std::string_view item = "    - ";
  std::vector<std::string> script;
  bool is_script = false;
  for (const std::string& line : lines_of(yaml)) {
    if (!line.starts_with(item)) {
      is_script = line == "  script:";
    } else if (is_script) {
      script.push_back(line.substr(item.size()));
    }
  }
  return script;
}

class CheckDoc : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    installed_ = new TemporaryFolder;
    const Outcome outcome =
        run_program(GHOSTFORCE_CMAKE, {"--install", GHOSTFORCE_BUILD_DIR, "--prefix", installed_->path()});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  static void TearDownTestSuite() {
    delete installed_;
    installed_ = nullptr;
  }

  void SetUp() override {
    ASSERT_GE(blocks("bash").size(), 2U);
    EXPECT_EQ(run(blocks("bash")[0]).exit_code, 0) << "the cases";
  }

  // As a person in an empty folder would.
  Outcome run(const std::string& script) const {
    ProgramCall call;
    call.words = {"-euc", script};
    call.folder = folder_.path();
    call.environment = {fmt::format("PATH={}:/usr/bin:/bin", *installed_ / "bin")};
    return run_program("/bin/bash", call);
  }

  // The first steps to the golden; returns what the check then says.
  Outcome store_golden() const {
    const std::vector<std::string> commands = lines_beginning(lines_of(blocks("bash")[1]), "ghostforce ");
    EXPECT_EQ(commands.size(), 2U);
    EXPECT_EQ(run(commands.front()).exit_code, 0);
    return run(commands.back());
  }

  void change_picture() const {
    const std::string path = folder_ / "pictures/wall45-naive.toml";
    write_whole(path, replaced(read_whole(path), "strategy = \"naive\"", "strategy = \"full\""));
  }

  TemporaryFolder folder_;

 private:
  static TemporaryFolder* installed_;
};
TemporaryFolder* CheckDoc::installed_ = nullptr;

TEST_F(CheckDoc, LeadsFromNothingToTheFirstCheck) {
  const Outcome outcome = store_golden();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(contains(read_whole(source_path("/docs/check.md")), "```\n" + outcome.out + "```\n"));
}

TEST_F(CheckDoc, HasAJobThatRunsAsItIsWritten) {
  ASSERT_EQ(blocks("yaml").size(), 1U);
  const std::string yaml = blocks("yaml").front();
  const std::vector<std::string> script = script_of(yaml);
  // What comes before is tried in a Debian of its own: tests/package/check_example_in_root.sh.
  EXPECT_EQ(std::vector(script.begin(), script.end() - 1),
            (std::vector<std::string>{"apt-get update", "apt-get install -y ./ghostforce_*.deb"}));
  ASSERT_TRUE(script.back().starts_with("ghostforce check pictures"));
  EXPECT_TRUE(contains(yaml, "\n      junit: report/junit.xml\n"));
  EXPECT_TRUE(contains(yaml, "\n    paths: [report]\n"));

  store_golden();
  const Outcome passes = run(script.back());
  EXPECT_EQ(passes.exit_code, 0) << passes.err;
  EXPECT_TRUE(contains(read_whole(folder_ / "report/junit.xml"), "tests=\"2\" failures=\"0\""));
  change_picture();
  EXPECT_EQ(run(script.back()).exit_code, 1);
  EXPECT_TRUE(contains(read_whole(folder_ / "report/junit.xml"), "tests=\"2\" failures=\"1\""));
  EXPECT_TRUE(fs::exists(folder_ / "report/wall45-naive.diff.png"));
}

// The same keys in the same order, and values of the same type; lists of numbers are as long.
void expect_same_shape(const Json& documented, const Json& printed, const std::string& where) {
  ASSERT_STREQ(documented.type_name(), printed.type_name()) << where;
  ASSERT_EQ(documented.size(), printed.size()) << where;
  if (!documented.is_structured()) return;
  auto other = printed.begin();
  for (const auto& [key, value] : documented.items()) {
    if (documented.is_object()) {
      ASSERT_EQ(key, other.key()) << where;
    }
    expect_same_shape(value, *other, where + "/" + key);
    ++other;
  }
}

TEST_F(CheckDoc, ShowsTheJsonThatIsPrinted) {
  ASSERT_EQ(blocks("json").size(), 1U);
  const Json documented = Json::parse(blocks("json").front());
  store_golden();
  change_picture();
  const Outcome outcome = run("ghostforce check pictures --report report --json");
  EXPECT_EQ(outcome.exit_code, 1);
  expect_same_shape(documented, Json::parse(outcome.out), "");
  const std::string doc = read_whole(source_path("/docs/check.md"));
  const auto expect_explained = [&](const auto& self, const Json& json) -> void {
    for (const auto& [key, value] : json.items()) {
      if (json.is_object()) {
        EXPECT_TRUE(contains(doc, fmt::format("`{}`", key)));
      }
      if (value.is_structured()) self(self, value);
    }
  };
  expect_explained(expect_explained, documented);
}

}  // namespace
}  // namespace ghostforce::check_doc_test
