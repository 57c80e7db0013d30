// What surrounds the scene in a lesson: its title, how far one has come, the way out; the mark beside the text; and
// below the answers, the slider and the ways back and on.
#include <algorithm>
#include <numbers>

#include <fmt/format.h>

#include "app/stage/stage_layers.h"

namespace ghostforce {
namespace {

void add_mark(const StageLayer& layer, LessonMark mark, const Vector<2>& middle, double reach, double width) {
  StageCanvas& canvas = layer.canvas;
  const Theme& theme = layer.content.theme;
  const auto at = [&](double x, double y) { return middle + reach * Vector<2>(x, y); };
  if (mark == LessonMark::right) {
    canvas.curve(Role::button, {at(-0.9, 0.1), at(-0.3, 0.7), at(0.9, -0.7)}, width, theme.accent);
  } else if (mark == LessonMark::wrong) {
    canvas.line(Role::button, at(-0.7, -0.7), at(0.7, 0.7), width, theme.problem);
    canvas.line(Role::button, at(-0.7, 0.7), at(0.7, -0.7), width, theme.problem);
  }
}

void add_header(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const StageLesson& lesson = *content.lesson;
  const LessonLayout& places = *layout.lesson;
  const Theme& theme = content.theme;
  add_plate(layer, Role::sentence, places.title_box, under_sentences);
  canvas.text(Role::sentence, places.title_box.least, places.title, layout.letters.bold_words, theme.text);
  canvas.text(Role::sentence, places.place, lesson.place, layout.letters.words, theme.text);
  for (std::size_t i = 0; i < places.dots.size(); ++i) {
    const Vector<2>& dot = places.dots[i];
    const bool is_present = i == lesson.step;
    if (lesson.dots[i] == LessonMark::wrong) {
      add_mark(layer, LessonMark::wrong, dot, canvas.points(6.0), canvas.width(2.5));
    } else {
      const bool is_right = lesson.dots[i] == LessonMark::right;
      const Colour colour = is_right ? theme.accent : i <= lesson.furthest ? theme.text : theme.faint_text;
      const Colour fill = is_right || i <= lesson.furthest ? colour : theme.background;
      canvas.disc(Role::button, dot, canvas.points(4.5), fill, colour, canvas.width(1.5));
    }
    if (!is_present) continue;
    const double half = canvas.points(6.0);
    const double y = dot.y + canvas.points(9.5);
    canvas.line(Role::button, {dot.x - half, y}, {dot.x + half, y}, canvas.width(2.5), theme.accent);
  }
}

// The first line's upper left corner in the middle of the button's height.
Vector<2> words_corner(const LessonLayout::Button& button, double left, double line) {
  const double height = static_cast<double>(button.lines.size()) * line;
  return {left, 0.5 * (button.box.least.y + button.box.most.y - height)};
}

void add_answer(const StageLayer& layer, std::size_t number) {
  const auto& [content, layout, canvas] = layer;
  const StageLesson& lesson = *content.lesson;
  const LessonLayout::Button& button = layout.lesson->answers[number];
  const Theme& theme = content.theme;
  const LessonMark mark = lesson.marks[number];
  const bool is_chosen = lesson.chosen == number;
  const bool is_hot = lesson.is_open && content.hovered == StageAction(static_cast<StageAnswer>(number));
  const Colour rim = is_hot || mark == LessonMark::right ? theme.accent
                     : mark == LessonMark::wrong         ? theme.problem
                                                         : theme.panel_border;
  canvas.box(Role::button, button.box, canvas.points(12.0), is_chosen ? theme.panel_field : theme.background, rim,
             canvas.width(is_chosen ? 4.0 : 2.0));
  const TextStyle& style = layout.letters.bold_words;
  const double left = button.box.least.x + canvas.points(18.0);
  const double middle = 0.5 * (button.box.least.y + button.box.most.y);
  if (lesson.is_open) {
    canvas.text(Role::button, {left, middle - 0.5 * style.height}, fmt::format("{}", number + 1), style,
                theme.faint_text, false);
  } else {
    add_mark(layer, mark, {left + canvas.points(9.0), middle}, canvas.points(11.0), canvas.width(4.5));
  }
  const bool is_told = lesson.is_open || mark != LessonMark::none;
  canvas.text(Role::button, words_corner(button, left + canvas.points(34.0), style.height), button.lines, style,
              is_told ? theme.text : theme.faint_text, false);
}

void add_slider(const StageLayer& layer, const StageLessonSlider& slider, const ScreenBox& box) {
  const auto& [content, layout, canvas] = layer;
  const Theme& theme = content.theme;
  const bool is_hot = content.hovered == StageAction(StageCommand::slider);
  canvas.box(Role::button, box, canvas.points(12.0), theme.background, is_hot ? theme.accent : theme.panel_border,
             canvas.width(2.0));
  const SliderTrack track = slider_track(box, canvas.unit);
  const double top = box.least.y + canvas.points(4.0);
  canvas.text(Role::button, {track.from.x, top}, slider.words, layout.letters.words, theme.text, false);
  if (!slider.value.empty()) {
    const double width = content.measure(slider.value, layout.letters.bold_words).x;
    canvas.text(Role::button, {track.to.x - width, top}, slider.value, layout.letters.bold_words, theme.text, false);
  }
  const Vector<2> knob = track.from + slider.share * (track.to - track.from);
  canvas.line(Role::button, track.from, track.to, canvas.width(5.0), theme.panel_border);
  canvas.line(Role::button, track.from, knob, canvas.width(5.0), theme.accent);
  canvas.disc(Role::button, knob, canvas.points(slider_knob), theme.background, theme.accent, canvas.width(4.0));
}

void add_way(const StageLayer& layer, const ScreenBox& box, const std::string& words, StageCommand command,
             bool is_first) {
  const auto& [content, layout, canvas] = layer;
  const Theme& theme = content.theme;
  const bool is_hot = content.hovered == StageAction(command);
  canvas.box(Role::button, box, canvas.points(12.0), is_first ? theme.panel_field : theme.background,
             is_hot || is_first ? theme.accent : theme.panel_border, canvas.width(is_first ? 3.0 : 2.0));
  const TextStyle& style = layout.letters.bold_words;
  const Vector<2> extent = content.measure(words, style);
  canvas.text(Role::button, 0.5 * (box.least + box.most - extent), words, style, theme.text, false);
}

}  // namespace

void add_lesson_frame(const StageLayer& layer) {
  const StageContent& content = layer.content;
  const StageLesson& lesson = *content.lesson;
  const LessonLayout& places = *layer.layout.lesson;
  add_header(layer);
  if (const auto& mark = layer.layout.mark) {
    const double side = mark->extent().y;
    add_mark(layer, LessonMark::right, mark->least + Vector<2>(0.45 * side, 0.5 * side), 0.4 * side,
             layer.canvas.width(5.0));
  }
  for (std::size_t i = 0; i < places.answers.size(); ++i) add_answer(layer, i);
  if (places.slider) add_slider(layer, *lesson.row().slider, *places.slider);
  if (places.language) add_way(layer, *places.language, lesson.other_language, StageCommand::language, false);
  if (places.back) add_way(layer, *places.back, lesson.back, StageCommand::previous, false);
  add_way(layer, places.next, lesson.next, StageCommand::next, true);
}

void keep_lesson_clear(const StageLayer& layer) {
  const LessonLayout& places = *layer.layout.lesson;
  LabelPlacer& labels = layer.canvas.labels;
  labels.keep_clear(places.title_box.grown(layer.canvas.points(4.0)));
  if (layer.layout.mark) labels.keep_clear(*layer.layout.mark);
  for (const StageButton& button : lesson_buttons(places)) labels.keep_clear(button.box.grown(layer.canvas.width(4.0)));
}

std::vector<StageButton> lesson_buttons(const LessonLayout& places) {
  std::vector<StageButton> buttons;
  for (std::size_t i = 0; i < places.answers.size(); ++i) {
    buttons.push_back({static_cast<StageAnswer>(i), places.answers[i].box, {}});
  }
  if (places.slider) buttons.push_back({StageCommand::slider, *places.slider, {}});
  if (places.back) buttons.push_back({StageCommand::previous, *places.back, {}});
  buttons.push_back({StageCommand::next, places.next, {}});
  if (places.language) buttons.push_back({StageCommand::language, *places.language, {}});
  return buttons;
}

}  // namespace ghostforce
