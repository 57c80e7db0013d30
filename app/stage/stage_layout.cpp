#include "app/stage/stage_layout.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ranges>

#include <fmt/format.h>

#include "app/stage/lesson_layout.h"
#include "app/stage/sentence_widths.h"
#include "app/stage/stage_places.h"
#include "app/stage/stage_sentence.h"
#include "app/state/stage_view.h"

namespace ghostforce {
namespace {

// Where nothing else is said, in points of the design.
constexpr double line_of_em = 1.17;  // height of a line of text over its nominal size
constexpr double words_em = 24.0;    // a thirtieth of the height, which the last row of a lecture hall can read
constexpr double about_em = 17.0;    // below the name of a strategy, which says enough without it
constexpr double sentence_em = 29.0;
constexpr double lesson_em = 27.0;                    // of a lesson's text, which is longer than a sentence
constexpr std::string_view widest_energy = "+888.8";  // of a round [mJ]
constexpr double number_em = 74.0;
constexpr double unit_em = 34.0;
constexpr double edge_margin = 36.0;
constexpr double button_height = 56.0;
constexpr double two_lines_padding = 8.0;  // above and below two lines in a button, together
constexpr double header_height = 40.0;
constexpr double header_gap = 4.0;
constexpr double header_padding = 8.0;
constexpr double menu_row_height = 40.0;
constexpr double menu_lines = 3.0;     // below the rows, of what is said of one of them
constexpr double menu_key_gap = 30.0;  // between the longest words and the widest key
constexpr double gap = 14.0;
constexpr double button_padding = 18.0;
constexpr double below_numbers = 8.0;
constexpr double below_upright_header = 18.0;

// A window that is less wide or high than that is a phone's, where a finger wants buttons that are so high [points].
constexpr double widest_phone = 500.0;
constexpr double finger = 44.0;
// Wider than that, for its height, a window has room for words beside the buttons above.
constexpr double widest_upright = 0.7;

// The number block must leave the lower half to the scene.
constexpr double greatest_block = 0.6;
constexpr std::size_t most_lines = 3;
constexpr std::size_t most_lesson_lines = 4;
constexpr double mark_room = 44.0;  // of a lesson's mark before its text

// Whole points: the letters that are painted then are as they were made.
StageLetters letters_at(double unit, double longer_text_em) {
  const auto style = [&](double em, bool is_bold) { return TextStyle{std::ceil(em * line_of_em * unit), is_bold}; };
  return {style(words_em, false), style(words_em, true), style(longer_text_em, true),
          style(number_em, true), style(unit_em, false), style(about_em, false)};
}

// What is the same at every size.
struct StageTexts {
  // All that may stand where the sentence does: the language's own, see SentenceWidths, in a lesson its warnings alone.
  std::vector<std::string_view> there;
  bool has_sentences = false;
  // Of the sentences, or of the lesson's texts: letters must be small enough for it, so that they do not change with what
  // is said.
  std::string_view longest{};
  std::vector<StageMenuRow> menu{};  // empty: it is closed
};

StageTexts texts_of(const MeasureText& measure, const StageFrameWords& words, SentenceWidths& widths) {
  StageTexts texts{.there = all_said_there(words.language), .has_sentences = words.lesson == nullptr};
  if (words.lesson != nullptr) {
    texts.longest = words.lesson->longest_text;
  } else {
    const std::vector<double>& wide = widths.of(words.language, letters_at(1.0, sentence_em).sentence, measure);
    const auto widest = std::max_element(wide.begin(), wide.begin() + sentence_count);
    texts.longest = texts.there[static_cast<std::size_t>(widest - wide.begin())];
  }
  if (words.shows_menu) texts.menu = stage_menu(words.language, words.keys);
  return texts;
}

// What the strategies' buttons say: less in each, and so in narrower ones.
enum class CardWords : std::uint8_t { name_and_about, name, name_in_two_lines };

// Of a name in two lines; a name has two words at most.
std::string_view longer_line(std::string_view name) {
  const std::size_t first = std::min(name.find(' '), name.size());
  const std::string_view rest = name.substr(std::min(first + 1, name.size()));
  return rest.size() > first ? rest : name.substr(0, first);
}

class Arrangement {
 public:
  Arrangement(const Vector<2>& size, double scale, const MeasureText& measure, const StageFrameWords& words,
              const StageTexts& texts, SentenceWidths& widths)
      : measure_(measure), words_(words), texts_(texts), widths_(widths) {
    layout_.size = size;
    layout_.unit = size.y / height_of_design * scale;
    layout_.margin = points(edge_margin);
    layout_.least_target = std::min(size.x, size.y) < widest_phone ? finger : 0.0;
    layout_.is_upright = size.x < widest_upright * size.y;
    layout_.letters = letters_at(layout_.unit, words.lesson ? lesson_em : sentence_em);
  }

