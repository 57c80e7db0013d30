// The frame round the stage's scene: the sentence and the two numbers above, the buttons, the menu.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "app/stage/stage_layers.h"

namespace ghostforce {
namespace {

bool is_hovered(const StageContent& content, const StageAction& action) {
  return content.hovered == action;
}

void add_strategy_button(const StageLayer& layer, const StageButton& button) {
  const auto& [content, layout, canvas] = layer;
  const Theme& theme = content.theme;
  const StrategyId id = std::get<StrategyId>(button.action);
  const bool is_active = content.settings.active == id;
  const Colour colour = theme.strategy[index_of(id)];
  const Colour rim = is_active ? colour : is_hovered(content, button.action) ? theme.accent : theme.panel_border;
  canvas.box(Role::button, button.box, canvas.points(12.0), is_active ? theme.panel_field : theme.background, rim,
             canvas.width(is_active ? 4.0 : 2.0));
  const double middle = 0.5 * (button.box.least.y + button.box.most.y);
  const double left = button.box.least.x;
  const StageLetters& letters = layout.letters;
  const double line_top = middle - 0.5 * letters.words.height;
  // While a question is open its answers have the digits.
  const bool has_key = !content.lesson || !content.lesson->is_open;
  if (has_key) {
    canvas.text(Role::button, {left + canvas.points(15.0), line_top}, fmt::format("{}", index_of(id) + 1),
                letters.bold_words, theme.faint_text, false);
  }
  canvas.marks.push_back({Role::button, id,
                          Marker{to_world(canvas.camera, {left + canvas.points(53.0), middle}),
                                 strategy_style(id).shape, canvas.points(10.0), colour, theme.background, 0.0}});
  const std::vector<std::string> lines =
      broken_into_lines(button.words, button.box.extent().x - canvas.points(88.0), letters.bold_words, content.measure);
  const double height = static_cast<double>(lines.size()) * letters.words.height;
  const double about_height = button.about.empty() ? 0.0 : letters.about.height;
  const Vector<2> words{left + canvas.points(74.0), middle - 0.5 * (height + about_height)};
  canvas.text(Role::button, words, lines, is_active ? letters.bold_words : letters.words,
              is_active ? theme.text : theme.faint_text, false);
  if (button.about.empty()) return;
  canvas.text(Role::button, words + Vector<2>(0.0, height), button.about, letters.about, theme.faint_text, false);
}

// Unmistakable from three metres while motors may push.
void add_corner_button(const StageLayer& layer, const StageButton& button, bool is_on) {
  const auto& [content, layout, canvas] = layer;
  const Theme& theme = content.theme;
  canvas.box(Role::button, button.box, canvas.points(12.0), is_on ? theme.problem : theme.panel_field,
             is_on ? theme.problem : theme.accent, canvas.width(3.0));
  const TextStyle& style = layout.letters.bold_words;
  const Vector<2> extent = content.measure(button.words, style);
  canvas.text(Role::button, 0.5 * (button.box.least + button.box.most - extent), button.words, style,
              is_on ? theme.background : theme.text, false);
}

// The mode that is on, and the motors that push.
bool is_chosen(const StageContent& content, const StageAction& action) {
  const bool pushes = content.motors_in_use && action == StageAction(*content.motors_in_use);
  return pushes || action == StageAction(content.mode);
}

// Without words it is the way out of a lesson.
void add_header_button(const StageLayer& layer, const StageButton& button) {
  const auto& [content, layout, canvas] = layer;
  const Theme& theme = content.theme;
  const auto mode = std::ranges::find(stage_mode_catalog(), content.mode, &StageModeEntry::id);
  const bool is_in_menu = mode != stage_mode_catalog().end() && mode->is_in_menu;
  const bool is_menu = button.action == StageAction(StageCommand::menu);
  const bool is_on = is_chosen(content, button.action) || (is_menu && (is_in_menu || content.shows_menu));
  const bool stands_out = is_on || is_hovered(content, button.action);
  canvas.box(Role::button, button.box, canvas.points(10.0), is_on ? theme.panel_field : theme.background,
             stands_out ? theme.accent : theme.panel_border, canvas.width(is_on ? 3.0 : 2.0));
  const Colour colour = stands_out ? theme.accent : theme.faint_text;
  const Vector<2> middle = 0.5 * (button.box.least + button.box.most);
  if (button.words.empty()) {
    constexpr double cross_reach = 0.204;  // of the button's width
    const double reach = cross_reach * button.box.extent().x;
    for (const double y : {-reach, reach}) {
      canvas.curve(Role::button, {middle - Vector<2>(reach, y), middle + Vector<2>(reach, y)}, canvas.width(2.5),
                   colour);
    }
    return;
  }
  const Vector<2> extent = content.measure(button.words, layout.letters.words);
  canvas.text(Role::button, middle - 0.5 * extent, button.words, layout.letters.words, colour, false);
}

// Below the buttons, to the right.
struct HoverPanel {
  std::vector<std::string> lines;
  ScreenBox box;
};

constexpr double hover_padding = 10.0;
constexpr double menu_padding = 18.0;
constexpr double plate_padding = 7.0;
constexpr double air_round_panel = 3.0;  // in which no words stand

std::string_view words_of_part(const StageContent& content) {
  const StageLanguage::Hovers& all = content.language.hovers;
  if (content.linkage) return content.language.device.other_motor;
  if (content.hovered_part == ScenePart::elbow) return all.elbow;
  const bool is_base = content.hovered_part == ScenePart::left_base || content.hovered_part == ScenePart::right_base;
  return is_base ? all.motor_joint : all.part;
}

std::optional<HoverPanel> hover_panel(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  // Who has pressed a button has read what it does, and the menu tells of its rows itself.
  // Who holds something knows what it is.
  const bool is_on =
      (content.hovered && is_chosen(content, *content.hovered)) || !layout.menu.empty() || content.is_dragging;
  const StageLanguage::Hovers& all = content.language.hovers;
  const std::string words = is_on             ? ""
                            : content.hovered ? hover_words(*content.hovered, content.language, content.keys)
                            : content.hovered_grip == StageGrip::wall  ? std::string(all.wall)
                            : content.hovered_grip == StageGrip::motor ? std::string(all.motor)
                            : content.hovered_part                     ? std::string(words_of_part(content))
                                                                       : "";
  if (words.empty()) return std::nullopt;
  const TextStyle& style = layout.letters.words;
  HoverPanel panel{broken_into_lines(words, 0.45 * layout.size.x, style, content.measure), {}};
  const Vector<2> extent = canvas.labels.extent_of(panel.lines, style);
  const double padding = canvas.points(hover_padding);
  // What stands at the left has its words beside it.
  for (const auto* const row : {&layout.tools, &layout.motors}) {
    if (!content.hovered || std::ranges::find(*row, *content.hovered, &StageButton::action) == row->end()) continue;
    const ScreenBox buttons = *StageLayout::box_round(*row);
    const Vector<2> corner(buttons.most.x + canvas.points(8.0) + padding, buttons.least.y + padding);
    panel.box = ScreenBox{corner, corner + extent}.grown(padding);
    return panel;
  }
  const ScreenBox& above = layout.header_end();
  const double left = above.most.x - extent.x - 2.0 * padding;
  const bool is_beside_sentence = left > layout.sentence_box.most.x + padding;
  const double below = layout.lesson ? std::max(above.most.y, layout.lesson->title_box.most.y) : above.most.y;
  const double top = is_beside_sentence ? below : std::max(below, layout.sentence_box.most.y);
  const Vector<2> corner = Vector<2>(left, top + canvas.points(8.0)) + Vector<2>(padding);
  panel.box = ScreenBox{corner, corner + extent}.grown(padding);
  return panel;
}

// Words are painted over all boxes. Those below this one go, with all that belongs to them, so that nothing else has to
// move.
void take_words_away(const StageLayer& layer, const ScreenBox& box) {
  const auto& [content, layout, canvas] = layer;
  const auto is_below = [&](const Mark& mark) {
    const auto* const label = std::get_if<Label>(&mark.form);
    if (label == nullptr) return false;
    const Vector<2> corner = to_screen(canvas.camera, label->anchor) + label->offset;
    return overlap(box, ScreenBox{corner, corner + content.measure(label->text, label->style)}) > 0.0;
  };
  // A map's words, and those of buttons, each stand for themselves.
  const bool is_map = content.mode == StageMode::landscape;
  const auto stands_alone = [is_map](const Mark& mark) {
    return is_map || mark.role == Role::map || mark.role == Role::button;
  };
  // A line that leads to words goes with them.
  Marks& marks = canvas.marks;
  const auto leads_to_words = [&](std::size_t i) {
    return std::holds_alternative<Line>(marks[i].form) && i + 1 < marks.size() && marks[i + 1].role == marks[i].role &&
           std::holds_alternative<Label>(marks[i + 1].form);
  };
  const auto is_crossed = [&](const Mark& mark) {
    const Line& line = std::get<Line>(mark.form);
    ScreenPiece piece{to_screen(canvas.camera, line.from), to_screen(canvas.camera, line.to), 0.0};
    return clip(box, piece);
  };
  std::vector<Role> covered;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (stands_alone(marks[i])) continue;
    if (is_below(marks[i]) || (leads_to_words(i) && is_crossed(marks[i]))) covered.push_back(marks[i].role);
  }
  Marks kept;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const bool belongs_to_words = std::holds_alternative<Label>(marks[i].form) || leads_to_words(i);
    const bool goes = stands_alone(marks[i]) ? is_below(marks[i])
                                             : belongs_to_words && std::ranges::count(covered, marks[i].role) > 0;
    if (!goes) kept.push_back(marks[i]);
  }
  marks = std::move(kept);
}

