// Who moves the goal; and for a device, how far it is.
#include <algorithm>
#include <string>

#include "app/keys.h"
#include "app/panels/controls.h"
#include "app/panels/panel_catalog.h"

namespace ghostforce {
namespace {

void draw_choice(const PanelContext& context) {
  Session& session = context.session;
  const auto chosen = std::ranges::find(context.loop.inputs, session.input, &InputChoice::name);
  const bool is_known = chosen != context.loop.inputs.end();
  const bool is_open = ImGui::BeginCombo("##input", is_known ? chosen->title.data() : "");
  if (!is_open) {
    if (is_known) explain(chosen->sentence);
    return;
  }
  close_popup_on_escape();
  for (const InputChoice& choice : context.loop.inputs) {
    if (ImGui::Selectable(choice.title.data(), session.input == choice.name)) session.wishes.input = choice.name;
    explain(choice.sentence);
  }
  ImGui::EndCombo();
}

// The rung that is to be reached now, with its words; the whole ladder is a key away.
void draw_rung(const PanelContext& context) {
  const auto rung = std::ranges::find_if(context.loop.ladder, &RungState::is_current);
  ImGui::PushTextWrapPos(0.0F);
  if (rung != context.loop.ladder.end()) {
    ImGui::TextUnformatted((std::string(rung->title) + ": " + rung->words).c_str());
  } else {
    ImGui::TextUnformatted("The device is ready, and its motors are on.");
  }
  if (!context.loop.device_remark.empty()) ImGui::TextUnformatted(context.loop.device_remark.c_str());
  ImGui::PopTextWrapPos();
  if (ImGui::SmallButton("F2  The whole ladder")) open_dialog<Dialog::doctor>(context.session);
}

}  // namespace

void draw_input(const PanelContext& context) {
  if (begin_rows("input", context)) {
    row("Goal from", "Who moves the goal of the hand.");
    draw_choice(context);
    end_rows();
  }
  if (!context.loop.ladder.empty()) draw_rung(context);
}

}  // namespace ghostforce
