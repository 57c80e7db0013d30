#include "app/tools/check/case_file.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <memory>
#include <span>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/files/input_file.h"
#include "app/files/named_text.h"
#include "app/files/scene_file.h"
#include "app/files/toml_document.h"
#include "app/state/lesson_file.h"
#include "app/state/permit.h"
#include "app/state/stage_language.h"

namespace ghostforce {
namespace {

// What may have been meant by the name of a scene that is none: a file in the subfolder that it names (what lies beside
// a case is a case), or a shipped scene.
std::string scene_hint(const std::filesystem::path& name, const std::filesystem::path& case_folder) {
  namespace fs = std::filesystem;
  const std::vector<std::string_view> shipped = shipped_scene_names();
  if (name.has_parent_path()) {
    const auto name_of = [](const fs::path& file) {
      return file.extension() == ".toml" ? file.filename().string() : "";
    };
    if (const auto near = nearest_name_in(case_folder / name.parent_path(), name.filename().string(), name_of)) {
      return fmt::format("did you mean '{}'?", quoted_text((name.parent_path() / *near).string(), longest_path));
    }
  }
  const bool is_file = name.extension() == ".toml";
  const std::string near = did_you_mean((is_file ? name.stem() : name.filename()).string(), shipped);
  return near.empty() ? fmt::format("give a path relative to this file, or one of {}", listed(shipped)) : near;
}

bool is_one_of(std::string_view name, std::span<const std::string_view> shipped) {
  return std::ranges::find(shipped, name) != shipped.end();
}

// None where one of them is no text, so that each stands where it stands in the file.
std::vector<std::string> read_overrides(const std::optional<TomlValue>& set) {
  constexpr std::string_view need = R"(give strings, as in ["wall.normal_deg=120"])";
  constexpr std::size_t most = 1000;  // a scene has some thirty keys
  const std::size_t count = set ? set->count(need).value_or(0) : 0;
  if (count > most) {
    set->refuse(fmt::format("has {} strings", count), fmt::format("give {} at most", most));
    return {};
  }
  std::vector<std::string> overrides;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string* const text = (*set)[i].as_text();
    if (text == nullptr) {
      (*set)[i].refuse_type(need, "contains");
      return {};
    }
    overrides.push_back(*text);
  }
  return overrides;
}

// Where a scene or a lesson lies that a case names; empty for one that is shipped.
std::string path_of(const std::string& name, std::span<const std::string_view> shipped,
                    const std::filesystem::path& folder) {
  return is_one_of(name, shipped) ? "" : (folder / name).string();
}

// What the scene's reader tells becomes a problem of the key that names the scene, or of the one value set.
Scene load_scene_of(const TomlValue& named, const std::optional<TomlValue>& set, const std::filesystem::path& folder) {
  const std::optional<std::string> name = named.text();
  const std::vector<std::string> overrides = read_overrides(set);
  if (!name) return {};
  const std::string path = path_of(*name, shipped_scene_names(), folder);
  std::error_code unknown;
  if (!path.empty() && std::filesystem::status(path, unknown).type() == std::filesystem::file_type::not_found) {
    named.refuse(words_of_missing_text("scene", *name), scene_hint(*name, folder));
    return {};
  }
  try {
    return load_scene(path.empty() ? *name : path, overrides);
  } catch (const ReadError& error) {
    for (ReadProblem problem : error.problems()) {
      const std::string remedy = std::exchange(problem.remedy, "");
      if (error.kind() == ReadError::Kind::unreadable) {
        ReadProblem here = named.place();
        here.what = "the key scene: " + words_of(problem);
        here.remedy = remedy;
        throw ReadError(error.kind(), {here});
      }
      const auto is_about = [&](const std::string& override) {
        return problem.file == "--set " + quoted_text(override);
      };
      const auto blamed = std::find_if(overrides.begin(), overrides.end(), is_about);
      if (blamed == overrides.end()) {
        named.refuse(words_of(problem), remedy);
      } else {
        (*set)[static_cast<std::size_t>(blamed - overrides.begin())].refuse(
            fmt::format("{}{}{}", quoted_text(*blamed), problem.joint, problem.what), remedy);
      }
    }
    return {};
  }
}

// Of a picture of that size; none where one of them is wrong.
std::vector<PixelBox> read_mask(const TomlValue& mask, int width, int height) {
  constexpr std::string_view need = "give rectangles [x, y, width, height] in pixels, as in [[0, 0, 200, 40]]";
  constexpr std::size_t most = 100;  // a mask that says where pictures may differ, not a second picture
  const std::size_t count = mask.count(need).value_or(0);
  if (count > most) {
    mask.refuse(fmt::format("has {} rectangles", count), fmt::format("give {} at most", most));
    return {};
  }
  std::vector<PixelBox> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const auto numbers = mask[i].numbers<4>({.least = 0.0, .greatest = largest_picture, .whole = true}, need);
    if (!numbers) return {};  // one mistake, and one line about it
    const auto [x, y, box_width, box_height] = *numbers;
    if (box_width == 0.0 || box_height == 0.0) {
      mask[i].refuse("a rectangle has no pixels", "give a width and a height of 1 or more");
      return {};
    }
    if (x + box_width > width || y + box_height > height) {
      mask[i].refuse(fmt::format("the rectangle [{}, {}, {}, {}] reaches beyond the picture, which has {}x{} pixels", x,
                                 y, box_width, box_height, width, height),
                     "give one within it");
      return {};
    }
    boxes.push_back(
        {static_cast<int>(x), static_cast<int>(y), static_cast<int>(box_width), static_cast<int>(box_height)});
  }
  if (Mask(width, height, boxes).count() == std::int64_t{width} * height) {
    mask.refuse("covers the whole picture, and nothing is left to compare", "leave some of it out");
  }
  return boxes;
}

