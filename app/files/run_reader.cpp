#include "app/files/run_reader.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <new>
#include <utility>

#include <fmt/format.h>

#include "app/base/interruption.h"
#include "app/base/progress.h"
#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/files/input_file.h"
#include "app/files/program_build.h"
#include "app/files/scene_file.h"
#include "app/files/scene_keys.h"
#include "core/divergence.h"

namespace ghostforce {
namespace {

constexpr std::string_view version_begins = "# ghostforce ";
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

// A scene's path may stand on one line and have a hundred thousand waypoints; what has a longer line is no run.
constexpr std::size_t longest_line = std::size_t{1} << 24;
constexpr std::size_t most_values = 256;  // in a row
constexpr std::size_t longest_change = 512;
// What set_plain_value() cannot read costs 0.1 ms: words that choose another device or wall, and what another program
// wrote in another form.
constexpr int most_read_changes = 10'000;

// A tick's time may be this far off, in ticks: programs that wrote it out again may have rounded it.
constexpr double time_tolerance = 0.01;

// What is read of a row; those after the needed ones may be missing: `simulate` and `replay` do not write them.
enum Column : std::size_t {
  strategy_column,
  time_column,  // from here on numbers
  goal_x_column,
  goal_y_column,
  device_x_column,
  device_y_column,
  proxy_x_column,
  proxy_y_column,
  force_x_column,
  force_y_column,
  needed_columns,
  sent_x_column = needed_columns,
  sent_y_column,
  loop_column,
  tone_x_column,
  tone_y_column,
  effort_1_column,
  effort_2_column,
  effort_3_column,
  effort_4_column,
  active_column,  // these two are 0 or 1
  saturated_column,
  goal_kind_column,  // these are words again
  device_kind_column,
  all_columns,
};
constexpr std::array<std::string_view, all_columns> column_names{
    "strategy",  "t_s",       "goal_x_m", "goal_y_m", "device_x_m", "device_y_m", "proxy_x_m",  "proxy_y_m",
    "force_x_N", "force_y_N", "sent_x_N", "sent_y_N", "loop_s",     "tone_x_N",   "tone_y_N",   "effort_1",
    "effort_2",  "effort_3",  "effort_4", "active",   "saturated",  "goal_kind",  "device_kind"};

// A finite number, and nothing but it.
template <typename Number>
bool take_number(std::string_view text, Number& value) noexcept {
  const std::optional<Number> number = number_in<Number>(text);
  if (number) value = *number;
  return number && std::isfinite(static_cast<double>(*number));
}

// "t_s=T " is taken off `rest`, and thrown away. False: it does not begin with a time.
bool take_time(std::string_view& rest) noexcept {
  if (!rest.starts_with(time_begins)) return false;
  rest.remove_prefix(time_begins.size());
  double time_s = 0.0;
  return take_number(take_until(rest, ' '), time_s);
}

// What stands after "# state ".
std::optional<RunState> read_state(std::string_view words) {
  if (!take_time(words)) return std::nullopt;
  RunState state;
  PerStrategy<bool> is_told{};
  while (!words.empty()) {
    std::string_view numbers = take_until(words, ' ');
    const std::optional<StrategyId> id = find_strategy(take_until(numbers, '='));
    if (!id || std::exchange(is_told[index_of(*id)], true)) return std::nullopt;
    Vector<2>& velocity = state.velocity[index_of(*id)];
    if (!take_number(take_until(numbers, ','), velocity.x) || !take_number(take_until(numbers, ','), velocity.y) ||
        !take_number(numbers, state.energy[index_of(*id)])) {
      return std::nullopt;
    }
  }
  return std::ranges::all_of(is_told, std::identity{}) ? std::optional(state) : std::nullopt;
}

class RunReader {
 public:
  RunReader(std::string_view shown_path, const TakeTick& take) : take_(take) {
    run_.name = quoted_text(shown_path, longest_path);
  }

  void take(std::string_view piece) {
    rest_ += piece;
    std::string_view text = rest_;
    for (std::size_t end = 0; (end = text.find('\n')) != std::string_view::npos; text.remove_prefix(end + 1)) {
      take_line(text.substr(0, end));
    }
    rest_.erase(0, rest_.size() - text.size());
    if (rest_.size() > longest_line) refuse("this is not a run");
  }

