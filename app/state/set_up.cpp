#include "app/state/set_up.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/base/quoted.h"
#include "app/base/shell_word.h"
#include "app/base/typed_text.h"
#include "app/files/input_file.h"
#include "app/files/scene_keys.h"
#include "app/files/shipped_scenes.h"
#include "core/conventions.h"
#include "core/strategy.h"

namespace ghostforce {
namespace {

// --- Writing ---

bool has_option_of_its_own(const SceneKey& key) {
  return key.table == "rendering" && key.name == "strategy";
}

bool is_words_about_scene(const SceneKey& key) {
  return std::holds_alternative<TextKey>(key.value);
}

bool is_path(const SceneKey& key) {
  return std::holds_alternative<PointsKey>(key.value);
}

// As --set takes it: a word of letters needs no quotes there.
std::string override_text(const Scene& scene, const SceneKey& key) {
  std::string text = value_text(scene, key);
  const bool is_word =
      text.size() > 2 && text.front() == '"' && text.back() == '"' &&
      std::all_of(text.begin() + 1, text.end() - 1, [](char c) { return (c >= 'a' && c <= 'z') || c == '-'; });
  return is_word ? text.substr(1, text.size() - 2) : text;
}

// What a set-up's scene is as text, key by key: made once and compared with every shipped scene.
class SetUpTexts {
 public:
  explicit SetUpTexts(const SetUp& set_up) : set_up_(set_up) {
    set_up_.scene.goal.points.back() = set_up_.goal;
    for (const SceneKey& key : scene_keys()) texts_.push_back(override_text(set_up_.scene, key));
  }

  // The words that make this scene of another; empty: there are none, since a key that is left out here stands there.
  std::optional<std::vector<std::string>> words_after(const Scene& base) const {
    std::vector<std::string> words;
    std::string moved_goal;
    for (std::size_t i = 0; i < texts_.size(); ++i) {
      const SceneKey& key = scene_keys()[i];
      if (is_words_about_scene(key) || has_option_of_its_own(key) || !belongs(key, set_up_.scene)) continue;
      if (belongs(key, base) && texts_[i] == override_text(base, key)) continue;
      if (!belongs(key, base) && key.is_omitted_when_default && texts_[i] == override_text(Scene{}, key)) continue;
      if (texts_[i].empty()) return std::nullopt;
      if (is_path(key) && only_end_differs(base, key)) {
        moved_goal = fmt::format("--goal-mm={}", position_mm_text(set_up_.goal));
      } else {
        words.push_back(fmt::format("--set {}", shell_word(fmt::format("{}={}", dotted_name(key), texts_[i]))));
      }
    }
    if (!moved_goal.empty()) words.push_back(std::move(moved_goal));
    const StrategyId active = set_up_.scene.settings.active;
    if (active != base.settings.active) words.push_back(fmt::format("--strategy {}", strategy(active).name));
    return words;
  }

 private:
  bool only_end_differs(Scene base, const SceneKey& key) const {
    if (base.goal.points.size() != set_up_.scene.goal.points.size()) return false;
    base.goal.points.back() = set_up_.goal;
    return override_text(base, key) == override_text(set_up_.scene, key);
  }

