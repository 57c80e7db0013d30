#include "app/view/stage/stage.h"

#include <utility>

#include "app/view/stage/stage_layers.h"

namespace ghostforce {
namespace {

void keep_frame_clear(const StageLayout& layout, StageLabels& labels) {
  labels.keep_clear(layout.sentence_box);
  for (const StageButton& button : layout.strategies) labels.keep_clear(button.box);
  for (const StageButton& button : layout.icons) labels.keep_clear(button.box);
  if (layout.keys) labels.keep_clear(layout.keys->box);
}

std::string_view sentence_of(const StageContent& content) {
  if (!content.warning.empty()) return content.warning;
  return stage_sentence(content.settings, content.moment, content.audience);
}

}  // namespace

StagePicture compose_stage(const StageContent& content, StageLabelMemory& memory, double interval_s, Marks earlier) {
  const Camera camera = stage_camera(content.shown, content.size);
  Marks marks = std::move(earlier);
  marks.clear();
  StageLayout layout =
      stage_layout(content.size, content.scale, content.measure, sentence_of(content), !content.moment.is_measured);
  StageLabels labels(content.size, layout.unit, content.measure, memory, interval_s);
  StageCanvas canvas{camera, content.theme, layout.unit, marks, labels};
  const StageLayer layer{content, layout, canvas};
  keep_frame_clear(layout, labels);
  add_stage_wall(layer);
  add_rail(layer);
  add_expectations(layer);
  add_springs(layer);
  add_stage_hand(layer);
  add_slide(layer);
  add_stage_force(layer);
  add_handle(layer);
  add_buttons(layer);
  add_sentence(layer);
  add_numbers(layer);
  add_stage_words(layer);

  StagePicture picture{{Vector<2>(0.0), camera, content.settings.active, std::move(marks)}, {}, layout.unit};
  for (auto* const buttons : {&layout.strategies, &layout.icons}) {
    picture.buttons.insert(picture.buttons.end(), buttons->begin(), buttons->end());
  }
  if (layout.keys) picture.buttons.push_back(*layout.keys);
  return picture;
}

}  // namespace ghostforce
