// After each test its process is as it was before: the environment, the working directory, and what becomes of SIGPIPE. So
// the next test of the program meets nothing of it, in whichever order they run. Linked into every program of tests.
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

namespace ghostforce {
namespace {

using Environment = std::map<std::string, std::string>;

Environment environment() {
  Environment found;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    const std::size_t sign = text.find('=');
    found.emplace(text.substr(0, sign), sign == std::string::npos ? "" : text.substr(sign + 1));
  }
  return found;
}

class LeavesAsFound : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo&) override {
    environment_ = environment();
    folder_ = std::filesystem::current_path();
    sigaction(SIGPIPE, nullptr, &broken_pipe_);
  }

  void OnTestEnd(const testing::TestInfo&) override {
    for (const auto& [name, value] : environment()) {
      if (!environment_.contains(name)) unsetenv(name.c_str());
    }
    for (const auto& [name, value] : environment_) {
      const char* const now = std::getenv(name.c_str());
      if (now == nullptr || now != value) setenv(name.c_str(), value.c_str(), 1);
    }
    if (std::filesystem::current_path() != folder_) std::filesystem::current_path(folder_);
    sigaction(SIGPIPE, &broken_pipe_, nullptr);
  }

  Environment environment_;
  std::filesystem::path folder_;
  struct sigaction broken_pipe_ {};
};

// GoogleTest owns it.
[[maybe_unused]] const bool is_listening =
    (testing::UnitTest::GetInstance()->listeners().Append(new LeavesAsFound), true);

}  // namespace
}  // namespace ghostforce
