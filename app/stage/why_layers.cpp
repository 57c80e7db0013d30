// Why?: the triangle of forces builds itself where the handle should rest: the wall's push, what one motor can give of
// it, what nobody gives, and the excess that follows.
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "app/stage/stage_layers.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

// At rest, of the active strategy.
struct ForceTriangle {
  Vector<2> push{0.0};     // of the wall, straight out [N]
  Vector<2> share{0.0};    // of it, along the motor [N]
  Vector<2> ghost{0.0};    // beyond that [N]
  Vector<2> handle{0.0};   // where they are drawn [m]
  Vector<2> full{0.0};     // where every motor would let it rest [m]
  bool has_rest = true;    // else there is nothing to tell of it
  bool is_pushed = false;  // by so much that there is something to explain
};

ForceTriangle triangle_of(const StageContent& content) {
  const auto full = rest_of(StrategyId::full, content.settings, content.moment.goal);
  const auto active = rest_of(content.settings.active, content.settings, content.moment.goal);
  if (!full || !active) return {.has_rest = false};
  const bool is_pushed = full->at.in_contact && glm::length(full->at.force) >= least_shown_force;
  // A motor that turns with its device gives its share where the handle is then.
  const bool turns = content.settings.general.mechanism != MechanismKind::axes;
  return {.push = full->at.force,
          .share = active->at.force - active->ghost_force,
          .ghost = active->ghost_force,
          .handle = turns ? active->at.device : full->at.device,
          .full = full->at.device,
          .is_pushed = is_pushed};
}

// What the sentence, and the third and the fourth step say. With every motor there is only the first step.
struct WhyWords {
  std::string_view sentence;
  std::string_view missing;
  std::string_view excess;
};

WhyWords words_for(const Settings& settings, const ForceTriangle& forces, const StageLanguage& language) {
  const StrategyId id = settings.active;
  const StageLanguage::Sentences& sentences = language.sentences;
  const StageLanguage::Why& steps = language.why;
  const bool has_ghost = glm::length(forces.ghost) >= least_shown_force;
  if (id == StrategyId::full) return {has_strings(settings) ? sentences.every_motor : sentences.why_two_motors, "", ""};
  if (glm::length(forces.share) < least_shown_force) {
    return {sentences.why_nothing_given, steps.no_share_missing, steps.no_share_excess};
  }
  if (glm::length(forces.push - forces.share) < least_shown_force) {
    return {sentences.why_all_given, steps.all_share_missing, steps.all_share_excess};
  }
  if (id == StrategyId::anisotropic && !has_ghost) {
    return {sentences.why_cured, steps.cured_missing, steps.cured_excess};
  }
  if (glm::length(forces.ghost) < least_dragging_force) {
    return {sentences.press_deeper, steps.missing, steps.hardly_any_excess};
  }
  return {has_strings(settings) ? sentences.why_strings : sentences.why_ghost, steps.missing, steps.excess};
}

// With every motor there is only the first.
int last_step(const StageContent& content) {
  return content.settings.active == StrategyId::full ? std::min(content.why_step, 1) : content.why_step;
}

// "upwards (2.12 N)".
std::string force_words(const StageContent& content, const Vector<2>& force) {
  const std::string direction = force_direction_words(force, content.language);
  return content.hides.numbers ? direction : fmt::format("{} ({} N)", direction, force_number(glm::length(force)));
}

std::vector<std::string> words_of_steps(const StageContent& content, const ForceTriangle& forces) {
  const WhyWords words = words_for(content.settings, forces, content.language);
  const StageLanguage::Why& steps = content.language.why;
  const double ghost = glm::length(forces.ghost);
  return {with_number(content, steps.push, force_number(glm::length(forces.push)), "N"),
          with_number(content, steps.share, force_number(glm::length(forces.share)), "N"),
          words.missing.empty() ? "" : filled(words.missing, force_words(content, forces.push - forces.share)),
          ghost < least_shown_force ? std::string(words.excess)
                                    : with_number(content, words.excess, force_number(ghost), "N")};
}

