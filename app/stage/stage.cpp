#include "app/stage/stage.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/stage/landscape_layers.h"
#include "app/stage/stage_layers.h"
#include "app/state/front_keys.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

// Of a handle that nobody knows nothing is drawn but, where there is one, the pose that its arms are to be put into.
void add_unknown_handle(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  add_stage_wall(layer);
  if (!content.linkage) return;
  add_mechanism(layer);
  const Colour own = stage_colour(content.moment, content.theme.strategy);
  canvas.disc(Role::linkage, canvas.at(handle_of(*content.linkage)), canvas.points(handle_radius), own, own, 0.0);
}

std::string unknown_handle_sentence(const StageContent& content) {
  return filled(content.language.warnings.device_not_ready, front_keys().device_status.shown);
}

constexpr StageModeLayers unknown_handle_layers{StageMode::none, add_unknown_handle, unknown_handle_sentence};

// Null: the scene as it is.
const StageModeLayers* layers_of(const StageContent& content) {
  static const std::array all{&predict_layers, &why_layers,    &landscape_layers,
                              &round_layers,   &ribbon_layers, &measure_layers};
  if (content.handle_is_unknown) return &unknown_handle_layers;
  // What is to be guessed is drawn as Predict does it.
  if (content.hides.handle) return &predict_layers;
  const auto found = std::ranges::find(all, content.mode, &StageModeLayers::id);
  return found == all.end() ? nullptr : *found;
}

std::string sentence_of(const StageContent& content, const StageModeLayers* mode) {
  if (!content.warning.empty()) return content.warning;
  // What keeps the hand from being measured is told in a lesson, too, until the question is answered.
  const bool is_held_up = content.measuring && content.measuring->has_trouble();
  if (content.lesson && (!is_held_up || content.lesson->is_right)) return content.lesson->text;
  if (mode != nullptr) {
    if (std::string words = mode->sentence(content); !words.empty()) return words;
  }
  if (!content.remark.empty()) return content.remark;
  return stage_sentence(content.settings, content.moment, content.audience, content.language);
}

// With the digits that choose them. Empty: there is nothing to choose.
std::string open_answers(const StageLesson& lesson) {
  std::string words;
  if (!lesson.is_open) return words;
  const std::vector<std::string>& answers = lesson.row().answers;
  for (std::size_t i = 0; i < answers.size(); ++i) words += fmt::format(" {}: {}.", i + 1, answers[i]);
  return words;
}

// Where a view can be moved, by who can press a button. A visitor cannot move it.
bool has_tools(const StageContent& content) {
  const bool is_map = content.mode == StageMode::landscape && !maps_workspace(content);
  // Upright, the ribbon needs their room.
  const bool is_ribbon = content.mode == StageMode::ribbon && content.size.x < content.size.y && !content.lesson;
  const bool has_view = !is_map && !is_ribbon && content.mode != StageMode::round;
  const bool is_visitor = content.lesson && !content.lesson->has_way_out;
  return content.has_controls && !is_visitor && has_view;
}

StageLayout layout_of(const StageContent& content, const StageModeLayers* mode) {
  if (content.is_bare) return bare_stage_layout(content.size, content.scale);
  const std::string sentence = sentence_of(content, mode);
  return stage_layout(content.size, content.scale, content.measure,
                      {.language = content.language,
                       .keys = content.keys,
                       .sentence = sentence,
                       .corner = content.corner ? std::string_view(content.corner->words) : "",
                       .corner_action = content.corner ? content.corner->action : StageCommand::next,
                       .has_full = !content.moment.is_measured || content.linkage.has_value(),
                       .has_strings = has_strings(content.settings),
                       .has_motors_to_choose = content.motors_in_use.has_value(),
                       .measuring = content.measuring_button ? &*content.measuring_button : nullptr,
                       .lesson = content.lesson ? &*content.lesson : nullptr,
                       .shows_menu = content.shows_menu,
                       .has_tools = has_tools(content),
                       .has_numbers = content.mode != StageMode::why,
                       .widths = content.widths});
}

void make_room_for_ribbon(const StageContent& content, StageLayout& layout) {
  // Its height is a matter of its letters alone.
  const Ribbon ribbon{.moments = *content.moments,
                      .looks_back_to_s = content.looks_back_to_s,
                      .language = content.language,
                      .theme = content.theme,
                      .measure = content.measure,
                      .camera = {.size = content.size},
                      .box = {}};
  const double bottom = layout.bottom - 10.0 * layout.unit;
  const double top = bottom - ribbon_height(ribbon);
  // With large letters, beside the numbers and what is below them.
  const double gap = 14.0 * layout.unit;
  Vector<2> end = layout.numbers ? layout.numbers->most : Vector<2>(0.0);
  if (const auto tools = layout.tools_box()) end = glm::max(end, tools->most);
  const double left = end.y + gap <= top ? layout.margin : std::max(layout.margin, end.x + gap);
  layout.ribbon = ScreenBox{{left, top}, {layout.size.x - layout.margin, bottom}};
  layout.bottom = layout.ribbon->least.y;
}

}  // namespace

void add_whole_scene(const StageLayer& layer) {
  add_stage_wall(layer);
  add_rail(layer);
  add_mechanism(layer);
  add_expectations(layer);
  add_springs(layer);
  add_stage_hand(layer);
  if (!layer.content.hides.slide) add_slide(layer);
  if (!layer.content.hides.force) add_stage_force(layer);
  add_part_grips(layer);
  add_handle(layer);
  add_rail_grips(layer);
  add_numbers(layer);
  add_device_inset(layer);
  add_stage_words(layer);
}

