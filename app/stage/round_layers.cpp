// Round and round: the hand goes round a circle inside the wall. What the rendering gives it on the way stands in a
// battery: a wall should give nothing.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include "app/picture/text.h"
#include "app/stage/stage_layers.h"

namespace ghostforce {
namespace {

constexpr double least_energy = 0.00005;  // [J], so much that a tenth of a millijoule is shown

const CircleEnergy* energy_of(const StageContent& content) {
  if (!content.round || content.round->reading.turns == 0) return nullptr;
  return &content.round->reading.strategies[index_of(content.settings.active)];
}

// The most that any strategy gives or takes on a turn: what a full battery is.
double greatest_energy(const StageRound& round) {
  double greatest = least_energy;
  for (const CircleEnergy& energy : round.reading.strategies) {
    greatest = std::max(greatest, std::abs(energy.last.energy));
  }
  return greatest;
}

void add_loop(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  if (!content.round || content.round->loop.size() < 3) return;
  const Colour colour = stage_colour(content.moment, content.theme.strategy);
  canvas.marks.push_back({Role::area, content.settings.active, Area{content.round->loop, colour.with_alpha(70)}});
  std::vector<Vector<2>> corners;
  for (const Vector<2>& corner : content.round->loop) corners.push_back(canvas.at(corner));
  canvas.curve(Role::area, corners, canvas.width(2.5), colour);
  for (std::size_t i = 1; i < corners.size(); ++i) {
    canvas.labels.keep_clear(corners[i - 1], corners[i], canvas.width(1.5));
  }
  const Vector<2> lowest = *std::ranges::max_element(corners, {}, [](const Vector<2>& corner) { return corner.y; });
  canvas.label(Role::area,
               {.id = StageLabel::loop,
                .lines = {std::string(content.language.labels.loop)},
                .style = layout.letters.words,
                .from = lowest,
                .to = lowest,
                .clearance = canvas.points(4.0),
                .direction = Vector<2>(0.0, 1.0)},
               stage_colour(content.moment, content.theme.strategy_text));
}

// What stands at its upper and its lower end; nothing before the first round is complete.
struct BatteryScale {
  std::string top;
  std::string bottom;
};

BatteryScale battery_scale(const StageContent& content, const CircleEnergy* energy) {
  if (energy == nullptr) return {};
  const double full = std::copysign(1e3 * greatest_energy(*content.round), energy->last.energy);
  const std::string words = fmt::format("{} mJ", signed_decimal_text(full, 1));
  return full < 0.0 ? BatteryScale{"0", words} : BatteryScale{words, "0"};
}

// Two ticks right of the battery, each with its number.
void add_battery_scale(const StageLayer& layer, const BatteryScale& scale, const ScreenBox& inside, double right) {
  const auto& [content, layout, canvas] = layer;
  const TextStyle& style = layout.letters.words;
  const double tick = canvas.points(5.0);
  const auto add = [&](const std::string& words, double y, double top) {
    if (words.empty()) return;
    canvas.line(Role::number, {right, y}, {right + tick, y}, canvas.width(1.5), content.theme.faint_text);
    canvas.text(Role::number, {right + tick + canvas.points(4.0), top}, words, style, content.theme.faint_text);
  };
  add(scale.top, inside.least.y, inside.least.y - 0.5 * style.height);
  add(scale.bottom, inside.most.y, inside.most.y - 0.9 * style.height);  // below it are the words of the last round
}

void add_battery(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const CircleEnergy* const energy = energy_of(content);
  const Theme& theme = content.theme;
  const StageLanguage::Labels& all = content.language.labels;
  const std::string words = energy == nullptr
                                ? std::string(all.first_round)
                                : filled(all.energy_a_round, signed_decimal_text(1e3 * energy->last.energy, 1));
  const TextStyle& style = layout.letters.bold_words;
  // A picture on paper is small.
  const Vector<2> cell(canvas.points(64.0), canvas.points(layout.numbers ? 170.0 : 110.0));
  const BatteryScale scale = battery_scale(content, energy);
  Vector<2> corner(0.0);
  if (layout.numbers) {
    add_place_of_numbers(layer);
    corner = layout.numbers->least;
  } else {
    const double scale_width = canvas.points(9.0) + std::max(content.measure(scale.top, layout.letters.words).x,
                                                             content.measure(scale.bottom, layout.letters.words).x);
    const Vector<2> extent(std::max(cell.x + scale_width, content.measure(words, style).x),
                           cell.y + canvas.points(6.0) + style.height);
    const auto found = canvas.labels.place_block({.id = StageLabel::battery,
                                                  .extent = extent,
                                                  .region = layout.room(),
                                                  .wanted = Vector<2>(layout.margin),
                                                  .may_cover = true});
    if (!found) return;
    corner = found->box.least;
  }
  const double width = canvas.width(3.5);
  const ScreenBox body{corner + Vector<2>(0.0, canvas.points(14.0)), corner + cell};
  const Vector<2> knob(canvas.points(34.0), canvas.points(18.0));
  const Vector<2> knob_corner = corner + Vector<2>(0.5 * (cell.x - knob.x), 0.0);
  canvas.box(Role::number, {knob_corner, knob_corner + knob}, canvas.points(4.0), theme.text, theme.text, 0.0);
  canvas.box(Role::number, body, canvas.points(12.0), theme.background, theme.text, width);
  // Full from below where the wall gives, from above where it takes.
  const double level = energy == nullptr ? 0.0 : energy->last.energy / greatest_energy(*content.round);
  const double inset = 2.0 * width;
  const ScreenBox inside = body.grown(-inset);
  const double height = std::abs(level) * inside.extent().y;
  if (height > 1.0) {
    const bool gives = level > 0.0;
    const ScreenBox fill{{inside.least.x, gives ? inside.most.y - height : inside.least.y},
                         {inside.most.x, gives ? inside.most.y : inside.least.y + height}};
    const Colour colour = stage_colour(content.moment, theme.strategy);
    canvas.box(Role::number, fill, std::min(canvas.points(8.0), 0.5 * height), colour, colour, 0.0);
  }
  add_battery_scale(layer, scale, inside, body.most.x + width);
  canvas.text(Role::number, corner + Vector<2>(0.0, cell.y + canvas.points(6.0)), words, style,
              stage_colour(content.moment, theme.strategy_text));
}

void add_round(const StageLayer& layer) {
  add_stage_wall(layer);
  add_rail(layer);
  add_mechanism(layer);
  add_loop(layer);
  add_springs(layer);
  add_stage_hand(layer);
  if (!layer.content.hides.force) add_stage_force(layer);
  add_handle(layer);
  add_rail_grips(layer);
  if (!layer.content.hides.numbers) add_battery(layer);
  add_hand_words(layer);
}

std::string round_sentence(const StageContent& content) {
  const CircleEnergy* const energy = energy_of(content);
  const StageLanguage::Sentences& all = content.language.sentences;
  if (energy == nullptr) return std::string(all.round_begins);
  if (!energy->stays_inside) return std::string(all.round_leaves_wall);
  // The sampled loop itself takes a little away.
  const double little = std::max(least_energy, 0.03 * greatest_energy(*content.round));
  if (energy->last.energy >= little) {
    const bool is_naive = content.settings.active == StrategyId::naive;
    return std::string(is_naive ? all.round_gives : all.round_gives_though_cured);
  }
  if (energy->last.energy <= -little) return std::string(all.round_takes);
  return std::string(all.round_is_fair);
}

}  // namespace

const StageModeLayers round_layers{StageMode::round, add_round, round_sentence};

}  // namespace ghostforce