  // What comes after the last line feed is left out: nobody can tell whether its last number is whole.
  RunFacts finish() {
    close_tick();
    if (line_number_ == 0 && rest_.empty()) {
      refuse("the file is empty");
    }
    if (run_.version.empty() && values_per_row_ == 0) refuse("this is not a run");
    if (run_.version.empty()) {
      warn("it does not say which version of ghostforce wrote it");
    } else if (run_.version != program_build()) {
      warn(fmt::format("written by version {}; this is version {}", quoted_text(run_.version), program_build()));
    }
    if (!scene_problem_.empty()) {
      warn(scene_problem_);
    } else if (!run_.scene) {
      warn("its scene is missing or incomplete");
    }
    if (run_.dropped > 0) warn(fmt::format("{} samples were lost while it was recorded", run_.dropped));
    if (!rest_.empty()) warn("its last line is cut off and is left out");
    if (tick_count_ == 0) warn("it has no rows");
    return std::move(run_);
  }

 private:
  void warn(std::string_view words) { run_.warnings.push_back(fmt::format("{}: {}", run_.name, words)); }
  [[noreturn]] void refuse(std::string_view why) const {
    throw ReadError(ReadError::Kind::wrong, {{.file = run_.name,
                                              .what = std::string(why),
                                              .remedy = "give a CSV file that ghostforce recorded or simulated"}});
  }
  [[noreturn]] void damaged(std::string_view what, std::size_t column = 1) const {
    throw ReadError(ReadError::Kind::wrong,
                    {{.file = run_.name,
                      .line = line_number_,
                      .column = column,
                      .what = std::string(what),
                      .remedy = values_per_row_ == 0 ? "correct the line"
                                                     : fmt::format("correct the line, or cut the file before it:\n"
                                                                   "head -n {} RUN.csv > shorter.csv",
                                                                   line_number_ - 1)}});
  }

  void take_line(std::string_view line) {
    line_begin_ = line.data();
    if (++line_number_ == 1 && line.starts_with(byte_order_mark)) line.remove_prefix(byte_order_mark.size());
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.starts_with('#')) {
      take_comment(line);
    } else if (!line.empty()) {
      take_values(line);
    }
  }

  // --- Comments ---

  void take_comment(std::string_view line) {
    const auto rest_after = [line](std::string_view begin) { return line.substr(begin.size()); };
    if (is_within_scene_) return take_scene_line(line);
    if (line.starts_with(version_begins) && run_.version.empty()) {
      run_.version = rest_after(version_begins);
    } else if (line.starts_with(format_begins) && values_per_row_ == 0) {
      check_format(rest_after(format_begins));
    } else if (line == scene_begins && !run_.scene && tick_count_ == 0) {
      is_within_scene_ = true;
      scene_text_.assign(line_number_, '\n');  // errors in it are told with their line in this file
    } else if (line.starts_with(set_begins)) {
      close_tick();
      take_set(rest_after(set_begins));
    } else if (line.starts_with(state_begins)) {
      close_tick();
      pending_state_ = read_state(rest_after(state_begins));
      if (!pending_state_) damaged("the state from which the run continues cannot be read");
    } else if (line.starts_with(dropped_begins)) {
      close_tick();
      std::uint64_t count = 0;
      if (!take_number(rest_after(dropped_begins), count)) damaged("the number of lost samples cannot be read");
      run_.dropped += std::min(count, UINT64_MAX - run_.dropped);
    } else if (line == interrupted_line) {
      run_.is_interrupted = true;
    } else if (values_per_row_ > 0 && !line.starts_with(hand_begins)) {
      damaged(fmt::format("the comment '{}' is not understood", quoted_text(line)));
    }
  }

