#include "app/files/scene_reader.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include "app/console/did_you_mean.h"
#include "app/console/failure.h"
#include "app/console/quoted.h"
#include "app/console/unicode.h"
#include "app/files/first_problems.h"
#include "app/files/scene_keys.h"
#include "app/files/scene_override.h"
#include "app/files/toml_text.h"

namespace ghostforce {
namespace {

constexpr std::int64_t known_format = 1;
constexpr std::string_view format_name = "format";

// Where something is wrong; sorts as a person reads.
struct Place {
  std::size_t override_number = 0;  // 0: in the file; else the how manieth --set
  toml::source_index line = 1;
  toml::source_index column = 1;

  auto operator<=>(const Place&) const = default;
};

// What was given for a key, in the file or by --set.
struct Given {
  const toml::node* node = nullptr;
  std::size_t override_number = 0;
};

struct Limits {
  double least = -std::numeric_limits<double>::max();
  double greatest = std::numeric_limits<double>::max();
  std::string_view unit;
  bool may_be_infinite = false;
  bool whole = false;
};

std::string range_words(const Limits& limits) {
  constexpr double any = std::numeric_limits<double>::max();
  if (limits.least == -any && limits.greatest == any) {
    return limits.unit.empty() ? "any finite number" : fmt::format("a finite number of {}", limits.unit);
  }
  return fmt::format("{} to {}{}{}{}", limits.least, limits.greatest, limits.unit.empty() ? "" : " ", limits.unit,
                     limits.may_be_infinite ? ", or inf" : "");
}

class SceneReader {
 public:
  SceneReader(std::string_view shown_path, std::span<const std::string> overrides)
      : shown_path_(printable(shown_path, longest_path)), overrides_(overrides) {}

  Scene read(std::string_view text) {
    if (!parse(text)) return finish();
    if (file_.empty()) {
      complain({}, "the file is empty; begin it with format = 1, or start from a copy of a shipped scene");
      return finish();
    }
    read_overrides();
    if (!read_format()) return finish();
    find_unknown();
    find_missing();
    for (const SceneKey& key : scene_keys()) {
      const Given given = given_for(key.table, key.name);
      if (given.node == nullptr) continue;
      key_ = &key;
      given_ = given;
      std::visit([this](const auto& value) { read_value(value); }, key.value);
    }
    if (problems_.empty()) {
      if (const std::optional<SceneProblem> problem = find_problem(scene_)) {
        const Given given = given_for(problem->table, problem->name);
        complain(place_of(given),
                 fmt::format("the key {}: {}", dotted_name(problem->table, problem->name), problem->what));
      }
    }
    return finish();
  }

 private:
  // --- Telling what is wrong ---

  // `what` is a text, or a function that makes it.
  template <typename Words>
  void complain(Place place, Words what) {
    problems_.add(place, std::move(what));
  }

  // About the key that is being read, at `node`, which is its value or part of it.
  void complain_at(const toml::node& node, const std::string& what) {
    complain(place_of({&node, given_.override_number}),
             fmt::format("the key {}: {}", dotted_name(key_->table, key_->name), what));
  }

  static Place place_of(toml::source_position position) {
    return {0, std::max<toml::source_index>(position.line, 1), std::max<toml::source_index>(position.column, 1)};
  }

  static Place place_of(const Given& given) {
    if (given.override_number > 0) return {given.override_number, 1, 1};
    return given.node == nullptr ? Place{} : place_of(given.node->source().begin);
  }

  std::string shown(const Place& place) const {
    if (place.override_number > 0) {
      const std::string& override = overrides_[place.override_number - 1];
      return fmt::format("--set {}", printable(override));
    }
    return fmt::format("{}:{}:{}", shown_path_, place.line, place.column);
  }

  Scene finish() {
    if (problems_.empty()) return std::move(scene_);
    const auto lines = problems_.lines([this](const Place& place) { return shown(place); });
    throw Failure(ExitCode::wrong_call, fmt::format("{}", fmt::join(lines, "\n")));
  }

  // --- The file and --set as TOML ---

  bool parse(std::string_view text) {
    ParsedToml parsed = parse_toml(text);
    if (parsed.problem) complain(place_of(parsed.problem->position), parsed.problem->what);
    file_ = std::move(parsed.table);
    return problems_.empty();
  }

  void read_overrides() {
    for (std::size_t i = 0; i < overrides_.size(); ++i) {
      std::variant<SceneOverride, std::string> parsed = parse_override(overrides_[i]);
      if (const std::string* const what = std::get_if<std::string>(&parsed)) {
        complain({i + 1, 1, 1}, *what);
      } else {
        overriding_.emplace_back(i + 1, std::move(std::get<SceneOverride>(parsed)));
      }
    }
  }