  // False where something does not fit.
  bool arrange(CardWords shown) {
    layout_.strategies.clear();
    bool buttons_fit = false;
    if (words_.lesson != nullptr) {
      buttons_fit = arrange_lesson(*words_.lesson, words_, measure_, layout_);
    } else {
      arrange_header();
      buttons_fit = layout_.header_left >= 0.0 && arrange_buttons(shown);
    }
    arrange_numbers();
    const std::size_t most = words_.lesson != nullptr ? most_lesson_lines : most_lines;
    const bool sentence_fits = lines_of(texts_.longest) <= most;
    const double block_height =
        first_line() + static_cast<double>(most) * layout_.letters.sentence.height + numbers_size_.y;
    // In an upright window the buttons stand below each other, and leave the scene less.
    constexpr double least_scene = 300.0;
    const double tools_height = points(below_numbers) + target(header_height);
    const bool scene_fits = !layout_.is_upright || words_.lesson != nullptr || layout_.strategies.empty() ||
                            layout_.strategies.front().box.least.y - block_height - tools_height >= points(least_scene);
    return buttons_fit && sentence_fits && scene_fits && block_height <= greatest_block * layout_.size.y;
  }

  StageLayout finished() {
    const bool has_mark = words_.lesson != nullptr && words_.lesson->is_right;
    layout_.sentence = lines(words_.sentence, mark_width(has_mark));
    layout_.sentence_box.least = Vector<2>(layout_.margin + mark_width(has_mark), first_line() - points(8.0));
    if (has_mark) {
      const double side = layout_.letters.sentence.height;
      const Vector<2> corner(layout_.margin, layout_.sentence_box.least.y);
      layout_.mark = ScreenBox{corner, corner + Vector<2>(side)};
    }
    double width = 0.0;
    for (const std::string& line : layout_.sentence) {
      width = std::max(width, measure_(line, layout_.letters.sentence).x);
    }
    layout_.sentence_box.most =
        layout_.sentence_box.least +
        Vector<2>(width, static_cast<double>(layout_.sentence.size()) * layout_.letters.sentence.height);
    const std::size_t most = std::max(layout_.sentence.size(), most_lines_there());
    layout_.words_end = layout_.sentence_box.least.y + static_cast<double>(most) * layout_.letters.sentence.height;
    layout_.top = std::max(layout_.sentence_box.most.y, layout_.header_end().most.y);
    if (layout_.lesson) layout_.top = std::max(layout_.top, layout_.lesson->title_box.most.y);
    layout_.bottom = layout_.lesson                         ? layout_.lesson->top
                     : layout_.measuring                    ? layout_.measuring->box.least.y
                     : layout_.corner && layout_.is_upright ? layout_.corner->box.least.y
                                                            : layout_.strategies.front().box.least.y;
    const Vector<2> corner(layout_.margin, layout_.words_end + points(6.0));
    const ScreenBox numbers{corner, corner + numbers_size_};
    if (numbers.most.x <= layout_.size.x && numbers.most.y <= layout_.bottom) layout_.numbers = numbers;
    if (words_.has_tools) arrange_tools();
    if (words_.has_motors_to_choose) arrange_motors();
    return std::move(layout_);
  }

 private:
  double points(double of_design) const { return of_design * layout_.unit; }

  // A finger has no keys.
  std::string corner_words() const {
    return layout_.least_target > 0.0 ? without_key(words_.corner) : std::string(words_.corner);
  }

  double mark_width(bool has_mark) const { return has_mark && words_.lesson != nullptr ? points(mark_room) : 0.0; }