void add_hover_panel(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const auto panel = hover_panel(layer);
  if (!panel) return;
  take_words_away(layer, panel->box.grown(canvas.points(air_round_panel)));
  canvas.box(Role::hint, panel->box, canvas.points(10.0), content.theme.panel, content.theme.panel_border,
             canvas.width(1.5));
  canvas.text(Role::hint, panel->box.grown(-canvas.points(hover_padding)).least, panel->lines, layout.letters.words,
              content.theme.text, false);
}

void add_menu(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const Theme& theme = content.theme;
  const TextStyle& style = layout.letters.words;
  const double padding = canvas.points(menu_padding);
  const auto end_of = [](const StageMenuRow& row) { return row.box.most.y; };
  take_words_away(layer, layout.menu_box.grown(canvas.points(air_round_panel)));
  canvas.box(Role::button, layout.menu_box, canvas.points(10.0), theme.panel, theme.panel_border, canvas.width(2.0));
  for (const StageMenuRow& row : layout.menu) {
    const ScreenBox& box = row.box;
    const bool is_hot = is_hovered(content, row.action);
    if (is_hot) canvas.box(Role::button, box, canvas.points(8.0), theme.panel_field, theme.panel_field, 0.0);
    const bool is_on = row.action == StageAction(content.mode);
    const double top = 0.5 * (box.least.y + box.most.y - style.height);
    canvas.text(Role::button, {box.least.x + padding, top}, std::string(row.title), style,
                is_on || is_hot ? theme.accent : theme.text, false);
    const std::string key(row.key);
    canvas.text(Role::button, {box.most.x - padding - content.measure(key, style).x, top}, key, style, theme.faint_text,
                false);
  }
  if (layout.least_target > 0.0) return;
  const auto hot = std::ranges::find_if(layout.menu, [&](const auto& row) { return is_hovered(content, row.action); });
  const std::string_view about = hot == layout.menu.end() ? content.language.hovers.more : hot->about;
  const double width = layout.menu_box.extent().x - 2.0 * padding;
  const double below = std::ranges::max(layout.menu, {}, end_of).box.most.y + canvas.points(4.0);
  canvas.text(Role::button, {layout.menu_box.least.x + padding, below},
              broken_into_lines(about, width, style, content.measure), style, theme.faint_text, false);
}

