#include "app/tools/worksheet/worksheet_layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "app/picture/text.h"

namespace ghostforce {
namespace {

// In points of the page.
constexpr double line_of_em = 1.165;  // height of a line of letters over their size
constexpr double line_step = 1.14;    // from line to line, in these heights
constexpr TextStyle body{9.5 * line_of_em};
constexpr TextStyle bold_body{9.5 * line_of_em, true};
constexpr TextStyle title_style{16.0 * line_of_em, true};
constexpr TextStyle quiet{least_worksheet_em * line_of_em + 0.1};
constexpr double number_room = 26.0;  // of a step's number, left of everything else
constexpr double gap = 11.0;          // between picture and words
constexpr double item_gap = 9.0;
constexpr double box_side = 9.0;
constexpr double box_gap = 5.0;  // to its words
constexpr double between_boxes = 16.0;
constexpr double writing_step = 18.0;  // from one line to write on to the next
constexpr double line_drop = 3.0;      // of its words, so that there is room to write above it
constexpr double least_line = 80.0;    // that is worth beginning behind words
constexpr double short_line = 46.0;    // before a unit
constexpr double part_gap = 4.0;       // between text, boxes and lines of an item
constexpr double picture_ratio = 1.6;  // width over height
constexpr double greatest_picture = 150.0;
constexpr double least_picture = 84.0;
constexpr double picture_of_many_pages = 116.0;
constexpr double picture_step = 2.0;
constexpr double least_lines = 2.0;  // below the last question
constexpr double most_lines = 6.0;
constexpr double thin = 0.7;  // of lines

// Draws on one page, from its upper left corner down.
class WorksheetPen {
 public:
  WorksheetPen(const Vector<2>& size, const MeasureText& measure, WorksheetPage& page)
      : measure_(measure), page_(page) {
    page_.camera = {.center = 0.5 * size, .points_per_metre = 1.0, .size = size};
  }

  double width(std::string_view words, const TextStyle& style) const { return measure_(words, style).x; }

  void text(const Vector<2>& corner, std::string words, const TextStyle& style) {
    page_.marks.push_back(
        {Role::sentence,
         {},
         Label{at(corner), Vector<2>(0.0), std::move(words), style, paper().text, Colour{0, 0, 0, 0}}});
  }
  // Returns where what follows may begin.
  double paragraph(const Vector<2>& corner, std::string_view words, double room, const TextStyle& style) {
    double top = corner.y;
    for (const std::string& line : broken_into_lines(words, room, style, measure_)) {
      text({corner.x, top}, line, style);
      top += line_step * style.height;
    }
    return top;
  }
  void line(Role role, const Vector<2>& from, const Vector<2>& to, double line_width, Colour colour) {
    page_.marks.push_back({role, {}, Line{at(from), at(to), line_width, colour}});
  }
  // To write on.
  void rule(double from, double to, double y) { line(Role::grid, {from, y}, {to, y}, thin, paper().faint_text); }
  void box(const Vector<2>& corner, bool is_ticked) {
    page_.marks.push_back(
        {Role::button, {}, Box{at(corner), Vector<2>(box_side), 0.0, Colour{0, 0, 0, 0}, paper().text, 1.0}});
    if (!is_ticked) return;
    const auto place = [&](double x, double y) { return corner + box_side * Vector<2>(x, y); };
    line(Role::hint, place(0.15, 0.45), place(0.45, 0.85), 2.0, paper().text);
    line(Role::hint, place(0.45, 0.85), place(1.15, -0.2), 2.0, paper().text);
  }
  void picture(const WorksheetItem& item, const ScreenBox& box) {
    page_.pictures.push_back({item.step, box, item.hides_handle});
  }

 private:
  Vector<2> at(const Vector<2>& point) const { return to_world(page_.camera, point); }