  Given given_for(std::string_view table, std::string_view name) const {
    for (auto override = overriding_.rbegin(); override != overriding_.rend(); ++override) {
      const auto& [number, parsed] = *override;
      if (parsed.key == dotted_name(table, name)) return {parsed.value.get("value"), number};
    }
    const toml::table* const in = table.empty() ? &file_ : file_[table].as_table();
    return {in == nullptr ? nullptr : in->get(name), 0};
  }

  // --- What is there and what is not ---

  // False: nothing else in the file can be relied on.
  bool read_format() {
    const Given given = given_for("", format_name);
    const toml::value<std::int64_t>* const number = given.node == nullptr ? nullptr : given.node->as_integer();
    if (given.node == nullptr) {
      complain({}, "the key format is missing; begin the file with format = 1");
    } else if (number == nullptr) {
      complain(place_of(given), fmt::format("the key format: is {}; write format = 1", type_words(given.node->type())));
    } else if (number->get() != known_format) {
      complain(place_of(given),
               fmt::format("the key format: is {}, and this program knows format 1 only; a newer one may read it",
                           number->get()));
      return false;
    }
    return true;
  }

  void find_unknown() {
    for (const auto& [key, node] : file_) {
      const std::string_view name = key.str();
      const Place place = place_of(key.source().begin);
      if (is_scene_table(name)) {
        if (const toml::table* const table = node.as_table()) {
          find_unknown_in(name, *table);
        } else {
          complain(place, fmt::format("{} is {}, and must be a table; write [{}] on a line of its own", name,
                                      type_words(node.type()), name));
        }
      } else if (node.is_table()) {
        complain(place, [name] {
          std::vector<std::string_view> tables;
          for (const SceneKey& known : scene_keys()) tables.push_back(known.table);
          return fmt::format("the table [{}] is unknown{}", printable(name), did_you_mean(name, tables));
        });
      } else if (name != format_name && find_scene_key("", name) == nullptr) {
        complain(place, [name] {
          return fmt::format("the key {} is unknown{}", printable(name), suggest_scene_key("", name));
        });
      }
    }
  }

  void find_unknown_in(std::string_view table_name, const toml::table& table) {
    for (const auto& [key, node] : table) {
      const std::string_view name = key.str();
      if (find_scene_key(table_name, name) != nullptr) continue;
      complain(place_of(key.source().begin), [table_name, name] {
        return fmt::format("the key {}.{} is unknown{}", table_name, printable(name),
                           suggest_scene_key(table_name, name));
      });
    }
  }

  void find_missing() {
    std::vector<std::string_view> absent_tables;
    for (const SceneKey& key : scene_keys()) {
      if (!key.required || given_for(key.table, key.name).node != nullptr) continue;
      if (key.table.empty()) {
        complain({}, fmt::format("the key {} is missing", key.name));
      } else if (const toml::node* const table = file_.get(key.table)) {
        if (table->is_table()) {
          complain(place_of({table, 0}), fmt::format("the key {}.{} is missing", key.table, key.name));
        }
      } else if (std::find(absent_tables.begin(), absent_tables.end(), key.table) == absent_tables.end()) {
        absent_tables.push_back(key.table);
        complain({}, fmt::format("the table [{}] is missing", key.table));
      }
    }
  }

  // --- Values ---

  std::optional<double> read_number(const toml::node& node, const Limits& limits) {
    const std::string need = fmt::format("give {}{}", limits.whole ? "a whole number, " : "", range_words(limits));
    double number = 0.0;
    if (const auto* const integer = node.as_integer()) {
      number = static_cast<double>(integer->get());
    } else if (const auto* const real = node.as_floating_point()) {
      number = real->get();
      if (limits.whole && std::isfinite(number)) {
        complain_at(node, fmt::format("has a decimal point or an exponent; {}", need));
        return std::nullopt;
      }
    } else {
      complain_at(node, fmt::format("is {}; {}", type_words(node.type()), need));
      return std::nullopt;
    }
    if (limits.may_be_infinite && number == std::numeric_limits<double>::infinity()) return number;
    // Written so that NaN is out of range too.
    if (!(number >= limits.least && number <= limits.greatest)) {
      complain_at(node, fmt::format("{} is out of range; {}", number, need));
      return std::nullopt;
    }
    return number;
  }