// A case that is being read.
struct CaseReading {
  TomlReader& reader;
  std::filesystem::path folder;  // of the case
  Case& summary;
  PictureRequest& request;
  // The keys of a step of a lesson, as they stand.
  std::optional<std::string> lesson{};
  std::size_t step = 1;
  std::optional<std::size_t> answer{};
  std::vector<TomlKey> keys{};
};

// What the lesson's reader tells becomes a problem of the key that names the lesson.
void show_lesson_of(const TomlValue& named, CaseReading& at) {
  const std::optional<TomlValue> language = at.reader.find("", "language");
  const std::string path = at.summary.source_path = path_of(*at.lesson, shipped_lesson_names(), at.folder);
  try {
    LessonPicture picture{.lesson = std::make_shared<const Lesson>(load_lesson(path.empty() ? *at.lesson : path)),
                          .step = at.step - 1,
                          .answer = at.answer};
    if (const std::string problem = find_problem(picture); !problem.empty()) return named.refuse(problem, "");
    // A lesson may speak more languages than the stage.
    const std::vector<std::string_view> codes = languages_with(std::span(&picture.lesson, 1));
    if (const auto code = language ? language->word(codes) : std::nullopt) at.request.language = codes[*code];
    at.request.scene = load_scene(std::string(default_scene_name));
    show_lesson_in(at.request, std::move(picture));
  } catch (const ReadError& error) {
    for (const ReadProblem& problem : error.problems()) named.refuse(words_of(problem), problem.remedy);
  }
}

void read_moment(const TomlValue& value, CaseReading& at) {
  PictureRequest& request = at.request;
  request.at_s = value.number({0.0, longest_s, "s"});
  if (!request.at_s || *request.at_s * request.scene.settings.rate <= most_ticks) return;
  value.refuse(fmt::format("{} s is out of range", *request.at_s),
               fmt::format("give 0 to {} s, which is {} ticks", most_ticks / request.scene.settings.rate, most_ticks));
}

void read_size(const TomlValue& value, CaseReading& at) {
  constexpr std::string_view need = "give [width, height] in pixels, as in [1280, 800]";
  const auto count = value.count(need);
  if (count && *count != 2) value.refuse(fmt::format("is an array of {}", *count), need);
  if (count != 2) return;
  const NumberLimits side{.least = smallest_picture, .greatest = largest_picture, .whole = true};
  const auto width = value[0].number(side);
  const auto height = value[1].number(side);
  if (!width || !height) return;
  at.request.width = static_cast<int>(*width);
  at.request.height = static_cast<int>(*height);
}

void refuse_on_stage(const TomlValue& value, const CaseReading& at) {
  if (at.request.face != Face::stage) return;
  value.refuse("the stage shows one strategy at a time", "name one with strategy, or leave out view = \"stage\"");
}

void refuse_on_workbench(const TomlValue& value, const CaseReading& at, std::string_view remedy) {
  if (at.request.face == Face::workbench) value.refuse("belongs to the stage", remedy);
}

void read_strategy(const TomlValue& value, CaseReading& at) {
  std::vector<std::string_view> strategies = names_of(strategy_catalog());
  strategies.push_back(every_strategy);
  const auto word = value.word(strategies);
  if (word) apply_strategy_word(strategies[*word], at.request);
  if (word && strategies[*word] == every_strategy) refuse_on_stage(value, at);
}

void read_mode(const TomlValue& value, CaseReading& at) {
  catalog_entry(stage_mode_catalog(), [&](auto& mode) { at.request.mode = mode.id; })(value);
  refuse_on_workbench(value, at, "give view = \"stage\" too");
}