  double target(double of_design) const { return std::max(points(of_design), layout_.least_target); }

  // Where the first line of words begins.
  double first_line() const {
    if (!layout_.is_upright) return layout_.margin;
    const double end = layout_.lesson ? std::max(layout_.lesson->title_box.most.y, layout_.lesson->corner.most.y)
                                      : layout_.header_end().most.y;
    return end + points(below_upright_header);
  }

  double sentence_width(double indented_by) const {
    if (layout_.is_upright) return layout_.size.x - 2.0 * layout_.margin - indented_by;
    return layout_.header_left - points(gap) - layout_.margin - indented_by;
  }

  std::vector<std::string> lines(std::string_view words, double indented_by) const {
    return broken_into_lines(words, sentence_width(indented_by), layout_.letters.sentence, measure_);
  }

  // Beside a lesson's mark.
  std::size_t lines_of(std::string_view words) const {
    return line_count(words, sentence_width(mark_width(true)), layout_.letters.sentence, measure_);
  }

  // Of all that may stand where the sentence does.
  std::size_t most_lines_there() const {
    const double width = sentence_width(mark_width(true));
    const std::vector<double>& wide = widths_.of(words_.language, layout_.letters.sentence, measure_);
    std::size_t most = texts_.has_sentences ? 1 : lines_of(texts_.longest);
    for (std::size_t i = texts_.has_sentences ? 0 : sentence_count; i < wide.size(); ++i) {
      if (wide[i] > width) most = std::max(most, lines_of(texts_.there[i]));
    }
    return most;
  }

  // From the right to the left.
  void arrange_header() {
    layout_.header.clear();
    double right = layout_.size.x - layout_.margin;
    const double top = layout_.margin - points(12.0);
    const auto add = [&](const StageAction& action, std::string_view words) {
      const double width = measure_(words, layout_.letters.words).x + points(2.0 * header_padding);
      layout_.header.push_back(
          {action, {{right - width, top}, {right, top + target(header_height)}}, std::string(words)});
      right -= width + points(header_gap);
    };
    add(StageCommand::menu, words_.language.header.more);
    add(StageCommand::lessons, words_.language.header.lessons);
    for (const StageModeEntry& mode : stage_mode_catalog() | std::views::reverse) {
      if (!mode.is_in_menu) add(mode.id, (words_.language.modes.*mode.words).title);
    }
    std::ranges::reverse(layout_.header);
    layout_.header_left = layout_.header.front().box.least.x;
    layout_.menu = texts_.menu;
    if (!layout_.menu.empty()) arrange_menu();
  }

  void arrange_menu() {
    double words = 0.0;
    double keys = 0.0;
    for (const StageMenuRow& row : layout_.menu) {
      words = std::max(words, measure_(row.title, layout_.letters.words).x);
      keys = std::max(keys, measure_(row.key, layout_.letters.words).x);
    }
    const double width = words + keys + points(menu_key_gap + 2.0 * button_padding);
    const ScreenBox& button = layout_.header.back().box;
    const double top = button.most.y + points(header_gap);
    const double first_top = top + points(header_gap);
    // Fingers do not hover.
    const bool tells_of_rows = layout_.least_target == 0.0;
    const double below = tells_of_rows ? points(gap) + menu_lines * layout_.letters.words.height : points(header_gap);
    // Where the picture is too low for all rows as a finger wants them, in two columns.
    const double room = layout_.size.y - first_top - below;
    const bool is_low = room < target(menu_row_height) * static_cast<double>(layout_.menu.size());
    const std::size_t columns = is_low && 2.0 * width <= button.most.x - layout_.margin ? 2 : 1;
    const std::size_t rows = (layout_.menu.size() + columns - 1) / columns;
    const double row_height =
        std::max(points(menu_row_height), std::min(layout_.least_target, room / static_cast<double>(rows)));
    layout_.menu_box = {{button.most.x - width * static_cast<double>(columns), top},
                        {button.most.x, first_top + row_height * static_cast<double>(rows) + below}};
    for (std::size_t i = 0; i < layout_.menu.size(); ++i) {
      const Vector<2> corner(layout_.menu_box.least.x + width * static_cast<double>(i / rows),
                             first_top + row_height * static_cast<double>(i % rows));
      layout_.menu[i].box = {corner, corner + Vector<2>(width, row_height)};
    }
  }

