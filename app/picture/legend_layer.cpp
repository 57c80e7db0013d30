// What the marks are: one line each; of a pane among others, whose it is.
#include <algorithm>
#include <array>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "app/picture/label_placer.h"
#include "app/picture/layers.h"
#include "app/picture/screen_box.h"

namespace ghostforce {
namespace {

constexpr double legend_margin = 10.0;  // to the edge of the picture [points]
constexpr double legend_padding = 6.0;  // of the backdrop
constexpr double legend_row = 22.0;
constexpr double icon_width = 30.0;

struct LegendEntry {
  Role about;
  std::optional<StrategyId> strategy;
  std::variant<Marker, Arrow> icon;  // beside the middle of a row: its place is still to be added
  std::string words;
  std::string in_brief;
  Colour colour;
};

struct LegendForm {
  bool is_brief;
  TextStyle style;
};

const std::string& words_of(const LegendEntry& entry, const LegendForm& form) {
  return form.is_brief ? entry.in_brief : entry.words;
}

Vector<2> extent_of(const View& view, const std::vector<LegendEntry>& entries, const LegendForm& form) {
  Vector<2> extent{0.0, view.points(legend_row) * static_cast<double>(entries.size())};
  for (const LegendEntry& entry : entries) {
    extent.x = std::max(extent.x, view.measure(words_of(entry, form), view.drawn(form.style)).x);
  }
  return extent + Vector<2>(view.points(icon_width) + 2.0 * view.points(legend_padding), view.points(legend_padding));
}

std::string letter_and_title(const Strategy& entry) {
  return fmt::format("{}  {}", entry.letter, entry.title);
}

class LegendEntries {
 public:
  explicit LegendEntries(const View& view) : view_(view), theme_(view.theme) {}

  std::vector<LegendEntry> all() {
    add_goal();
    add_device();
    const Shape shape = strategy_style(view_.settings.active).shape;
    add(Role::proxy, marker(shape, 6.0, theme_.background, active(), 1.8), "proxy",
        "the point that the wall holds back");
    const bool can_have_ghost =
        !strategy(view_.settings.active).has_every_motor && (!view_.snapshot.measured || view_.snapshot.has_target);
    if (view_.options.ghost_forces && can_have_ghost) {
      Arrow arrow{Vector<2>(0.0), Vector<2>(0.0), view_.points(7.0), theme_.background, active(), view_.points(1.4)};
      arrow.is_hatched = true;
      add(Role::ghost_force, arrow, "ghost force", "the hatched end of the arrow");
    }
    if (view_.options.predictions) {
      add(Role::prediction, marker(Shape::disc, 7.0, active().with_alpha(0), active(), 1.0), "ring",
          "where theory says that it rests");
    }
    add_others();
    return std::move(entries_);
  }

 private:
  Colour active() const { return theme_.strategy[index_of(view_.settings.active)]; }
  Marker marker(Shape shape, double radius, Colour fill, Colour rim, double rim_width) const {
    return {Vector<2>(0.0), shape, view_.points(radius), fill, rim, view_.points(rim_width)};
  }
  void add(Role about, std::variant<Marker, Arrow> icon, const std::string& name, std::string_view sense,
           std::optional<StrategyId> id = {}) {
    const Colour colour = id ? theme_.strategy_text[index_of(*id)] : theme_.text;
    entries_.push_back({about, id, icon, fmt::format("{}: {}", name, sense), name, colour});
  }