// Beside the button that it speaks of, whatever lies there: far from it, nobody would know which one is meant. A mode has
// words of its own.
void add_cure_hint(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  if (content.hint != StageHint::cure || content.mode != StageMode::none) return;
  const TextStyle& style = layout.letters.bold_words;
  const std::string words(content.language.buttons.cure_hint);
  const Vector<2> extent = content.measure(words, style);
  const double left = std::min(layout.strategies.back().box.least.x, layout.size.x - layout.margin - extent.x);
  const Vector<2> corner(left, layout.strategies.front().box.least.y - canvas.points(10.0) - extent.y);
  const ScreenBox box{corner, corner + extent};
  if (canvas.labels.obstacles().is_crossed(box, Clearance::always)) {
    add_plate(layer, Role::hint, box, under_sentences);
  }
  canvas.labels.keep_clear(box);
  canvas.text(Role::hint, corner, words, style, content.theme.accent);
}

struct LargeNumber {
  std::string number;  // empty: it cannot be known
  std::string_view unit;
  std::string words;
};

void add_number(const StageLayer& layer, const LargeNumber& number, const Vector<2>& corner) {
  const auto& [content, layout, canvas] = layer;
  const StageLetters& letters = layout.letters;
  const Theme& theme = content.theme;
  // On the way from one strategy to another it is no strategy's own.
  const Colour shown =
      content.moment.is_between() ? theme.faint_text : stage_colour(content.moment, theme.strategy_text);
  const std::string digits = number.number.empty() ? "–" : number.number;
  const double width = content.measure(digits, letters.number).x;
  canvas.text(Role::number, corner + Vector<2>(layout.number_width - width, 0.0), digits, letters.number, shown);
  canvas.text(Role::number,
              corner + Vector<2>(layout.number_width + canvas.points(14.0),
                                 0.79 * letters.number.height - 0.79 * letters.unit.height),
              std::string(number.unit), letters.unit, theme.faint_text);
  canvas.text(Role::number, corner + Vector<2>(0.0, letters.number.height - canvas.points(6.0)), number.words,
              letters.words, theme.faint_text);
}