void read_compare(const TomlValue& value, CaseReading& at) {
  catalog_entry(compare_catalog(), [&](auto& mode) { at.request.options.compare = mode.id; })(value);
  refuse_on_stage(value, at);
}

void read_language(const TomlValue& value, CaseReading& at) {
  if (at.lesson) return;  // with the lesson
  const std::vector<std::string_view> codes = languages_with({});
  if (const auto code = value.word(codes)) at.request.language = codes[*code];
  refuse_on_workbench(value, at, "give view = \"stage\" too, or name a lesson");
}

template <Expectation expectation>
void read_other(const TomlValue& value, CaseReading& at) {
  Case& summary = at.summary;
  const std::optional<std::string> name = value.text();
  if (!name) return;
  if (summary.expectation != Expectation::golden) {
    value.refuse(fmt::format("the key {} is there too", expectation_name(summary.expectation)),
                 "a case can have only one of them");
  } else if (*name == summary.name) {
    value.refuse("names this case itself, which always equals itself", "name another");
  } else {
    summary.expectation = expectation;
    summary.other = *name;
    summary.other_place = value.place();
  }
}

// Which cases a key belongs to: all, those of a scene, or those of a step of a lesson, which says the rest itself.
enum class CaseKind : std::uint8_t { any, of_scene, of_lesson };

struct CaseKey {
  TomlKey toml;
  CaseKind kind = CaseKind::any;
};

constexpr std::array<std::string_view, 2> part_words{"window", "scene"};
constexpr NumberLimits number_from_1{.least = 1.0, .greatest = 1e6, .whole = true};

// In the order in which they are read; into `at`.
std::vector<CaseKey> keys_into(CaseReading& at) {
  using Value = const TomlValue&;
  PictureRequest& request = at.request;
  Tolerance& tolerance = at.summary.tolerance;
  const auto by = [&at](void (*read)(Value, CaseReading&)) { return [&at, read](Value value) { read(value, at); }; };
  const auto origin_into = [&at](std::string GoldenOrigin::*member) {
    return [&at, member](Value value) { (*at.summary.origin).*member = value.text().value_or(""); };
  };
  const auto scene = [&](Value value) {
    at.summary.source_path = path_of(value.text().value_or(""), shipped_scene_names(), at.folder);
    request.scene = load_scene_of(value, at.reader.find("", "set"), at.folder);
  };
  const auto mask = [&](Value value) { at.summary.mask = read_mask(value, request.width, request.height); };
  const auto part = [&](Value value) { request.part = value.word(part_words) == 1U ? Part::scene : Part::window; };
  const auto answer = [&](Value value) {
    if (const auto number = value.number(number_from_1)) at.answer = static_cast<std::size_t>(*number);
  };
  return {
      {{"", "scene", scene}, CaseKind::of_scene},
      {{"", "at_s", by(read_moment)}},
      {{"", "size", by(read_size)}},
      {{"", "mask", mask}},
      {{"", "part", part}},
      {{"", "view",
        catalog_entry(std::span<const FaceEntry>(face_catalog), [&](auto& entry) { request.face = entry.id; })},
       CaseKind::of_scene},
      {{"", "mode", by(read_mode)}, CaseKind::of_scene},
      {{"", "strategy", by(read_strategy)}, CaseKind::of_scene},
      {{"", "compare", by(read_compare)}, CaseKind::of_scene},
      {{"", "theme", catalog_entry(theme_catalog(), [&](auto& theme) { request.appearance.theme = &theme; })}},
      {{"", "scale", number_into(request.appearance.scale, {Appearance::least_scale, Appearance::greatest_scale})}},
      {{"", "set", nullptr}, CaseKind::of_scene},  // it is read with the scene
      {{"", "lesson", [&at](Value value) { at.lesson = value.text(); }}},
      {{"", "language", by(read_language)}},
      {{"", "step", number_into(at.step, number_from_1)}, CaseKind::of_lesson},
      {{"", "answer", answer}, CaseKind::of_lesson},
      {{"", "match", by(read_other<Expectation::match>)}},
      {{"", "mismatch", by(read_other<Expectation::mismatch>)}},
      {{"tolerance", "channel", number_into(tolerance.channel, {.least = 0.0, .greatest = 255.0, .whole = true})}},
      {{"tolerance", "share", number_into(tolerance.share, {0.0, 1.0})}},
      {{"expect", "tolerance", number_into(at.summary.number_tolerance, {0.0, 1e9})}},
      {{"golden", "renderer", origin_into(&GoldenOrigin::renderer)}},
      {{"golden", "mesa", origin_into(&GoldenOrigin::mesa)}},
      {{"golden", "version", origin_into(&GoldenOrigin::version)}},
      {{"", "format", nullptr}},  // may be missing: then it is 1
  };
}

