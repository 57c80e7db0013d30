#include "app/check/case_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/console/did_you_mean.h"
#include "app/console/failure.h"
#include "app/console/quoted.h"
#include "app/console/unicode.h"
#include "app/files/first_problems.h"
#include "app/files/input_file.h"
#include "app/files/scene_file.h"
#include "app/files/toml_text.h"

namespace ghostforce {
namespace {

constexpr double latest_s = 1e6;  // as --at of `render` has it

struct Range {
  double least;
  double greatest;
  std::string_view unit;
};

// The one list of what a case may say; the rest of this file gives each its meaning.
struct CaseKey {
  std::string_view table;  // "" at the top of the file
  std::string_view name;
};
constexpr std::array case_keys{
    CaseKey{"", "scene"},          CaseKey{"", "at_s"},           CaseKey{"", "size"},
    CaseKey{"", "part"},           CaseKey{"", "strategy"},       CaseKey{"", "compare"},
    CaseKey{"", "theme"},          CaseKey{"", "scale"},          CaseKey{"", "set"},
    CaseKey{"", "match"},          CaseKey{"", "mismatch"},       CaseKey{"tolerance", "channel"},
    CaseKey{"tolerance", "share"}, CaseKey{"golden", "renderer"}, CaseKey{"golden", "mesa"},
    CaseKey{"golden", "version"},
};
constexpr std::array<std::string_view, 2> case_tables{"tolerance", "golden"};

std::string dotted(std::string_view table, std::string_view name) {
  return table.empty() ? std::string(name) : fmt::format("{}.{}", table, name);
}

bool is_known(std::string_view table, std::string_view name) {
  return std::any_of(case_keys.begin(), case_keys.end(),
                     [&](const CaseKey& key) { return key.table == table && key.name == name; });
}

// The end of a message about an unknown key.
std::string suggestion(std::string_view table, std::string_view name) {
  std::vector<std::string_view> here;
  for (const CaseKey& key : case_keys) {
    if (key.name == name) {
      return fmt::format("; did you mean '{}'?{}", dotted(key.table, key.name),
                         key.table.empty() ? " It stands before the first [table]" : "");
    }
    if (key.table == table) here.push_back(key.name);
  }
  if (table.empty()) here.insert(here.end(), case_tables.begin(), case_tables.end());
  const std::string near = did_you_mean(name, here);
  return near.empty() ? fmt::format("; there is {}", listed(here)) : near;
}

// What may have been meant by the name of a scene that is none: a file in the subfolder that it names (what lies beside
// a case is a case), or a shipped scene.
std::string scene_hint(const std::filesystem::path& name, const std::filesystem::path& case_folder) {
  namespace fs = std::filesystem;
  const std::vector<std::string_view> shipped = shipped_scene_names();
  if (name.has_parent_path()) {
    std::vector<std::string> files;
    std::error_code error;
    for (fs::directory_iterator file(case_folder / name.parent_path(), error), end; !error && file != end;
         file.increment(error)) {
      if (file->path().extension() == ".toml") files.push_back(file->path().filename().string());
    }
    std::sort(files.begin(), files.end());
    const std::vector<std::string_view> views(files.begin(), files.end());
    if (const auto near = nearest_name(name.filename().string(), views)) {
      return fmt::format("; did you mean '{}'?", printable((name.parent_path() / *near).string(), longest_path));
    }
  }
  const bool is_file = name.extension() == ".toml";
  const std::string near = did_you_mean((is_file ? name.stem() : name.filename()).string(), shipped);
  return near.empty() ? fmt::format("; give a path relative to this file, or one of {}", listed(shipped)) : near;
}

class CaseReader {
 public:
  CaseReader(ReadCase& into, std::vector<std::string>& problems)
      : case_(into.summary), text_(into.content.text), request_(into.content.request), problems_(problems) {}

  void read() {
    ParsedToml parsed = parse_toml(text_);
    if (parsed.problem) {
      complain(parsed.problem->position, parsed.problem->what);
      tell();
      return;
    }
    file_ = std::move(parsed.table);
    if (is_scene()) {
      complain({1, 1}, fmt::format("this is a scene, not a case; put scenes into a subfolder, and name them as in "
                                   "scene = \"scenes/{}\"",
                                   printable(std::filesystem::path(case_.path).filename().string())));
      tell();
      return;
    }
    find_unknown();
    read_scene();
    read_picture();
    read_expectation();
    tell();
  }

