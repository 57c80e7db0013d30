#include "app/tools/figures/sheet.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <utility>

#include "app/base/typed_text.h"
#include "app/paint/vector/vector_painter.h"
#include "ghostforce_version.h"

namespace ghostforce {
namespace {

// [points]
constexpr double edge = 14.0;       // of the paper
constexpr double between = 12.0;    // panes of a row
constexpr double line_step = 1.3;   // from line to line, in their heights
constexpr double entry_gap = 16.0;  // between entries of the legend

Pane empty_pane(const Vector<2>& corner, const Vector<2>& size) {
  return {corner, Camera{0.5 * size, 1.0, size}, StrategyId::full, {}};
}

Mark words_at(const Pane& pane, const Vector<2>& upper_left, std::string words, const TextStyle& style, Colour colour) {
  return {
      Role::legend, std::nullopt,
      Label{to_world(pane.camera, upper_left), Vector<2>(0.0), std::move(words), style, colour, Colour{0, 0, 0, 0}}};
}

// Broken where there is a blank, so that each line has room.
std::vector<std::string> broken(std::string_view text, double room, const TextStyle& style) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::string word(take_until(text, ' '));
    const std::string joined = lines.empty() ? word : lines.back() + " " + word;
    if (!lines.empty() && measure_on_paper(joined, style).x <= room) {
      lines.back() = joined;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

}  // namespace

std::string provenance_of_scene(const std::string& scene) {
  return fmt::format("ghostforce {}; scene {}; seed {}", version, scene, figure_seed);
}

std::string provenance_of_hand(const std::string& recording) {
  return fmt::format("ghostforce {}; hand {}", version, recording);
}

Vector<2> measure_on_paper(std::string_view text, const TextStyle& style) {
  return measure_vector_text(text, style);
}

std::vector<LegendEntry> strategy_legend() {
  std::vector<LegendEntry> entries;
  for (const Strategy& strategy : strategy_catalog()) {
    entries.push_back({.name = fmt::format("{}  {}", strategy.letter, strategy.title),
                       .colour = paper().strategy[index_of(strategy.id)],
                       .has_line = true,
                       .pattern = strategy_style(strategy.id).pattern,
                       .shape = strategy_style(strategy.id).shape});
  }
  return entries;
}

Pane chart_on(const Place& place, const Chart& chart) {
  return chart_pane(chart, place.corner, place.size, paper(), 1.0, measure_vector_text);
}

Sheet::Sheet(std::string title, double width) : bottom_(edge) {
  figure_.title = std::move(title);
  figure_.size.x = width;
  add_words(figure_.title, large_text, paper().text);
  bottom_ += 4.0;
}

void Sheet::add_words(const std::string& text, const TextStyle& style, Colour colour) {
  const double room = figure_.size.x - 2.0 * edge;
  const std::vector<std::string> lines = broken(text, room, style);
  const double step = line_step * style.height;
  Pane pane = empty_pane({edge, bottom_}, {room, step * static_cast<double>(lines.size())});
  Vector<2> at(0.0);
  for (const std::string& line : lines) {
    pane.marks.push_back(words_at(pane, at, line, style, colour));
    at.y += step;
  }
  bottom_ += pane.camera.size.y;
  figure_.panes.push_back(std::move(pane));
}

Vector<2> Sheet::place_size(double height, std::size_t count) const {
  const auto places = static_cast<double>(count);
  return {(figure_.size.x - 2.0 * edge - (places - 1.0) * between) / places, height};
}

void Sheet::add_row(double height, std::size_t count,
                    const std::function<Pane(const Place&, std::size_t number)>& make) {
  const Vector<2> size = place_size(height, count);
  for (std::size_t i = 0; i < count; ++i) {
    figure_.panes.push_back(make({{edge + static_cast<double>(i) * (size.x + between), bottom_}, size}, i));
  }
  bottom_ += height + 0.5 * between;
}

void Sheet::add_titles(std::span<const std::string> titles) {
  constexpr double height = line_step * normal_text.height;
  add_row(height, titles.size(), [&](const Place& place, std::size_t number) {
    Pane pane = empty_pane(place.corner, place.size);
    pane.marks.push_back(words_at(pane, {2.0, 4.0}, titles[number], normal_text, paper().text));
    return pane;
  });
}

void Sheet::add_legend(const std::vector<LegendEntry>& entries) {
  const double room = figure_.size.x - 2.0 * edge;
  const double height = small_text.height;
  const double row = 1.6 * height;
  const auto sample_of = [](const LegendEntry& entry) { return entry.has_line ? chart_sample_length : 16.0; };
  // Where each begins; at first in a pane that is high enough for one entry a row.
  std::vector<Vector<2>> starts;
  Vector<2> at(0.0);
  for (const LegendEntry& entry : entries) {
    const double width = sample_of(entry) + 7.0 + measure_on_paper(entry.name, small_text).x;
    if (at.x > 0.0 && at.x + width > room) at = {0.0, at.y + row};
    starts.push_back(at);
    at.x += width + entry_gap;
  }
  Pane pane = empty_pane({edge, bottom_}, {room, at.y + row});
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const LegendEntry& entry = entries[i];
    const Vector<2> middle = starts[i] + Vector<2>(0.0, 0.5 * row);
    const double sample = sample_of(entry);
    if (entry.has_line) {
      pane.marks.push_back(
          {Role::legend, std::nullopt,
           Line{to_world(pane.camera, middle + Vector<2>(1.5, 0.0)),
                to_world(pane.camera, middle + Vector<2>(sample, 0.0)), 2.2, entry.colour, entry.pattern}});
    }
    if (entry.shape) {
      pane.marks.push_back({Role::legend, std::nullopt,
                            Marker{to_world(pane.camera, middle + Vector<2>(0.5 * sample, 0.0)), *entry.shape, 5.5,
                                   entry.is_hollow ? paper().background : entry.colour,
                                   entry.is_hollow ? entry.colour : paper().background, entry.is_hollow ? 1.6 : 0.8}});
    }
    pane.marks.push_back(
        words_at(pane, middle + Vector<2>(sample + 7.0, -0.55 * height), entry.name, small_text, paper().text));
  }
  bottom_ += pane.camera.size.y + 4.0;
  figure_.panes.push_back(std::move(pane));
}

Figure Sheet::finish(const std::string& caption, const std::string& provenance, CsvTable data) {
  add_words(caption, small_text, paper().text);
  bottom_ += 3.0;
  add_words(provenance, small_text, paper().faint_text);
  figure_.size.y = std::ceil(bottom_ + edge);  // whole pixels
  figure_.data = std::move(data);
  figure_.data.comments.insert(figure_.data.comments.begin(), {provenance, figure_.title + ". " + caption});
  return std::move(figure_);
}

}  // namespace ghostforce