  const MeasureText& measure_;
  WorksheetPage& page_;
};

// All of a worksheet, with pictures of one height.
class Worksheet {
 public:
  Worksheet(const WorksheetContent& content, const Vector<2>& size, const MeasureText& measure, double picture)
      : content_(content), size_(size), measure_(measure), picture_(picture) {
    begin_page();
    for (const WorksheetItem& item : content_.items) {
      place(height_of(item), [&](double top) { return add(item, top, pages_.back()); });
    }
    const double least = content_.in_short.empty() ? least_lines * writing_step : 0.0;
    place(height_of_end() + least, [&](double top) { return add_end(top); });
    for (std::size_t i = 0; i < pages_.size(); ++i) add_footer(i);
  }

  const std::vector<WorksheetPage>& pages() const noexcept { return pages_; }

 private:
  double left() const { return worksheet_margin; }
  double right() const { return size_.x - worksheet_margin; }
  double bottom() const { return size_.y - worksheet_margin - line_step * quiet.height - 2.0; }

  WorksheetPen pen_on(WorksheetPage& page) const { return {size_, measure_, page}; }

  // What does not fit any more goes to a new page. `draw(top)` returns the lower end.
  template <typename Draw>
  void place(double height, Draw&& draw) {
    if (top_ + height > bottom() && top_ > first_top_) begin_page();
    top_ = draw(top_) + item_gap;
  }

  void begin_page() {
    WorksheetPen pen = pen_on(pages_.emplace_back());
    top_ = worksheet_margin;
    const WorksheetPhrases& phrases = content_.phrases;
    const bool is_first = pages_.size() == 1;
    if (is_first && content_.side == WorksheetSide::questions) {
      const double base = top_ + body.height;
      const double middle = left() + 0.66 * (right() - left());
      pen.text({left(), top_}, std::string(phrases.name), body);
      pen.rule(left() + pen.width(phrases.name, body) + box_gap, middle - between_boxes, base);
      pen.text({middle, top_}, std::string(phrases.date), body);
      pen.rule(middle + pen.width(phrases.date, body) + box_gap, right(), base);
      top_ += 24.0;
    }
    pen.text({left(), top_}, content_.title, title_style);
    top_ += title_style.height + part_gap;
    if (is_first && content_.side == WorksheetSide::questions) {
      top_ = pen.paragraph({left(), top_}, content_.how, right() - left(), body) + part_gap;
    }
    first_top_ = top_ += part_gap;
  }

  double height_of(const WorksheetItem& item) const {
    WorksheetPage scratch;
    return add(item, 0.0, scratch);
  }
  double height_of_end() const {
    WorksheetPage scratch;
    return add_question_at_end(0.0, scratch);
  }

  double add(const WorksheetItem& item, double top, WorksheetPage& page) const {
    WorksheetPen pen = pen_on(page);
    const bool begins_with_line = item.text.empty() && item.boxes.empty();
    pen.text({left(), top + (begins_with_line ? line_drop : 0.0)}, item.number, bold_body);
    double words_left = left() + number_room;
    double picture_end = top;
    if (item.picture_share > 0.0) {
      const Vector<2> picture = Vector<2>(picture_ratio, 1.0) * (picture_ * item.picture_share);
      const Vector<2> corner(words_left, top);
      pen.picture(item, {corner, corner + picture});
      words_left += picture.x + gap;
      picture_end += picture.y;
    }
    const double room = right() - words_left;
    double y = top;
    if (!item.text.empty()) y = pen.paragraph({words_left, y}, item.text, room, body) + part_gap;
    if (!item.boxes.empty()) y = add_boxes(item.boxes, {words_left, y}, pen) + part_gap;
    if (!item.note.empty()) y = add_note(item.note, {words_left, y}, pen) + part_gap;
    for (const WorksheetLine& line : item.lines) y = add_line(line, {words_left, y}, pen);
    // Beside a picture there may be room for more.
    const bool can_go_on = !item.lines.empty() && item.lines.back().unit.empty();
    for (; can_go_on && y + writing_step <= picture_end; y += writing_step) {
      pen.rule(words_left, right(), y + body.height);
    }
    return std::max(y - part_gap, picture_end);
  }

