// What it costs to hold a picture against its golden, against the tools that people otherwise use; and how long a whole
// suite takes.
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "app/files/png_writer.h"
#include "app/files/scene_file.h"
#include "app/shell/desktop/offscreen.h"
#include "app/tools/check/comparison.h"
#include "bench/support/child.h"
#include "bench/support/contest.h"
#include "bench/support/report.h"
#include "tests/support/read_png.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::bench {
namespace {

Image picture_of(StrategyId active) {
  PictureRequest request{.scene = load_scene("wall45"), .at_s = {}};
  request.scene.settings.active = active;
  request.width = 1280;
  request.height = 720;
  return draw_moment(request, simulate_to_moment(request)).image;
}

void write(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

// `answer`: its exit code.
Contestant program(std::string name, std::vector<std::string> words, int answer) {
  return {std::move(name), [words = std::move(words), answer](std::int64_t calls) {
            for (std::int64_t i = 0; i < calls; ++i) {
              if (run_to_end(words) != answer) throw std::runtime_error(words[0] + " says something else");
            }
          }};
}

void add_comparisons(Report& report) {
  const TemporaryFolder folder;
  const std::string golden_path = folder / "golden.png";
  const Image golden = picture_of(StrategyId::naive);
  write(golden_path, png_bytes(golden));
  const char* const odiff = std::getenv("ODIFF");
  for (const bool is_equal : {true, false}) {
    const std::string what = is_equal ? "equal" : "differing";
    const Image actual = is_equal ? golden : picture_of(StrategyId::anisotropic);
    const std::string actual_path = folder / "actual.png";
    write(actual_path, png_bytes(actual));
    const Contestant ours{"here", [&](std::int64_t calls) {
                            for (std::int64_t i = 0; i < calls; ++i) {
                              const Comparison comparison = compare_pictures(read_png(golden_path), actual, {});
                              if ((comparison.over == 0) != is_equal) throw std::logic_error("wrong verdict");
                            }
                          }};
    std::vector<Contestant> contestants{
        ours, program("compare", {"compare", "-metric", "AE", golden_path, actual_path, "null:"}, is_equal ? 0 : 1)};
    if (odiff != nullptr)
      contestants.push_back(
          program("odiff", {odiff, golden_path, actual_path}, is_equal ? 0 : 22));  // its word for pixels
    const Contest contest(std::move(contestants), {.rounds = 25, .seconds_per_turn = 0.05});
    const auto milliseconds = [&](std::string_view name) {
      return fmt::format("{:.1f} ms", 1e3 * contest.median_seconds(name));
    };
    report.row(fmt::format("golden read and compared in process, {}", what), milliseconds("here"));
    report.row(fmt::format("`odiff`, {}", what),
               odiff != nullptr ? milliseconds("odiff") : "not measured: npm install odiff-bin");
    report.row(fmt::format("ImageMagick's `compare`, {}", what), milliseconds("compare"));
    if (odiff != nullptr) {
      const double to_odiff = contest.ratio("here", "odiff");
      report.row(fmt::format("in process against `odiff`, {}", what), fmt::format("{:.2f}", to_odiff),
                 at_most(to_odiff, 1.0));
    }
    const double to_compare = contest.ratio("here", "compare");
    report.row(fmt::format("in process against `compare`, {}", what), fmt::format("{:.3f}", to_compare),
               at_most(to_compare, 0.16));
  }
}

// As the program's own stored pictures are: scenes, strategies and angles, at 640 × 480, and one window in ten.
void add_suite(Report& report) {
  constexpr int count = 100;
  const TemporaryFolder folder;
  const std::vector<std::string_view> scenes = shipped_scene_names();
  std::vector<std::string> update{GHOSTFORCE_PROGRAM, "check", folder.path(), "--update"};
  for (int i = 0; i < count; ++i) {
    const bool is_window = i % 10 == 0;
    const std::string name = fmt::format("case-{:02}", i);
    write(
        folder / (name + ".toml"),
        fmt::format("scene = \"{}\"\nsize = [{}]\npart = \"{}\"\nstrategy = \"all\"\nset = [\"wall.normal_deg={}\"]\n",
                    scenes[static_cast<std::size_t>(i) % scenes.size()], is_window ? "1280, 800" : "640, 480",
                    is_window ? "window" : "scene", 100 + i / 3));
    update.push_back(name);
  }
  if (run_to_end(update) != 0) throw std::runtime_error("the goldens of the suite cannot be made");
  std::vector<double> times;
  for (int round = 0; round < 5; ++round) {
    const auto began = std::chrono::steady_clock::now();
    if (run_to_end({GHOSTFORCE_PROGRAM, "check", folder.path()}) != 0) throw std::runtime_error("the suite fails");
    times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
  }
  const double taken = median(times);
  report.row("`ghostforce check` of 100 cases, 90 scenes of 640×480 and 10 windows of 1280×800",
             fmt::format("{:.1f} s", taken), at_most(taken, 10.0, "s"));
}

}  // namespace

int run(int argc, char** argv) {
  Report report("6. The picture check");
  report.paragraph(
      "One window of 1280×720, drawn naïve and anisotropic. In process: the picture is in memory, its golden is read "
      "from a PNG and compared. The others are programs that read two PNG files; their start is part of it, as it is "
      "of a test suite's.");
  add_comparisons(report);
  add_suite(report);
  return report.finish(argc, argv);
}

}  // namespace ghostforce::bench
