#include "app/run_reader.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <map>
#include <new>
#include <utility>

#include <fmt/format.h>

#include "app/failure.h"
#include "app/file_kind.h"
#include "app/interruption.h"
#include "app/output_file.h"
#include "app/printable.h"
#include "app/progress.h"
#include "app/run_line.h"
#include "app/run_remarks.h"
#include "app/scene_file.h"
#include "app/scene_key_name.h"
#include "ghostforce_version.h"

namespace ghostforce {
namespace {

constexpr std::string_view version_begins = "# ghostforce ";
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

// A scene's path may stand on one line and have a hundred thousand waypoints; what has a longer line is no run.
constexpr std::size_t longest_line = std::size_t{1} << 24;

// So far off a tick's time may be, in ticks: programs that wrote it out again may have rounded it.
constexpr double time_tolerance = 0.01;
constexpr double last_tick_ever = 1e12;

class RunReader {
 public:
  explicit RunReader(std::string_view shown_path)
      : shown_path_(printable(shown_path, longest_path)), remarks_(shown_path_) {}

  // A line without its line feed.
  void take_line(std::string_view line) {
    if (++line_number_ == 1 && line.starts_with(byte_order_mark)) line.remove_prefix(byte_order_mark.size());
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.starts_with('#')) {
      take_comment(line);
    } else if (!line.empty()) {
      take_values(line);
    }
  }

  // The whole is about so many times as long as what was taken so far: room for its ticks at once, since a vector that
  // grows needs up to three times as much.
  void expect(double times_as_long) {
    constexpr double spare = 1.02;
    const double ticks = spare * times_as_long * static_cast<double>(run_.ticks.size());
    if (ticks < static_cast<double>(run_.ticks.max_size())) run_.ticks.reserve(static_cast<std::size_t>(ticks));
  }

  // What comes after the last line feed. Nobody can tell whether its last number is whole.
  void take_end(std::string_view rest) {
    is_empty_ = line_number_ == 0 && rest.empty();
    is_cut_ = !rest.empty();
  }

  Run finish() {
    close_tick();
    if (is_empty_) throw Failure(ExitCode::wrong_call, fmt::format("{}: the file is empty", shown_path_));
    if (run_.version.empty() && !columns_.are_known()) {
      throw Failure(
          ExitCode::wrong_call,
          fmt::format("{}: this is no run; give a CSV file that ghostforce has recorded or simulated", shown_path_));
    }
    leave_out_ticks_out_of_order();
    write_remarks();
    run_.remarks = remarks_.take();
    return std::move(run_);
  }

 private:
  // --- Comments ---

  void take_comment(std::string_view line) {
    if (is_within_scene_) {
      if (line == scene_ends) {
        is_within_scene_ = false;
        read_scene_text();
      } else {
        line.remove_prefix(std::min<std::size_t>(line.size(), line.starts_with("# ") ? 2 : 1));
        scene_text_.append(line).push_back('\n');
      }
    } else if (line.starts_with(version_begins) && run_.version.empty()) {
      run_.version = line.substr(version_begins.size());
    } else if (line == scene_begins && !run_.scene) {
      is_within_scene_ = true;
      scene_text_.clear();
    } else if (line.starts_with(set_begins)) {
      close_tick();
      if (!take_set(line.substr(set_begins.size()))) {
        complain(RunFault::bad_set);
        knows_settings_ = false;
      }
    } else if (line.starts_with(state_begins)) {
      close_tick();
      pending_state_ = read_state(line.substr(state_begins.size()));
      if (!pending_state_) complain(RunFault::bad_state);
      knows_state_ = pending_state_.has_value();
    } else if (line.starts_with(dropped_begins)) {
      close_tick();
      take_dropped(line.substr(dropped_begins.size()));
    } else if (line == interrupted_line) {
      run_.is_interrupted = true;
    } else if (columns_.are_known() && !line.starts_with(hand_begins)) {
      complain(RunFault::not_understood);
    }
  }

