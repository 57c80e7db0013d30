#include "app/tools/doctor/udev_rule.h"

#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <sstream>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/base/quoted.h"
#include "app/base/shell_word.h"
#include "app/files/output_file.h"
#include "embedded_udev_rule.h"

namespace ghostforce {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr std::array<std::string_view, 4> folders{udev_rule_folder, "/usr/local/lib/udev/rules.d",
                                                  "/usr/lib/udev/rules.d", "/lib/udev/rules.d"};

// What makes udev read its rules again, and apply them to what is plugged in already.
const std::array<Words, 2> reload{
    Words{"udevadm", "control", "--reload"},
    Words{"udevadm", "trigger", "--subsystem-match=usb", "--subsystem-match=hidraw", "--subsystem-match=tty"},
};

std::string shown(const Words& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

// Administration's programs are not on everybody's PATH. Empty: there is none.
std::string find_program(std::string_view name) {
  const char* const path = std::getenv("PATH");
  std::istringstream places(std::string(path == nullptr ? "" : path) + ":/usr/bin:/bin:/usr/sbin:/sbin");
  for (std::string place; std::getline(places, place, ':');) {
    fs::path program = fs::path(place) / name;
    if (program.is_absolute() && access(program.c_str(), X_OK) == 0) return program.string();
  }
  return {};
}

// Nobody need listen.
void tell(const std::string& words) {
  try {
    OutputFile output("-");
    output.write(words);
    output.commit();
  } catch (const BrokenPipe&) {
  }
}

// Its exit code; -1: it could not be started, or something killed it. Throws Failure(interrupted).
int run_and_wait(const std::string& program, Words words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  if (posix_spawn(&child, program.c_str(), nullptr, nullptr, arguments.data(), environ) != 0) return -1;
  // It may ask for a password on this terminal. Ctrl+C is for it too: it gets a second to put the terminal in order.
  constexpr int glance_ms = 50;
  int glances_left = 20;
  int status = 0;
  pid_t ended = 0;
  while ((ended = waitpid(child, &status, WNOHANG)) == 0 && (!interrupted() || glances_left-- > 0)) {
    poll(nullptr, 0, glance_ms);
  }
  if (ended != child) stop_if_interrupted();
  return ended == child && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void announce(const fs::path& rule) {
  std::string text =
      fmt::format("This will be written to {}, which needs root:\n\n{}\nThese commands then notify udev:\n",
                  rule.string(), udev_rule_text());
  for (const Words& words : reload) text += fmt::format("  {}\n", shown(words));
  tell(text + "\n");
}

// As a person would type it: this program as root.
void install_as_root(const fs::path& rule) {
  std::error_code error;
  const std::string self = fs::read_symlink("/proc/self/exe", error).string();
  const std::string by_hand = fmt::format("sudo {} doctor --install-udev", shell_word(self));
  const bool is_somebody_there = isatty(STDIN_FILENO) != 0 && isatty(STDERR_FILENO) != 0;
  for (const std::string_view asker : {"sudo", "pkexec"}) {
    const std::string program = is_somebody_there && !error ? find_program(asker) : "";
    if (program.empty()) continue;
    const Words words{std::string(asker), self, "doctor", "--install-udev", "--udev-announced"};
    tell(fmt::format("Asking for root: {}\n", shown(words)));
    if (run_and_wait(program, words) == 0) return;
    throw Failure(ExitCode::file_trouble,
                  fmt::format("{} did not write {}; as root, run: {}", asker, rule.string(), by_hand));
  }
  throw Failure(ExitCode::file_trouble, fmt::format("only root may write {}; run: {}", rule.string(), by_hand));
}

void tell_udev() {
  const std::string udevadm = find_program("udevadm");
  if (udevadm.empty()) {
    tell("There is no udevadm here, so udev was not notified. Restart the machine, or plug the devices in again.\n");
    return;
  }
  for (const Words& words : reload) {
    if (run_and_wait(udevadm, words) != 0) tell(fmt::format("'{}' failed. Plug the devices in again.\n", shown(words)));
  }
}

}  // namespace

std::string_view udev_rule_text() noexcept {
  return embedded_udev_rule[0].contents;
}

std::span<const std::string_view> udev_folders() noexcept {
  return folders;
}

fs::path installed_udev_rule(std::span<const std::string_view> places) {
  std::error_code error;
  for (const std::string_view place : places) {
    fs::path rule = fs::path(place) / udev_rule_name;
    if (fs::exists(rule, error)) return rule;
  }
  return {};
}

fs::path write_udev_rule(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw Failure(ExitCode::file_trouble, fmt::format("the folder {} cannot be created: {}",
                                                      quoted_text(folder.string(), longest_path), error.message()));
  }
  const fs::path rule = folder / udev_rule_name;
  OutputFile file(rule.string());
  file.write(udev_rule_text());
  file.commit();
  // Whatever root's umask makes of new files: there is nothing secret in it, and `doctor` of anybody looks for it.
  fs::permissions(rule, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read | fs::perms::others_read,
                  error);
  return rule;
}

void install_udev_rule(bool is_announced) {
  const fs::path folder(udev_rule_folder);
  if (!is_announced) announce(folder / udev_rule_name);
  if (geteuid() != 0) return install_as_root(folder / udev_rule_name);
  tell(fmt::format("Written: {}\n", write_udev_rule(folder).string()));
  tell_udev();
}

}  // namespace ghostforce
