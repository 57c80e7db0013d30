#include "app/shell/preferences.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/base/language.h"
#include "app/base/quoted.h"
#include "app/files/kept_file.h"
#include "app/files/toml_document.h"
#include "app/files/xdg_folders.h"
#include "app/shell/window.h"
#include "app/workbench/panel_catalog.h"

namespace ghostforce {
namespace {

namespace fs = std::filesystem;

KeptFile preferences_file() {
  const fs::path where = config_folder();
  return {.path = where.empty() ? where : where / "preferences.toml",
          .contents = "preferences are",
          .comment = "what a person has chosen. Delete it to begin anew."};
}

KeptFile layout_file() {
  const fs::path where = state_folder();
  return {.path = where.empty() ? where : where / "layout.toml",
          .contents = "the window's layout is",
          .comment = "how the window was when it closed."};
}

// A key of a file, and the part of `Kept` that it stands for.
template <typename Kept>
struct KeptKey {
  std::string_view name;
  std::function<std::function<void(const TomlValue&)>(Kept& into)> reader;
  std::function<std::string(const Kept& kept)> text;  // as TOML
  std::function<bool(const Kept& one, const Kept& other)> is_same;
  std::function<void(const Kept& from, Kept& into)> copy;
};

// `select` names the part; `read` makes what reads it, `write` its text.
template <typename Kept, typename Select, typename Read, typename Write>
KeptKey<Kept> kept_key(std::string_view name, Select select, Read read, Write write) {
  return {name, [=](Kept& into) { return read(select(into)); }, [=](const Kept& kept) { return write(select(kept)); },
          [=](const Kept& one, const Kept& other) { return select(one) == select(other); },
          [=](const Kept& from, Kept& into) { select(into) = select(from); }};
}

template <typename Kept, typename Select>
KeptKey<Kept> number(std::string_view name, Select select, const NumberLimits& limits) {
  return kept_key<Kept>(
      name, select, [limits](auto& into) { return number_into(into, limits); },
      [](auto value) { return fmt::format("{}", value); });  // as many digits as read back exactly
}

template <typename Kept, typename Select>
KeptKey<Kept> yes_or_no(std::string_view name, Select select) {
  return kept_key<Kept>(
      name, select, [](bool& into) { return yes_or_no_into(into); },
      [](bool value) { return std::string(value ? "true" : "false"); });
}

// An entry of a catalog that lasts, by its name. `value_of`: what is kept of it.
template <typename Kept, typename Catalog, typename Select, typename ValueOf>
KeptKey<Kept> choice(std::string_view name, const Catalog& catalog, Select select, ValueOf value_of) {
  using Entry = typename Catalog::value_type;
  const std::span<const Entry> entries(catalog);
  return kept_key<Kept>(
      name, select,
      [=](auto& into) {
        return catalog_entry(entries, [&into, value_of](const Entry& entry) { into = value_of(entry); });
      },
      [=](const auto& value) { return toml_string(std::ranges::find(entries, value, value_of)->name); });
}
template <typename Kept, typename Catalog, typename Select>
KeptKey<Kept> choice(std::string_view name, const Catalog& catalog, Select select) {
  return choice<Kept>(name, catalog, select, [](const auto& entry) { return entry.id; });
}

// Names in files of what has none elsewhere.
template <typename Id>
struct NamedId {
  Id id;
  std::string_view name;
};
template <typename Id>
NamedId(Id, std::string_view) -> NamedId<Id>;
using CapMode = SpaceMouseSettings::Mode;
using CapUp = SpaceMouseSettings::Up;
constexpr std::array cap_modes{NamedId{CapMode::position, "position"}, NamedId{CapMode::rate, "speed"}};
constexpr std::array cap_ups{NamedId{CapUp::lift, "lifting"}, NamedId{CapUp::push_away, "pushing-away"}};
constexpr std::array motions{NamedId{ScreenMotion::as_system, "as-system"}, NamedId{ScreenMotion::full, "full"},
                             NamedId{ScreenMotion::reduced, "reduced"}};
constexpr std::array plot_tabs{NamedId{PlotTab::time, plot_tab_name(PlotTab::time)},
                               NamedId{PlotTab::wall_angle, plot_tab_name(PlotTab::wall_angle)},
                               NamedId{PlotTab::ratio, plot_tab_name(PlotTab::ratio)},
                               NamedId{PlotTab::hand, plot_tab_name(PlotTab::hand)}};

auto read_language(std::string& into) {
  return [&into](const TomlValue& value) {
    const auto text = value.text();
    if (!text) return;
    if (text->empty() || is_language_code(*text)) {  // empty: the environment's
      into = *text;
    } else {
      value.refuse(fmt::format("'{}' is not a language", quoted_text(*text)), "give two small letters, as in \"es\"");
    }
  };
}

const std::vector<KeptKey<Preferences>>& preference_keys() {
  using P = Preferences;
  static const std::vector<KeptKey<P>> all{
      choice<P>(
          "theme", theme_catalog(), [](auto& kept) -> auto& { return kept.appearance.theme; },
          [](const Theme& theme) { return &theme; }),
      number<P>("scale", [](auto& kept) -> auto& { return kept.appearance.scale; },
                {Appearance::least_scale, Appearance::greatest_scale}),
      number<P>("arrows", [](auto& kept) -> auto& { return kept.appearance.arrow_scale; },
                {Appearance::least_arrow_scale, Appearance::greatest_arrow_scale}),
      choice<P>(
          "motion", motions, [](auto& kept) -> auto& { return kept.motion; }),
      choice<P>(
          "view", face_catalog, [](auto& kept) -> auto& { return kept.face; }),
      choice<P>(
          "compare", compare_catalog(), [](auto& kept) -> auto& { return kept.options.compare; }),
      yes_or_no<P>(
          "ghost_forces", [](auto& kept) -> auto& { return kept.options.ghost_forces; }),
      yes_or_no<P>(
          "predictions", [](auto& kept) -> auto& { return kept.options.predictions; }),
      yes_or_no<P>(
          "trails", [](auto& kept) -> auto& { return kept.options.trails; }),
      yes_or_no<P>(
          "plots", [](auto& kept) -> auto& { return kept.plots.is_open; }),
      choice<P>(
          "plots_tab", plot_tabs, [](auto& kept) -> auto& { return kept.plots.tab; }),
      number<P>("plots_span_s", [](auto& kept) -> auto& { return kept.plots.span_s; },
                {PlotView::shortest_span_s, PlotView::longest_span_s, "s"}),
      number<P>("speed", [](auto& kept) -> auto& { return kept.speed; }, {0.01, 1.0}),
      choice<P>(
          "spacemouse_sets", cap_modes, [](auto& kept) -> auto& { return kept.spacemouse.mode; }),
      choice<P>(
          "spacemouse_up", cap_ups, [](auto& kept) -> auto& { return kept.spacemouse.up; }),
      number<P>("spacemouse_dead_zone", [](auto& kept) -> auto& { return kept.spacemouse.dead_zone; }, {0.0, 0.5}),
      yes_or_no<P>(
          "speech", [](auto& kept) -> auto& { return kept.speaks; }),
      yes_or_no<P>(
          "hints", [](auto& kept) -> auto& { return kept.offers_hints; }),
      kept_key<P>(
          "language", [](auto& kept) -> auto& { return kept.language; }, read_language, toml_string),
  };
  return all;
}

auto read_titles(std::set<std::string, std::less<>>& into) {
  return [&into](const TomlValue& titles) {
    const std::size_t count = titles.count("give a list of panels").value_or(0);
    for (std::size_t i = 0; i < count; ++i) {
      if (const auto title = titles[i].text()) into.insert(*title);
    }
  };
}

std::string titles_text(const std::set<std::string, std::less<>>& titles) {
  std::vector<std::string> texts;
  for (const std::string& title : titles) texts.push_back(toml_string(title));
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

const std::vector<KeptKey<WindowLayout>>& layout_keys() {
  using L = WindowLayout;
  const NumberLimits length{.least = 1.0, .greatest = 32768.0, .unit = "pixels", .whole = true};  // of any screen
  static const std::vector<KeptKey<L>> all{
      number<L>(
          "width", [](auto& kept) -> auto& { return kept.width; }, length),
      number<L>(
          "height", [](auto& kept) -> auto& { return kept.height; }, length),
      yes_or_no<L>(
          "maximized", [](auto& kept) -> auto& { return kept.is_maximized; }),
      yes_or_no<L>(
          "full_screen", [](auto& kept) -> auto& { return kept.is_full_screen; }),
      kept_key<L>(
          "folded", [](auto& kept) -> auto& { return kept.folded_panels; }, read_titles, titles_text),
  };
  return all;
}

// Unknown keys are those of a newer program, and missing ones those that an older one did not know.
template <typename Kept>
std::optional<Kept> load_keys(const KeptFile& file, const std::vector<KeptKey<Kept>>& keys,
                              std::vector<std::string>& remarks) {
  Kept kept;
  const auto read = [&](TomlReader& reader) {
    std::vector<TomlKey> readers;
    for (const KeptKey<Kept>& key : keys) readers.push_back({"", key.name, key.reader(kept)});
    reader.read_values(readers);
  };
  return load(file, read, remarks) ? std::optional(kept) : std::nullopt;
}

template <typename Kept>
void save_keys(const KeptFile& file, const std::vector<KeptKey<Kept>>& keys, const Kept& kept) {
  std::string text;
  for (const KeptKey<Kept>& key : keys) text += fmt::format("{} = {}\n", key.name, key.text(kept));
  save(file, text, names_of(keys));
}

}  // namespace

Preferences preferences_in(const Session& session) {
  // A lesson has the stage and the usual speed for itself.
  const std::optional<LessonState>& lesson = session.lesson;
  // While the plots follow the present, both ends move, and their distance changes in its last digits.
  const double span_s = std::round(1e3 * session.plots.span_s()) / 1e3;
  return {.appearance = session.appearance,
          .motion = session.motion,
          .options = session.options,
          .plots = {session.plots.is_open, session.plots.tab, span_s},
          .spacemouse = session.spacemouse,
          .face = lesson ? lesson->before.face : session.face,
          .speed = lesson ? lesson->before.speed : session.speed,
          .speaks = session.speaks,
          .offers_hints = session.hint.has_value(),
          .language = session.language};
}

void apply(const Preferences& preferences, Session& session) {
  session.appearance = preferences.appearance;
  session.motion = preferences.motion;
  session.options = preferences.options;
  session.plots.is_open = preferences.plots.is_open;
  session.plots.tab = preferences.plots.tab;
  session.plots.set_span(preferences.plots.span_s);
  session.spacemouse = preferences.spacemouse;
  // As above.
  (session.lesson ? session.lesson->before.face : session.face) = preferences.face;
  (session.lesson ? session.lesson->before.speed : session.speed) = preferences.speed;
  session.speaks = preferences.speaks;
  session.language = wanted_language(preferences.language, locale_variables());
  session.hint = preferences.offers_hints ? std::optional<std::size_t>(0) : std::nullopt;
}

std::set<std::string, std::less<>> panels_folded_at_first(double height) {
  std::set<std::string, std::less<>> folded;
  for (const Panel& panel : panel_catalog()) {
    if (height < panel.opens_from) folded.emplace(panel.title);
  }
  return folded;
}

void reset_preferences(Session& session, Window& window) {
  apply(Preferences{}, session);
  ++session.preference_resets;
  const WindowLayout layout;
  window.restore(layout.width, layout.height);
  session.folded_panels = panels_folded_at_first(layout.height);
}

StoredPreferences load_preferences() {
  StoredPreferences stored;
  stored.preferences = load_keys(preferences_file(), preference_keys(), stored.remarks).value_or(Preferences{});
  stored.layout = load_keys(layout_file(), layout_keys(), stored.remarks);
  if (stored.layout) {
    // A window cannot be made smaller, whatever is written.
    stored.layout->width = std::max(stored.layout->width, least_window_width);
    stored.layout->height = std::max(stored.layout->height, least_window_height);
  }
  return stored;
}

StoredPreferences for_visitors(const StoredPreferences& stored) {
  const Preferences& of_machine = stored.preferences;
  return {.preferences = {.appearance = {.theme = of_machine.appearance.theme, .scale = of_machine.appearance.scale},
                          .motion = of_machine.motion,
                          .offers_hints = false,
                          .language = of_machine.language},
          .layout = WindowLayout{.is_full_screen = true},
          .remarks = stored.remarks};
}

void save(const Preferences& preferences) {
  save_keys(preferences_file(), preference_keys(), preferences);
}

void save(const WindowLayout& layout) {
  save_keys(layout_file(), layout_keys(), layout);
}

void PreferenceKeeper::keep(const Session& session) {
  const Preferences now = preferences_in(session);
  if (std::exchange(resets_, session.preference_resets) != session.preference_resets) {
    stored_ = {};
    seen_ = now;
    unsaved_.clear();
    for (const KeptFile& file : {preferences_file(), layout_file()}) forget(file);
    return;
  }
  if (now == seen_) return;
  for (const KeptKey<Preferences>& key : preference_keys()) {
    if (!key.is_same(now, seen_)) unsaved_.insert(key.name);
  }
  seen_ = now;
  std::vector<std::string> problems;
  if (const auto stored = load_keys(preferences_file(), preference_keys(), problems)) {
    stored_ = *stored;
  } else if (problems.empty()) {
    stored_ = {};  // another window has reset them
  }
  for (const KeptKey<Preferences>& key : preference_keys()) {
    if (unsaved_.contains(key.name)) key.copy(now, stored_);
  }
  save(stored_);
  unsaved_.clear();
}

}  // namespace ghostforce
