#include "app/files/clipboard_tool.h"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include <fmt/format.h>

#include "app/files/descriptor.h"
#include "app/files/output_file.h"
#include "app/files/tool_process.h"

namespace ghostforce {
namespace {

struct Tool {
  const char* package;
  std::vector<std::string> words;
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
  if (picture.number() < 0 || append_whole(picture.number(), png) != 0 || lseek(picture.number(), 0, SEEK_SET) != 0) {
    return fmt::format("The picture cannot be copied: {}. Save it to a file.", reason(errno));
  }
  const Tool& tool = tool_for(display);
  pid_t child = 0;
  const int error = start_tool(tool.words, {.in = picture.number()}, child);
  if (error == ENOENT) {
    return fmt::format("To copy pictures, install the package {}; without it, save the picture to a file.",
                       tool.package);
  }
  if (error != 0) return fmt::format("{} cannot be started: {}.", tool.words.front(), reason(error));
  children_.push_back(child);
  return {};
}

std::string ClipboardTool::poll() {
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
