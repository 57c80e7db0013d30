// Who moves the goal.
#include "app/panels/controls.h"
#include "app/panels/panel_catalog.h"

namespace ghostforce {

void draw_input(const PanelContext& context) {
  Session& session = context.session;
  for (const InputChoice& choice : context.loop.inputs) {
    if (&choice != context.loop.inputs.data()) ImGui::SameLine();
    if (ImGui::RadioButton(choice.title.data(), session.input == choice.name)) session.wishes.input = choice.name;
    explain(choice.sentence);
  }
}

}  // namespace ghostforce
