#include "app/shell/desktop/renderer_examination.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <exception>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/base/interruption.h"
#include "app/files/descriptor.h"
#include "app/shell/desktop/opengl_window.h"
#include "app/shell/window.h"

namespace ghostforce {
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
