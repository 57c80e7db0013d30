// Measuring the hand as a mode of the stage: the scene with a ring round the hand, which fills, and then the number.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "app/picture/text.h"
#include "app/stage/stage_layers.h"

namespace ghostforce {
namespace {

constexpr double ring_width = 8.0;
constexpr double newton_per_cm = 0.01;  // of a stiffness of 1 N/m

// From above, clockwise, as clocks have it.
void add_arc(StageCanvas& canvas, const Vector<2>& middle, double share, double width, Colour colour) {
  if (!(share > 0.0)) return;
  constexpr double pieces_per_turn = 72.0;
  const int pieces = std::max(1, static_cast<int>(std::ceil(share * pieces_per_turn)));
  std::vector<Vector<2>> corners;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = 2.0 * std::numbers::pi * share * i / pieces;
    corners.push_back(middle + canvas.points(measuring_ring) * Vector<2>(std::sin(angle), -std::cos(angle)));
  }
  canvas.curve(Role::hand, corners, width, colour);
}

// What is said of a hand that nobody knows, in the order of HandUnknown.
using Sentences = StageLanguage::Sentences;
constexpr std::array<std::string_view Sentences::*, hand_unknown_count> reasons{
    &Sentences::measure_runs,    &Sentences::hand_left_wall,    &Sentences::hand_not_moved,
    &Sentences::hand_left_wall,  &Sentences::hand_at_limit,     &Sentences::hand_damaged,
    &Sentences::hand_too_slowly, &Sentences::hand_too_restless, &Sentences::hand_out_of_range,
};

std::string_view sentence_of_running(const StageContent& content) {
  const Sentences& all = content.language.sentences;
  switch (content.measuring->why) {
    case HandUnknown::no_tones:
      return all.measure_needs_motors;
    case HandUnknown::no_contact:
      return content.audience.can_drag ? all.drag_into_wall : all.measure_needs_wall;
    default:
      return all.measure_runs;
  }
}

std::string measure_sentence(const StageContent& content) {
  if (!content.measuring) return {};
  const StageMeasuring& measuring = *content.measuring;
  const Sentences& all = content.language.sentences;
  if (measuring.is_running) return std::string(sentence_of_running(content));
  if (measuring.has_trouble()) return std::string(all.*reasons[static_cast<std::size_t>(measuring.why)]);
  if (!measuring.result) return {};
  const HandEstimate& hand = *measuring.result;
  if (measuring.is_believed) return filled(all.hand_believed, decimal_text(hand.k_u, 0));
  return filled(all.hand_known, decimal_text(hand.k_u, 0), deviation_text(hand.sigma),
                fmt::format("{:.1f}", newton_per_cm * hand.k_u));
}

void add_measure(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  if (!content.measuring) return add_whole_scene(layer);
  const Theme& theme = content.theme;
  const StageMeasuring& measuring = *content.measuring;
  const Vector<2> hand = canvas.at(content.moment.goal);
  constexpr double air = 2.0;
  canvas.labels.keep_clear(hand, hand, canvas.points(measuring_ring + air) + canvas.width(0.5 * ring_width));
  add_whole_scene(layer);
  if (measuring.result) {
    add_arc(canvas, hand, 1.0, canvas.width(ring_width), theme.accent);
  } else if (measuring.is_running) {
    add_arc(canvas, hand, 1.0, canvas.width(ring_width), mix(theme.background, theme.faint_text, 0.35));
    add_arc(canvas, hand, std::min(measuring.filled, 1.0), canvas.width(ring_width), theme.accent);
  } else if (measuring.has_trouble()) {
    canvas.ring(Role::hand, hand, canvas.points(measuring_ring), canvas.width(0.5 * ring_width), theme.faint_text);
  }
}

}  // namespace

std::vector<std::string> measured_hand_words(const StageMeasuring& measuring, const StageLanguage& language) {
  const StageLanguage::Labels& all = language.labels;
  // Nothing is measured yet where it waits for something.
  if (measuring.is_running && measuring.why != HandUnknown::none) return {};
  if (measuring.is_running) return {std::string(all.measuring)};
  if (measuring.has_trouble()) return {std::string(all.hand_unknown)};
  if (!measuring.result) return {};
  const HandEstimate& hand = *measuring.result;
  std::vector<std::string> lines{filled(all.hand_measured, decimal_text(hand.k_u, 0), deviation_text(hand.sigma))};
  if (measuring.asked) {
    lines.push_back(filled(*measuring.asked < hand.k_u ? all.hand_asked_softer : all.hand_asked_stiffer,
                           decimal_text(*measuring.asked, 0)));
  } else if (measuring.before) {
    lines.push_back(filled(all.hand_before, decimal_text(measuring.before->k_u, 0)));
  }
  return lines;
}

const StageModeLayers measure_layers{StageMode::measure, add_measure, measure_sentence};

}  // namespace ghostforce
