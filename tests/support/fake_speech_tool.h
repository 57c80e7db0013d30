// FakeSpeechTool: a spd-say that writes down how it was called, and stays or ends as it is told.
#pragma once

#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace ghostforce {

class FakeSpeechTool {
 public:
  // What each call does once it is written down, in the language of sh.
  explicit FakeSpeechTool(const std::string& then = "exit 0") : path_(std::getenv("PATH")) {
    behave(then);
    setenv("PATH", (folder_.path() + ":" + path_).c_str(), 1);
  }
  FakeSpeechTool(const FakeSpeechTool&) = delete;
  FakeSpeechTool& operator=(const FakeSpeechTool&) = delete;
  ~FakeSpeechTool() { setenv("PATH", path_.c_str(), 1); }

  void behave(const std::string& then) const {
    write_whole(folder_ / "script",
                "#!/bin/sh\nprintf '%s\\n' \"$*\" >> '" + (folder_ / "calls") + "'\n" + then + "\n");
    chmod((folder_ / "script").c_str(), 0755);
    std::filesystem::rename(folder_ / "script", folder_ / "spd-say");
  }

  // The arguments of each call up to now, with blanks between.
  std::vector<std::string> calls() const {
    std::vector<std::string> lines;
    if (!std::filesystem::exists(folder_ / "calls")) return lines;
    std::istringstream text(read_whole(folder_ / "calls"));
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
  }

 private:
  std::string path_;
  TemporaryFolder folder_;
};

}  // namespace ghostforce
