#include "app/files/clipboard_tool.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace ghostforce {
namespace {

struct Descriptor {
  explicit Descriptor(int number) noexcept : number(number) {}
  ~Descriptor() {
    if (number >= 0) close(number);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  const int number;
};

bool write_all(int descriptor, std::string_view bytes) noexcept {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return lseek(descriptor, 0, SEEK_SET) == 0;
}

// The tool as it would be started by hand: with the picture to read, no other file of ours (a device that is open would
// stay taken), nothing on the terminal, and every signal.
class Start {
 public:
  explicit Start(int input) {
    posix_spawn_file_actions_init(&files_);
    posix_spawn_file_actions_adddup2(&files_, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&files_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addclosefrom_np(&files_, STDERR_FILENO + 1);
    posix_spawnattr_init(&attributes_);
    sigset_t signals;
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes_, &signals);
    sigfillset(&signals);
    posix_spawnattr_setsigdefault(&attributes_, &signals);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~Start() {
    posix_spawn_file_actions_destroy(&files_);
    posix_spawnattr_destroy(&attributes_);
  }
  Start(const Start&) = delete;
  Start& operator=(const Start&) = delete;

  // 0, or the number of an error.
  int run(const std::vector<const char*>& words, pid_t& child) const {
    std::vector<char*> arguments;
    for (const char* const word : words) arguments.push_back(const_cast<char*>(word));  // only read
    arguments.push_back(nullptr);
    return posix_spawnp(&child, arguments.front(), &files_, &attributes_, arguments.data(), environ);
  }

 private:
  posix_spawn_file_actions_t files_;
  posix_spawnattr_t attributes_;
};

struct Tool {
  const char* package;
  std::vector<const char*> words;
};

const Tool& tool_for(DisplayKind display) {
  static const Tool wayland{"wl-clipboard", {"wl-copy", "--type", "image/png"}};
  static const Tool x11{"xclip", {"xclip", "-selection", "clipboard", "-t", "image/png", "-i"}};
  return display == DisplayKind::wayland ? wayland : x11;
}

std::string reason(int error) {
  return std::generic_category().message(error);
}

}  // namespace

std::string ClipboardTool::copy_png(std::string_view png, DisplayKind display) {
  if (display == DisplayKind::none) return "There is no desktop to copy a picture to.";
  const Descriptor picture(memfd_create("picture", MFD_CLOEXEC));
  if (picture.number < 0 || !write_all(picture.number, png)) {
    return fmt::format("The picture cannot be copied: {}. Save it to a file.", reason(errno));
  }
  const Tool& tool = tool_for(display);
  pid_t child = 0;
  const int error = Start(picture.number).run(tool.words, child);
  if (error == ENOENT) {
    return fmt::format("To copy pictures, install the package {}; without it, save the picture to a file.",
                       tool.package);
  }
  if (error != 0) return fmt::format("{} cannot be started: {}.", tool.words.front(), reason(error));
  children_.push_back(child);
  return {};
}

std::string ClipboardTool::look() {
  std::string problem;
  std::erase_if(children_, [&problem](pid_t child) {
    int status = 0;
    const pid_t ended = waitpid(child, &status, WNOHANG);
    if (ended == 0) return false;
    if (ended == child && (!WIFEXITED(status) || WEXITSTATUS(status) != 0)) {
      problem = "The clipboard has not taken the picture. Save it to a file.";
    }
    return true;
  });
  return problem;
}

}  // namespace ghostforce