StageReading stage_reading(const StageContent& content) {
  const StageSecrets& hides = content.hides;
  StageReading reading{.strategy = content.settings.active,
                       .sentence = sentence_of(content, layers_of(content)),
                       .hides = hides,
                       .corner = content.corner,
                       .measuring = content.measuring_button,
                       .lesson = content.lesson,
                       .moment = content.moment,
                       .settings = content.settings};
  if (content.mode == StageMode::why && !hides.handle) reading.steps = why_steps(content);
  if (content.lesson && content.warning.empty()) {
    reading.sentence += open_answers(*content.lesson);
    // Above stands the lesson's text, and the number beside the hand.
    if (content.measuring && content.measuring->result) {
      reading.sentence +=
          fmt::format(" {}.", fmt::join(measured_hand_words(*content.measuring, content.language), ", "));
    }
  } else if (!content.lesson && content.mode == StageMode::landscape && !maps_workspace(content) &&
             content.warning.empty()) {
    // The map has its verdict in place of a sentence.
    reading.sentence = landscape_sentence(stage_landscape(content, {}, {}));
  }
  const bool is_asked = content.mode == StageMode::predict && content.guess.is_open;
  reading.hides.numbers = is_asked || hides.numbers || hides.handle;
  if (reading.hides.numbers) return reading;
  reading.numbers = stage_numbers(content.moment);
  if (hides.force) reading.numbers.force = reading.numbers.wall_share = reading.numbers.ghost_force = std::nullopt;
  if (hides.slide) reading.numbers.slide = std::nullopt;
  return reading;
}

StagePicture compose_stage(const StageContent& content, LabelMemory& memory, double interval_s, Marks earlier) {
  const StageModeLayers* const mode = layers_of(content);
  const bool is_map = content.mode == StageMode::landscape && !content.hides.handle && !maps_workspace(content);
  StageLayout layout = layout_of(content, mode);
  if (content.mode == StageMode::ribbon && content.moments != nullptr) make_room_for_ribbon(content, layout);
  const Camera camera = content.is_bare ? camera_on(content.shown.center, content.shown.width, content.size)
                                        : stage_camera(content.shown, layout);
  StagePicture picture{.pane = {Vector<2>(0.0), camera, content.settings.active, std::move(earlier)},
                       .unit = layout.unit};
  // A lesson's are also what it says.
  const bool has_buttons = !content.is_bare && (content.has_controls || content.lesson);
  Marks& marks = picture.pane.marks;
  marks.clear();
  std::vector<StagePart> parts;
  {
    LabelPlacer labels(content.size, layout.unit, content.measure, memory, interval_s);
    StageCanvas canvas{.camera = camera, .theme = content.theme, .unit = layout.unit, .marks = marks, .labels = labels};
    const StageLayer layer{content, layout, canvas};
    if (!content.is_bare) keep_frame_clear(layer);
    // Of an answered guess of a lesson; an open one belongs to Predict.
    const bool has_old_guess = content.lesson && mode != &predict_layers;
    if (has_old_guess) keep_guess_clear(layer);
    (mode != nullptr ? mode->add : add_whole_scene)(layer);
    if (has_old_guess) add_guess(layer);
    if (content.may_move_parts) parts = stage_parts(layer);
    if (!content.is_bare && (!is_map || content.lesson)) add_sentence(layer);
    if (has_buttons) add_buttons(layer);
    canvas.add_labels();
    if (has_buttons) add_overlays(layer);
    if (canvas.inset) picture.inset = canvas.inset->box;
    if (const auto ribbon = stage_ribbon(layer)) picture.ribbon = {*layout.ribbon, ribbon_axis(*ribbon)};
  }
  picture.scene = layout.scene();
  picture.numbers = layout.numbers;
  // Buttons are nearly clear while something is dragged below them; a lesson's rows and the ribbon are not. A map ends
  // before them.
  picture.reach = layout.lesson || layout.ribbon || maps_workspace(content) ? layout.scene()
                                                                            : ScreenBox{Vector<2>(0.0), layout.size};
  picture.pivot = content.rail_pivot.value_or(content.moment.handle);
  if (!is_map) {
    const StageMoment& moment = hides_rest(content) ? moment_of_question(content) : content.moment;
    const StageGrips grips = stage_grips(content.settings, moment, camera, layout, content.held_end);
    if (content.may_turn_motor) picture.motor_grips = grips.motor;
    if (content.may_turn_wall) picture.wall_grips = grips.wall;
    if (content.may_move_parts) picture.parts = std::move(parts);
  }
  if (is_map)
    picture.landscape = landscape_layout(stage_landscape(content, camera, {layout.header_box(), layout.bottom}));
  if (!has_buttons) return picture;
  for (const auto* const buttons :
       {&layout.strategies, &layout.header, &layout.tools, &layout.motors, &layout.key_hints}) {
    picture.buttons.insert(picture.buttons.end(), buttons->begin(), buttons->end());
  }
  picture.tools = layout.tools_box();
  picture.motors = layout.motors_box();
  for (const StageMenuRow& row : layout.menu) {
    picture.buttons.push_back({row.action, row.box, std::string(row.title)});
  }
  for (const auto* const button : {&layout.measuring, &layout.corner}) {
    if (*button) picture.buttons.push_back(**button);
  }
  if (!layout.menu.empty()) picture.menu = layout.menu_box;
  if (layout.lesson) {
    const std::vector<StageButton> buttons = lesson_buttons(*layout.lesson);
    picture.buttons.insert(picture.buttons.begin(), buttons.begin(), buttons.end());
  }
  return picture;
}

}  // namespace ghostforce
