#include "app/files/scene_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "app/base/number.h"
#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/files/named_text.h"
#include "app/files/scene_keys.h"
#include "app/files/toml_document.h"
#include "core/conventions.h"
#include "embedded_scenes.h"

namespace ghostforce {
namespace {

// The number of file units from which the reader makes exactly this SI value, in as few digits as possible; the nearest
// one where there is none.
double file_value(double si, double per_si) {
  if (per_si == 1.0 || !std::isfinite(si)) return si;
  const double exact = si * per_si;
  for (int digits = 1; digits <= 17; ++digits) {
    const std::string text = fmt::format("{:.{}g}", exact, digits);
    const double candidate = read_number(text).value_or(0.0);
    if (candidate / per_si == si) return candidate;
  }
  return exact;
}

// A real number as TOML has it: what looks like an integer loses the sign of zero.
std::string toml_number(double value) {
  std::string text = fmt::format("{}", value);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

std::string toml_point(const Vector<2>& point) {
  return fmt::format("[{}, {}]", toml_number(file_value(point.x, mm_per_m)),
                     toml_number(file_value(point.y, mm_per_m)));
}

std::string toml_pair(const std::array<double, 2>& pair, double per_si) {
  return fmt::format("[{}, {}]", toml_number(file_value(pair[0], per_si)), toml_number(file_value(pair[1], per_si)));
}

std::string toml_range(const NumberRange& range) {
  return fmt::format("[{}, {}]", toml_number(range.least), toml_number(range.greatest));
}

// Empty for none.
template <typename Values, typename Words>
std::string toml_array(const Values& values, Words&& words_of) {
  std::string text;
  for (const auto& value : values) text += (text.empty() ? "" : ", ") + words_of(value);
  return text.empty() ? text : "[" + text + "]";
}

// The value of a key as TOML; empty: left out.
struct ValueText {
  Scene& scene;

  std::string operator()(const NumberKey& key) const {
    const double value = file_value(key.in(scene), key.per_si);
    return key.whole ? fmt::format("{:.0f}", value) : toml_number(value);
  }
  std::string operator()(const OptionalNumberKey& key) const {
    if (const std::optional<double>& value = key.in(scene)) return toml_number(*value);
    return key.word_for_empty.empty() ? "" : toml_string(key.word_for_empty);
  }
  std::string operator()(const TextKey& key) const { return toml_string(key.in(scene)); }
  std::string operator()(const ChoiceKey& key) const { return toml_string(words_of(key, scene)[key.get(scene)]); }
  std::string operator()(const PointKey& key) const { return toml_point(key.in(scene)); }
  std::string operator()(const PointsKey& key) const { return toml_array(key.in(scene), toml_point); }
  std::string operator()(const TimesKey& key) const { return toml_array(key.in(scene), toml_number); }
  std::string operator()(const NumbersKey& key) const { return toml_array(key.in(scene), toml_number); }
  std::string operator()(const RangeKey& key) const { return toml_range(key.in(scene)); }
  std::string operator()(const PairKey& key) const { return toml_pair(key.in(scene), key.per_si); }
  std::string operator()(const PointPairKey& key) const { return toml_array(key.in(scene), toml_point); }
  std::string operator()(const AnchorsKey& key) const {
    const Strings& strings = key.in(scene);
    return toml_array(std::span(strings.anchors).first(strings.count), toml_point);
  }
};

// Replaces each value of a key by what reading its text gives.
struct Rounding {
  Scene& scene;

  static void round(double& si, double per_si) { si = file_value(si, per_si) / per_si; }
  static void round(Vector<2>& point) {
    round(point.x, mm_per_m);
    round(point.y, mm_per_m);
  }
  void operator()(const NumberKey& key) const { round(key.in(scene), key.per_si); }
  void operator()(const PointKey& key) const { round(key.in(scene)); }
  void operator()(const PointsKey& key) const {
    for (Vector<2>& point : key.in(scene)) round(point);
  }
  void operator()(const PairKey& key) const {
    for (double& number : key.in(scene)) round(number, key.per_si);
  }
  void operator()(const PointPairKey& key) const {
    for (Vector<2>& point : key.in(scene)) round(point);
  }
  void operator()(const AnchorsKey& key) const {
    for (Vector<2>& point : key.in(scene).anchors) round(point);
  }
  template <typename Other>
  void operator()(const Other&) const {}
};

}  // namespace

std::vector<std::string_view> shipped_scene_names() {
  std::vector<std::string_view> names = names_of_texts(embedded_scenes);
  std::sort(names.begin(), names.end());
  return names;
}

bool may_be_scene(const std::string& name_or_path) {
  return find_text(embedded_scenes, name_or_path) != nullptr || name_or_path.find('/') != std::string::npos ||
         name_or_path.ends_with(".toml") || access(name_or_path.c_str(), F_OK) == 0;
}

Scene load_scene(const std::string& name_or_path, std::span<const std::string> overrides) {
  return read_scene(named_text(name_or_path, "scene", embedded_scenes), name_or_path, overrides);
}

namespace {

// Whether a file of the scene tells that key, with that value.
bool is_told(const Scene& scene, const SceneKey& key, std::string_view value) {
  if (value.empty() || !belongs(key, scene)) return false;
  return !key.is_omitted_when_default || value != value_text(Scene{}, key);
}

}  // namespace

int format_of(const Scene& scene) {
  return is_general(scene.settings) ? 2 : 1;
}

std::string scene_text(const Scene& scene) {
  Scene copy = scene;  // the catalog gives access to members, not views of them
  std::string text = fmt::format("format = {}\n", format_of(scene));
  std::string_view table;
  for (const SceneKey& key : scene_keys()) {
    const std::string value = std::visit(ValueText{copy}, key.value);
    if (!is_told(scene, key, value)) continue;
    if (key.table != table) {
      table = key.table;
      text += fmt::format("\n[{}]\n", table);
    }
    text += fmt::format("{} = {}\n", key.name, value);
  }
  return text;
}

std::string value_text(Scene scene, const SceneKey& key) {
  return std::visit(ValueText{scene}, key.value);
}

double file_millimetres(double metres) {
  return file_value(metres, mm_per_m);
}

Scene rounded_to_file(Scene scene) {
  for (const SceneKey& key : scene_keys()) std::visit(Rounding{scene}, key.value);
  return scene;
}

namespace {

// [x, y] in mm -> m.
std::optional<Vector<2>> read_point(const TomlValue& value) {
  const auto mm = value.numbers<2>({-farthest_mm, farthest_mm, "mm"}, "give a position as [x, y]");
  return mm ? std::optional(Vector<2>((*mm)[0] / mm_per_m, (*mm)[1] / mm_per_m)) : std::nullopt;
}

// How many elements an array has: none where it is wrong, which has been told then.
std::size_t read_count(const TomlValue& value, std::string_view of_what) {
  const std::string remedy = fmt::format("give an array of one or more {}", of_what);
  const std::optional<std::size_t> count = value.count(remedy);
  if (count == 0) value.refuse("is empty", remedy);
  return count.value_or(0);
}

// A value into the scene, one function per kind of key.
struct ValueReader {
  Scene& scene;
  const TomlValue& value;
  NumberLimits limits;

