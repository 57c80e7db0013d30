// Why?: the triangle of forces builds itself where the handle should rest: the wall's push, what one motor can give of
// it, what nobody gives, and the excess that follows.
#include <glm/geometric.hpp>

#include "app/stage/stage_layers.h"
#include "core/prediction.h"

namespace ghostforce {
namespace {

// At rest, of the active strategy.
struct ForceTriangle {
  Vector<2> push{0.0};     // of the wall, straight out [N]
  Vector<2> share{0.0};    // of it, along the motor [N]
  Vector<2> ghost{0.0};    // beyond that [N]
  bool is_pushed = false;  // by so much that there is something to explain
};

ForceTriangle triangle_of(const StageContent& content) {
  const auto equilibria = predicted_equilibria(content.settings, content.moment.goal);
  const PredictedEquilibrium& full = equilibria[index_of(StrategyId::full)];
  const PredictedEquilibrium& active = equilibria[index_of(content.settings.active)];
  const bool is_pushed = full.at.in_contact && glm::length(full.at.force) >= least_shown_force;
  return {full.at.force, active.at.force - active.ghost_force, active.ghost_force, is_pushed};
}

// What the sentence, and the third and the fourth step say. With every motor there is only the first step.
struct WhyWords {
  std::string_view sentence;
  std::string_view missing;
  std::string_view excess;
};

WhyWords words_for(StrategyId id, const ForceTriangle& forces, const StageLanguage& language) {
  const StageLanguage::Sentences& sentences = language.sentences;
  const StageLanguage::Why& steps = language.why;
  const bool has_ghost = glm::length(forces.ghost) >= least_shown_force;
  if (id == StrategyId::full) return {sentences.why_two_motors, "", ""};
  if (glm::length(forces.share) < least_shown_force) {
    return {sentences.why_nothing_given, steps.no_share_missing, steps.no_share_excess};
  }
  if (glm::length(forces.push - forces.share) < least_shown_force) {
    return {sentences.why_all_given, steps.all_share_missing, steps.all_share_excess};
  }
  if (id == StrategyId::anisotropic && !has_ghost) {
    return {sentences.why_cured, steps.cured_missing, steps.cured_excess};
  }
  if (!has_ghost) {
    return {sentences.press_deeper, steps.missing, steps.hardly_any_excess};
  }
  return {sentences.why_ghost, steps.missing, steps.excess};
}

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
  corner.moment.handle = equilibrium_of(StrategyId::full, content.settings, content.moment.goal).device;
  const StrategyId id = content.settings.active;
  const WhyWords words = words_for(id, forces, content.language);
  const StageLayer at_corner{corner, layout, canvas};
  add_rail(at_corner);

  // As long as the picture has room for.
  const double longest = std::max(glm::length(forces.push), glm::length(forces.share + forces.ghost));
  const double per_newton = std::min(canvas.points(320.0), 0.4 * layout.size.y) / longest;
  const auto drawn = [&](const Vector<2>& force) { return to_screen_direction(force) * per_newton; };
  const Vector<2> start = canvas.at(corner.moment.handle);
  const Vector<2> push_end = start + drawn(forces.push);
  const Vector<2> share_end = start + drawn(forces.share);
  const Vector<2> ghost_end = share_end + drawn(forces.ghost);
  const Colour dark = mix(theme.wall_edge, theme.background, 0.08);
  const Colour red = theme.strategy[index_of(StrategyId::naive)];
  const double body = canvas.points(12.0);
  const auto add_arrow = [&](Role role, const Vector<2>& from, const Vector<2>& to, Colour fill, Colour rim,
                             bool is_hatched) {
    if (glm::distance(from, to) < canvas.points(4.0)) return;
    canvas.marks.push_back({role,
                            {},
                            Arrow{to_world(canvas.camera, from), to_world(canvas.camera, to), body, fill, rim,
                                  canvas.width(2.5), Vector<2>(0.0), true, is_hatched}});
    canvas.labels.keep_clear(from, to, 1.3 * body);
  };
  const int step = id == StrategyId::full ? std::min(content.why_step, 1) : content.why_step;
  if (step >= 1) add_arrow(Role::force, start, push_end, dark, dark, false);
  if (step >= 2) add_arrow(Role::wall_share, start, share_end, dark, dark, false);
  if (step >= 3) {
    canvas.line(Role::force, push_end, share_end, canvas.width(3.5), theme.faint_text, {3.0, 8.0, 3.0, 8.0});
    canvas.labels.keep_clear(push_end, share_end, canvas.width(2.0));
  }
  if (step >= 4) add_arrow(Role::ghost_force, share_end, ghost_end, theme.background, red, true);
  canvas.marks.push_back({Role::device, id,
                          Marker{corner.moment.handle, strategy_style(id).shape, canvas.points(handle_radius),
                                 theme.strategy[index_of(id)], theme.background, canvas.width(4.0)}});
  canvas.labels.keep_clear(start, start, canvas.points(1.4 * handle_radius));

  const Vector<2> out = to_screen_direction(direction_at(content.settings.wall_normal_angle));
  const Vector<2> along = glm::length(forces.share) > 0.0 ? glm::normalize(drawn(forces.share)) : out;
  const Vector<2> missing = push_end - share_end;
  const auto say = [&](int from_step, StageLabel::Id id, Role role, const std::string& said, const Vector<2>& anchor,
                       const Vector<2>& side, Colour colour, bool is_bold) {
    if (step < from_step) return;
    const TextStyle& style = is_bold ? layout.letters.bold_words : layout.letters.words;
    canvas.label(role,
                 {id, broken_into_lines(said, 0.5 * layout.size.x, style, content.measure), style, anchor, anchor,
                  canvas.points(14.0), side},
                 colour);
  };
  const double ghost = glm::length(forces.ghost);
  const std::string excess = ghost < least_shown_force ? std::string(words.excess)
                                                       : with_number(content, words.excess, force_number(ghost), "N");
  say(1, StageLabel::hand, Role::force,
      with_number(content, content.language.why.push, force_number(glm::length(forces.push)), "N"), push_end, out,
      theme.text, false);
  say(2, StageLabel::wall_share, Role::wall_share,
      with_number(content, content.language.why.share, force_number(glm::length(forces.share)), "N"),
      0.5 * (start + share_end), -missing, theme.text, false);
  say(3, StageLabel::expected_contact, Role::force, std::string(words.missing), 0.5 * (push_end + share_end), along,
      theme.faint_text, false);
  say(4, StageLabel::ghost, Role::ghost_force, excess, 0.5 * (share_end + ghost_end),
      along - 0.5 * missing / std::max(1.0, glm::length(missing)), theme.strategy_text[index_of(StrategyId::naive)],
      true);
}

std::string why_sentence(const StageContent& content) {
  const ForceTriangle forces = triangle_of(content);
  if (!forces.is_pushed) return std::string(content.language.sentences.why_needs_wall);
  return std::string(words_for(content.settings.active, forces, content.language).sentence);
}

}  // namespace

const StageModeLayers why_layers{StageMode::why, add_why, why_sentence};

}  // namespace ghostforce
