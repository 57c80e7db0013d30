// A script in ffmpeg's place, alone on the PATH until the test ends. As it is made, there is none. For tests; the
// process's environment is changed meanwhile.
#pragma once

#include <stdlib.h>
#include <sys/stat.h>

#include <string>

#include "tests/support/temporary_folder.h"

namespace ghostforce {

class FakeFfmpeg {
 public:
  // What it can be. $file is where the video should go.
  static constexpr const char* keeps_what_it_gets = "exec /bin/cat > \"$file\"\n";
  static constexpr const char* fails =
      "echo half > \"$file\"\nfor i in 1 2 3 4 5 6 7 8; do echo \"line $i\" >&2; done\n"
      "echo 'the encoder is broken' >&2\nexit 3\n";
  static constexpr const char* fails_at_the_end =
      "/bin/cat > \"$file\"\nfor i in 1 2 3 4 5 6 7 8; do echo \"line $i\" >&2; done\n"
      "echo 'the encoder is broken' >&2\nexit 3\n";
  static constexpr const char* stops_early = "echo half > \"$file\"\nexit 0\n";
  static constexpr const char* writes_nothing = "exec /bin/cat > /dev/null\n";
  static constexpr const char* never_reads = "exec /bin/sleep 1000\n";
  static constexpr const char* never_ends = "/bin/cat > \"$file\"\nexec /bin/sleep 1000\n";

  FakeFfmpeg() { setenv("PATH", folder_.path().c_str(), 1); }
  FakeFfmpeg(const FakeFfmpeg&) = delete;
  FakeFfmpeg& operator=(const FakeFfmpeg&) = delete;

  void is(const std::string& script) const {
    write_whole(folder_ / "ffmpeg", "#!/bin/sh\nfor word; do echo \"$word\"; file=${word#file:}; done > " +
                                        (folder_ / "arguments") + "\n" + script);
    chmod((folder_ / "ffmpeg").c_str(), 0755);
  }
  // Those of the last call, a line each.
  std::string arguments() const { return read_whole(folder_ / "arguments"); }
  const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
};

}  // namespace ghostforce
