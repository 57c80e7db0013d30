// How long until there is something to see, against the least program that shows anything by the same means.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "bench/support/child.h"
#include "bench/support/contest.h"
#include "bench/support/report.h"
#include "tests/support/display.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::bench {
namespace {

constexpr int width = 1280;
constexpr int height = 800;

// The display server's memory, looked at without asking it: black where there is no window. A frame comes there as a
// whole, by one request.
class Glass {
 public:
  explicit Glass(const std::string& path) {
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) throw std::runtime_error("the display's memory is not there");
    struct stat known {};
    fstat(file, &known);
    size_ = static_cast<std::size_t>(known.st_size);
    void* const memory = mmap(nullptr, size_, PROT_READ, MAP_SHARED, file, 0);
    close(file);
    if (memory == MAP_FAILED) throw std::runtime_error("the display's memory cannot be read");
    bytes_ = static_cast<const volatile std::uint8_t*>(memory);
  }
  Glass(const Glass&) = delete;
  Glass& operator=(const Glass&) = delete;
  ~Glass() { munmap(const_cast<std::uint8_t*>(bytes_), size_); }

  bool is_lit_everywhere() const { return count_lit() == spots.size(); }
  bool is_dark() const { return count_lit() == 0; }

 private:
  // One in each corner.
  static constexpr std::array<std::pair<int, int>, 4> spots{
      {{4, 4}, {width - 5, 4}, {4, height - 5}, {width - 5, height - 5}}};

  std::size_t count_lit() const {
    // As Display::picture() reads it: a header of big-endian words, a colour table, then rows of four bytes a pixel.
    const std::size_t pixels = word(0) + 12U * word(19);
    std::size_t lit = 0;
    for (const auto& [x, y] : spots) {
      const std::size_t at = pixels + static_cast<std::size_t>(y) * word(12) + 4U * static_cast<std::size_t>(x);
      if ((bytes_[at] | bytes_[at + 1] | bytes_[at + 2]) != 0) ++lit;
    }
    return lit;
  }
  std::size_t word(std::size_t number) const {
    std::size_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | bytes_[4 * number + i];
    return value;
  }

  const volatile std::uint8_t* bytes_;
  std::size_t size_;
};

template <typename Condition>
void wait_for(Condition&& condition) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > until) throw std::runtime_error("the display does not change");
    std::this_thread::sleep_for(std::chrono::microseconds(500));
  }
}

// From the start of the program until its frame is on the glass; its end is not counted.
double seconds_to_picture(const std::vector<std::string>& words, const Display& display, const Glass& glass) {
  wait_for([&] { return glass.is_dark(); });
  const auto began = std::chrono::steady_clock::now();
  BackgroundProgram program(words, display.environment());
  wait_for([&] { return glass.is_lit_everywhere(); });
  const double taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return taken;
}

void add_window(Report& report) {
  const Display display(width, height);
  const Glass glass(display.memory_file());
  std::vector<double> ours, least, ratios;
  const auto start_both = [&] {
    const double one = seconds_to_picture({GHOSTFORCE_PROGRAM, "run", "--no-hints"}, display, glass);
    const double other = seconds_to_picture({MINIMAL_WINDOW}, display, glass);
    return std::pair(one, other);
  };
  start_both();  // warms the machine's memory of files
  for (int round = 0; round < 15; ++round) {
    const auto [one, other] = start_both();
    ours.push_back(one);
    least.push_back(other);
    ratios.push_back(one / other);
  }
  report.row("`ghostforce run`, exec to the first frame on the screen", fmt::format("{:.0f} ms", 1e3 * median(ours)));
  report.row("a minimal GLFW and ImGui program, the same", fmt::format("{:.0f} ms", 1e3 * median(least)));
  const double ratio = median(ratios);
  report.row("`ghostforce run` against it", fmt::format("{:.2f}", ratio), at_most(ratio, 1.3));
  report.note(
      "Where the processor's time of `run` goes, seen by time stamps, 130 ms in all: 6 ms until main (30 shared "
      "libraries; Cairo's 1.6 and OpenSSL's 1.0 of it), 75 for the display and its context, 6 to compile its shader "
      "(ImGui's, which comes after it, takes 0.6), 2 to play the scene, 8 and 8 for the first use of its shader and of "
      "ImGui's, 20 to draw 1280×800 pixels; widgets and marks take 1. Mesa keeps compiled shaders in a cache; without "
      "it, as at the first start ever, those 8 and 8 are 51 and 43. Between runs on a shared machine the ratio was "
      "seen from 1.2 to 1.6.");
}

void add_offscreen(Report& report) {
  const TemporaryFolder folder;
  const auto program = [](std::string name, std::vector<std::string> words) {
    return Contestant{std::move(name), [words](std::int64_t calls) {
                        for (std::int64_t i = 0; i < calls; ++i) {
                          if (run_to_end(words) != 0) throw std::runtime_error(words[0] + " fails");
                        }
                      }};
  };
  const auto render = [&](const std::string& renderer) {
    return program(renderer,
                   {GHOSTFORCE_PROGRAM, "render", "wall45", "--renderer", renderer, "-o", folder / "picture.png"});
  };
  const Contest contest({render("egl"), render("osmesa"), program("empty", {MINIMAL_OFFSCREEN})},
                        {.rounds = 15, .seconds_per_turn = 0.1});
  report.row("`ghostforce render wall45 -o F.png`, by EGL, to its end",
             fmt::format("{:.0f} ms", 1e3 * contest.median_seconds("egl")));
  report.row("the same by OSMesa", fmt::format("{:.0f} ms", 1e3 * contest.median_seconds("osmesa")));
  report.row("an empty OSMesa start, read once", fmt::format("{:.0f} ms", 1e3 * contest.median_seconds("empty")));
  const double ratio = contest.ratio("egl", "empty");
  report.row("`render` by EGL against it", fmt::format("{:.2f}", ratio), at_most(ratio, 2.0));
  report.note(
      "`render` was 4.4 times the empty start before its first two frames, which only settle the panels, left the "
      "pixels alone, and before libpng wrote its file. What some 100 ms of processor's time held by OSMesa: 5 "
      "until main, 2 to play the scene, 30 for the context, 2 for ImGui and its fonts, 6 to compile its shader, 7 and "
      "4 for the first use of its shader and of ImGui's (from Mesa's cache; 51 and 43 without), 3 for the frame that "
      "is seen, 17 to draw its pixels, 7 for the PNG file, 5 to let go of the context. Tried and not kept: zlib's "
      "level 1 instead of 3 (0.5 ms), other thresholds of malloc (nothing), less arithmetic for arrows in the shader "
      "(1 ms, and single pixels of pictures change).");
}

}  // namespace

int run(int argc, char** argv) {
  Report report("5. Start");
  report.paragraph(
      "A window of 1280×800 under Xvfb, drawn in software. The first frame is there when all four corners of the "
      "display server's own memory, which is looked at twice a millisecond, are no longer black: the program is the "
      "one that people start, without any help in it.");
  add_window(report);
  add_offscreen(report);
  return report.finish(argc, argv);
}

}  // namespace ghostforce::bench
