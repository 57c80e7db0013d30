// What a window costs in which nothing moves, drawn in software: time runs, and there is nothing to draw.
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "bench/support/contest.h"
#include "bench/support/report.h"
#include "tests/support/display.h"

namespace ghostforce::bench {
namespace {

constexpr int width = 1280;
constexpr int height = 800;

// Of processors so far, in seconds: the servo's thread, and all the others of the program: the window's, and those that
// draw for it.
struct Used {
  double servo_s = 0.0;
  double others_s = 0.0;
};

Used used_by(pid_t process) {
  Used used;
  for (const auto& task : std::filesystem::directory_iterator(fmt::format("/proc/{}/task", process))) {
    std::ifstream file(task.path() / "stat");
    std::string text;
    if (!std::getline(file, text)) continue;       // it has just ended
    const std::size_t name_end = text.rfind(')');  // the name may hold anything
    std::istringstream fields(text.substr(name_end + 2));
    std::string skipped;
    for (int field = 3; field < 14; ++field) fields >> skipped;
    double own = 0.0;
    double system = 0.0;
    fields >> own >> system;
    const bool is_servo = text.substr(0, name_end).ends_with("(servo");
    (is_servo ? used.servo_s : used.others_s) += (own + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
  }
  return used;
}

class Visit {
 public:
  Visit()
      : display_(width, height), program_({GHOSTFORCE_PROGRAM, "run", "--no-hints", "--view", "stage"}, environment()) {
    const auto is_light = [](const Image& image) { return image.rgb.front() > 0 && image.rgb.back() > 0; };
    if (!display_.becomes(is_light)) throw std::runtime_error("no window comes up");
  }

  void press(const std::string& key) {
    display_.act({"mousemove", "640", "780"});
    display_.act({"key", key});
  }
  // A touch, without which the stage begins to show itself.
  void touch() {
    place_ = place_ == 600 ? 700 : 600;
    display_.act({"mousemove", std::to_string(place_), "780"});
  }

  static void wait(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

  // Of a core, over so long [%].
  Used shares(double seconds) const {
    const auto began = std::chrono::steady_clock::now();
    const Used before = used_by(program_.pid());
    wait(seconds);
    const Used after = used_by(program_.pid());
    const double taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    return {100.0 * (after.servo_s - before.servo_s) / taken, 100.0 * (after.others_s - before.others_s) / taken};
  }

 private:
  std::vector<std::string> environment() const {
    std::vector<std::string> variables = display_.environment();
    variables.emplace_back("LIBGL_ALWAYS_SOFTWARE=1");
    return variables;
  }

  Display display_;
  BackgroundProgram program_;
  int place_ = 600;
};

constexpr double after_touch_s = 2.5;  // until words of explanation have come, or not
constexpr int turns = 4;
constexpr double turn_s = 15.0;  // and after 20 s untouched the stage shows itself

void add_rest(Report& report) {
  Visit visit;
  std::vector<double> servo;
  const auto at_rest = [&](const std::string& what, double most) {
    std::vector<double> others;
    for (int turn = 0; turn < turns; ++turn) {
      visit.touch();
      Visit::wait(after_touch_s);
      const Used share = visit.shares(turn_s);
      others.push_back(share.others_s);
      servo.push_back(share.servo_s);
    }
    const double share = median(others);
    report.row(what, fmt::format("{:.1f} %", share), at_most(share, most, "%"));
  };
  at_rest("the stage at rest, time runs", 5.0);
  visit.press("F4");
  at_rest("the workbench at rest, time runs, its status bar counts", 5.0);
  visit.press("F4");
  report.row("the servo's thread beside it", fmt::format("{:.1f} %", median(servo)));
  visit.press("space");
  at_rest("the stage, paused", 2.0);
  visit.press("space");
  visit.touch();
  Visit::wait(22.0);
  report.row("a frame 60 times a second, or as often as can be: the stage shows itself",
             fmt::format("{:.1f} %", visit.shares(10.0).others_s));
}

}  // namespace

int run(int argc, char** argv) {
  Report report("7. At rest");
  report.paragraph(
      "`ghostforce run` in a window of 1280×800 under Xvfb, drawn by llvmpipe: processor time of all its threads but "
      "the "
      "servo's, of one core, as Linux counts it for each thread. Medians of 4 turns of 15 s, each 2.5 s after the "
      "pointer "
      "was moved.");
  add_rest(report);
  return report.finish(argc, argv);
}

}  // namespace ghostforce::bench
