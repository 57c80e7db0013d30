#include "app/files/tool_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <unistd.h>

namespace ghostforce {
namespace {

class ToolStart {
 public:
  explicit ToolStart(const ToolStreams& streams) {
    posix_spawn_file_actions_init(&files_);
    posix_spawn_file_actions_adddup2(&files_, streams.in, STDIN_FILENO);
    send_to(streams.out, STDOUT_FILENO);
    send_to(streams.err, STDERR_FILENO);
    posix_spawn_file_actions_addclosefrom_np(&files_, STDERR_FILENO + 1);
    posix_spawnattr_init(&attributes_);
    sigset_t signals;
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes_, &signals);
    sigfillset(&signals);
    posix_spawnattr_setsigdefault(&attributes_, &signals);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~ToolStart() {
    posix_spawn_file_actions_destroy(&files_);
    posix_spawnattr_destroy(&attributes_);
  }
  ToolStart(const ToolStart&) = delete;
  ToolStart& operator=(const ToolStart&) = delete;

  int run(const std::vector<std::string>& words, pid_t& child) const {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));  // only read
    arguments.push_back(nullptr);
    return posix_spawnp(&child, arguments.front(), &files_, &attributes_, arguments.data(), environ);
  }

 private:
  void send_to(int descriptor, int stream) {
    if (descriptor >= 0) {
      posix_spawn_file_actions_adddup2(&files_, descriptor, stream);
    } else {
      posix_spawn_file_actions_addopen(&files_, stream, "/dev/null", O_WRONLY, 0);
    }
  }

  posix_spawn_file_actions_t files_;
  posix_spawnattr_t attributes_;
};

}  // namespace

int start_tool(const std::vector<std::string>& words, const ToolStreams& streams, pid_t& child) {
  return ToolStart(streams).run(words, child);
}

}  // namespace ghostforce
