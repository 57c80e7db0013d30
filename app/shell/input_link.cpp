#include "app/shell/input_link.h"

#include <algorithm>

#include "device/input/mouse_input.h"
#include "device/input/scripted_input.h"
#include "device/input/unsteady_input.h"

namespace ghostforce {

LinkedInput make_in_hand_of(const Scene& scene, const InputEntry& entry, const InputOptions& options) {
  LinkedInput made = entry.make(scene, options);
  if (entry.hand_is_simulated) return made;
  const bool is_recorded = entry.needs_recording && options.recorded_hand != nullptr;
  const bool has_own_tremor = is_recorded || made.input->haptic_device() != nullptr;
  made.input = in_hand_of(scene, std::move(made.input), has_own_tremor);
  return made;
}

const InputEntry* find_input(std::span<const InputEntry> inputs, std::string_view name) noexcept {
  const auto found = std::ranges::find(inputs, name, &InputEntry::name);
  return found == inputs.end() ? nullptr : &*found;
}

std::vector<InputChoice> choices_of(std::span<const InputEntry> inputs, bool has_recording) {
  std::vector<InputChoice> choices;
  for (const InputEntry& entry : inputs) {
    if (has_recording || !entry.needs_recording) choices.push_back(entry);
  }
  return choices;
}

void PointerLink::begin(Session& session) {
  session.pointer_moves_goal = true;
  sent_goal_ = session.goal;
  restarts_ = session.restarts_asked;
}

void PointerLink::send(Session& session, double interval_s) {
  target_.set_user_stiffness(session.settings.stiffnesses.k_u);
  // A restart takes the goal along.
  if (std::exchange(restarts_, session.restarts_asked) != session.restarts_asked) sent_goal_ = session.goal;
  if (!session.drags_goal && session.goal == sent_goal_) return;
  target_.move_to(session.goal, interval_s * session.speed);
  sent_goal_ = session.goal;
}

namespace {

const InputMaker<MouseInput> mouse_kind{
    {mouse_hand}, [](const Scene&, const InputOptions&) { return std::make_unique<MouseInput>(); }};

const InputMaker<ScriptedInput> script_kind{
    {scripted_hand, /*is_scripted=*/true},
    [](const Scene& scene, const InputOptions&) { return std::make_unique<ScriptedInput>(scene.goal); }};

const InputMaker<ScriptedInput> replay_kind{
    {replayed_hand,
     /*is_scripted=*/true,
     /*needs_recording=*/true},
    [](const Scene& scene, const InputOptions& options) {
      return std::make_unique<ScriptedInput>(options.recorded_hand ? *options.recorded_hand : scene.goal);
    }};

}  // namespace

std::vector<InputEntry> portable_inputs(const ReadinessOf& readiness_of, const std::vector<InputEntry>& devices) {
  std::vector<InputEntry> inputs{linked<PointerLink>(mouse_kind), linked<InputLink>(script_kind),
                                 linked<InputLink>(replay_kind), circle_entry()};
  inputs.insert(inputs.end(), devices.begin(), devices.end());
  inputs.push_back(virtual_falcon_entry(readiness_of));
  return inputs;
}

}  // namespace ghostforce