  // A run without a number is older than these numbers, and in the first format.
  void check_format(std::string_view number) const {
    int format = 0;
    if (!take_number(number, format) || format < 1) damaged("this is not the number of a format");
    if (format <= run_format) return;
    throw ReadError(ReadError::Kind::wrong,
                    {{.file = run_.name,
                      .line = line_number_,
                      .column = 1,
                      .what = fmt::format("this is a run of format {}, but this program only knows formats 1 to {}",
                                          format, run_format),
                      .remedy = "a newer version of ghostforce may read it"}});
  }

  void take_scene_line(std::string_view line) {
    if (line == scene_ends) {
      is_within_scene_ = false;
      return read_scene_text();
    }
    // Blanks for the "# ", so that also the columns are those of this file.
    const std::size_t prefix = line.starts_with("# ") ? 2 : 1;
    scene_text_.append(prefix, ' ').append(line.substr(prefix)).push_back('\n');
    if (scene_text_.size() > largest_text_file) damaged("the scene is longer than a scene can be");
  }

  // Another version of this program may know other keys. The hand can be played all the same, in another scene.
  void read_scene_text() {
    try {
      run_.scene = read_scene(scene_text_, run_.name);
    } catch (const ReadError& error) {
      scene_problem_ = fmt::format("the scene in it cannot be read:\n{}", error.what());
      return;
    }
    run_.settings = {run_.scene->settings};
    // Settings alone, so that a change is quick to read however long path and words are.
    changed_ = *run_.scene;
    changed_.title = changed_.about = "";
    changed_.goal = {{changed_.goal.points.front()}, {0.0}, Motion::linear};
    changed_.stiffness_path = {};
    changed_.duration = 0.0;
    scene_text_.clear();
  }

  void take_set(std::string_view rest) {
    if (!take_time(rest)) damaged("the time of the change cannot be read");
    if (!run_.scene) return;  // nothing to change
    const std::string_view name = rest.substr(0, rest.find('='));
    const SceneKey* const key = find_scene_key(name);
    if (key == nullptr || !is_setting(*key)) damaged(fmt::format("'{}' is not a setting", quoted_text(name)));
    if (rest.size() > longest_change) damaged("the change is longer than one can be");
    Scene changed = changed_;
    const std::string_view value = trimmed(rest.substr(std::min(name.size() + 1, rest.size())));
    if (belongs(*key, changed) && set_plain_value(changed, *key, value) && !find_problem(changed)) {
      changed_ = std::move(changed);
      return;
    }
    if (++read_changes_ > most_read_changes) damaged("there are more changes of this kind than a run can have");
    const std::array change{std::string(rest)};
    try {
      changed_.settings = read_scene(scene_text(changed_), run_.name, change, SceneChecks::all_but_workspace).settings;
    } catch (const ReadError& error) {
      damaged(error.problems().front().what);
    }
  }

  // --- Rows ---

  void take_values(std::string_view line) {
    if (is_within_scene_) damaged(fmt::format("the scene above it does not end with '{}'", scene_ends));
    values_.clear();
    for (bool is_last = false; !is_last && values_.size() <= most_values;) {
      is_last = line.find(',') == std::string_view::npos;
      values_.push_back(take_until(line, ','));
    }
    if (values_per_row_ == 0) {
      take_columns();
    } else {
      take_row();
    }
  }

  void take_columns() {
    std::vector<std::string_view> missing;
    for (std::size_t i = 0; i < all_columns; ++i) {
      place_[i] = static_cast<std::size_t>(std::ranges::find(values_, column_names[i]) - values_.begin());
      if (i < needed_columns && !has(i)) missing.push_back(column_names[i]);
    }
    if (!missing.empty()) {
      refuse(fmt::format("this is not a run: line {} does not name the column {}", line_number_, listed(missing)));
    }
    run_.tells_tones = has(tone_x_column) && has(tone_y_column);
    if (!run_.tells_tones && (has(tone_x_column) || has(tone_y_column))) {
      warn(fmt::format("it has no column {}, so its tones are not read",
                       column_names[has(tone_x_column) ? tone_y_column : tone_x_column]));
    }
    values_per_row_ = values_.size();
  }

