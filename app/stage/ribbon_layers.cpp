// The last minute as a mode of the stage: the scene as it was, and the ribbon below it.
#include "app/stage/ribbon_layer.h"
#include "app/stage/stage_layers.h"

namespace ghostforce {
namespace {

void add_last_minute(const StageLayer& layer) {
  add_whole_scene(layer);
  if (const auto ribbon = stage_ribbon(layer)) add_ribbon(*ribbon, layer.canvas.marks);
}

std::string ribbon_sentence(const StageContent& content) {
  if (content.looks_back_to_s) return {};
  return std::string(content.language.sentences.drag_along_ribbon);
}

}  // namespace

std::optional<Ribbon> stage_ribbon(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  if (content.moments == nullptr || !layout.ribbon) return std::nullopt;
  return Ribbon{.moments = *content.moments,
                .looks_back_to_s = content.looks_back_to_s,
                .language = content.language,
                .theme = content.theme,
                .measure = content.measure,
                .camera = canvas.camera,
                .box = *layout.ribbon};
}

const StageModeLayers ribbon_layers{StageMode::ribbon, add_last_minute, ribbon_sentence};

}  // namespace ghostforce
