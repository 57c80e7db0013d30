#include "app/shell/desktop/renderer.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "app/base/interruption.h"
#include "app/base/words.h"
#include "app/files/descriptor.h"
#include "app/shell/desktop/opengl_window.h"
#include "app/shell/window.h"

namespace ghostforce {
namespace {

constexpr std::array renderers{
    RendererEntry{Renderer::egl, "egl", "Mesa's software renderer, by EGL",
                  "install Debian's packages libegl1 and libgl1-mesa-dri", true},
    RendererEntry{Renderer::osmesa, "osmesa", "Mesa's software renderer, by OSMesa",
                  "install Debian's package libosmesa6", true},
    RendererEntry{
        Renderer::gpu, "gpu", "the graphics card, by EGL: fast, but its pixels differ from machine to machine",
        "install the graphics card's driver and Debian's package libegl1, or leave out --renderer gpu", false},
};

}  // namespace

std::span<const RendererEntry> renderer_catalog() noexcept {
  return renderers;
}

const RendererEntry& entry_of(Renderer renderer) noexcept {
  return renderers[static_cast<std::size_t>(renderer)];
}

std::optional<Renderer> find_renderer(std::string_view name) noexcept {
  const auto found = std::ranges::find(renderers, name, &RendererEntry::name);
  return found == renderers.end() ? std::nullopt : std::optional(found->renderer);
}

namespace {

// Those that change what Mesa draws. Some of its beginnings are short enough for strangers' variables: of these the
// whole names.
constexpr std::array<std::string_view, 8> begins{"EGL_", "GALLIUM_", "GALLIVM_",  "LIBGL_",
                                                 "LP_",  "MESA_",    "SOFTPIPE_", "TGSI_"};
constexpr std::array<std::string_view, 5> names_of_mesa{"DRAW_FSE", "DRAW_NO_FSE", "DRAW_USE_LLVM", "NIR_DEBUG",
                                                        "ST_DEBUG"};

// These change no picture: how many threads draw, and where compiled shaders are kept.
constexpr std::array<std::string_view, 2> harmless{"LP_NUM_THREADS", "MESA_SHADER_CACHE_"};

bool is_for_mesa(std::string_view name) {
  const auto begins_name = [name](std::string_view begin) { return name.starts_with(begin); };
  return std::ranges::count(names_of_mesa, name) != 0 ||
         (std::ranges::any_of(begins, begins_name) && std::ranges::none_of(harmless, begins_name));
}

}  // namespace

void choose_offscreen_driver() {
  std::vector<std::string> names;
  for (char** variable = environ; variable != nullptr && *variable != nullptr; ++variable) {
    const std::string_view text = *variable;
    if (const std::string_view name = text.substr(0, text.find('=')); is_for_mesa(name)) names.emplace_back(name);
  }
  if (names.empty()) return;
  for (const std::string& name : names) unsetenv(name.c_str());
  std::ranges::sort(names);
  say("Drawing offscreen with Mesa's own software renderer, so {} {} ignored.\n", fmt::join(names, ", "),
      names.size() == 1 ? "is" : "are");
}

namespace {

constexpr unsigned int longest_trial_s = 20;

constexpr char is_there_mark = '+';
constexpr char is_absent_mark = '-';

// A mark, then words.
std::string tried(Renderer renderer) {
  try {
    const OpenGlWindow window({.title = "", .width = 64, .height = 64, .offscreen = true}, renderer);
    return is_there_mark + Window::graphics_description();
  } catch (const std::exception& failure) {
    return std::string(1, is_absent_mark) + failure.what();
  }
}

// What drivers print is nobody's concern here.
[[noreturn]] void try_as_child(Renderer renderer, int out) {
  alarm(longest_trial_s);
  if (const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0) {
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
  }
  const std::string words = tried(renderer);
  const ssize_t written = write(out, words.data(), words.size());  // a pipe takes that much at once
  _exit(written == static_cast<ssize_t>(words.size()) ? 0 : 1);
}

std::string read_to_end(int in) {
  std::string text;
  std::array<char, 4096> piece{};
  for (;;) {
    wait_to_read(in);
    const ssize_t count = read(in, piece.data(), piece.size());
    if (count > 0) text.append(piece.data(), static_cast<std::size_t>(count));
    if (count == 0 || (count < 0 && errno != EINTR)) return text;
  }
}

// It has said everything, or nobody waits for it any more.
struct EndOfChild {
  pid_t child;
  ~EndOfChild() {
    kill(child, SIGKILL);
    while (waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
};

RendererFinding examine(Renderer renderer) {
  RendererFinding finding{.renderer = renderer, .words = "this system lets the program start no other process"};
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return finding;
  const Descriptor read_end(ends[0]);
  const pid_t child = fork();
  if (child == 0) try_as_child(renderer, ends[1]);
  close(ends[1]);
  if (child < 0) return finding;
  const EndOfChild end{child};
  const std::string answer = read_to_end(read_end.number());
  finding.is_there = answer.starts_with(is_there_mark);
  finding.words = answer.empty() ? "its driver crashes or hangs" : answer.substr(1);
  return finding;
}

}  // namespace

std::vector<RendererFinding> examine_renderers() {
  std::vector<RendererFinding> findings;
  for (const RendererEntry& entry : renderer_catalog()) findings.push_back(examine(entry.renderer));
  const auto chosen = std::ranges::find_if(findings, [](const RendererFinding& finding) {
    return finding.is_there && entry_of(finding.renderer).is_tried_unasked;
  });
  if (chosen != findings.end()) chosen->is_default = true;
  return findings;
}

std::string default_renderer_words() {
  std::vector<std::string> problems;
  for (const RendererEntry& entry : renderer_catalog()) {
    if (!entry.is_tried_unasked) continue;
    const RendererFinding finding = examine(entry.renderer);
    if (finding.is_there) return fmt::format("{}, by {}", finding.words, entry.name);
    problems.push_back(fmt::format("{}: {}", entry.name, finding.words));
  }
  return fmt::format("none; {}", fmt::join(problems, "; "));
}

}  // namespace ghostforce