  void read_scene_text() {
    try {
      run_.scene = read_scene(scene_text_, shown_path_);
    } catch (const Failure& failure) {
      const std::string_view words = failure.what();
      scene_problem_ = fmt::format("the scene in it cannot be read ({})", words.substr(0, words.find('\n')));
      return;
    }
    run_.settings = {run_.scene->settings};
    settings_ = run_.scene->settings;
    // Settings alone, so that a change is quick to read however long the path is.
    Scene short_scene = *run_.scene;
    short_scene.goal = {{Vector<2>(0.0)}, {0.0}, Motion::linear};
    short_scene.duration = 0.0;
    settings_text_ = ghostforce::scene_text(short_scene);
  }

  bool take_set(std::string_view rest) {
    if (!take_time(rest)) return false;
    if (!run_.scene) return true;  // nothing to change
    const std::string_view name = rest.substr(0, rest.find('='));
    const SceneKey* const key = find_scene_key(name);
    if (key == nullptr || !is_setting(*key)) return false;
    auto tried = overrides_;
    tried.insert_or_assign(std::string(name), std::string(rest));
    std::vector<std::string> arguments;
    for (const auto& [of, argument] : tried) arguments.push_back(argument);
    try {
      settings_ = read_scene(settings_text_, shown_path_, arguments).settings;
    } catch (const Failure&) {
      return false;
    }
    overrides_ = std::move(tried);
    return true;
  }

  void take_dropped(std::string_view words) {
    std::uint64_t count = 0;
    const auto [stop, error] = std::from_chars(words.data(), words.data() + words.size(), count);
    if (error != std::errc{} || stop != words.data() + words.size()) {
      complain(RunFault::damaged);
    } else {
      run_.dropped += std::min(count, UINT64_MAX - run_.dropped);
    }
  }

  // --- Rows ---

  void take_values(std::string_view line) {
    is_within_scene_ = false;  // its end was damaged
    values_.clear();
    constexpr std::size_t most_values = 256;
    while (values_.size() <= most_values) {
      const bool is_last = line.find(',') == std::string_view::npos;
      values_.push_back(take_until(line, ','));
      if (is_last) break;
    }
    if (take_columns()) return;
    if (!columns_.are_known()) {
      if (run_.version.empty()) return;  // no line of it is worth a word: it may be anything
      // The line of names is damaged. That a row has the usual columns shows in its numbers.
      if (values_.empty() || !find_strategy(values_.front())) return complain(RunFault::damaged);
      columns_.assume_usual(values_.size());
      assumes_columns_ = true;
    }
    take_row();
  }

  bool take_columns() {
    if (columns_.are_known() || !RunColumns::may_be_names(values_)) return false;
    const std::vector<std::string_view> missing = columns_.find(values_);
    if (missing.empty()) return true;
    if (!run_.version.empty()) return false;
    throw Failure(ExitCode::wrong_call, fmt::format("{}: this is no run: there is no column {}; give a CSV file that "
                                                    "ghostforce has recorded or simulated",
                                                    shown_path_, listed(missing)));
  }

  void take_row() {
    RunLine line;
    if (const std::optional<RunFault> fault = columns_.read(values_, line)) return complain(*fault);
    auto k = static_cast<std::int64_t>(run_.ticks.size() + (is_open_ ? 1 : 0));
    if (run_.scene) {
      const double tick = line.time_s * settings_.rate;
      // Written so that what is no tick's time is damaged, however far off.
      if (!(tick >= -time_tolerance && tick <= last_tick_ever)) return complain(RunFault::damaged);
      k = std::llround(tick);
      if (std::abs(tick - static_cast<double>(k)) > time_tolerance) return complain(RunFault::damaged);
    }
    const std::size_t i = index_of(line.strategy);
    const bool is_same_tick = is_open_ && open_.time_s == line.time_s && !open_.rows[i];
    if (is_same_tick && open_.goal != line.goal) return complain(RunFault::damaged);
    if (!is_same_tick) open_tick(k, line.time_s, line.goal);
    if (line.is_measured) open_.measured = line.strategy;
    // The strategy on a real device is the active one, also where its row is lost.
    if (line.is_estimated && !open_.measured && run_.scene) open_.measured = settings_.active;
    open_.rows[i] = line.row;
  }