void refuse_what_general_scenes_lack(CaseReading& at) {
  const PictureRequest& request = at.request;
  if (is_general(request.scene.settings) && permit(session_of(request.scene), ToggleMode{request.mode})) {
    at.reader.refuse("that mode does not show scenes of format 2 yet", "leave it out", at.reader.find("", "mode"));
  }
}

void read_keys(CaseReading& at) {
  const std::optional<TomlValue> named = at.reader.find("", "lesson");
  const std::vector<CaseKey> case_keys = keys_into(at);
  for (const CaseKey& key : case_keys) at.keys.push_back(key.toml);
  for (std::size_t i = 0; i < quantity_count; ++i) {
    at.keys.push_back({"expect", quantity_catalog()[i].column,
                       [&at, i](const TomlValue& value) { at.summary.numbers[i] = value.number({}); }});
  }
  if (!named) at.keys.front().if_missing = "give the name of a shipped scene, or a path relative to this file";
  at.reader.read(at.keys);
  for (const CaseKey& key : case_keys) {
    if (key.kind != (named ? CaseKind::of_scene : CaseKind::of_lesson)) continue;
    const std::optional<TomlValue> wrong = at.reader.find(key.toml.table, key.toml.name);
    if (wrong && named) wrong->refuse("is what a step of a lesson says", "leave it out, or leave out lesson");
    if (wrong && !named) wrong->refuse("belongs to a lesson", "name one with lesson");
  }
  if (at.lesson) show_lesson_of(*named, at);
  if (!named) refuse_what_general_scenes_lack(at);
  const bool has_number = std::ranges::any_of(quantity_catalog(), [&](const Quantity& quantity) {
    return at.reader.find("expect", quantity.column).has_value();
  });
  if (at.reader.has_table("expect") && !has_number) {
    at.reader.refuse("the table [expect] states no number", "give one, as in ghost_force_N = 1.2678",
                     at.reader.find("", "expect"));
  }
  if (at.summary.origin && at.summary.expectation != Expectation::golden) {
    at.reader.refuse(
        fmt::format("the table [golden]: with the key {} no golden is used", expectation_name(at.summary.expectation)),
        "remove one of them", at.reader.find("", "golden"));
  }
}

void read_case_text(ReadCase& into, std::vector<ReadProblem>& problems) {
  Case& summary = into.summary;
  const std::filesystem::path path = summary.path;
  TomlReader reader(summary.path);
  CaseReading at{reader, path.parent_path(), summary, into.content.request};
  if (reader.parse(into.content.text)) {
    summary.has_tolerance = reader.has_table("tolerance");
    if (reader.has_table("golden")) summary.origin.emplace();
    if (!reader.find("", "scene") && reader.has_table("wall")) {
      reader.refuse("this is a scene, not a case",
                    fmt::format("put scenes into a subfolder, and refer to them as in scene = \"scenes/{}\"",
                                quoted_text(path.filename().string())));
    } else if (!reader.find("", "format") || reader.has_known_format()) {
      read_keys(at);
    }
  }
  const std::vector<ReadProblem> found = reader.problems();
  problems.insert(problems.end(), found.begin(), found.end());
}

}  // namespace

std::string Case::golden_path() const {
  return std::filesystem::path(path).replace_extension(".png").string();
}

ReadCase read_case(const std::string& path, std::vector<ReadProblem>& problems) {
  ReadCase result;
  result.summary.name = std::filesystem::path(path).stem().string();
  result.summary.path = path;
  FileContents file = file_contents(path);
  if (file.error == EFBIG) {
    problems.push_back({.file = quoted_text(path, longest_path),
                        .what = fmt::format("is larger than {} MiB, too large for a case", largest_text_file >> 20),
                        .remedy = "rename it, or remove it"});
  } else if (file.error != 0) {
    throw unreadable(quoted_text(path, longest_path), file.error);
  } else {
    result.content.text = std::move(file.text);
    read_case_text(result, problems);
  }
  result.summary.width = result.content.request.width;
  result.summary.height = result.content.request.height;
  return result;
}

CaseContent content_of(const Case& described) {
  std::vector<ReadProblem> problems;
  ReadCase read = read_case(described.path, problems);
  if (!problems.empty()) throw ReadError(ReadError::Kind::wrong, problems);
  return std::move(read.content);
}

std::string_view expectation_name(Expectation expectation) noexcept {
  constexpr std::array<std::string_view, 3> names{"golden", "match", "mismatch"};
  return names[static_cast<std::size_t>(expectation)];
}

}  // namespace ghostforce
