#include "tests/support/display.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <thread>

extern char** environ;

namespace ghostforce {
namespace {

// Machines that run tests may be slow and busy; a good run never waits that long.
constexpr std::chrono::seconds patience{60};

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> result;
  for (std::string& word : words) result.push_back(word.data());
  result.push_back(nullptr);
  return result;
}

int exit_code_of(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::uint32_t big_endian(const std::string& bytes, std::size_t word) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint8_t>(bytes.at(4 * word + i));
  return value;
}

}  // namespace

BackgroundProgram::BackgroundProgram(std::vector<std::string> words, std::vector<std::string> environment, int pipe) {
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string inherited = *variable;
    if (!inherited.starts_with("DISPLAY=") && !inherited.starts_with("WAYLAND_DISPLAY="))
      environment.push_back(inherited);
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (pipe >= 3) posix_spawn_file_actions_adddup2(&actions, pipe, 3);
  const int error =
      posix_spawnp(&pid_, words[0].c_str(), &actions, nullptr, pointers(words).data(), pointers(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::runtime_error(words[0] + " does not start; ./check installs what the tests need");
}

BackgroundProgram::~BackgroundProgram() {
  if (pid_ > 0) end(SIGKILL);
}

bool BackgroundProgram::is_running() {
  int status = 0;
  if (pid_ <= 0 || waitpid(pid_, &status, WNOHANG) == 0) return pid_ > 0;
  exit_code_ = exit_code_of(status);
  pid_ = -1;
  return false;
}

int BackgroundProgram::end(int signal) {
  if (is_running()) {
    kill(pid_, signal);
    int status = 0;
    waitpid(pid_, &status, 0);
    exit_code_ = exit_code_of(status);
    pid_ = -1;
  }
  return exit_code_;
}

namespace {

// As a desktop does it: in the property that toolkits read, with libX11 as the program itself opens it.
void tell_density(const std::string& display_name, int dots_per_inch) {
  const std::unique_ptr<void, int (*)(void*)> library(dlopen("libX11.so.6", RTLD_NOW), dlclose);
  if (!library) throw std::runtime_error("no libX11");
  using Atom = unsigned long;
  const auto open_display = reinterpret_cast<void* (*)(const char*)>(dlsym(library.get(), "XOpenDisplay"));
  const auto close_display = reinterpret_cast<int (*)(void*)>(dlsym(library.get(), "XCloseDisplay"));
  const auto root_window = reinterpret_cast<unsigned long (*)(void*)>(dlsym(library.get(), "XDefaultRootWindow"));
  const auto change_property =
      reinterpret_cast<int (*)(void*, unsigned long, Atom, Atom, int, int, const unsigned char*, int)>(
          dlsym(library.get(), "XChangeProperty"));
  void* const display = open_display(display_name.c_str());
  if (display == nullptr) throw std::runtime_error("the display cannot be opened");
  constexpr Atom resource_manager = 23;  // predefined, as is the type: X11/Xatom.h
  constexpr Atom string = 31;
  const std::string text = "Xft.dpi:\t" + std::to_string(dots_per_inch) + "\n";
  change_property(display, root_window(display), resource_manager, string, 8, 0,
                  reinterpret_cast<const unsigned char*>(text.data()), static_cast<int>(text.size()));
  close_display(display);
}

}  // namespace

Display::Display(int width, int height, int dots_per_inch) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  const std::string size = std::to_string(width) + "x" + std::to_string(height) + "x24";
  // The server looks for a free display number itself and tells it through the pipe, so that tests may run side by
  // side.
  server_ = std::make_unique<BackgroundProgram>(
      std::vector<std::string>{"Xvfb", "-displayfd", "3", "-screen", "0", size, "-fbdir", folder_.path(), "-nolisten",
                               "tcp", "-noreset"},
      std::vector<std::string>{}, ends[1]);
  close(ends[1]);
  // To the end of the line: closing early would break the server's second write.
  std::string line;
  pollfd waiting{ends[0], POLLIN, 0};
  char letter = '\0';
  while (letter != '\n' && poll(&waiting, 1, static_cast<int>(std::chrono::milliseconds(patience).count())) == 1 &&
         read(ends[0], &letter, 1) == 1) {
    line += letter;
  }
  close(ends[0]);
  if (letter != '\n') throw std::runtime_error("Xvfb does not come up");
  name_ += std::to_string(std::stoi(line));
  if (dots_per_inch != 96) tell_density(name_, dots_per_inch);
}

Image Display::picture() const {
  // The format of xwd: a header of big-endian words, a colour table, then rows of four bytes a pixel.
  const std::string file = read_whole(memory_file());
  const std::uint32_t header = big_endian(file, 0);
  const std::uint32_t row = big_endian(file, 12);
  const std::size_t pixels = header + 12U * big_endian(file, 19);
  Image image{static_cast<int>(big_endian(file, 4)), static_cast<int>(big_endian(file, 5)), {}};
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(image.width); ++x) {
      for (const std::size_t channel : {2U, 1U, 0U}) {
        image.rgb.push_back(static_cast<std::uint8_t>(file.at(pixels + y * row + 4 * x + channel)));
      }
    }
  }
  return image;
}

void Display::act(const std::vector<std::string>& words) const {
  std::vector<std::string> call{"xdotool"};
  call.insert(call.end(), words.begin(), words.end());
  BackgroundProgram hands(call, {environment()});
  if (hands.end(0) != 0) throw std::runtime_error("xdotool did not do what it was told");
}

bool Display::becomes(const std::function<bool(const Image&)>& as_wanted) const {
  const auto until = std::chrono::steady_clock::now() + patience;
  while (std::chrono::steady_clock::now() < until) {
    if (as_wanted(picture())) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
  }
  return false;
}

}  // namespace ghostforce