  void operator()(const NumberKey& key) const {
    if (const auto number = value.number(limits)) key.in(scene) = *number / key.per_si;
  }

  void operator()(const OptionalNumberKey& key) const {
    const std::string* const word = key.word_for_empty.empty() ? nullptr : value.as_text();
    if (word == nullptr) {
      key.in(scene) = value.number(limits);
    } else if (*word == key.word_for_empty) {
      key.in(scene) = std::nullopt;
    } else {
      value.refuse(fmt::format("is '{}'", quoted_text(*word)),
                   fmt::format("give '{}' or {}", key.word_for_empty, range_words(limits)));
    }
  }

  void operator()(const TextKey& key) const { key.in(scene) = value.text(key.may_have_lines).value_or(""); }

  void operator()(const ChoiceKey& key) const {
    if (const auto word = value.word(words_of(key, scene))) key.set(scene, *word);
  }

  void operator()(const PointKey& key) const { key.in(scene) = read_point(value).value_or(Vector<2>(0.0)); }

  void operator()(const PointsKey& key) const {
    const std::size_t count = read_count(value, "positions, [[x, y], …]");
    for (std::size_t i = 0; i < count; ++i) key.in(scene).push_back(read_point(value[i]).value_or(Vector<2>(0.0)));
  }

  void operator()(const TimesKey& key) const {
    std::vector<double>& times = key.in(scene);
    const std::size_t count = read_count(value, "times, [0.0, …]");
    for (std::size_t i = 0; i < count; ++i) {
      const auto time = value[i].number(limits);
      if (!time) return;
      if (times.empty() && *time != 0.0) {
        value[i].refuse(fmt::format("the first time is {} s", *time), "it must be 0");
      } else if (!times.empty() && !(*time > times.back())) {
        value[i].refuse(fmt::format("{} s comes after {} s", *time, times.back()), "times must increase");
      }
      times.push_back(*time);
    }
  }

  void operator()(const NumbersKey& key) const {
    const NumberLimits each{key.range.least, key.range.greatest, limits.unit};
    const std::size_t count = read_count(value, "numbers");
    for (std::size_t i = 0; i < count; ++i) key.in(scene).push_back(value[i].number(each).value_or(each.least));
  }