constexpr double least_shown_torque = 0.005;  // [N·m]

double ghost_effort(const StageContent& content) {
  return efforts_of(content.settings, content.moment.handle, content.moment.ghost_force)[0];
}

}  // namespace

void add_plate(const StageLayer& layer, Role role, const ScreenBox& words, double strength) {
  const auto& [content, layout, canvas] = layer;
  const Colour plate = faded(content.theme.background, strength);
  canvas.box(role, words.grown(canvas.points(plate_padding)), canvas.points(8.0), plate, plate, 0.0);
}

void add_sentence(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const bool is_crossed = canvas.labels.obstacles().is_crossed(layout.sentence_box, Clearance::always);
  if (content.lesson || is_crossed) add_plate(layer, Role::sentence, layout.sentence_box, under_sentences);
  if (content.lesson && content.settings.general.mechanism != MechanismKind::axes) {
    // Between words and the picture's edge, the end of a link would be taken for a stray line.
    ScreenBox margin = layout.sentence_box;
    margin.most.x = margin.least.x - canvas.points(plate_padding);
    margin.least.x = 0.0;
    add_plate(layer, Role::sentence, margin, 1.0);
  }
  canvas.text(Role::sentence, layout.sentence_box.least, layout.sentence, layout.letters.sentence,
              content.warning.empty() ? content.theme.text : content.theme.problem);
}

void add_place_of_numbers(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  if (!layout.numbers) return;
  // A hand that is dragged may be there until it is let go, and must be seen, too.
  constexpr double under_numbers = 0.6;
  const LabelObstacles& obstacles = canvas.labels.obstacles();
  const bool has_mechanism = content.settings.general.mechanism != MechanismKind::axes;
  const auto is_below = [&](const Vector<2>& place) {
    return contains(layout.numbers->grown(canvas.points(40.0)), canvas.at(place));
  };
  const bool covers_hand = has_mechanism ? is_below(content.moment.goal) || is_below(content.moment.handle)
                                         : obstacles.is_crossed(*layout.numbers, Clearance::if_possible);
  if (!content.hides.numbers && obstacles.is_crossed(*layout.numbers, Clearance::always)) {
    ScreenBox plate = *layout.numbers;
    // Joints and strings that shine through would be taken for digits; the small picture has them.
    if (has_mechanism) plate.least.x = 0.0;
    add_plate(layer, Role::number, plate, covers_hand ? under_numbers : has_mechanism ? 1.0 : under_sentences);
  }
  canvas.labels.keep_clear(layout.numbers->grown(canvas.points(plate_padding)));
}

void add_numbers(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  add_place_of_numbers(layer);
  if (content.hides.numbers || !layout.numbers) return;
  const ScreenBox& box = *layout.numbers;
  const StageNumbers numbers = stage_numbers(content.moment);
  const std::optional<double>& ghost = numbers.ghost_force;
  const StageLanguage::Numbers& all = content.language.numbers;
  const std::string_view ghost_words = words_of_ghost_force(content.hides.force ? 0.0 : ghost, all);
  // What it is at a motor that turns.
  const double torque = has_joints(content.settings) ? std::abs(ghost_effort(content)) : 0.0;
  const bool tells_torque = ghost_words == all.ghost_force && !content.hides.force && torque >= least_shown_torque;
  const std::string ghost_told = tells_torque
                                     ? filled(content.language.labels.torque, ghost_words, force_number(torque))
                                     : std::string(ghost_words);
  const auto told = [](bool is_hidden, const std::optional<double>& number, const auto& words) -> std::string {
    return is_hidden ? "?" : number ? words(*number) : "";
  };
  add_number(layer, {told(content.hides.force, ghost, force_number), "N", ghost_told}, box.least);
  const Vector<2> below(0.0, 0.5 * (box.extent().y + canvas.points(6.0)));
  add_number(layer,
             {told(content.hides.slide, numbers.slide, slide_number), "mm",
              std::string(numbers.slide ? all.slide : all.slide_unknown)},
             box.least + below);
}