 private:
  // --- Telling what is wrong ---

  std::string shown(toml::source_position position) const {
    return fmt::format("{}:{}:{}", printable(case_.path, longest_path), std::max<toml::source_index>(position.line, 1),
                       std::max<toml::source_index>(position.column, 1));
  }

  // `what` is a text, or a function that makes it.
  template <typename Words>
  void complain(toml::source_position position, Words what) {
    found_.add(position, std::move(what));
  }

  void complain(const toml::node& node, std::string_view key, const std::string& what) {
    complain(node.source().begin, fmt::format("the key {}: {}", key, what));
  }

  void tell() {
    std::vector<std::string> lines = found_.lines([this](toml::source_position position) { return shown(position); });
    problems_.insert(problems_.end(), std::make_move_iterator(lines.begin()), std::make_move_iterator(lines.end()));
  }

  // --- What is there ---

  bool is_scene() const { return !file_.contains("scene") && (file_.contains("format") || file_["wall"].is_table()); }

  void find_unknown() {
    for (const auto& [key, node] : file_) {
      const std::string_view name = key.str();
      if (std::find(case_tables.begin(), case_tables.end(), name) != case_tables.end()) {
        const toml::table* const table = node.as_table();
        if (table == nullptr) {
          complain(node, name, fmt::format("is {}; write [{}] on a line of its own", type_words(node.type()), name));
          continue;
        }
        for (const auto& [inner_key, inner_node] : *table) {
          if (!is_known(name, inner_key.str())) complain_unknown(name, inner_key);
        }
      } else if (!is_known("", name)) {
        complain_unknown("", key);
      }
    }
  }

  void complain_unknown(std::string_view table, const toml::key& key) {
    complain(key.source().begin, [table, name = key.str()] {
      return fmt::format("the key {} is unknown{}", dotted(table, printable(name)), suggestion(table, name));
    });
  }

  const toml::node* find(std::string_view table, std::string_view name) const {
    const toml::table* const in = table.empty() ? &file_ : file_[table].as_table();
    return in == nullptr ? nullptr : in->get(name);
  }

  // --- Values; empty where there is none or where it is wrong, which has been told then ---

  std::optional<std::string> text(std::string_view table, std::string_view name) {
    const toml::node* const node = find(table, name);
    if (node == nullptr) return std::nullopt;
    const auto* const value = node->as_string();
    if (value == nullptr) {
      complain(*node, dotted(table, name), fmt::format("is {}; give a text in quotes", type_words(node->type())));
      return std::nullopt;
    }
    if (const auto what = unshowable_in(value->get(), false)) {
      complain(*node, dotted(table, name), fmt::format("holds {}; remove it", *what));
      return std::nullopt;
    }
    return value->get();
  }

  std::optional<std::string> word(std::string_view name, const std::vector<std::string_view>& words) {
    std::optional<std::string> value = text("", name);
    if (!value || std::find(words.begin(), words.end(), *value) != words.end()) return value;
    complain(*find("", name), name,
             fmt::format("'{}' is none of {}{}", printable(*value), listed(words), did_you_mean(*value, words)));
    return std::nullopt;
  }

  std::optional<double> number(std::string_view table, std::string_view name, const Range& range) {
    const toml::node* const node = find(table, name);
    if (node == nullptr) return std::nullopt;
    const std::string need =
        fmt::format("give {} to {}{}{}", range.least, range.greatest, range.unit.empty() ? "" : " ", range.unit);
    const std::optional<double> value = node->is_number() ? node->value<double>() : std::nullopt;
    if (!value) {
      complain(*node, dotted(table, name), fmt::format("is {}; {}", type_words(node->type()), need));
      return std::nullopt;
    }
    // Written so that NaN is out of range too.
    if (*value >= range.least && *value <= range.greatest) return value;
    complain(*node, dotted(table, name), fmt::format("{} is out of range; {}", *value, need));
    return std::nullopt;
  }

  std::optional<int> whole(const toml::node& node, std::string_view key, int least, int greatest) {
    const auto* const value = node.as_integer();
    if (value != nullptr && value->get() >= least && value->get() <= greatest) return static_cast<int>(value->get());
    const std::string is = value != nullptr           ? fmt::format("{} is out of range", value->get())
                           : node.is_floating_point() ? std::string("has a decimal point or an exponent")
                                                      : fmt::format("is {}", type_words(node.type()));
    complain(node, key, fmt::format("{}; give a whole number, {} to {}", is, least, greatest));
    return std::nullopt;
  }