  void operator()(const PairKey& key) const {
    const auto pair = value.numbers<2>({key.least, key.greatest, limits.unit}, "give two numbers, as in [160, 120]");
    if (pair) key.in(scene) = {(*pair)[0] / key.per_si, (*pair)[1] / key.per_si};
  }

  void operator()(const PointPairKey& key) const {
    constexpr std::string_view remedy = "give two positions, [[x, y], [x, y]]";
    const std::optional<std::size_t> count = value.count(remedy);
    if (!count) return;
    if (*count != 2) return value.refuse(fmt::format("has {} elements", *count), remedy);
    for (std::size_t i = 0; i < 2; ++i) key.in(scene)[i] = read_point(value[i]).value_or(Vector<2>(0.0));
  }

  void operator()(const AnchorsKey& key) const {
    constexpr std::string_view remedy = "give one to four positions, [[x, y], …]";
    const std::optional<std::size_t> count = value.count(remedy);
    if (!count) return;
    if (*count < 1 || *count > most_motors) return value.refuse(fmt::format("has {} elements", *count), remedy);
    Strings& strings = key.in(scene);
    strings.count = static_cast<std::uint32_t>(*count);
    for (std::size_t i = 0; i < *count; ++i) strings.anchors[i] = read_point(value[i]).value_or(Vector<2>(0.0));
  }

  void operator()(const RangeKey& key) const {
    const auto ends =
        value.numbers<2>({key.range.least, key.range.greatest, limits.unit}, "give a range as [least, greatest]");
    if (!ends) return;
    const auto [least, greatest] = *ends;
    if (least > greatest) {
      value.refuse(fmt::format("{} {} comes before {} {}", least, limits.unit, greatest, limits.unit),
                   "give the smaller number first");
    }
    key.in(scene) = {least, greatest};
  }
};

// Keys and kinds that the format has, and this version has not.
struct LaterKey {
  std::string_view table;
  std::string_view name;
};
constexpr std::array later_keys{
    LaterKey{"wall", "friction"},
    LaterKey{"wall", "points_mm"},
    LaterKey{"device", "tip_mm"},
    LaterKey{"device", "motors"},
    LaterKey{"device", "inertia_kg_m2"},
    LaterKey{"device", "damping_N_m_s_per_rad"},
    LaterKey{"user", "k_u_angle_N_m_per_rad"},
    LaterKey{"rendering", "k_r_angle_N_m_per_rad"},
};
constexpr std::array<std::string_view, 2> later_kinds{"polyline", "stylus"};

constexpr std::string_view follows_later = "follows in a later version";

bool is_later_key(std::string_view dotted) {
  return std::ranges::any_of(later_keys,
                             [dotted](const LaterKey& key) { return dotted_name(key.table, key.name) == dotted; });
}

// KEY=VALUE, blanks around both allowed.
void read_override(TomlReader& reader, std::string_view argument) {
  const std::size_t equals = argument.find('=');
  const std::string_view name = trimmed(argument.substr(0, equals));
  const SceneKey* const key = find_scene_key(name);
  if (equals == std::string_view::npos || name.empty()) {
    reader.refuse_override(argument, "give KEY=VALUE, for example rendering.k_r_N_per_m=800", "");
  } else if (is_later_key(name)) {
    reader.refuse_override(argument, fmt::format("the key {} {}", name, follows_later), "leave it out");
  } else if (key == nullptr && name != "format") {
    reader.refuse_override(argument, fmt::format("the key {} is unknown", quoted_text(name)), suggest_scene_key(name));
  } else {
    const bool holds_text = key != nullptr && (std::holds_alternative<TextKey>(key->value) ||
                                               std::holds_alternative<ChoiceKey>(key->value));
    reader.override_key(argument, name, trimmed(argument.substr(equals + 1)), holds_text);
  }
}

// One reading of a file: what its tables' kinds are, and what each key does about that.
class SceneReading {
 public:
  SceneReading(TomlReader& reader, Scene& scene) : reader_(reader), scene_(scene) {
    constexpr std::int64_t newest_format = 2;
    const auto format = reader_.find("", "format");
    is_newest_ = format ? format->as_integer() == newest_format : has_newer_key();
    if (!reader_.has_known_format(newest_format, is_newest_ ? newest_format : 1)) reader_.finish();
  }

  void read() {
    keys_.push_back({"", "format", nullptr});
    for (const SceneKey& key : scene_keys()) add(key);
    for (const LaterKey& key : later_keys) {
      keys_.push_back(
          {key.table, key.name, [](const TomlValue& value) { value.refuse(follows_later, "leave it out"); }});
    }
    reader_.read(keys_, [this](std::string_view table, std::string_view name) {
      return suggest_scene_key(table, name, of_these_kinds_);
    });
    refuse_mixture();
    reader_.finish();
  }