  SetUp set_up_;
  std::vector<std::string> texts_;  // of scene_keys()
};

// Of equally near ones the first is taken: the one with this title, then the default, then the first by name.
std::vector<const ShippedScene*> shipped_scenes_by_rank(std::string_view title) {
  std::vector<const ShippedScene*> scenes;
  for (const ShippedScene& shipped : shipped_scenes()) scenes.push_back(&shipped);
  std::ranges::sort(scenes, {}, [title](const ShippedScene* shipped) {
    const int rank = shipped->scene.title == title ? 0 : shipped->name == default_scene_name ? 1 : 2;
    return std::pair(rank, std::string_view(shipped->name));
  });
  return scenes;
}

// --- Reading ---

[[noreturn]] void refuse_line(std::string_view about, std::string what, std::string remedy = {}) {
  throw ReadError(ReadError::Kind::wrong,
                  {{.file = std::string(about), .what = std::move(what), .remedy = std::move(remedy)}});
}

// What the words of a line say, before any of it is looked up.
struct LineWords {
  std::optional<std::string> scene;
  std::vector<std::string> overrides;
  std::optional<std::string> goal;
  std::optional<std::string> strategy;
  std::optional<std::string> view;
  std::optional<std::string> mode;
};

struct LineOption {
  std::string_view name;
  std::optional<std::string> LineWords::*value;  // null: overrides
};
constexpr std::array line_options{
    LineOption{"--set", nullptr},
    LineOption{"--goal-mm", &LineWords::goal},
    LineOption{"--strategy", &LineWords::strategy},
    LineOption{"--view", &LineWords::view},
    LineOption{"--mode", &LineWords::mode},
};

// Each key needs one; the limit keeps a hostile text from taking minutes.
constexpr std::size_t most_overrides = 1000;

void take_option(LineWords& line, const LineOption& option, std::string value) {
  if (option.value == nullptr) {
    if (line.overrides.size() == most_overrides) refuse_line(option.name, "is given too often", "give each key once");
    line.overrides.push_back(std::move(value));
  } else if (line.*option.value) {
    refuse_line(option.name, "is given twice", "give it once");
  } else {
    line.*option.value = std::move(value);
  }
}

void take_scene(LineWords& line, const std::string& word) {
  if (line.scene) {
    refuse_line("", fmt::format("'{}' stands after the scene '{}'", quoted_text(word), quoted_text(*line.scene)),
                "give one scene, and the options with two dashes before their names");
  }
  line.scene = word;
}

// "ghostforce", "build/release/bin/ghostforce" and "./demo" start the program.
bool is_program(std::string_view word) noexcept {
  const std::string_view name = word.substr(word.rfind('/') + 1);
  return name == "ghostforce" || name == "demo";
}

// "$", "user@host:~$", "user@host ~ %", "[root@host /]#", "~/src>": what a terminal writes before a command. Words that
// only end in such a sign, as in "rm x # ghostforce run", begin like a command.
bool is_prompt(std::string_view text) noexcept {
  constexpr std::string_view signs = "$%#>";
  constexpr std::string_view meaningful = "$%#>;|&<`'\"\\";
  constexpr std::string_view seldom_in_command = "@~/:[(";
  if (text.empty() || signs.find(text.back()) == std::string_view::npos) return false;
  text.remove_suffix(1);
  if (text.find_first_of(meaningful) != std::string_view::npos) return false;
  const std::size_t end = text.find_first_of(" \t");
  return end == std::string_view::npos ||
         text.substr(0, end).find_first_of(seldom_in_command) != std::string_view::npos;
}

// A command is often copied with its prompt.
std::string_view without_prompt(std::string_view text) noexcept {
  text = trimmed(text);
  const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  for (std::size_t end = 0; end < line.size();) {
    const std::size_t begin = std::min(line.find_first_not_of(" \t", end), line.size());
    end = std::min(line.find_first_of(" \t", begin), line.size());
    if (!is_program(line.substr(begin, end - begin))) continue;
    if (begin == 0) return text;
    if (is_prompt(trimmed(line.substr(0, begin)))) return text.substr(begin);
  }
  return text.substr(text.starts_with("$ ") ? 2 : 0);
}

// "run" may follow the program.
std::span<const std::string> without_command(std::span<const std::string> words) {
  if (!words.empty() && is_program(words.front())) words = words.subspan(1);
  if (!words.empty() && words.front() == "run") words = words.subspan(1);
  return words;
}

LineWords read_words(std::span<const std::string> words) {
  LineWords line;
  while (!words.empty()) {
    const std::string& word = words.front();
    words = words.subspan(1);
    if (!word.starts_with('-')) {
      take_scene(line, word);
      continue;
    }
    const std::size_t equals = word.find('=');
    const std::string_view name = std::string_view(word).substr(0, equals);
    const auto* const option = std::ranges::find(line_options, name, &LineOption::name);
    if (option == line_options.end()) {
      const std::vector<std::string_view> known = names_of(line_options);
      refuse_line("", fmt::format("{} is not part of a set-up, which has {}{}", quoted_text(name), listed(known),
                                  did_you_mean(name, known)));
    }
    if (equals != std::string::npos) {
      take_option(line, *option, word.substr(equals + 1));
    } else if (words.empty()) {
      refuse_line(name, "its value is missing", "copy the whole line");
    } else {
      take_option(line, *option, words.front());
      words = words.subspan(1);
    }
  }
  return line;
}

// The entry of a catalog; `usual` where the option is not given.
template <typename Catalog, typename Id>
Id chosen_in(const Catalog& catalog, std::string_view option, const std::optional<std::string>& name, Id usual) {
  if (!name) return usual;
  if (std::string problem = not_one_of(*name, names_of(catalog)); !problem.empty()) {
    refuse_line(option, std::move(problem));
  }
  return std::ranges::find_if(catalog, [&](const auto& entry) { return entry.name == *name; })->id;
}

Scene scene_of(const LineWords& line) {
  const std::string name = line.scene.value_or(std::string(default_scene_name));
  if (std::string problem = not_one_of(name, shipped_scene_names()); !problem.empty()) {
    refuse_line("a set-up names a scene that comes with ghostforce", std::move(problem));
  }
  return load_scene(name, line.overrides);
}

}  // namespace

std::string set_up_line(const SetUp& set_up) {
  const SetUpTexts texts(set_up);
  std::string_view nearest;
  std::optional<std::vector<std::string>> fewest;
  for (const ShippedScene* const shipped : shipped_scenes_by_rank(set_up.scene.title)) {
    auto words = texts.words_after(shipped->scene);
    if (!words || (fewest && fewest->size() <= words->size())) continue;
    nearest = shipped->name;
    fewest = std::move(words);
  }
  std::string line = fmt::format("ghostforce run {}", nearest);
  for (const std::string& word : *fewest) line.append(" ").append(word);
  line += fmt::format(" --view {}", face_name(set_up.face));
  if (set_up.face == Face::stage && set_up.mode != StageMode::none) {
    line += fmt::format(" --mode {}", stage_mode_name(set_up.mode));
  }
  return line;
}

SetUp read_set_up_line(std::string_view text) {
  if (text.size() > largest_text_file) refuse_line("", "the text is too long for a set-up");
  if (const auto unshowable = unshowable_in(text, true)) refuse_line("", fmt::format("there is {} in it", *unshowable));
  ShellWords words = split_shell_words(without_prompt(text));
  if (!words.problem.empty()) refuse_line("", std::move(words.problem));
  if (words.words.empty()) refuse_line("", "there is no text", "give a line that begins with 'ghostforce run'");
  const LineWords line = read_words(without_command(words.words));

  SetUp set_up;
  set_up.scene = scene_of(line);
  set_up.scene.settings.active =
      chosen_in(strategy_catalog(), "--strategy", line.strategy, set_up.scene.settings.active);
  if (line.goal) {
    const auto goal = read_position_mm(*line.goal);
    if (!goal) refuse_line("--goal-mm", no_position_words("--goal-mm", *line.goal));
    set_up.scene.goal.points.back() = *goal;
  }
  set_up.goal = set_up.scene.goal.points.back();
  set_up.face = chosen_in(face_catalog, "--view", line.view, Face::stage);
  set_up.mode = chosen_in(stage_mode_catalog(), "--mode", line.mode, StageMode::none);
  if (set_up.face != Face::stage && set_up.mode != StageMode::none) {
    refuse_line("--mode", fmt::format("{} belongs to the stage", *line.mode), "leave out --view workbench");
  }
  return set_up;
}

std::optional<Vector<2>> read_position_mm(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const auto x = signed_number_in<double>(text.substr(0, comma));
  const auto y = signed_number_in<double>(text.substr(comma + 1));
  const auto fits = [](const std::optional<double>& mm) { return mm && std::abs(*mm) <= farthest_mm; };
  return fits(x) && fits(y) ? std::optional(Vector<2>(*x / mm_per_m, *y / mm_per_m)) : std::nullopt;
}

std::string no_position_words(std::string_view option, std::string_view text) {
  return fmt::format("{}: not a position; give two numbers from {} to {} mm, as in {}=-10,5", quoted_text(text),
                     -farthest_mm, farthest_mm, option);
}

std::string position_mm_text(const Vector<2>& position) {
  return fmt::format("{},{}", file_millimetres(position.x), file_millimetres(position.y));
}

}  // namespace ghostforce