  bool has(std::size_t column) const noexcept { return place_[column] < values_.size(); }
  std::string_view value(std::size_t column) const { return values_[place_[column]]; }
  [[noreturn]] void damaged_value(std::size_t column, std::string_view wanted) const {
    damaged(fmt::format("{} is '{}', which is {}", column_names[column], quoted_text(value(column)), wanted),
            static_cast<std::size_t>(value(column).data() - line_begin_) + 1);
  }

  // Whether the value is the second word; without the column it is the first.
  bool is_second(Column column, std::string_view first, std::string_view second) const {
    if (!has(column) || value(column) == first) return false;
    if (value(column) != second) damaged_value(column, fmt::format("neither {} nor {}", first, second));
    return true;
  }

  void take_row() {
    if (values_.size() != values_per_row_) {
      damaged(fmt::format("the row has {}{} values, but there are {} columns",
                          values_.size() > most_values ? "over " : "", std::min(values_.size(), most_values),
                          values_per_row_));
    }
    const std::optional<StrategyId> id = find_strategy(value(strategy_column));
    if (!id) damaged_value(strategy_column, "not a strategy");
    std::array<double, all_columns> number{};
    for (std::size_t i = time_column; i < goal_kind_column; ++i) {
      if (!has(i)) continue;
      if (!take_number(value(i), number[i])) damaged_value(i, "not a finite number");
      if (i >= active_column && number[i] != 0.0 && number[i] != 1.0) damaged_value(i, "neither 0 nor 1");
    }
    const bool is_measured = is_second(device_kind_column, "simulated", "measured");
    const bool is_estimated = is_second(goal_kind_column, "given", "estimated");
    RunRow row{{number[device_x_column], number[device_y_column]},
               {number[proxy_x_column], number[proxy_y_column]},
               {number[force_x_column], number[force_y_column]}};
    row.is_saturated = number[saturated_column] != 0.0;
    for (std::size_t i = 0; i < most_motors; ++i) row.efforts[i] = number[effort_1_column + i];
    if (run_.tells_tones) row.tone = {number[tone_x_column], number[tone_y_column]};
    if (is_measured) {  // the others have no motors
      if (has(sent_x_column) && has(sent_y_column)) row.sent = {number[sent_x_column], number[sent_y_column]};
    }
    // An estimated goal is where the hand would be with the believed stiffness: a low belief puts it anywhere.
    const bool is_given = has(goal_kind_column) && !is_estimated;  // `replay` writes goals without their kind
    for (const Column column : {goal_x_column, goal_y_column}) {
      if (is_given && std::abs(number[column]) > farthest_device_m) {
        damaged_value(column, fmt::format("farther away than {} m", farthest_device_m));
      }
    }
    go_to(number[time_column], {number[goal_x_column], number[goal_y_column]}, *id);
    open_.loop_s = number[loop_column];
    if (is_measured) open_.measured = *id;
    // The strategy on a real device is the active one, also where its row is not there.
    if (is_estimated && !open_.measured && run_.scene) open_.measured = changed_.settings.active;
    open_.rows[index_of(*id)] = row;
  }

  // The open tick is then the row's.
  void go_to(double time_s, const Vector<2>& goal, StrategyId id) {
    const bool is_same_tick = is_open_ && open_.time_s == time_s && !open_.rows[index_of(id)];
    if (is_same_tick && open_.goal == goal) return;
    if (is_same_tick) damaged(fmt::format("the goal is not the same as in line {}, of the same tick", open_.line));
    // A file without its scene has lost its other comments too, those that tell of resets among them.
    if (run_.scene && tick_count_ > 0 && !pending_state_ && !(time_s > open_.time_s)) {
      damaged(fmt::format("t_s = {} does not come after the {} of line {}, and there is no '{}' line to mark a reset",
                          time_s, open_.time_s, open_.line, state_begins.substr(0, state_begins.size() - 1)));
    }
    close_tick();
    is_open_ = true;
    open_ = {};
    open_.tick = tick_at(time_s);
    open_.time_s = time_s;
    open_.goal = goal;
    open_.line = line_number_;
    ++tick_count_;
    if (run_.scene) {
      if (changed_.settings != run_.settings.back()) run_.settings.push_back(changed_.settings);
      open_.settings = run_.settings.size() - 1;
      if (!length_.takes(open_.tick, changed_.settings.rate)) throw too_long(run_, open_);
    }
    if (pending_state_) {
      open_.state = static_cast<std::uint32_t>(run_.states.size());
      run_.states.push_back(*std::exchange(pending_state_, std::nullopt));
    }
  }