  // What the lesson says after an answer has a bar beside it.
  double add_note(const std::string& note, const Vector<2>& corner, WorksheetPen& pen) const {
    if (content_.side == WorksheetSide::questions) return pen.paragraph(corner, note, right() - corner.x, body);
    constexpr double bar = 2.0;
    constexpr double indent = 9.0;
    const double end = pen.paragraph(corner + Vector<2>(indent, 0.0), note, right() - corner.x - indent, body);
    const double x = corner.x + 0.5 * bar;
    pen.line(Role::grid, {x, corner.y + bar}, {x, end - bar}, bar, paper().text);
    return end;
  }

  double add_boxes(const std::vector<WorksheetBox>& boxes, const Vector<2>& corner, WorksheetPen& pen) const {
    constexpr double row = 15.0;
    Vector<2> place = corner;
    for (const WorksheetBox& box : boxes) {
      const TextStyle& style = box.is_ticked ? bold_body : body;
      const double width = box_side + box_gap + pen.width(box.words, style);
      if (place.x > corner.x && place.x + width > right()) place = {corner.x, place.y + row};
      pen.box(place + Vector<2>(0.0, 0.5 * (body.height - box_side)), box.is_ticked);
      pen.text(place + Vector<2>(box_side + box_gap, 0.0), box.words, style);
      place.x += width + between_boxes;
    }
    return place.y + row;
  }

  double add_line(const WorksheetLine& line, const Vector<2>& corner, WorksheetPen& pen) const {
    double y = corner.y + line_drop;
    double from = corner.x;
    if (!line.words.empty()) {
      pen.text({from, y}, line.words, body);
      from += pen.width(line.words, body) + box_gap;
    }
    const bool is_short = !line.unit.empty();
    if (!is_short && right() - from < least_line) {
      from = corner.x;
      y += writing_step;
    }
    const double to = is_short ? from + short_line : right();
    pen.rule(from, to, y + body.height);
    if (is_short) pen.text({to + box_gap, y}, std::string(line.unit), body);
    return y - line_drop + writing_step;
  }

  double add_question_at_end(double top, WorksheetPage& page) const {
    return pen_on(page).paragraph({left(), top}, content_.phrases.in_short, right() - left(), bold_body) + part_gap +
           (content_.in_short.empty() ? 0.0 : 2.0 * line_step * body.height);
  }

  double add_end(double top) {
    WorksheetPen pen = pen_on(pages_.back());
    double y = pen.paragraph({left(), top}, content_.phrases.in_short, right() - left(), bold_body) + part_gap;
    if (!content_.in_short.empty()) return pen.paragraph({left(), y}, content_.in_short, right() - left(), body);
    const double lines = std::min(most_lines, std::floor((bottom() - y) / writing_step));
    for (int i = 0; i < static_cast<int>(lines); ++i) {
      pen.rule(left(), right(), y + body.height);
      y += writing_step;
    }
    return y;
  }

  void add_footer(std::size_t number) {
    WorksheetPen pen = pen_on(pages_[number]);
    const double y = size_.y - worksheet_margin - quiet.height;
    std::string place = pages_.size() == 1 ? "" : fmt::format("{} / {}", number + 1, pages_.size());
    const double width = pen.width(place, quiet);
    const auto has_room = [&](const std::string& footer) {
      return pen.width(footer, quiet) <= right() - left() - (width > 0.0 ? width + gap : 0.0);
    };
    const auto footer = std::ranges::find_if(content_.footers, has_room);
    pen.text({left(), y}, footer == content_.footers.end() ? content_.footers.back() : *footer, quiet);
    if (!place.empty()) pen.text({right() - width, y}, std::move(place), quiet);
  }

  const WorksheetContent& content_;
  const Vector<2> size_;
  const MeasureText& measure_;
  const double picture_;
  std::vector<WorksheetPage> pages_;
  double top_ = 0.0;        // of what comes next
  double first_top_ = 0.0;  // of what comes first on this page
};

}  // namespace

std::vector<WorksheetPage> worksheet_pages(const WorksheetContent& content, const Vector<2>& size,
                                           const MeasureText& measure) {
  for (double picture = greatest_picture; picture >= least_picture; picture -= picture_step) {
    const Worksheet sheet(content, size, measure, picture);
    if (sheet.pages().size() == 1) return sheet.pages();
  }
  return Worksheet(content, size, measure, picture_of_many_pages).pages();
}

}  // namespace ghostforce