  void refuse(const SceneProblem& problem) {
    reader_.find(problem.table, problem.name)->refuse(problem.what, problem.remedy);
    reader_.finish();
  }

 private:
  bool has_newer_key() const {
    return std::ranges::any_of(scene_keys(), [this](const SceneKey& key) {
      const auto value = key.format > 1 ? reader_.find(key.table, key.name) : std::nullopt;
      return value && !value->is_override();
    });
  }

  // Of the file; empty: it is none that is known.
  std::string_view kind_in_file(std::string_view table) {
    const std::span<const std::string_view> kinds = kinds_of(table);
    if (kinds.empty()) return {};
    const auto value = reader_.find(table, "kind");
    if (!value) return kinds.front();
    if (value->is_override()) overridden_.push_back(table);
    const std::string* const word = value->as_text();
    const auto found = word == nullptr ? kinds.end() : std::ranges::find(kinds, *word);
    return found == kinds.end() ? std::string_view() : *found;
  }

  void add(const SceneKey& key) {
    const std::string_view kind = kind_in_file(key.table);
    const bool is_kind_known = !kind.empty() || kinds_of(key.table).empty();
    const bool is_wanted = belongs_to_kind(key, kind);
    if (is_wanted || !is_kind_known) of_these_kinds_.push_back(&key);
    const auto read = [this, &key, kind, is_kind_known, is_wanted](const TomlValue& value) {
      if (key.name == "kind" && is_later_kind(value)) return;
      if (key.format > 1 && !is_newest_ && !value.is_override()) {
        value.refuse("is of format 2", "write format = 2 at the top of the file");
      } else if (is_wanted) {
        std::visit(ValueReader{scene_, value, limits_of(key).value_or(NumberLimits{.unit = unit_of(key.name)})},
                   key.value);
      } else if (is_kind_known && (value.is_override() || !is_kind_overridden(key.table))) {
        value.refuse(wrong_kind_text(key, kind),
                     fmt::format("leave it out, or write kind = \"{}\"", key.kinds.substr(0, key.kinds.find(' '))));
      }
    };
    keys_.push_back({key.table, key.name, read,
                     key.required && is_wanted && is_kind_known ? std::optional(std::string_view()) : std::nullopt});
  }

  bool is_kind_overridden(std::string_view table) const {
    return std::ranges::find(overridden_, table) != overridden_.end();
  }

  static bool is_later_kind(const TomlValue& value) {
    const std::string* const word = value.as_text();
    if (word == nullptr || std::ranges::find(later_kinds, *word) == later_kinds.end()) return false;
    value.refuse(fmt::format("is '{}', which {}", *word, follows_later), "choose another kind");
    return true;
  }

  // Keys that each make sense alone.
  void refuse_mixture() {
    const auto ratio = reader_.find("rendering", "tracking_ratio");
    if (ratio && is_general(scene_.settings) && (is_newest_ || ratio->is_override())) {
      ratio->refuse("belongs to scenes of format 1",
                    "write compliance_share instead: 0 is naïve rendering, 1 the cure");
    }
    const auto first = reader_.find("user", "k_u_first_deg");
    // Where another key is wrong, it may be the second stiffness.
    if (first && !scene_.settings.general.k_u_second && reader_.problems().empty()) {
      first->refuse("is the direction of a hand with two stiffnesses", "give k_u_second_N_per_m too, or leave it out");
    }
  }

  TomlReader& reader_;
  Scene& scene_;
  bool is_newest_ = false;
  std::vector<TomlKey> keys_;
  SceneKeys of_these_kinds_;
  std::vector<std::string_view>
      overridden_;  // tables whose kind is another than the file's: its keys of that say nothing
};

}  // namespace

Scene read_scene(std::string_view text, std::string_view shown_path, std::span<const std::string> overrides,
                 SceneChecks asks) {
  Scene scene;
  TomlReader reader(shown_path);
  if (!reader.parse(text)) reader.finish();
  if (reader.is_empty()) {
    reader.refuse("the file is empty", "start it with format = 1, or start from a copy of a shipped scene");
    reader.finish();
  }
  for (const std::string& override : overrides) read_override(reader, override);
  SceneReading reading(reader, scene);
  reading.read();
  std::optional<SceneProblem> problem = find_problem(scene);
  if (!problem && asks == SceneChecks::all) problem = find_workspace_problem(scene);
  if (problem) reading.refuse(*problem);
  return scene;
}

}  // namespace ghostforce
