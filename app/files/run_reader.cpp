#include "app/files/run_reader.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <new>
#include <utility>

#include <fmt/format.h>

#include "app/console/failure.h"
#include "app/console/interruption.h"
#include "app/console/progress.h"
#include "app/console/quoted.h"
#include "app/files/file_kind.h"
#include "app/files/input_file.h"
#include "app/files/run_length.h"
#include "app/files/run_line.h"
#include "app/files/run_remarks.h"
#include "app/files/scene_file.h"
#include "app/files/scene_keys.h"
#include "app/files/tick_order.h"
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
  RunReader(std::string_view shown_path, const TakeTick& take)
      : take_(take), shown_path_(printable(shown_path, longest_path)), remarks_(shown_path_) {
    run_.name = shown_path_;
  }

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

  RunFacts finish() {
    close_tick();
    order_.end();
    if (is_empty_) throw Failure(ExitCode::wrong_call, fmt::format("{}: the file is empty", shown_path_));
    if (run_.version.empty() && !columns_.are_known()) {
      throw Failure(
          ExitCode::wrong_call,
          fmt::format("{}: this is no run; give a CSV file that ghostforce has recorded or simulated", shown_path_));
    }
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
    } else if (line == scene_begins && !run_.scene && tick_count_ == 0) {
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
    } catch (const ReadError& error) {
      const std::string_view words = error.what();
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
    } catch (const ReadError&) {
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
    std::int64_t k = tick_count_;
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
    ++tick_count_;
    open_ = {};
    open_.line = line_number_;
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
    if (!std::exchange(is_open_, false)) return;
    // Without a scene nobody knows what order is.
    if (run_.scene) {
      order_.take(open_);
    } else {
      take_(run_, open_);
    }
  }

  void hand_on(const RunTick& tick) {
    if (!length_.takes(tick.tick, run_.settings[tick.settings].rate)) throw too_long(run_, tick);
    take_(run_, tick);
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
    if (const std::size_t count = order_.left_out(); count > 0) {
      remarks_.add(
          fmt::format("{} out of order and left out", count == 1 ? "1 tick is" : fmt::format("{} ticks are", count)));
    }
    if (run_.dropped > 0) remarks_.add(fmt::format("{} samples were lost while it was recorded", run_.dropped));
    if (is_cut_) remarks_.add("its last line is cut and left out");
    if (tick_count_ == 0) remarks_.add("it holds no row");
  }

  const TakeTick& take_;
  std::string shown_path_;
  RunRemarks remarks_;
  RunFacts run_;
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
  std::int64_t tick_count_ = 0;  // the open one included
  TickOrder order_{[this](const RunTick& tick) { hand_on(tick); }};
  RunLength length_;
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

struct Closer {
  int descriptor;
  ~Closer() { close(descriptor); }
};

// `expect` is told once about how many times as many ticks there are as were taken so far.
RunFacts read_pieces(const std::string& path, Progress& progress, std::int64_t size, int descriptor,
                     const TakeTick& take, const std::function<void(double times_as_many)>& expect) {
  const std::string shown = printable(path, longest_path);
  RunReader reader(path, take);
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
      throw Failure(ExitCode::file_trouble, fmt::format("{} cannot be read: {}", shown, unreadable_words(error)));
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
    if (done == 0) expect(static_cast<double>(size) / static_cast<double>(count));
    done += count;
    progress.at(std::min(done, size));  // it may grow while it is read
  }
  reader.take_end(text);
  return reader.finish();
}

RunFacts read_file(const std::string& path, std::string_view doing, bool shows_progress, const TakeTick& take,
                   const std::function<void(double times_as_many)>& expect) {
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
    throw Failure(ExitCode::file_trouble, fmt::format("{} cannot be read: {}", shown, unreadable_words(error)));
  }
  const Closer closer{descriptor};
  struct stat status {};
  const std::int64_t size = fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) ? status.st_size : 0;
  Progress progress(std::string(doing), size, shows_progress);
  try {
    return read_pieces(path, progress, size, descriptor, take, expect);
  } catch (const std::bad_alloc&) {
    throw Failure(ExitCode::file_trouble,
                  fmt::format("{}: the run is too long for this machine's memory; cut it, as in\n"
                              "head -n 1000000 RUN.csv > shorter.csv",
                              shown));
  }
}

}  // namespace

bool may_be_run(std::string_view path) noexcept {
  return path.ends_with(".csv") || path.ends_with(".CSV");
}

Run read_run(std::string_view text, std::string_view shown_path) {
  std::vector<RunTick> ticks;
  const TakeTick take = [&](const RunFacts&, const RunTick& tick) { ticks.push_back(tick); };
  RunReader reader(shown_path, take);
  reader.take_end(take_lines(reader, text));
  return {reader.finish(), std::move(ticks)};
}

Run load_run(const std::string& path) {
  std::vector<RunTick> ticks;
  RunFacts facts = read_file(
      path, "reading", true, [&](const RunFacts&, const RunTick& tick) { ticks.push_back(tick); },
      [&](double times_as_many) {
        // At once: a vector that grows needs up to three times as much.
        constexpr double spare = 1.02;
        const double count = spare * times_as_many * static_cast<double>(ticks.size());
        if (count < static_cast<double>(ticks.max_size())) ticks.reserve(static_cast<std::size_t>(count));
      });
  return {std::move(facts), std::move(ticks)};
}

RunFacts stream_run(const std::string& path, std::string_view doing, bool shows_progress, const TakeTick& take) {
  return read_file(path, doing, shows_progress, take, [](double) {});
}

}  // namespace ghostforce
