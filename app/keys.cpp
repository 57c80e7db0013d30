#include "app/keys.h"

#include <array>

namespace ghostforce {
namespace {

template <StrategyId id>
void activate(Session& session) {
  session.settings.active = id;
}

constexpr std::array bindings{
    KeyBinding{ImGuiKey_1, "1", "Fully actuated rendering", activate<StrategyId::full>, false},
    KeyBinding{ImGuiKey_2, "2", "Naïve rendering", activate<StrategyId::naive>, false},
    KeyBinding{ImGuiKey_3, "3", "Anisotropic rendering", activate<StrategyId::anisotropic>, false},
    KeyBinding{ImGuiKey_0, "0", "Compare: all strategies, or the active one only", toggle_compare, false},
    KeyBinding{ImGuiKey_Space, "Space", "Pause, and go on", toggle_pause, false},
    KeyBinding{ImGuiKey_Period, ".", "One tick, then pause", single_step, true},
    KeyBinding{ImGuiKey_R, "R", "Reset the motion", restart, false},
    KeyBinding{ImGuiMod_Alt | ImGuiKey_R, "Alt+R", "Reset motion and all settings", restart_with_scene_settings, false},
};

}  // namespace

std::span<const KeyBinding> key_table() noexcept {
  return bindings;
}

void act_on_keys(Session& session) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantTextInput) return;
  for (const KeyBinding& binding : bindings) {
    const auto key = static_cast<ImGuiKey>(binding.chord & ~ImGuiMod_Mask_);
    if ((binding.chord & ImGuiMod_Mask_) == io.KeyMods && ImGui::IsKeyPressed(key, binding.repeats)) {
      binding.act(session);
    }
  }
}

void toggle_compare(Session& session) {
  session.compare = session.compare == Compare::overlay ? Compare::active_only : Compare::overlay;
}

void toggle_pause(Session& session) {
  session.paused = !session.paused;
}

void single_step(Session& session) {
  session.paused = true;
  ++session.steps_asked;
}

void restart(Session& session) {
  session.goal = session.scene.goal.points.back();
  ++session.restarts_asked;
}

void restart_with_scene_settings(Session& session) {
  session.settings = session.scene.settings;
  restart(session);
}

}  // namespace ghostforce