  std::int64_t tick_at(double time_s) const {
    if (!run_.scene) return tick_count_;
    const double tick = time_s * changed_.settings.rate;
    // Written so that what is no tick's time is damaged, however far off.
    if (!(tick >= -time_tolerance && tick <= double{last_tick_ever} &&
          std::abs(tick - std::round(tick)) <= time_tolerance)) {
      damaged(fmt::format("t_s = {} is not the time of a tick at {} Hz", time_s, changed_.settings.rate));
    }
    return std::llround(tick);
  }

  void close_tick() {
    if (std::exchange(is_open_, false)) take_(run_, open_);
  }

  const TakeTick& take_;
  RunFacts run_;
  std::string rest_;  // of the pieces, without a line feed
  std::size_t line_number_ = 0;
  const char* line_begin_ = nullptr;  // of the line that is being read

  bool is_within_scene_ = false;
  std::string scene_text_;     // until it is read
  Scene changed_;              // the header's, with the settings in use
  std::string scene_problem_;  // why there is none; empty: it was read, or is not told
  int read_changes_ = 0;
  std::optional<RunState> pending_state_;

  std::array<std::size_t, all_columns> place_{};  // where in a row each value stands; past its end: nowhere
  std::size_t values_per_row_ = 0;                // 0: the names of the columns are not known yet
  std::vector<std::string_view> values_;          // of the line that is being read

  RunTick open_;  // the newest
  bool is_open_ = false;
  std::int64_t tick_count_ = 0;  // the open one included
  RunLength length_;
};

ReadError why_unreadable(const std::string& shown, int error) {
  switch (error) {
    case EISDIR:
      return {ReadError::Kind::wrong, {{.file = shown, .what = "is a folder", .remedy = "name a recording in it"}}};
    case ENOENT:
    case ENOTDIR:
    case ENAMETOOLONG:
      return {ReadError::Kind::wrong, {{.file = shown, .what = "there is no such file", .remedy = "name a recording"}}};
    default:
      return unreadable(shown, error);
  }
}

}  // namespace

Run read_run(std::string_view text, std::string_view shown_path) {
  Run run;
  const TakeTick take = [&](const RunFacts&, const RunTick& tick) { run.ticks.push_back(tick); };
  RunReader reader(shown_path, take);
  reader.take(text);
  static_cast<RunFacts&>(run) = reader.finish();
  return run;
}

Run load_run(const std::string& path) {
  Run run;
  static_cast<RunFacts&>(run) =
      stream_run(path, "reading", true, [&](const RunFacts&, const RunTick& tick) { run.ticks.push_back(tick); });
  return run;
}

RunFacts stream_run(const std::string& path, std::string_view doing, bool shows_progress, const TakeTick& take) {
  const std::string shown = quoted_text(path, longest_path);
  std::error_code no_file;
  const auto size = std::filesystem::is_regular_file(path, no_file)
                        ? static_cast<std::int64_t>(std::filesystem::file_size(path, no_file))
                        : 0;
  Progress progress(std::string(doing), size, shows_progress);
  RunReader reader(path, take);
  std::int64_t done = 0;
  try {
    const int error = read_pieces(path, [&](std::string_view piece) {
      stop_if_interrupted();
      reader.take(piece);
      done += static_cast<std::int64_t>(piece.size());
      progress.at(std::min(done, size));  // it may grow while it is read
      return true;
    });
    if (error != 0) throw why_unreadable(shown, error);
    return reader.finish();
  } catch (const std::bad_alloc&) {
    throw ReadError(ReadError::Kind::unreadable,
                    {{.file = shown,
                      .what = "the run is too long for the memory of this machine",
                      .remedy = "shorten it, as in\nhead -n 1000000 RUN.csv > shorter.csv"}});
  }
}

}  // namespace ghostforce
