#include "app/run_reader.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "app/failure.h"
#include "app/file_kind.h"
#include "app/interruption.h"
#include "app/output_file.h"
#include "app/printable.h"
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

// What is read of a row, and how many numbers of it; the word of the device's kind may be missing.
enum Column : std::size_t {
  strategy_column,
  time_column,
  goal_x_column,
  goal_y_column,
  device_x_column,
  device_y_column,
  proxy_x_column,
  proxy_y_column,
  force_x_column,
  force_y_column,
  needed_columns,
  goal_kind_column = needed_columns,
  device_kind_column,
  column_count,
};
constexpr std::array<std::string_view, column_count> column_names{
    "strategy",  "t_s",       "goal_x_m",  "goal_y_m",  "device_x_m", "device_y_m",
    "proxy_x_m", "proxy_y_m", "force_x_N", "force_y_N", "goal_kind",  "device_kind"};

// Why a line is left out.
enum class Fault : std::size_t { damaged, not_finite, bad_set, bad_state, not_understood, count };
struct FaultWords {
  std::string_view one;
  std::string_view many;
};
constexpr std::array<FaultWords, static_cast<std::size_t>(Fault::count)> fault_words{{
    {"line is damaged and left out", "lines are damaged and left out"},
    {"row has a number that is none (NaN or infinite) and is left out",
     "rows have numbers that are none (NaN or infinite) and are left out"},
    {"change of a setting cannot be read: the settings are not known from there on",
     "changes of settings cannot be read: the settings are not known from there on"},
    {"line about a jump cannot be read", "lines about jumps cannot be read"},
    {"comment is not understood and left out", "comments are not understood and left out"},
}};

// A finite number, and nothing but it.
enum class Number { good, not_finite, damaged };  // from good to bad
Number read_number(std::string_view text, double& value) noexcept {
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return Number::damaged;
  return std::isfinite(value) ? Number::good : Number::not_finite;
}

// The text up to the separator, which is taken off `rest` with it.
std::string_view take_until(std::string_view& rest, char separator) noexcept {
  const std::size_t end = rest.find(separator);
  const std::string_view piece = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  return piece;
}

class RunReader {
 public:
  explicit RunReader(std::string_view shown_path) : shown_path_(printable(shown_path, longest_path)) {}

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

  // What comes after the last line feed. Nobody can tell whether its last number is whole.
  void take_end(std::string_view rest) {
    is_empty_ = line_number_ == 0 && rest.empty();
    is_cut_ = !rest.empty();
  }

