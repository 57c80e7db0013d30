#include "app/shell/desktop/wayland_clipboard.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

#include <fmt/format.h>

#include "app/files/descriptor.h"
#include "app/files/output_file.h"
#include "app/files/tool_process.h"
#include "device/input/monotonic_clock.h"

namespace ghostforce {
namespace {

// A tool that is ended with its reader, whatever it is waiting for.
class ReadTool {
 public:
  explicit ReadTool(pid_t process) : process_(process) {}
  ReadTool(const ReadTool&) = delete;
  ReadTool& operator=(const ReadTool&) = delete;
  ~ReadTool() {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }

 private:
  pid_t process_;
};

[[noreturn]] void throw_tool_cannot_be_started(int error) {
  const std::string what_to_do =
      error == ENOENT ? "Install the package wl-clipboard" : std::generic_category().message(error);
  throw Failure(ExitCode::file_trouble, fmt::format("wl-paste, which pastes text, cannot be started. {}.", what_to_do));
}

std::string read_within_limits(int pipe, std::int64_t patience_ns) {
  const std::int64_t end_ns = monotonic_ns() + patience_ns;
  std::string text;
  for (;;) {
    const std::int64_t left_ms = (end_ns - monotonic_ns()) / 1'000'000;
    pollfd waits{pipe, POLLIN, 0};
    if (left_ms <= 0) throw_clipboard_is_silent();
    if (::poll(&waits, 1, static_cast<int>(left_ms)) <= 0) continue;
    std::array<char, 4096> bytes;
    const ssize_t count = read(pipe, bytes.data(), bytes.size());
    if (count == 0) return text;
    if (count < 0) {
      if (errno == EINTR || errno == EAGAIN) continue;
      throw_clipboard_is_silent();
    }
    text.append(bytes.data(), static_cast<std::size_t>(count));
    if (text.size() > most_clipboard_bytes) throw_clipboard_is_too_long();
  }
}

}  // namespace

bool WaylandClipboard::copy(const std::string& text) {
  const Descriptor file(memfd_create("text", MFD_CLOEXEC));
  if (file.number() < 0 || append_whole(file.number(), text) != 0 || lseek(file.number(), 0, SEEK_SET) != 0) {
    return false;
  }
  pid_t process = 0;
  if (start_tool({"wl-copy", "--type", "text/plain"}, {.in = file.number()}, process) != 0) return false;
  copies_.push_back(process);
  return true;
}

std::string WaylandClipboard::text(std::int64_t patience_ns) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw_tool_cannot_be_started(errno);
  const Descriptor reading(ends[0]);
  pid_t process = 0;
  {
    const Descriptor writing(ends[1]);
    const std::vector<std::string> words{"wl-paste", "--no-newline", "--type", "text/plain"};
    const int error = start_tool(words, {.out = writing.number()}, process);
    if (error != 0) throw_tool_cannot_be_started(error);
  }
  const ReadTool tool(process);
  return read_within_limits(reading.number(), patience_ns);
}

void WaylandClipboard::poll() {
  std::erase_if(copies_, [](pid_t process) { return waitpid(process, nullptr, WNOHANG) != 0; });
}

}  // namespace ghostforce
