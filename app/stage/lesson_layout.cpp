#include "app/stage/lesson_layout.h"

#include <algorithm>
#include <utility>

#include "app/picture/text.h"
#include "app/stage/stage_places.h"

namespace ghostforce {
namespace {

// In points of a picture 720 points high.
constexpr double row_height = 56.0;
constexpr double padding = 18.0;
constexpr double number_room = 34.0;  // of an answer's digit and, once it is answered, its mark
constexpr double row_gap = 10.0;
constexpr double button_gap = 14.0;
constexpr double least_slider = 330.0;
constexpr double leave_side = 46.0;
constexpr double dot_step = 17.0;
constexpr double slider_padding = 6.0;

constexpr double most_of_width = 0.3;  // that the title takes
constexpr double most_of_upright = 0.6;
constexpr double most_of_height = 0.34;  // that the rows of buttons take

// A thing in the row, from left to right.
struct Item {
  std::vector<std::string> lines{};
  Vector<2> size{0.0};
  ScreenBox box{};
};

class LessonArrangement {
 public:
  LessonArrangement(const StageLesson& lesson, const StageFrameWords& words, const MeasureText& measure,
                    StageLayout& layout)
      : lesson_(lesson), words_(words), measure_(measure), layout_(layout) {
    layout.lesson.emplace();
  }

  bool arrange() {
    const bool header_fits = arrange_header();
    bool rows_fit = true;
    for (const StageLessonRow& row : lesson_.rows) rows_fit = arrange_row(row) && rows_fit;
    arrange_row(lesson_.row());
    return header_fits && rows_fit;
  }

 private:
  double points(double of_design) const { return of_design * layout_.unit; }
  double target(double of_design) const { return std::max(points(of_design), layout_.least_target); }
  double width_of(const std::string& words, const TextStyle& style) const { return measure_(words, style).x; }

  bool arrange_header() {
    LessonLayout& made = *layout_.lesson;
    const double top = layout_.margin - points(10.0);
    const double right = layout_.size.x - layout_.margin;
    const TextStyle& title = layout_.letters.bold_words;
    const bool has_language = !lesson_.has_way_out && !lesson_.other_language.empty();
    const double corner_width = lesson_.has_way_out ? target(leave_side)
                                : has_language      ? width_of(lesson_.other_language, title) + points(2.0 * padding)
                                                    : 0.0;
    made.corner = {{right - corner_width, top}, {right, top + target(leave_side)}};
    made.language = has_language ? std::optional(made.corner) : std::nullopt;
    layout_.header.clear();
    layout_.menu.clear();
    if (lesson_.has_way_out) layout_.header.push_back({StageCommand::leave, made.corner, {}});
    const TextStyle& words = layout_.letters.words;
    const double most = (layout_.is_upright ? most_of_upright : most_of_width) * layout_.size.x;
    made.title = broken_into_lines(lesson_.title, most, title, measure_);
    double width = 0.0;
    for (const std::string& line : made.title) width = std::max(width, width_of(line, title));
    const double place_width = width_of(lesson_.place, words);
    const double dots_width = static_cast<double>(lesson_.dots.size()) * points(dot_step);
    // Long lessons have their dots below.
    const bool is_one_line = place_width + points(button_gap) + dots_width <= std::max(width, most);
    const double below =
        is_one_line ? place_width + points(button_gap) + dots_width : std::max(place_width, dots_width);
    width = std::max(width, below);
    const double left = made.corner.least.x - points(button_gap) - width;
    const double title_height = static_cast<double>(made.title.size()) * title.height;
    made.place = {left, top + title_height};
    const double dots_left = is_one_line ? left + place_width + points(button_gap) : left;
    const double dots_y = made.place.y + (is_one_line ? 0.5 : 1.3) * words.height;
    made.dots.clear();
    for (std::size_t i = 0; i < lesson_.dots.size(); ++i) {
      made.dots.push_back({dots_left + (static_cast<double>(i) + 0.5) * points(dot_step), dots_y});
    }
    made.title_box = {{left, top},
                      {made.corner.least.x - points(button_gap),
                       std::max(made.place.y + words.height, dots_y + points(0.5 * dot_step))}};
    layout_.header_left = left;
    return made.title.size() <= 2 && width <= 1.2 * most;
  }

  Item button(const std::string& words, double room_before) const {
    const TextStyle& style = layout_.letters.bold_words;
    const double around = points(room_before + 2.0 * padding);
    Item item{.lines = broken_into_lines(words, row_width() - around, style, measure_)};
    for (const std::string& line : item.lines) item.size.x = std::max(item.size.x, width_of(line, style));
    item.size.x += around;
    item.size.y = std::max(target(row_height), static_cast<double>(item.lines.size()) * style.height + points(padding));
    return item;
  }

  Item slider(const StageLessonSlider& shown) const {
    const double words = width_of(shown.words, layout_.letters.words) + points(button_gap) +
                         std::max(width_of(shown.value, layout_.letters.bold_words),
                                  width_of(shown.longest, layout_.letters.bold_words));
    const double around = points(2.0 * (slider_padding + slider_knob));
    return {.size = {std::max(points(least_slider), words + around),
                     std::max(layout_.letters.words.height + around, layout_.least_target)}};
  }

  double row_width() const { return layout_.size.x - 2.0 * layout_.margin; }

