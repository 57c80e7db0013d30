#include "app/stage/hints.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/state/landscape.h"
#include "app/state/permit.h"
#include "app/widgets/controls.h"
#include "app/widgets/symbol_text.h"

namespace ghostforce {
namespace {

// By closed form: where the motor pushes straight at the wall, or along it, there is nothing to cure.
bool is_there_a_ghost_force(const Session& session) {
  constexpr double least_share = 0.01;  // of the push that the wall should give
  constexpr double naive_dial = 0.0;
  return std::abs(ghost_share(landscape_of(session.settings, naive_dial), landscape_point(session.settings))) >=
         least_share;
}

constexpr std::array hints{
    Hint{"Drag: this is where your hand wants to be.",
         "You press a handle into a virtual wall. With one motor, rendered as if there were two (2, naïve), the "
         "hatched end of the force arrow is the ghost force: that is what goes wrong.",
         HintTarget::goal,
         [](const Session& session, const HintProgress& progress) {
           return progress.has_dragged && !session.drags_goal;
         },
         // A goal that a script moves cannot be dragged.
         [](const Session& session) { return session.pointer_moves_goal; }},
    Hint{"Press 3: same hand, same wall.",
         "Same motor, too: this is anisotropic rendering. Watch the ghost force and the proxy drift disappear.",
         HintTarget::third_strategy,
         [](const Session& session, const HintProgress&) { return session.settings.active == StrategyId::anisotropic; },
         is_there_a_ghost_force},
    Hint{"Turn the arrow.",
         "With naïve rendering (2), drag the actuated direction, lower right. At which angle is there a force, but no "
         "ghost "
         "force?",
         HintTarget::motor_axis,
         [](const Session& session, const HintProgress& progress) {
           return session.settings.actuated_angle != progress.actuated_angle && !session.is_editing;
         },
         [](const Session& session) { return session.has_handles && !permit(session, TurnMotorTo{}); }},
};

}  // namespace

std::span<const Hint> hint_catalog() noexcept {
  return hints;
}

bool points_at(const Session& session, HintTarget target) noexcept {
  return session.hint && hints[*session.hint].target == target;
}

void Hints::follow(Session& session) {
  if (!session.hint) return;
  if (begun_ != session.hint || scene_ != session.scene) {
    begun_ = session.hint;
    scene_ = session.scene;
    progress_ = {.actuated_angle = session.settings.actuated_angle};
  }
  progress_.has_dragged = progress_.has_dragged || session.drags_goal;
  const Hint& hint = hints[*session.hint];
  if (hint.is_possible(session) && !hint.is_followed(session, progress_)) return;
  const std::size_t next = *session.hint + 1;
  session.hint = next < hints.size() ? std::optional(next) : std::nullopt;
}

void draw_hint(const PanelContext& context) {
  const Session& session = context.session;
  const Hint& hint = hints[*session.hint];
  const ImVec2 corner = ImGui::GetCursorPos();
  const float gap = 12.0F * context.scale;
  const auto beside = [](const char* words) {
    return ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(words).x - 2.0F * ImGui::GetStyle().FramePadding.x;
  };
  const char* const long_words = "No more hints";
  ImGui::PushFont(context.fonts.bold, 0.0F);
  const float room = beside(long_words) - gap - corner.x;
  const bool is_narrow = symbol_text_size(hint.sentence, room).y > 2.0F * ImGui::GetTextLineHeight();
  const char* const enough = is_narrow ? "×" : long_words;
  const float right = beside(enough);
  ImGui::PushStyleColor(ImGuiCol_Text, unpacked(context.theme.accent));
  wrapped_text(hint.sentence, right - gap);
  ImGui::PopStyleColor();
  ImGui::PopFont();
  const float end = ImGui::GetCursorPosY() + symbol_text_size(hint.detail, right - gap - corner.x).y;
  if (end <= ImGui::GetWindowHeight()) wrapped_text(hint.detail, right - gap);
  ImGui::SetCursorPos({right, corner.y});
  if (!is_narrow) {
    ImGui::TextUnformatted(fmt::format("Hint {} of {}", *session.hint + 1, hints.size()).c_str());
    ImGui::SetCursorPos({right, corner.y + ImGui::GetTextLineHeightWithSpacing()});
  }
  if (ImGui::Button(fmt::format("{}###enough", enough).c_str())) context.apply(HideHints{});
  if (is_narrow) tooltip(long_words);
}

}  // namespace ghostforce