  // [x, y] in mm -> m.
  std::optional<Vector<2>> read_point(const toml::node& node) {
    constexpr double mm_per_m = 1000.0;
    const toml::array* const numbers = node.as_array();
    if (numbers == nullptr || numbers->size() != 2) {
      complain_at(node, fmt::format("is {}; give a position as [x, y]",
                                    numbers == nullptr ? std::string(type_words(node.type()))
                                                       : fmt::format("an array of {}", numbers->size())));
      return std::nullopt;
    }
    const Limits limits{-farthest_mm, farthest_mm, "mm"};
    const std::optional<double> x = read_number((*numbers)[0], limits);
    const std::optional<double> y = read_number((*numbers)[1], limits);
    if (!x || !y) return std::nullopt;
    return Vector<2>(*x / mm_per_m, *y / mm_per_m);
  }

  // Null after having said so: it must be an array of one or more.
  const toml::array* read_array(const toml::node& node, std::string_view of_what) {
    const toml::array* const array = node.as_array();
    if (array == nullptr || array->empty()) {
      complain_at(node, fmt::format("is {}; give an array of one or more {}",
                                    array == nullptr ? type_words(node.type()) : "empty", of_what));
      return nullptr;
    }
    return array;
  }

  std::optional<std::string> read_text(const toml::node& node, std::string_view need) {
    if (const auto* const text = node.as_string()) return text->get();
    complain_at(node, fmt::format("is {}; give {}", type_words(node.type()), need));
    return std::nullopt;
  }

  void read_value(const NumberKey& key) {
    const Limits limits{key.least, key.greatest, unit_of(key_->name), key.may_be_infinite, key.whole};
    if (const auto number = read_number(*given_.node, limits)) key.in(scene_) = *number / key.per_si;
  }

  void read_value(const OptionalNumberKey& key) {
    if (!key.word_for_empty.empty()) {
      if (const auto* const word = given_.node->as_string()) {
        if (word->get() == key.word_for_empty) {
          key.in(scene_) = std::nullopt;
        } else {
          complain_at(*given_.node, fmt::format("is '{}'; give '{}' or {}", printable(word->get()), key.word_for_empty,
                                                range_words({key.least, key.greatest, unit_of(key_->name)})));
        }
        return;
      }
    }
    if (const auto number = read_number(*given_.node, {key.least, key.greatest, unit_of(key_->name)})) {
      key.in(scene_) = *number;
    }
  }

  void read_value(const TextKey& key) {
    auto text = read_text(*given_.node, "a text in quotes");
    if (!text) return;
    if (const auto what = unshowable_in(*text, key.may_have_lines)) {
      complain_at(*given_.node, fmt::format("holds {}; remove it", *what));
    }
    key.in(scene_) = std::move(*text);
  }

  void read_value(const ChoiceKey& key) {
    const auto word = read_text(*given_.node, fmt::format("one of {}", listed(key.words)));
    if (!word) return;
    const auto found = std::find(key.words.begin(), key.words.end(), *word);
    if (found == key.words.end()) {
      complain_at(*given_.node, fmt::format("'{}' is none of {}{}", printable(*word), listed(key.words),
                                            did_you_mean(*word, key.words)));
    } else {
      key.set(scene_, static_cast<std::size_t>(found - key.words.begin()));
    }
  }

  void read_value(const PointKey& key) {
    if (const auto point = read_point(*given_.node)) key.in(scene_) = *point;
  }

  void read_value(const PointsKey& key) {
    const toml::array* const array = read_array(*given_.node, "positions, [[x, y], …]");
    if (array == nullptr) return;
    std::vector<Vector<2>> points;
    for (const toml::node& node : *array) {
      if (const auto point = read_point(node)) points.push_back(*point);
    }
    key.in(scene_) = std::move(points);
  }

  void read_value(const TimesKey& key) {
    const toml::array* const array = read_array(*given_.node, "times, [0.0, …]");
    if (array == nullptr) return;
    std::vector<double> times;
    for (const toml::node& node : *array) {
      const auto time = read_number(node, {.unit = unit_of(key_->name)});
      if (!time) return;
      if (times.empty() && *time != 0.0) {
        complain_at(node, fmt::format("the first time is {} s; it must be 0", *time));
      } else if (!times.empty() && !(*time > times.back())) {
        complain_at(node, fmt::format("{} s comes after {} s; times must increase", *time, times.back()));
      }
      times.push_back(*time);
    }
    key.in(scene_) = std::move(times);
  }

  std::string shown_path_;
  std::span<const std::string> overrides_;
  toml::table file_;
  std::vector<std::pair<std::size_t, SceneOverride>> overriding_;  // how manieth --set, and what it says
  FirstProblems<Place> problems_;
  Scene scene_;
  const SceneKey* key_ = nullptr;  // being read
  Given given_;                    // its value
};

}  // namespace

Scene read_scene(std::string_view text, std::string_view shown_path, std::span<const std::string> overrides) {
  return SceneReader(shown_path, overrides).read(text);
}

}  // namespace ghostforce