  // Below the numbers; where there is no room left, beside them. Upright, the scene needs the place of those that are
  // not shown.
  void arrange_tools() {
    const bool are_below = layout_.numbers && (words_.has_numbers || !layout_.is_upright);
    Vector<2> corner(layout_.margin, (are_below ? layout_.numbers->most.y : layout_.words_end) + points(below_numbers));
    if (are_below && corner.y + target(header_height) > layout_.bottom)
      corner = {layout_.numbers->most.x + points(gap), layout_.words_end + points(below_numbers)};
    add_small(layout_.tools, StageCommand::fit, words_.language.header.fit, corner);
    add_small(layout_.tools, layout_.lesson ? StageCommand::reset : StageCommand::reset_all,
              words_.language.header.reset, corner);
    // Elsewhere it stands at the end of the row below.
    if (layout_.is_upright && !layout_.lesson && !words_.keys.link.empty()) {
      add_small(layout_.tools, StageCommand::link, words_.language.header.link, corner);
    }
  }

  // Where there is room for it; the next one stands beside it.
  void add_small(std::vector<StageButton>& row, const StageAction& action, std::string_view words, Vector<2>& corner) {
    const double width =
        std::max(measure_(words, layout_.letters.words).x + points(2.0 * header_padding), layout_.least_target);
    const ScreenBox box{corner, corner + Vector<2>(width, target(header_height))};
    if (box.most.y <= layout_.bottom) row.push_back({action, box, std::string(words)});
    corner.x = box.most.x + points(header_gap);
  }

  // Where the small picture of the device stands too, which ends above them.
  void arrange_motors() {
    const StageLanguage::Device& words = words_.language.device;
    Vector<2> corner(layout_.margin, layout_.bottom - points(0.5 * gap) - target(header_height));
    add_small(layout_.motors, MotorsInUse::first, words.first_motor, corner);
    add_small(layout_.motors, MotorsInUse::second, words.second_motor, corner);
    add_small(layout_.motors, MotorsInUse::both, words.both_motors, corner);
  }

  bool arrange_buttons(CardWords shown) {
    const double bottom = layout_.size.y - layout_.margin - points(10.0);
    double x = layout_.margin;
    const bool is_broken = shown == CardWords::name_in_two_lines;
    const double height =
        is_broken ? 2.0 * layout_.letters.words.height + points(two_lines_padding) : target(button_height);
    if (layout_.is_upright) return arrange_column(shown, target(button_height));
    for (const Strategy& strategy : strategy_catalog()) {
      if (strategy.id == StrategyId::full && !words_.has_full) continue;
      StrategyWords words = strategy_words(words_.language, strategy.id, words_.has_strings);
      if (shown != CardWords::name_and_about) words.about = "";
      const StrategyWords widest{.name = is_broken ? longer_line(words.name) : words.name, .about = words.about};
      const double width = strategy_button_width(widest, layout_.unit, layout_.letters, measure_);
      layout_.strategies.push_back({strategy.id,
                                    {{x, bottom - height}, {x + width, bottom}},
                                    std::string(words.name),
                                    std::string(words.about)});
      x += width + points(gap);
    }
    const double right = layout_.size.x - layout_.margin;
    arrange_corner({right, bottom});
    if (layout_.corner) return x <= layout_.corner->box.least.x;
    const std::vector<StageButton> hints = key_hints(words_.language, words_.keys);
    arrange_key_hints(hints, {right, bottom - 0.5 * points(button_height)}, x);
    if (shown == CardWords::name_and_about && layout_.key_hints.empty() && !hints.empty()) return false;
    return x - points(gap) <= right;
  }

  // From the right to the left.
  void arrange_key_hints(const std::vector<StageButton>& hints, Vector<2> end, double left) {
    for (const StageButton& hint : hints) {
      const Vector<2> size(measure_(hint.words, layout_.letters.words).x, layout_.letters.words.height);
      const Vector<2> corner = end - Vector<2>(size.x, 0.5 * size.y);
      if (corner.x < left) return;
      layout_.key_hints.push_back({hint.action, {corner, corner + size}, hint.words});
      end.x = corner.x - points(1.4 * gap);
    }
  }