  // Puts the items into as few rows as can be; what leads on stands at the end of the last.
  bool arrange_row(const StageLessonRow& row) {
    std::vector<Item> items;
    if (row.slider) items.push_back(slider(*row.slider));
    const std::size_t first_strategy = items.size();
    std::vector<StageButton> strategies;
    if (row.has_strategies) {
      for (const Strategy& strategy : strategy_catalog()) {
        if (strategy.id == StrategyId::full && !words_.has_full) continue;
        const StrategyWords words{.name = words_.language.strategy_buttons[index_of(strategy.id)].name, .about = ""};
        strategies.push_back({strategy.id, {}, std::string(words.name)});
        const double width = strategy_button_width(words, layout_.unit, layout_.letters, measure_);
        items.push_back({.lines = {}, .size = {width, target(row_height)}});
      }
    }
    const std::size_t measuring = items.size();
    if (row.has_measuring && words_.measuring != nullptr) items.push_back(button(words_.measuring->longest, 0.0));
    const std::size_t first_answer = items.size();
    for (const std::string& answer : row.answers) items.push_back(button(answer, number_room));
    std::vector<Item> ends;
    if (!words_.corner.empty()) ends.push_back(button(std::string(words_.corner), 0.0));
    if (!lesson_.back.empty()) ends.push_back(button(lesson_.back, 0.0));
    ends.push_back(button(lesson_.next, 0.0));

    place(items, ends);

    LessonLayout& made = *layout_.lesson;
    made.slider.reset();
    if (row.slider) made.slider = items.front().box;
    for (std::size_t i = 0; i < strategies.size(); ++i) strategies[i].box = items[first_strategy + i].box;
    layout_.strategies = std::move(strategies);
    layout_.measuring.reset();
    if (measuring < first_answer) {
      layout_.measuring = StageButton{StageCommand::measure, items[measuring].box, words_.measuring->words};
    }
    made.answers.clear();
    for (std::size_t i = first_answer; i < items.size(); ++i) {
      made.answers.push_back({items[i].box, std::move(items[i].lines)});
    }
    layout_.corner.reset();
    layout_.key_hints.clear();
    if (!words_.corner.empty())
      layout_.corner = StageButton{words_.corner_action, ends.front().box, std::string(words_.corner)};
    made.back.reset();
    if (!lesson_.back.empty()) made.back = ends[ends.size() - 2].box;
    made.next = ends.back().box;
    const bool is_wide =
        std::ranges::any_of(items, [&](const Item& item) { return item.box.extent().x > row_width(); });
    const bool is_high = std::ranges::any_of(items, [](const Item& item) { return item.lines.size() > 2; });
    const bool ends_fit = ends.front().box.least.x >= layout_.margin;
    return !is_wide && !is_high && ends_fit && layout_.size.y - made.top <= most_of_height * layout_.size.y;
  }

  void place(std::vector<Item>& items, std::vector<Item>& ends) {
    const double gap = points(button_gap);
    double ends_width = -gap;
    for (const Item& end : ends) ends_width += end.size.x + gap;
    // Rows, as numbers of the items that they end before.
    std::vector<std::size_t> rows;
    double x = 0.0;
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (x > 0.0 && x + items[i].size.x > row_width()) {
        rows.push_back(i);
        x = 0.0;
      }
      x += items[i].size.x + gap;
    }
    if (x > 0.0 && x + ends_width > row_width()) rows.push_back(items.size());
    rows.push_back(items.size());
    // From the last row upwards.
    double bottom = layout_.size.y - layout_.margin - points(10.0);
    const double ends_height = std::ranges::max(ends, {}, [](const Item& item) { return item.size.y; }).size.y;
    for (std::size_t i = rows.size(); i-- > 0;) {
      const std::size_t begin = i == 0 ? 0 : rows[i - 1];
      const bool is_last = i + 1 == rows.size();
      double height = is_last ? ends_height : 0.0;
      for (std::size_t k = begin; k < rows[i]; ++k) height = std::max(height, items[k].size.y);
      double left = layout_.margin;
      for (std::size_t k = begin; k < rows[i]; ++k) {
        items[k].box = {{left, bottom - height}, {left + items[k].size.x, bottom}};
        left += items[k].size.x + gap;
      }
      if (is_last) {
        double right = layout_.size.x - layout_.margin;
        for (std::size_t k = ends.size(); k-- > 0;) {
          ends[k].box = {{right - ends[k].size.x, bottom - height}, {right, bottom}};
          right -= ends[k].size.x + gap;
        }
      }
      layout_.lesson->top = bottom - height;
      bottom -= height + points(row_gap);
    }
  }

  const StageLesson& lesson_;
  const StageFrameWords& words_;
  const MeasureText& measure_;
  StageLayout& layout_;
};

}  // namespace

bool arrange_lesson(const StageLesson& lesson, const StageFrameWords& words, const MeasureText& measure,
                    StageLayout& layout) {
  return LessonArrangement(lesson, words, measure, layout).arrange();
}

SliderTrack slider_track(const ScreenBox& slider, double unit) noexcept {
  const double inset = (slider_knob + slider_padding) * unit;
  const double y = slider.most.y - inset;
  return {{slider.least.x + inset, y}, {slider.most.x - inset, y}};
}

}  // namespace ghostforce