  void open_tick(std::int64_t k, double time_s, const Vector<2>& goal) {
    close_tick();
    is_open_ = true;
    open_ = {};
    open_.tick = k;
    open_.time_s = time_s;
    open_.goal = goal;
    if (run_.scene && settings_ != run_.settings.back()) run_.settings.push_back(settings_);
    open_.settings = run_.settings.empty() ? 0 : run_.settings.size() - 1;
    if (pending_state_) {
      open_.state = static_cast<std::uint32_t>(run_.states.size());
      run_.states.push_back(*std::exchange(pending_state_, std::nullopt));
    }
    open_.is_sure = knows_settings_ && knows_state_;
  }

  void close_tick() {
    if (std::exchange(is_open_, false)) run_.ticks.push_back(open_);
  }

  // A damaged time makes a tick of its own, in the midst of others that go on without it.
  void leave_out_ticks_out_of_order() {
    std::vector<RunTick>& ticks = run_.ticks;
    if (!run_.scene) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      if (kept > 0 && ticks[i].state == RunTick::none) {
        RunTick& last = ticks[kept - 1];
        const RunTick* const next =
            i + 1 < ticks.size() && ticks[i + 1].state == RunTick::none ? &ticks[i + 1] : nullptr;
        if (next != nullptr && last.time_s <= next->time_s &&
            (ticks[i].time_s < last.time_s || ticks[i].time_s > next->time_s)) {
          ++out_of_order_;
          continue;
        }
        if (can_join(last, ticks[i])) {
          for (std::size_t s = 0; s < strategy_count; ++s) {
            if (ticks[i].rows[s]) last.rows[s] = ticks[i].rows[s];
          }
          if (ticks[i].measured) last.measured = ticks[i].measured;
          continue;
        }
      }
      if (kept != i) ticks[kept] = ticks[i];
      ++kept;
    }
    ticks.resize(kept);
  }

  static bool can_join(const RunTick& a, const RunTick& b) noexcept {
    if (a.time_s != b.time_s || a.goal != b.goal || a.settings != b.settings) return false;
    for (std::size_t s = 0; s < strategy_count; ++s) {
      if (a.rows[s] && b.rows[s]) return false;
    }
    return true;
  }

  // --- Telling what was left out ---

  void complain(RunFault fault) { remarks_.complain(fault, line_number_); }

  void write_remarks() {
    if (run_.version.empty()) {
      remarks_.add("which version of ghostforce wrote it is not told");
    } else if (run_.version != version) {
      remarks_.add(fmt::format("written by version {}; this is version {}", printable(run_.version), version));
    }
    if (!scene_problem_.empty()) {
      remarks_.add(scene_problem_);
    } else if (!run_.scene) {
      remarks_.add("the scene is not told, or not to its end");
    }
    if (assumes_columns_) remarks_.add("the line of column names is damaged; the usual ones are assumed");
    remarks_.add_faults();
    if (out_of_order_ > 0) {
      remarks_.add(fmt::format("{} out of order and left out",
                               out_of_order_ == 1 ? "1 tick is" : fmt::format("{} ticks are", out_of_order_)));
    }
    if (run_.dropped > 0) remarks_.add(fmt::format("{} samples were lost while it was recorded", run_.dropped));
    if (is_cut_) remarks_.add("its last line is cut and left out");
    if (run_.ticks.empty()) remarks_.add("it holds no row");
  }

  std::string shown_path_;
  RunRemarks remarks_;
  Run run_;
  std::size_t line_number_ = 0;
  bool is_empty_ = false;
  bool is_cut_ = false;

  bool is_within_scene_ = false;
  std::string scene_text_;
  std::string scene_problem_;

  std::string settings_text_;                     // a scene of the header's settings
  std::map<std::string, std::string> overrides_;  // by key, the newest change of it
  Settings settings_;                             // in use
  bool knows_settings_ = true;
  bool knows_state_ = true;
  std::optional<RunState> pending_state_;

  RunColumns columns_;
  bool assumes_columns_ = false;
  std::vector<std::string_view> values_;  // of the line that is being read

  RunTick open_;
  bool is_open_ = false;

  std::size_t out_of_order_ = 0;
};