// A missing part that is shorter leaves no room beside the arrows for the words of steps 1 to 4 [points of the design].
constexpr std::array least_missing{0.0, 100.0, 175.0, 50.0};

void add_why(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  add_stage_wall(layer);
  const ForceTriangle forces = triangle_of(content);
  if (!forces.is_pushed) {
    add_stage_hand(layer);
    add_hand_words(layer);
    return;
  }
  const Theme& theme = content.theme;
  StageContent corner = content;
  corner.moment = stage_moment_at_rest(content.settings, content.moment.goal);
  corner.moment.handle = forces.handle;
  const StrategyId id = content.settings.active;
  const std::vector<std::string> words = words_of_steps(content, forces);
  const StageLayer at_corner{corner, layout, canvas};
  add_rail(at_corner);
  add_mechanism(at_corner);

  // As long as the picture has room for.
  const double longest = std::max(glm::length(forces.push), glm::length(forces.share + forces.ghost));
  const Vector<2> start = canvas.at(corner.moment.handle);
  double per_newton = std::min(canvas.points(320.0), 0.4 * layout.size.y) / longest;
  // Between the sentence and a tip there must be room for words.
  for (const Vector<2>& force : {forces.push, forces.share + forces.ghost}) {
    const double upwards = std::max(0.0, force.y);
    const double room = std::max(start.y - layout.words_end - canvas.points(42.0), 0.2 * layout.size.y);
    if (per_newton * upwards > room) per_newton = room / upwards;
  }
  const auto drawn = [&](const Vector<2>& force) { return to_screen_direction(force) * per_newton; };
  const Vector<2> push_end = start + drawn(forces.push);
  const Vector<2> share_end = start + drawn(forces.share);
  const Vector<2> ghost_end = share_end + drawn(forces.ghost);
  const Colour dark = mix(theme.wall_edge, theme.background, 0.08);
  const Colour red = theme.strategy[index_of(StrategyId::naive)];
  const double body = canvas.points(12.0);
  const int step = last_step(content);
  // What comes with a later step has its place already: nothing moves when it is there.
  const auto is_there = [&](int from_step) { return step >= from_step; };
  const auto add_arrow = [&](int from_step, Role role, const Vector<2>& from, const Vector<2>& to, Colour fill,
                             Colour rim, bool is_hatched) {
    if (glm::distance(from, to) < canvas.points(4.0)) return;
    canvas.labels.keep_clear(from, to, 1.3 * body);
    if (!is_there(from_step)) return;
    canvas.marks.push_back({role,
                            {},
                            Arrow{to_world(canvas.camera, from), to_world(canvas.camera, to), body, fill, rim,
                                  canvas.width(2.5), Vector<2>(0.0), true, is_hatched}});
  };
  add_arrow(1, Role::force, start, push_end, dark, dark, false);
  if (content.settings.active != StrategyId::full) {
    add_arrow(2, Role::wall_share, start, share_end, dark, dark, false);
    if (glm::distance(forces.full, forces.handle) > 0.0) {
      const Vector<2> full = canvas.at(forces.full);
      canvas.labels.keep_clear(full, full, canvas.points(handle_radius));
      if (is_there(3)) {
        canvas.line(Role::expected_rest, full, start, canvas.width(2.0), theme.faint_text, {2.0, 6.0, 2.0, 6.0});
        canvas.ring(Role::expected_rest, full, canvas.points(handle_radius), canvas.width(2.5), theme.faint_text);
      }
    }
    canvas.labels.keep_clear(push_end, share_end, canvas.width(2.0));
    if (is_there(3)) {
      canvas.line(Role::force, push_end, share_end, canvas.width(3.5), theme.faint_text, {3.0, 8.0, 3.0, 8.0});
    }
    add_arrow(4, Role::ghost_force, share_end, ghost_end, theme.background, red, true);
  }
  canvas.marks.push_back({Role::device, id,
                          Marker{corner.moment.handle, strategy_style(id).shape, canvas.points(handle_radius),
                                 theme.strategy[index_of(id)], theme.background, canvas.width(4.0)}});
  canvas.labels.keep_clear(start, start, canvas.points(1.4 * handle_radius));

  const Vector<2> out = to_screen_direction(wall_near(content.settings, content.moment.goal).normal);
  const Vector<2> along = glm::length(forces.share) > 0.0 ? glm::normalize(drawn(forces.share)) : out;
  const Vector<2> missing = push_end - share_end;
  // Links, strings and their rail leave less room than words need.
  const bool has_links = is_general(content.settings);
  const auto say = [&](int from_step, StageLabel::Id id, Role role, const StageEdge& thing, const Vector<2>& side,
                       Colour colour, bool is_bold) {
    // Nor does a steep triangle under the sentence.
    const bool is_steep = ghost_end.y < share_end.y && glm::length(missing) > 2.5 * glm::distance(start, share_end);
    const bool is_narrow = has_links || (from_step == 3 && is_steep);
    // Words without room stand as near as they can.
    const bool is_short = glm::length(missing) < canvas.points(least_missing[static_cast<std::size_t>(from_step - 1)]);
    const Vector<2> middle = 0.5 * (thing.from + thing.to);
    const std::string& said = words[static_cast<std::size_t>(from_step - 1)];
    if (said.empty() || (from_step > 1 && content.settings.active == StrategyId::full)) return;
    const TextStyle& style = is_bold ? layout.letters.bold_words : layout.letters.words;
    const std::vector<std::string> lines =
        broken_into_lines(said, (is_narrow || is_short ? 0.34 : 0.5) * layout.size.x, style, content.measure);
    if (is_short) {
      const Vector<2> extent = canvas.labels.extent_of(lines, style);
      ScreenBox region = layout.room();
      region.least.y = layout.sentence_box.most.y + canvas.points(6.0);
      const LabelBlock block{.id = id,
                             .extent = extent,
                             .region = region,
                             .wanted = middle - 0.5 * extent,
                             .may_cover = true,
                             .named = middle};
      canvas.label(role, {.id = id, .lines = lines, .style = style, .block = block, .is_to_come = !is_there(from_step)},
                   colour);
      return;
    }
    canvas.label(role,
                 {.id = id,
                  .lines = lines,
                  .style = style,
                  .from = is_narrow ? thing.from : middle,
                  .to = is_narrow ? thing.to : middle,
                  .clearance = canvas.points(14.0),
                  .direction = side,
                  .may_cover = true,
                  .is_to_come = !is_there(from_step)},
                 colour);
  };
  say(1, StageLabel::hand, Role::force, {push_end, push_end}, out, theme.text, false);
  say(2, StageLabel::wall_share, Role::wall_share, {start, share_end}, -missing, theme.text, false);
  say(3, StageLabel::expected_contact, Role::force, {push_end, share_end}, along, theme.faint_text, false);
  // Red is the ghost force's colour: without one there is nothing wrong.
  const bool has_ghost = glm::length(forces.ghost) >= least_shown_force;
  say(4, StageLabel::ghost, Role::ghost_force, {share_end, ghost_end},
      along - 0.5 * missing / std::max(1.0, glm::length(missing)),
      has_ghost ? theme.strategy_text[index_of(StrategyId::naive)] : theme.text, true);
}

std::string why_sentence(const StageContent& content) {
  const ForceTriangle forces = triangle_of(content);
  if (!forces.has_rest) return no_rest_sentence(content.settings.active, content.language);
  if (!forces.is_pushed) return std::string(content.language.sentences.why_needs_wall);
  return std::string(words_for(content.settings, forces, content.language).sentence);
}

}  // namespace

std::vector<std::string> why_steps(const StageContent& content) {
  const ForceTriangle forces = triangle_of(content);
  if (!forces.is_pushed) return {};
  std::vector<std::string> steps = words_of_steps(content, forces);
  steps.resize(std::min(steps.size(), static_cast<std::size_t>(std::max(last_step(content), 0))));
  return steps;
}

const StageModeLayers why_layers{StageMode::why, add_why, why_sentence};

}  // namespace ghostforce