namespace {

void fade(Mark& mark, double strength) {
  if (auto* const box = std::get_if<Box>(&mark.form)) {
    box->fill = faded(box->fill, strength);
    box->rim = faded(box->rim, strength);
  } else if (auto* const label = std::get_if<Label>(&mark.form)) {
    label->colour = faded(label->colour, strength);
    label->halo = faded(label->halo, strength);
  } else if (auto* const marker = std::get_if<Marker>(&mark.form)) {
    marker->fill = faded(marker->fill, strength);
    marker->rim = faded(marker->rim, strength);
  } else if (auto* const line = std::get_if<Line>(&mark.form)) {
    line->colour = faded(line->colour, strength);
  }
}

// While something is dragged the view stands still: a button that lies over it is nearly clear until it is let go. The
// one that stops motors never is.
void add_button(const StageLayer& layer, const StageButton& button, const auto& add) {
  const auto& [content, layout, canvas] = layer;
  constexpr double over_what_is_dragged = 0.3;
  const std::size_t begin = canvas.marks.size();
  add(layer, button);
  if (!content.is_dragging || !canvas.labels.obstacles().is_crossed(button.box, Clearance::if_possible)) return;
  for (std::size_t i = begin; i < canvas.marks.size(); ++i) fade(canvas.marks[i], over_what_is_dragged);
}

}  // namespace

void add_buttons(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  for (const StageButton& button : layout.strategies) add_button(layer, button, add_strategy_button);
  for (const StageButton& button : layout.header) add_button(layer, button, add_header_button);
  for (const StageButton& button : layout.tools) add_button(layer, button, add_header_button);
  for (const StageButton& button : layout.motors) add_button(layer, button, add_header_button);
  if (content.lesson) add_lesson_frame(layer);
  if (layout.measuring) add_corner_button(layer, *layout.measuring, false);
  if (layout.corner && content.corner->is_alarming) {
    add_corner_button(layer, *layout.corner, true);
  } else if (layout.corner) {
    add_button(layer, *layout.corner,
               [](const StageLayer& at, const StageButton& button) { add_corner_button(at, button, false); });
  }
  for (const StageButton& hint : layout.key_hints) {
    canvas.text(Role::button, hint.box.least, hint.words, layout.letters.words,
                is_hovered(content, hint.action) ? content.theme.accent : content.theme.faint_text);
  }
  add_cure_hint(layer);
}

// What lies over everything else.
void add_overlays(const StageLayer& layer) {
  add_hover_panel(layer);
  if (!layer.layout.menu.empty()) add_menu(layer);
}

void keep_frame_clear(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  LabelPlacer& labels = canvas.labels;
  // Words beside it must not read as its end.
  const Vector<2> aside(layout.unit * 4.0, 0.0);
  labels.keep_clear(ScreenBox{layout.sentence_box.least - aside, layout.sentence_box.most + aside});
  const double rim = canvas.width(2.0);
  for (const StageButton& button : layout.strategies) labels.keep_clear(button.box.grown(rim));
  for (const StageButton& button : layout.header) labels.keep_clear(button.box.grown(rim));
  for (const StageButton& button : layout.tools) labels.keep_clear(button.box.grown(rim));
  for (const StageButton& button : layout.motors) labels.keep_clear(button.box.grown(rim));
  for (const StageButton& hint : layout.key_hints) labels.keep_clear(hint.box.grown(rim));
  for (const auto* const button : {&layout.measuring, &layout.corner}) {
    if (*button) labels.keep_clear((*button)->box.grown(rim));
  }
  if (layout.lesson) keep_lesson_clear(layer);
  if (layout.ribbon) labels.keep_clear(*layout.ribbon);
}

}  // namespace ghostforce