  // One below the other, as wide as the window; what stands at a row's other end is above them.
  bool arrange_column(CardWords shown, double height) {
    const double left = layout_.margin;
    const double right = layout_.size.x - layout_.margin;
    double bottom = layout_.size.y - layout_.margin;
    bool all_fit = true;
    for (const Strategy& strategy : strategy_catalog() | std::views::reverse) {
      if (strategy.id == StrategyId::full && !words_.has_full) continue;
      StrategyWords words = strategy_words(words_.language, strategy.id, words_.has_strings);
      if (shown != CardWords::name_and_about) words.about = "";
      all_fit = all_fit && strategy_button_width(words, layout_.unit, layout_.letters, measure_) <= right - left;
      layout_.strategies.push_back(
          {strategy.id, {{left, bottom - height}, {right, bottom}}, std::string(words.name), std::string(words.about)});
      bottom -= height + points(0.5 * gap);
    }
    std::ranges::reverse(layout_.strategies);
    arrange_corner({right, bottom});
    return all_fit;
  }

  void arrange_corner(const Vector<2>& end) {
    layout_.corner.reset();
    layout_.key_hints.clear();
    if (words_.corner.empty()) return;
    const std::string words = corner_words();
    layout_.corner = button_ending_at(end, words, words, words_.corner_action);
    arrange_measuring();
  }

  StageButton button_ending_at(const Vector<2>& end, std::string_view words, std::string_view longest,
                               const StageAction& action) const {
    const double width = measure_(longest, layout_.letters.bold_words).x + points(2.0 * button_padding);
    return {action, {end - Vector<2>(width, target(button_height)), end}, std::string(words)};
  }

  // Where the corner is the motors', above it.
  void arrange_measuring() {
    layout_.measuring.reset();
    if (words_.measuring == nullptr) return;
    const ScreenBox& corner = layout_.corner->box;
    layout_.measuring = button_ending_at({corner.most.x, corner.least.y - points(0.5 * gap)}, words_.measuring->words,
                                         words_.measuring->longest, StageCommand::measure);
  }

  void arrange_numbers() {
    const StageLetters& all = layout_.letters;
    layout_.number_width = measure_("88.8", all.number).x;
    const double unit_width = points(gap) + measure_("mm", all.unit).x;
    double words_width = 0.0;
    for (const std::string_view words : words_of(words_.language.numbers)) {
      words_width = std::max(words_width, measure_(words, all.words).x);
    }
    // The battery of round and round stands there, too.
    const std::string energy = filled(words_.language.labels.energy_a_round, widest_energy);
    words_width = std::max(words_width, measure_(energy, all.bold_words).x);
    numbers_size_ = {std::max(layout_.number_width + unit_width, words_width),
                     2.0 * (all.number.height + all.words.height) - points(6.0)};
  }

