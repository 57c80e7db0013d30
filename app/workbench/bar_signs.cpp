#include "app/workbench/bar_signs.h"

#include <algorithm>
#include <utility>

namespace ghostforce {

void draw_play_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour) {
  draw_list.AddTriangleFilled({middle.x - 0.7F * unit, middle.y - unit}, {middle.x + unit, middle.y},
                              {middle.x - 0.7F * unit, middle.y + unit}, colour);
}

void draw_pause_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour) {
  for (const float side : {-1.0F, 1.0F}) {
    const float x = middle.x + 0.5F * side * unit;
    draw_list.AddRectFilled({x - 0.28F * unit, middle.y - unit}, {x + 0.28F * unit, middle.y + unit}, colour);
  }
}

namespace {

// To the right, or mirrored.
void draw_step(ImDrawList& draw_list, ImVec2 middle, float unit, float side, ImU32 colour) {
  const float x = middle.x - side * unit;
  // The corners in the order that ImGui smooths the edges of.
  ImVec2 top{x, middle.y - unit};
  ImVec2 bottom{x, middle.y + unit};
  if (side < 0.0F) std::swap(top, bottom);
  draw_list.AddTriangleFilled(top, {middle.x + 0.4F * side * unit, middle.y}, bottom, colour);
  const float from = middle.x + 0.5F * side * unit;
  const float to = middle.x + 0.95F * side * unit;
  draw_list.AddRectFilled({std::min(from, to), middle.y - unit}, {std::max(from, to), middle.y + unit}, colour);
}

// Back to where it came from: a hook that ends in an arrow head to the left, or mirrored.
void draw_hook(ImDrawList& draw_list, ImVec2 middle, float unit, float side, ImU32 colour) {
  constexpr float quarter = 1.5708F;
  const auto at = [&](float x, float y) { return ImVec2{middle.x + side * x * unit, middle.y + y * unit}; };
  const float turn = side > 0.0F ? 0.0F : 2.0F * quarter;
  draw_list.PathLineTo(at(-0.5F, -0.4F));
  draw_list.PathArcTo(at(0.35F, 0.2F), 0.6F * unit, turn - side * quarter, turn + side * quarter, 16);
  draw_list.PathLineTo(at(-0.5F, 0.8F));
  draw_list.PathStroke(colour, 0, 0.3F * unit);
  ImVec2 top = at(-0.4F, -0.95F);
  ImVec2 bottom = at(-0.4F, 0.15F);
  if (side < 0.0F) std::swap(top, bottom);
  draw_list.AddTriangleFilled(at(-1.1F, -0.4F), top, bottom, colour);
}

}  // namespace

void draw_step_back_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour) {
  draw_step(draw_list, middle, unit, -1.0F, colour);
}

void draw_step_on_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour) {
  draw_step(draw_list, middle, unit, 1.0F, colour);
}

// Three quarters of a circle and an arrow head: once more.
void draw_reset_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour) {
  constexpr float quarter = 1.5708F;
  draw_list.PathArcTo(middle, 0.85F * unit, -0.6F * quarter, 2.6F * quarter, 24);
  draw_list.PathStroke(colour, 0, 0.3F * unit);
  const ImVec2 end{middle.x + 0.5F * unit, middle.y - 0.69F * unit};
  draw_list.AddTriangleFilled({end.x - 0.75F * unit, end.y - 0.3F * unit}, {end.x + 0.5F * unit, end.y - 0.75F * unit},
                              {end.x + 0.35F * unit, end.y + 0.6F * unit}, colour);
}

void draw_record_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour) {
  draw_list.AddCircleFilled(middle, unit, colour, 24);
}

void draw_undo_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour) {
  draw_hook(draw_list, middle, unit, 1.0F, colour);
}

void draw_redo_sign(ImDrawList& draw_list, ImVec2 middle, float unit, ImU32 colour) {
  draw_hook(draw_list, middle, unit, -1.0F, colour);
}

}  // namespace ghostforce
