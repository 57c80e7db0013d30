// Which walls are bad, for a device with joints: over its whole workspace, how strong the ghost force is wherever the
// handle is at a wall of the direction that the scene's has. Beside it, small, the same with the motor at the other
// joint.
#include <algorithm>
#include <string>
#include <vector>

#include "app/picture/share_colour.h"
#include "app/picture/workspace_layer.h"
#include "app/stage/landscape_map.h"
#include "app/stage/stage_layers.h"
#include "app/state/stage_view.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

// In the place of the device's small picture.
void add_other_map(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const auto box = place_of_device(layout);
  if (!box || content.is_bare) return;
  const TextStyle& style = layout.letters.about;
  ScreenBox room = *box;
  room.least.y += style.height + canvas.points(4.0);
  add_plate(layer, Role::map, *box, under_sentences);
  canvas.text(Role::map, box->least, std::string(content.language.labels.other_motor), style, content.theme.text);
  const SceneView all = workspace_view(content.settings);
  const Vector<2> shown = stage_view_room * (all.width / stage_view_width);  // [m]
  const Vector<2> fitting = room.extent() / shown;
  const Camera seen{all.center, std::min(fitting.x, fitting.y), room.extent()};
  const WorkspaceMap other = workspace_map(with_other_motor(content.settings), content.moment.goal);
  add_workspace_cells(other, canvas.camera, room, seen, canvas.points(4.0), content.theme, canvas.marks);
  canvas.box(Role::map, room, 0.0, content.theme.background.with_alpha(0), content.theme.panel_border,
             canvas.width(2.0));
}

// What the colours mean, at the lower right.
void add_colour_scale(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  if (content.is_bare || layout.is_upright) return;
  const TextStyle& style = layout.letters.about;
  const Theme& theme = content.theme;
  const double width = canvas.points(150.0);
  const std::vector<std::string> title =
      broken_into_lines(content.language.labels.ghost_at_rest, width, style, content.measure);
  const double bar_height = canvas.points(120.0);
  const double title_height = static_cast<double>(title.size()) * style.height + canvas.points(6.0);
  const Vector<2> most{layout.size.x - layout.margin, layout.bottom - canvas.points(14.0)};
  const ScreenBox all{most - Vector<2>(width, title_height + bar_height + style.height), most};
  add_plate(layer, Role::scale, all, under_sentences);
  canvas.text(Role::scale, all.least, title, style, theme.text);
  const Vector<2> corner = all.least + Vector<2>(0.0, title_height + 0.5 * style.height);
  canvas.marks.push_back({Role::scale,
                          {},
                          Raster{to_world(canvas.camera, corner),
                                 {canvas.points(22.0), bar_height},
                                 1,
                                 scale_rows,
                                 scale_of_shares(theme, 0.0)}});
  for (const double share : {0.0, 0.2, 1.0, deepest_share}) {
    const double y = corner.y + bar_height * (1.0 - depth_of_colour(share));
    canvas.text(Role::scale, {corner.x + canvas.points(30.0), y - 0.5 * style.height}, share_words(share), style,
                theme.faint_text);
  }
}

}  // namespace

void add_workspace(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const WorkspaceMap map = workspace_map(content.settings, content.moment.goal);
  const ScreenBox whole = layout.scene();
  const Camera seen{to_world(canvas.camera, 0.5 * (whole.least + whole.most)), canvas.camera.points_per_metre,
                    whole.extent()};
  add_workspace_cells(map, canvas.camera, whole, seen, canvas.points(8.0), content.theme, canvas.marks);
  add_workspace_strokes(map, canvas.camera, whole, canvas.unit, content.theme, canvas.marks);
  add_edge_in(layer, {whole, seen.center, seen.points_per_metre}, Role::wall, 5.0, content.theme.wall_edge);
  add_mechanism(layer);
  add_springs(layer);
  add_stage_hand(layer);
  add_handle(layer);
  add_part_grips(layer);
  add_wall_grips(layer);
  if (layout.numbers) add_plate(layer, Role::number, *layout.numbers, under_sentences);
  add_numbers(layer);
  add_other_map(layer);
  add_colour_scale(layer);
}

std::string workspace_sentence(const StageContent& content) {
  const StageLanguage::Sentences& all = content.language.sentences;
  const WorkspaceMap map = workspace_map(content.settings, content.moment.goal);
  return std::string(map.is_without_ghost() ? all.no_bad_walls : all.bad_walls);
}

}  // namespace ghostforce