// Takes the whole lines; what is left has no line feed.
std::string_view take_lines(RunReader& reader, std::string_view text) {
  while (true) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return text;
    reader.take_line(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
}

// The text comes in pieces, so that it never stands in the memory beside its ticks.
Run read_pieces(int descriptor, const std::string& path, const std::string& shown) {
  struct stat status {};
  const std::int64_t size = fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) ? status.st_size : 0;
  Progress progress("reading", size, true);
  RunReader reader(path);
  std::string text;
  constexpr std::size_t piece = std::size_t{1} << 20;
  std::size_t kept = 0;  // of a line that is not complete yet
  std::int64_t done = 0;
  while (true) {
    text.resize(kept + piece);
    const ssize_t count = read(descriptor, text.data() + kept, piece);
    if (count < 0) {
      const int error = errno;
      stop_if_interrupted();
      if (error == EINTR) continue;
      throw Failure(ExitCode::file_trouble, fmt::format("{} cannot be read: {}", shown, reason_of(error)));
    }
    text.resize(kept + static_cast<std::size_t>(count));
    if (count == 0) break;
    stop_if_interrupted();
    const std::string_view rest = take_lines(reader, text);
    kept = rest.size();
    if (kept > longest_line) {
      throw Failure(
          ExitCode::wrong_call,
          fmt::format("{}: this is no run; give a CSV file that ghostforce has recorded or simulated", shown));
    }
    text.erase(0, text.size() - kept);
    if (done == 0) reader.expect(static_cast<double>(size) / static_cast<double>(count));
    done += count;
    progress.at(std::min(done, size));  // it may grow while it is read
  }
  reader.take_end(text);
  return reader.finish();
}

}  // namespace

bool may_be_run(std::string_view path) noexcept {
  return path.ends_with(".csv") || path.ends_with(".CSV");
}

Run read_run(std::string_view text, std::string_view shown_path) {
  RunReader reader(shown_path);
  reader.take_end(take_lines(reader, text));
  return reader.finish();
}

Run load_run(const std::string& path) {
  const std::string shown = printable(path, longest_path);
  if (const std::string_view kind = kind_instead_of_file(path); kind == "a folder") {
    throw Failure(ExitCode::wrong_call, fmt::format("{}: is a folder; name a recording in it", shown));
  }
  const int descriptor = open_unless_interrupted(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    const int error = errno;
    if (error == ENOENT || error == ENOTDIR || error == ENAMETOOLONG) {
      throw Failure(ExitCode::wrong_call, fmt::format("{}: there is no such file; name a recording", shown));
    }
    throw Failure(ExitCode::file_trouble, fmt::format("{} cannot be read: {}", shown, reason_of(error)));
  }
  struct Closer {
    int descriptor;
    ~Closer() { close(descriptor); }
  } const closer{descriptor};

  try {
    return read_pieces(descriptor, path, shown);
  } catch (const std::bad_alloc&) {
    throw Failure(ExitCode::file_trouble,
                  fmt::format("{}: the run is too long for this machine's memory; cut it, as in\n"
                              "head -n 1000000 RUN.csv > shorter.csv",
                              shown));
  }
}

GoalPath goal_path_of(const Run& run) {
  if (run.ticks.empty()) throw Failure(ExitCode::wrong_call, "the run holds no row: there is no hand to replay");
  GoalPath path;
  path.points.reserve(run.ticks.size());
  path.times.reserve(run.ticks.size());
  if (!run.scene) {  // and so no rate
    for (const RunTick& tick : run.ticks) {
      const double time_s = tick.time_s - run.ticks.front().time_s;
      if (!path.times.empty() && !(time_s > path.times.back())) break;
      path.points.push_back(tick.goal);
      path.times.push_back(time_s);
    }
    return path;
  }
  // Times from whole ticks, as the servo reckons them: the goal of a tick is then that of its row, bit for bit.
  const RunTick* begin = &run.ticks.front();  // of the stretch with the same rate
  double begin_s = 0.0;
  for (const RunTick& tick : run.ticks) {
    const double rate = run.settings[tick.settings].rate;
    double time_s = begin_s + time_of(tick.tick - begin->tick, rate);
    if (rate != run.settings[begin->settings].rate) {
      const double before_s = path.times.back();
      begin = &tick;
      begin_s = time_s = before_s + 1.0 / rate;
    }
    if (!path.times.empty() && !(time_s > path.times.back())) break;
    path.points.push_back(tick.goal);
    path.times.push_back(time_s);
  }
  return path;
}

}  // namespace ghostforce