  // --- Their meaning ---

  void read_scene() {
    const toml::node* const scene_node = find("", "scene");
    if (scene_node == nullptr) {
      complain({1, 1}, "the key scene is missing; give the name of a shipped scene, or a path relative to this file");
      return;
    }
    const std::optional<std::string> scene = text("", "scene");
    const std::vector<std::string> overrides = read_overrides();
    if (!scene) return;
    const std::vector<std::string_view> shipped = shipped_scene_names();
    const bool is_shipped = std::find(shipped.begin(), shipped.end(), *scene) != shipped.end();
    const std::filesystem::path folder = std::filesystem::path(case_.path).parent_path();
    const std::filesystem::path beside = folder / *scene;
    std::error_code unknown;
    if (!is_shipped && std::filesystem::status(beside, unknown).type() == std::filesystem::file_type::not_found) {
      complain(*scene_node, "scene",
               fmt::format("no scene named '{}'{}", printable(*scene, longest_path), scene_hint(*scene, folder)));
      return;
    }
    try {
      request_.scene = load_scene(is_shipped ? *scene : beside.string(), overrides);
    } catch (const Failure& failure) {
      if (failure.code() != ExitCode::wrong_call) {
        throw Failure(failure.code(),
                      fmt::format("{}: the key scene: {}", shown(scene_node->source().begin), failure.what()));
      }
      complain_about_scene(*scene_node, failure.what(), overrides);
    }
  }

  // A line of the scene reader each: about the scene, or about one of the values set.
  void complain_about_scene(const toml::node& scene_node, const std::string& words,
                            const std::vector<std::string>& overrides) {
    std::istringstream lines(words);
    for (std::string line; std::getline(lines, line);) {
      const auto is_about = [&](const std::string& override) {
        return line.starts_with(fmt::format("--set {}: ", printable(override)));
      };
      const auto blamed = std::find_if(overrides.begin(), overrides.end(), is_about);
      if (blamed == overrides.end()) {
        complain(scene_node, "scene", line);
      } else {
        const toml::array& set = *find("", "set")->as_array();
        complain(set[static_cast<std::size_t>(blamed - overrides.begin())], "set",
                 line.substr(std::string_view("--set ").size()));
      }
    }
  }

  // Nothing where one of them is no text, so that each stands where it stands in the file.
  std::vector<std::string> read_overrides() {
    const toml::node* const node = find("", "set");
    if (node == nullptr) return {};
    constexpr std::string_view need = R"(give texts, as in ["wall.normal_deg=120"])";
    const toml::array* const array = node->as_array();
    if (array == nullptr) {
      complain(*node, "set", fmt::format("is {}; {}", type_words(node->type()), need));
      return {};
    }
    constexpr std::size_t most = 1000;  // a scene has some thirty keys
    if (array->size() > most) {
      complain(*node, "set", fmt::format("holds {} texts; give {} at most", array->size(), most));
      return {};
    }
    std::vector<std::string> overrides;
    for (const toml::node& element : *array) {
      const auto* const value = element.as_string();
      if (value == nullptr) {
        complain(element, "set", fmt::format("holds {}; {}", type_words(element.type()), need));
        return {};
      }
      overrides.push_back(value->get());
    }
    return overrides;
  }

  void read_picture() {
    request_.at_s = number("", "at_s", {0.0, latest_s, "s"});
    if (request_.at_s && *request_.at_s * request_.scene.settings.rate > most_ticks) {
      complain(*find("", "at_s"), "at_s",
               fmt::format("{} s is out of range; give 0 to {} s, which is {} ticks", *request_.at_s,
                           most_ticks / request_.scene.settings.rate, most_ticks));
    }
    read_size();
    if (const auto part = word("part", {"window", "scene"})) {
      request_.part = *part == "scene" ? Part::scene : Part::window;
    }
    std::vector<std::string_view> strategies;
    for (const Strategy& strategy : strategy_catalog()) strategies.push_back(strategy.name);
    strategies.push_back(every_strategy);
    if (const auto strategy = word("strategy", strategies)) apply_strategy_word(*strategy, request_);
    std::vector<std::string_view> modes;
    for (const CompareMode& mode : compare_catalog()) modes.push_back(mode.name);
    if (const auto compare = word("compare", modes)) request_.options.compare = find_compare(*compare).value();
    std::vector<std::string_view> themes;
    for (const Theme& theme : theme_catalog()) themes.push_back(theme.name);
    if (const auto theme = word("theme", themes)) request_.look.theme = find_theme(*theme);
    if (const auto scale = number("", "scale", {Look::least_scale, Look::greatest_scale, ""})) {
      request_.look.scale = *scale;
    }
  }