  Run finish() {
    close_tick();
    if (is_empty_) throw Failure(ExitCode::wrong_call, fmt::format("{}: the file is empty", shown_path_));
    if (run_.version.empty() && !knows_columns_) {
      throw Failure(
          ExitCode::wrong_call,
          fmt::format("{}: this is no run; give a CSV file that ghostforce has recorded or simulated", shown_path_));
    }
    leave_out_ticks_out_of_order();
    write_remarks();
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
        complain(Fault::bad_set);
        knows_settings_ = false;
      }
    } else if (line.starts_with(state_begins)) {
      close_tick();
      pending_state_ = take_state(line.substr(state_begins.size()));
      if (!pending_state_) complain(Fault::bad_state);
      knows_state_ = pending_state_.has_value();
    } else if (line.starts_with(dropped_begins)) {
      close_tick();
      take_dropped(line.substr(dropped_begins.size()));
    } else if (line == interrupted_line) {
      run_.is_interrupted = true;
    } else if (knows_columns_ && !line.starts_with(hand_begins)) {
      complain(Fault::not_understood);
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

  static bool take_time(std::string_view& rest) noexcept {
    if (!rest.starts_with(time_begins)) return false;
    rest.remove_prefix(time_begins.size());
    double time_s = 0.0;
    return read_number(take_until(rest, ' '), time_s) == Number::good;
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

  static std::optional<RunState> take_state(std::string_view rest) {
    if (!take_time(rest)) return std::nullopt;
    RunState state;
    PerStrategy<bool> is_told{};
    while (!rest.empty()) {
      std::string_view words = take_until(rest, ' ');
      const std::optional<StrategyId> id = find_strategy(take_until(words, '='));
      if (!id || std::exchange(is_told[index_of(*id)], true)) return std::nullopt;
      double x = 0.0;
      double y = 0.0;
      if (read_number(take_until(words, ','), x) != Number::good ||
          read_number(take_until(words, ','), y) != Number::good ||
          read_number(words, state.energy[index_of(*id)]) != Number::good) {
        return std::nullopt;
      }
      state.velocity[index_of(*id)] = {x, y};
    }
    if (!std::ranges::all_of(is_told, std::identity{})) return std::nullopt;
    return state;
  }

  void take_dropped(std::string_view words) {
    std::uint64_t count = 0;
    const auto [stop, error] = std::from_chars(words.data(), words.data() + words.size(), count);
    if (error != std::errc{} || stop != words.data() + words.size()) {
      complain(Fault::damaged);
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
    if (!knows_columns_) {
      if (run_.version.empty()) return;  // no line of it is worth a word: it may be anything
      // The line of names is damaged. That a row has the usual columns shows in its numbers.
      if (values_.empty() || !find_strategy(values_.front())) return complain(Fault::damaged);
      assume_usual_columns();
    }
    take_row();
  }

  bool take_columns() {
    if (knows_columns_ || std::ranges::find(values_, column_names[time_column]) == values_.end()) return false;
    std::vector<std::string_view> missing;
    for (std::size_t i = 0; i < column_count; ++i) {
      const auto found = std::ranges::find(values_, column_names[i]);
      place_[i] = found == values_.end() ? absent : static_cast<std::size_t>(found - values_.begin());
      if (i < needed_columns && place_[i] == absent) missing.push_back(column_names[i]);
    }
    if (!missing.empty()) {
      if (!run_.version.empty()) return false;
      throw Failure(ExitCode::wrong_call, fmt::format("{}: this is no run: there is no column {}; give a CSV file that "
                                                      "ghostforce has recorded or simulated",
                                                      shown_path_, listed(missing)));
    }
    knows_columns_ = true;
    values_per_row_ = values_.size();
    return true;
  }

  void assume_usual_columns() {
    for (std::size_t i = 0; i < column_count; ++i) place_[i] = i < needed_columns ? i : absent;
    values_per_row_ = std::max<std::size_t>(values_.size(), needed_columns);
    knows_columns_ = true;
    assumes_columns_ = true;
  }

  void take_row() {
    if (values_.size() != values_per_row_) return complain(Fault::damaged);
    const std::optional<StrategyId> id = find_strategy(values_[place_[strategy_column]]);
    if (!id) return complain(Fault::damaged);
    std::array<double, needed_columns> number{};
    Number worst = Number::good;
    for (std::size_t i = time_column; i < needed_columns; ++i) {
      worst = std::max(worst, read_number(values_[place_[i]], number[i]));
    }
    if (worst != Number::good) return complain(worst == Number::damaged ? Fault::damaged : Fault::not_finite);

    const std::string_view device_kind = word_at(device_kind_column, "simulated");
    const std::string_view goal_kind = word_at(goal_kind_column, "given");
    const bool is_measured = device_kind == "measured";
    const bool is_estimated = goal_kind == "estimated";
    if ((!is_measured && device_kind != "simulated") || (!is_estimated && goal_kind != "given")) {
      return complain(Fault::damaged);
    }

    const double time_s = number[time_column];
    const Vector<2> goal{number[goal_x_column], number[goal_y_column]};
    auto k = static_cast<std::int64_t>(run_.ticks.size() + (is_open_ ? 1 : 0));
    if (run_.scene) {
      const double tick = time_s * settings_.rate;
      // Written so that what is no tick's time is damaged, however far off.
      if (!(tick >= -time_tolerance && tick <= last_tick_ever)) return complain(Fault::damaged);
      k = std::llround(tick);
      if (std::abs(tick - static_cast<double>(k)) > time_tolerance) return complain(Fault::damaged);
    }
    const bool is_same_tick = is_open_ && open_.time_s == time_s && !open_.rows[index_of(*id)];
    if (is_same_tick && open_.goal != goal) return complain(Fault::damaged);
    if (!is_same_tick) open_tick(k, time_s, goal);
    if (is_measured) open_.measured = *id;
    // The strategy on a real device is the active one, also where its row is lost.
    if (is_estimated && !open_.measured && run_.scene) open_.measured = settings_.active;
    open_.rows[index_of(*id)] = RunRow{{number[device_x_column], number[device_y_column]},
                                       {number[proxy_x_column], number[proxy_y_column]},
                                       {number[force_x_column], number[force_y_column]}};
  }

  std::string_view word_at(Column column, std::string_view otherwise) const {
    return place_[column] == absent ? otherwise : values_[place_[column]];
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

  void complain(Fault fault) {
    Complaint& complaint = complaints_[static_cast<std::size_t>(fault)];
    if (complaint.count++ == 0) complaint.first_line = line_number_;
  }

  void remark(const std::string& words) { run_.remarks.push_back(fmt::format("{}: {}", shown_path_, words)); }

  void write_remarks() {
    if (run_.version.empty()) {
      remark("which version of ghostforce wrote it is not told");
    } else if (run_.version != version) {
      remark(fmt::format("written by version {}; this is version {}", printable(run_.version), version));
    }
    if (!scene_problem_.empty()) {
      remark(scene_problem_);
    } else if (!run_.scene) {
      remark("the scene is not told, or not to its end");
    }
    if (assumes_columns_) remark("the line of column names is damaged; the usual ones are assumed");
    for (std::size_t i = 0; i < complaints_.size(); ++i) {
      const auto& [count, first_line] = complaints_[i];
      if (count == 1) remark(fmt::format("1 {}: line {}", fault_words[i].one, first_line));
      if (count > 1) remark(fmt::format("{} {}, the first is line {}", count, fault_words[i].many, first_line));
    }
    if (out_of_order_ > 0) {
      remark(fmt::format("{} out of order and left out",
                         out_of_order_ == 1 ? "1 tick is" : fmt::format("{} ticks are", out_of_order_)));
    }
    if (run_.dropped > 0) remark(fmt::format("{} samples were lost while it was recorded", run_.dropped));
    if (is_cut_) remark("its last line is cut and left out");
    if (run_.ticks.empty()) remark("it holds no row");
  }

  struct Complaint {
    std::size_t count = 0;
    std::size_t first_line = 0;
  };
  static constexpr std::size_t absent = SIZE_MAX;

  std::string shown_path_;
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

  bool knows_columns_ = false;
  bool assumes_columns_ = false;
  std::array<std::size_t, column_count> place_{};
  std::size_t values_per_row_ = 0;
  std::vector<std::string_view> values_;  // of the line that is being read

  RunTick open_;
  bool is_open_ = false;

  std::array<Complaint, static_cast<std::size_t>(Fault::count)> complaints_{};
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
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
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

  // In pieces: a day of recording is larger than many a memory.
  RunReader reader(path);
  std::string text;
  constexpr std::size_t piece = std::size_t{1} << 20;
  std::size_t kept = 0;  // of a line that is not complete yet
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
  }
  reader.take_end(text);
  return reader.finish();
}

GoalPath goal_path_of(const Run& run) {
  if (!run.scene || run.ticks.empty()) {
    throw Failure(ExitCode::wrong_call, run.scene ? "the run holds no row: there is no hand to replay"
                                                  : "the run does not tell its scene: there is no hand to replay");
  }
  GoalPath path;
  path.points.reserve(run.ticks.size());
  path.times.reserve(run.ticks.size());
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