  void add_goal() {
    const Colour line = theme_.dark ? theme_.goal : theme_.goal_rim;
    if (view_.snapshot.measured) {
      add(Role::goal, marker(Shape::disc, 6.5, theme_.goal.with_alpha(0), line, 2.4), "goal",
          "where the hand seems to pull to");
    } else {
      add(Role::goal, marker(Shape::disc, 6.5, theme_.goal, theme_.goal_rim, 1.8), "goal", "where the hand pulls to");
    }
  }
  void add_device() {
    const Strategy& entry = strategy(view_.settings.active);
    const Colour fill = view_.is_predicted(entry.id) ? theme_.background : active();
    const Colour rim = view_.is_predicted(entry.id) ? active() : theme_.background;
    const std::string_view sense = view_.is_predicted(entry.id)          ? "simulated"
                                   : view_.snapshot.measured == entry.id ? "device, measured in your hand"
                                                                         : "device (the handle), filled";
    add(Role::device, marker(strategy_style(entry.id).shape, 7.0, fill, rim, 1.0), letter_and_title(entry), sense,
        entry.id);
    entries_.back().in_brief = "device";
  }
  void add_others() {
    for (const Strategy& entry : strategy_catalog()) {
      if (view_.in_front(entry.id) || !view_.shows(entry.id)) continue;
      const Colour pale = pale_colour(theme_, entry.id);
      const bool is_hollow = view_.is_predicted(entry.id);
      add(Role::device,
          marker(strategy_style(entry.id).shape, 5.4, is_hollow ? theme_.background : pale,
                 is_hollow ? pale : theme_.background, 1.2),
          letter_and_title(entry), is_hollow ? "simulated beside it" : "pale, for comparison", entry.id);
    }
  }

  const View& view_;
  const Theme& theme_;
  std::vector<LegendEntry> entries_;
};

std::vector<LegendEntry> title_of_pane(const View& view) {
  const Strategy& entry = strategy(view.settings.active);
  const std::size_t i = index_of(entry.id);
  const Marker icon{Vector<2>(0.0),         strategy_style(entry.id).shape, view.points(8.0),
                    view.theme.strategy[i], view.theme.background,          view.points(1.0)};
  return {{Role::device, entry.id, icon, letter_and_title(entry), std::string(1, entry.letter),
           view.theme.strategy_text[i]}};
}

void draw(const View& view, const std::vector<LegendEntry>& entries, const LegendForm& form, const ScreenBox& box,
          double strength, Marks& marks) {
  const ScreenPen pen{view, marks, Role::legend, strength};
  pen.backdrop(box);
  const double padding = view.points(legend_padding);
  const double row = view.points(legend_row);
  Vector<2> middle{box.least.x + padding + view.points(0.4 * icon_width), box.least.y + 0.5 * (padding + row)};
  for (const LegendEntry& entry : entries) {
    if (const auto* marker = std::get_if<Marker>(&entry.icon)) {
      Marker icon = *marker;
      icon.center = to_world(view.camera, middle);
      icon.fill = faded(icon.fill, strength);
      icon.rim = faded(icon.rim, strength);
      marks.push_back({Role::legend, entry.strategy, icon, entry.about});
    } else {
      Arrow icon = std::get<Arrow>(entry.icon);
      const Vector<2> half(view.points(11.0), 0.0);
      icon.tail = to_world(view.camera, middle - half);
      icon.tip = to_world(view.camera, middle + half);
      icon.fill = faded(icon.fill, strength);
      icon.rim = faded(icon.rim, strength);
      marks.push_back({Role::legend, entry.strategy, icon, entry.about});
    }
    const std::string& words = words_of(entry, form);
    const double height = view.measure(words, view.drawn(form.style)).y;
    pen.text({box.least.x + padding + view.points(icon_width), middle.y - 0.55 * height}, words, entry.colour,
             form.style);
    marks.back().strategy = entry.strategy;
    marks.back().about = entry.about;
    middle.y += row;
  }
}

}  // namespace

void add_legend(const View& view, LabelPlacer& labels, CornerMemory& memory, Marks& marks) {
  const std::vector<LegendEntry> entries = view.is_pane ? title_of_pane(view) : LegendEntries(view).all();
  const TextStyle& style = view.is_pane ? normal_text : small_text;
  const std::array forms{LegendForm{false, style}, LegendForm{true, style}};
  constexpr std::array corners{Corner::upper_left, Corner::upper_right, Corner::lower_left};
  std::vector<ScreenBox> places;
  for (const LegendForm& form : forms) {
    const Vector<2> extent = extent_of(view, entries, form);
    for (const Corner corner : corners) {
      places.push_back(box_in_corner(corner, extent, view.camera.size, view.points(legend_margin)));
    }
  }
  const auto found = place_in_corner(places, corners.size(), labels, memory);
  if (!found || found->strength <= 0.0) return;
  draw(view, entries, forms[found->place / corners.size()], places[found->place], found->strength, marks);
}

}  // namespace ghostforce