  void read_size() {
    const toml::node* const node = find("", "size");
    if (node == nullptr) return;
    const toml::array* const lengths = node->as_array();
    if (lengths == nullptr || lengths->size() != 2) {
      complain(*node, "size",
               fmt::format("is {}; give [width, height] in pixels, as in [1280, 800]",
                           lengths == nullptr ? std::string(type_words(node->type()))
                                              : fmt::format("an array of {}", lengths->size())));
      return;
    }
    const auto width = whole((*lengths)[0], "size", smallest_picture, largest_picture);
    const auto height = whole((*lengths)[1], "size", smallest_picture, largest_picture);
    if (!width || !height) return;
    request_.width = *width;
    request_.height = *height;
  }

  void read_expectation() {
    for (const Wanted wanted : {Wanted::match, Wanted::mismatch}) read_other(wanted);
    if (const toml::node* const channel = find("tolerance", "channel")) {
      case_.tolerance.channel = whole(*channel, "tolerance.channel", 0, 255).value_or(0);
    }
    case_.tolerance.share = number("tolerance", "share", {0.0, 1.0, ""}).value_or(0.0);
    const toml::node* const golden = file_.get("golden");
    if (golden == nullptr || !golden->is_table()) return;
    if (case_.wanted != Wanted::golden) {
      complain(golden->source().begin, fmt::format("the table [golden]: with the key {} no golden is used; remove one "
                                                   "of them",
                                                   wanted_name(case_.wanted)));
    }
    case_.origin = GoldenOrigin{text("golden", "renderer").value_or(""), text("golden", "mesa").value_or(""),
                                text("golden", "version").value_or("")};
  }

  void read_other(Wanted wanted) {
    const std::string_view key = wanted_name(wanted);
    const std::optional<std::string> other = text("", key);
    if (!other) return;
    const toml::node& node = *find("", key);
    if (case_.wanted != Wanted::golden) {
      complain(node, key, fmt::format("there is the key {} too; a case has one of them", wanted_name(case_.wanted)));
      return;
    }
    if (*other == case_.name) {
      complain(node, key, "names this case itself, which is always equal to itself; name another");
      return;
    }
    case_.wanted = wanted;
    case_.other = *other;
    case_.other_place = shown(node.source().begin);
  }

  Case& case_;
  const std::string& text_;
  PictureRequest& request_;
  std::vector<std::string>& problems_;
  FirstProblems<toml::source_position> found_;
  toml::table file_;
};

}  // namespace

std::string Case::golden_path() const {
  return std::filesystem::path(path).replace_extension(".png").string();
}

ReadCase read_case(const std::string& path, std::vector<std::string>& problems) {
  ReadCase result;
  result.summary.name = std::filesystem::path(path).stem().string();
  result.summary.path = path;
  FileContents file = file_contents(path);
  if (file.error == EFBIG) {
    problems.push_back(fmt::format("{}: is larger than {} MiB, which no case is; rename it, or remove it",
                                   printable(path, longest_path), largest_text_file >> 20));
  } else if (file.error != 0) {
    throw Failure(ExitCode::file_trouble,
                  fmt::format("{} cannot be read: {}", printable(path, longest_path), unreadable_words(file.error)));
  } else {
    result.content.text = std::move(file.text);
    CaseReader(result, problems).read();
  }
  result.summary.width = result.content.request.width;
  result.summary.height = result.content.request.height;
  return result;
}

CaseContent content_of(const Case& described) {
  std::vector<std::string> problems;
  ReadCase read = read_case(described.path, problems);
  if (!problems.empty()) throw Failure(ExitCode::wrong_call, fmt::format("{}", fmt::join(problems, "\n")));
  return std::move(read.content);
}

std::string_view wanted_name(Wanted wanted) noexcept {
  return wanted == Wanted::match ? "match" : "mismatch";
}

}  // namespace ghostforce
