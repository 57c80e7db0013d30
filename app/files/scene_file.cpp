#include "app/files/scene_file.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include <fmt/format.h>

#include "app/base/number.h"
#include "app/files/named_text.h"
#include "app/files/toml_document.h"
#include "core/units.h"
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
  std::string operator()(const ChoiceKey& key) const { return toml_string(key.words[key.get(scene)]); }
  std::string operator()(const PointKey& key) const { return toml_point(key.in(scene)); }
  std::string operator()(const PointsKey& key) const { return toml_array(key.in(scene), toml_point); }
  std::string operator()(const TimesKey& key) const { return toml_array(key.in(scene), toml_number); }
  std::string operator()(const NumbersKey& key) const { return toml_array(key.in(scene), toml_number); }
  std::string operator()(const RangeKey& key) const { return toml_range(key.in(scene)); }
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

std::string scene_text(const Scene& scene) {
  Scene copy = scene;  // the catalog gives access to members, not views of them
  std::string text = "format = 1\n";
  std::string_view table;
  for (const SceneKey& key : scene_keys()) {
    const std::string value = std::visit(ValueText{copy}, key.value);
    if (value.empty() || (key.is_omitted_when_default && value == value_text(Scene{}, key))) continue;
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

}  // namespace ghostforce
