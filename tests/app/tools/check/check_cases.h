// Folders of cases for the tests of `ghostforce check`, and what it is called with. For tests, any thread.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce {

// Small, so that a picture takes a twentieth of a second.
inline constexpr std::string_view small_case =
    "scene = \"wall45\"\n"
    "size = [320, 240]\n"
    "part = \"scene\"\n";

// A folder of cases, name -> text, which goes with it.
class Cases {
 public:
  explicit Cases(const std::map<std::string, std::string>& texts = {}) {
    std::filesystem::create_directory(path());
    for (const auto& [name, text] : texts) write_whole(*this / (name + ".toml"), text);
  }

  std::string path() const { return folder_ / "cases"; }
  std::string operator/(std::string_view name) const { return (std::filesystem::path(path()) / name).string(); }
  std::string beside(std::string_view name) const { return folder_ / name; }

  Outcome check(const std::vector<std::string>& more = {}) const { return check_with({}, more); }
  Outcome check_with(const std::vector<std::string>& environment, const std::vector<std::string>& more = {}) const {
    ProgramCall call;
    call.words = {"check", path()};
    call.words.insert(call.words.end(), more.begin(), more.end());
    call.environment = environment;
    return run_ghostforce(call);
  }
  void update(const std::string& name) const {
    const Outcome outcome = check({"--update", name});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }

  // Names of what is in the folder, hidden files too.
  std::set<std::string> files() const { return files_in(path()); }
  static std::set<std::string> files_in(const std::string& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      names.insert(entry.path().filename().string());
    }
    return names;
  }

 private:
  TemporaryFolder folder_;
};

inline testing::AssertionResult contains(const std::string& text, std::string_view piece) {
  if (text.find(piece) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "no '" << piece << "' in:\n" << text;
}

inline std::string replaced(std::string text, std::string_view piece, std::string_view by) {
  const std::size_t at = text.find(piece);
  EXPECT_NE(at, std::string::npos) << piece;
  return text.replace(at, piece.size(), by);
}

}  // namespace ghostforce
