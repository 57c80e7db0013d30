// Ctrl+S: the scene with its settings as they are now.
#include "app/ui/panels/dialogs.h"
#include "app/ui/widgets/save_path.h"

namespace ghostforce {

void draw_save_scene(const PanelContext& context) {
  Session& session = context.session;
  if (session.form.belongs_to != Dialog::save_scene) {
    session.form.path = proposed_path(file_stem(session.scene->title), "toml");
  }
  ImGui::TextUnformatted("The scene with all settings as they are, and a path that ends at the goal:");
  if (!draw_save_path(context)) return;
  session.wishes.save_scene = session.form.path;
  session.dialog = Dialog::none;
}

}  // namespace ghostforce
