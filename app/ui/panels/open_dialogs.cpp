// Ctrl+O: a scene by its path. The shipped ones are in the menu of the status bar.
#include "app/ui/panels/dialogs.h"
#include "app/ui/widgets/controls.h"

namespace ghostforce {

void draw_open_scene(const PanelContext& context) {
  Session& session = context.session;
  ImGui::TextUnformatted("Path of a scene file, or name of a shipped scene:");
  if (session.form.belongs_to != Dialog::open_scene) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(dialog_field_width(420.0F, context));
  const bool entered = text_field("##path", "my_scene.toml", session.form.path);
  ImGui::BeginDisabled(session.form.path.empty());
  const bool pressed = ImGui::Button("Open");
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (ImGui::Button("Cancel")) session.dialog = Dialog::none;
  ImGui::SameLine();
  text_in(context.theme.faint_text, "Or drop the file on the window.");
  if ((entered || pressed) && !session.form.path.empty()) {
    session.requests.open_scene = session.form.path;
    session.dialog = Dialog::none;
  }
}

}  // namespace ghostforce
