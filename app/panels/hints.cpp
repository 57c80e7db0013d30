#include "app/panels/hints.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/panels/controls.h"

namespace ghostforce {
namespace {

constexpr std::array hints{
    Hint{"Drag: this is where your hand wants to be.", HintTarget::goal,
         [](const Session& session, const HintProgress& progress) {
           return progress.has_dragged && !session.drags_goal;
         }},
    Hint{"Press 3. Same hand, same wall.", HintTarget::third_strategy,
         [](const Session& session, const HintProgress&) {
           return session.settings.active == StrategyId::anisotropic;
         }},
    Hint{"Turn the arrow.", HintTarget::motor_axis,
         [](const Session& session, const HintProgress& progress) {
           return session.settings.actuated_angle != progress.actuated_angle && !session.is_editing;
         }},
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
  if (begun_ != session.hint) {
    begun_ = session.hint;
    progress_ = {.actuated_angle = session.settings.actuated_angle};
  }
  progress_.has_dragged = progress_.has_dragged || session.drags_goal;
  if (!hints[*session.hint].is_followed(session, progress_)) return;
  const std::size_t next = *session.hint + 1;
  session.hint = next < hints.size() ? std::optional(next) : std::nullopt;
}

void Hints::draw(const PanelContext& context, ImVec2 corner, ImVec2 size, ImVec2 goal) const {
  Session& session = context.session;
  if (!session.hint) return;
  const Hint& hint = hints[*session.hint];
  const float scale = context.scale;
  // Between scale bars and motor dial.
  const float middle = 0.5F * (170.0F * scale + size.x - 118.0F * scale);
  ImGui::SetNextWindowPos({corner.x + middle, corner.y + size.y - 56.0F * scale}, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 2.0F * scale);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6.0F * scale);
  ImGui::PushStyleColor(ImGuiCol_Border, unpacked(context.theme.accent));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, unpacked(context.theme.panel_field));
  ImGui::Begin("hint", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PushFont(context.fonts.bold, 1.1F * ImGui::GetStyle().FontSizeBase);
  ImGui::TextUnformatted(hint.sentence.data(), hint.sentence.data() + hint.sentence.size());
  ImGui::PopFont();
  ImGui::PushStyleColor(ImGuiCol_Text, unpacked(context.theme.faint_text));
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(fmt::format("Hint {} of {}", *session.hint + 1, hints.size()).c_str());
  ImGui::PopStyleColor();
  ImGui::SameLine(0.0F, 16.0F * scale);
  const bool enough = ImGui::SmallButton("No more hints");
  const ImVec2 box = ImGui::GetWindowPos();
  const ImVec2 box_size = ImGui::GetWindowSize();
  ImGui::End();
  ImGui::PopStyleColor(2);
  ImGui::PopStyleVar(2);
  if (hint.target == HintTarget::goal) {
    const ImVec2 from{box.x + 0.5F * box_size.x, box.y};
    const float away = 24.0F * scale;
    const ImVec2 along{goal.x - from.x, goal.y - from.y};
    const float length = std::sqrt(along.x * along.x + along.y * along.y);
    if (length > 2.0F * away) {
      const float share = (length - away) / length;
      ImGui::GetBackgroundDrawList()->AddLine(from, {from.x + along.x * share, from.y + along.y * share},
                                              packed(context.theme.accent), 2.0F * scale);
    }
  }
  if (enough) session.hint.reset();
}

}  // namespace ghostforce
