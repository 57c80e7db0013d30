#include "device/input_catalog.h"

#include <algorithm>
#include <array>

#include "device/mouse_input.h"
#include "device/scripted_input.h"

namespace ghostforce {
namespace {

constexpr std::array kinds{
    InputKind{"mouse", "Mouse", "Drag in the scene: the goal follows the pointer.",
              [](const Scene&) -> std::unique_ptr<Input> { return std::make_unique<MouseInput>(); }},
    InputKind{"script", "Scripted hand", "The goal follows the scene's path, the same way every time.",
              [](const Scene& scene) -> std::unique_ptr<Input> { return std::make_unique<ScriptedInput>(scene.goal); }},
};

}  // namespace

std::span<const InputKind> input_catalog() noexcept {
  return kinds;
}

const InputKind* find_input(std::string_view name) noexcept {
  const auto found = std::ranges::find(kinds, name, &InputKind::name);
  return found == kinds.end() ? nullptr : &*found;
}

}  // namespace ghostforce
