// The landscape as a mode of the stage.
#include "app/stage/landscape_layer.h"
#include "app/stage/stage_layers.h"

namespace ghostforce {
namespace {

void add_map(const StageLayer& layer) {
  const StageContent& content = layer.content;
  add_landscape(stage_landscape(content, layer.canvas.camera), layer.canvas.marks);
}

std::string no_sentence(const StageContent& /*content*/) {
  return {};
}

}  // namespace

LandscapeView stage_landscape(const StageContent& content, const Camera& camera) {
  return {.settings = content.settings,
          .dial = content.landscape_dial,
          .has_every_motor = content.moment.weights[index_of(StrategyId::full)] == 1.0,
          .language = content.language,
          .theme = content.theme,
          .camera = camera,
          .scale = content.scale,
          .measure = content.measure};
}

const StageModeLayers landscape_layers{StageMode::landscape, add_map, no_sentence};

}  // namespace ghostforce