  const MeasureText& measure_;
  const StageFrameWords& words_;
  const StageTexts& texts_;
  SentenceWidths& widths_;
  StageLayout layout_;
  Vector<2> numbers_size_{0.0};
};

}  // namespace

StageLayout stage_layout(const Vector<2>& size, double scale, const MeasureText& measure,
                         const StageFrameWords& words) {
  constexpr double step = 0.97;
  constexpr int most_steps = 100;
  SentenceWidths measured_anew;
  SentenceWidths& widths = words.widths != nullptr ? *words.widths : measured_anew;
  const StageTexts texts = texts_of(measure, words, widths);
  const auto scale_after = [&](int steps) { return scale * std::pow(step, steps); };
  const auto fits = [&](int steps) {
    return Arrangement(size, scale_after(steps), measure, words, texts, widths).arrange(CardWords::name_in_two_lines);
  };
  // The first that fits.
  int too_large = -1;
  int fitting = 0;
  if (!fits(0)) {
    too_large = 0;
    fitting = most_steps;
  }
  while (fitting - too_large > 1) {
    const int between = (too_large + fitting) / 2;
    (fits(between) ? fitting : too_large) = between;
  }
  Arrangement arrangement(size, scale_after(fitting), measure, words, texts, widths);
  for (const CardWords shown : {CardWords::name_and_about, CardWords::name, CardWords::name_in_two_lines}) {
    if (arrangement.arrange(shown)) break;
  }
  return arrangement.finished();
}

double scale_over_stage(const Vector<2>& size, double scale) noexcept {
  constexpr double room_of_dialogs = 640.0;  // at a scale of 1 all dialogs fit into a square of that side [points]
  constexpr double steps = 15.0;             // to 1, as the letters of a dialog are high: a whole point each
  constexpr double larger = 1.25;            // beside the large letters of the stage
  const double grown = std::min(larger * scale * size.y / height_of_design, std::min(size.x, size.y) / room_of_dialogs);
  constexpr double rounding = 1e-6;
  return std::max(scale, std::floor(steps * grown + rounding) / steps);
}

StageLayout bare_stage_layout(const Vector<2>& size, double scale) {
  constexpr double bare_margin = 14.0;
  StageLayout layout;
  layout.size = size;
  layout.unit = size.y / height_of_design * scale;
  layout.margin = bare_margin * layout.unit;
  layout.letters = letters_at(layout.unit, sentence_em);
  layout.sentence_box = {Vector<2>(layout.margin), Vector<2>(layout.margin)};
  layout.header_left = size.x;
  layout.bottom = size.y;
  return layout;
}

Camera stage_camera(const SceneView& shown, const StageLayout& layout) {
  constexpr Vector<2> middle{0.52, 0.60};      // of what is above the row of buttons, from its upper left corner
  constexpr double with_buttons = 1.0 / 0.86;  // the picture's height over that
  // That are as large as letters are: how far they reach to each side. An upright window has no room to spare there.
  const double things = layout.is_upright ? 96.0 : 92.0;
  constexpr double air = 8.0;
  const double around = air * layout.unit;
  const double header_end = layout.lesson ? layout.lesson->title_box.most.y : layout.header_end().most.y;
  const ScreenBox all{{around, std::max(layout.words_end, header_end) + around},
                      {layout.size.x - around, layout.bottom - around}};
  ScreenBox beside = all;
  ScreenBox below = all;
  if (layout.numbers) {
    beside.least.x = layout.numbers->most.x + around;
    below.least.y = layout.numbers->most.y + around;
  }
  if (const auto tools = layout.tools_box()) {
    beside.least.x = std::max(beside.least.x, tools->most.x + around);
    below.least.y = std::max(below.least.y, tools->most.y + around);
  }
  if (const auto motors = layout.motors_box()) {
    beside.least.x = std::max(beside.least.x, motors->most.x + around);
    below.most.y = motors->least.y - around;
  }
  Camera camera = camera_on(shown.center, shown.width, {layout.size.x, with_buttons * layout.bottom});
  const double usual = camera.points_per_metre * shown.width / stage_view_width;
  // Of a point of the view: what must be seen takes its room then, and as much more as letters are larger than usual.
  const auto unit_in = [&](const ScreenBox& room) {
    const Vector<2> most = room.extent() / stage_view_room;
    const Vector<2> with_things =
        (room.extent() - Vector<2>(2.0 * things * layout.unit)) / (stage_view_room - Vector<2>(2.0 * things));
    constexpr double least = 0.1;
    return std::clamp(std::min({most.x, most.y, with_things.x, with_things.y}), least * usual, usual);
  };
  const double unit_beside = unit_in(beside);
  const double unit_below = unit_in(below);
  const ScreenBox& room = unit_beside >= unit_below ? beside : below;
  const double unit = std::max(unit_beside, unit_below);
  camera.size = layout.size;
  camera.points_per_metre = unit * stage_view_width / shown.width;
  const Vector<2> half = 0.5 * unit * stage_view_room + Vector<2>(things * std::max(0.0, layout.unit - unit));
  const Vector<2> place = glm::clamp(middle * Vector<2>(layout.size.x, layout.bottom), room.least + half,
                                     glm::max(room.least + half, room.most - half));
  camera.center -= to_screen_direction(place - 0.5 * layout.size) / camera.points_per_metre;
  return camera;
}

}  // namespace ghostforce
