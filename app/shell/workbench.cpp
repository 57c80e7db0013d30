#include "app/shell/workbench.h"

#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "app/stage/hints.h"
#include "app/state/target.h"
#include "app/state/user_measurement_guide.h"
#include "app/widgets/controls.h"
#include "app/workbench/bars.h"
#include "app/workbench/drawer.h"
#include "app/workbench/motor_control.h"
#include "app/workbench/panel_catalog.h"

namespace ghostforce {
namespace {

// Bold, low, and with a line above: a heading, not a bar of buttons.
bool draw_panel_head(const Panel& panel, const PanelContext& context) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float y = ImGui::GetCursorScreenPos().y;
  const float left = ImGui::GetWindowPos().x + style.WindowPadding.x;
  const float right = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
  ImGui::PushFont(context.fonts.bold, 0.0F);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {4.0F * context.scale, 0.0F});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {style.ItemSpacing.x, 4.0F * context.scale});
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0.0F);
  ImGui::PushStyleColor(ImGuiCol_Header, unpacked(context.theme.panel));
  const bool is_open = ImGui::CollapsingHeader(panel.title.data());
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
  ImGui::PopFont();
  ImGui::GetWindowDrawList()->AddLine({left, y}, {right, y}, packed(context.theme.panel_border), context.scale);
  return is_open;
}

// Scrolls so that what lies between these heights of the window that is being drawn is all in sight, or else its
// beginning.
void bring_into_sight(float top, float bottom) {
  const float view_top = ImGui::GetScrollY();
  const float view_height = ImGui::GetWindowHeight();
  if (top < view_top || bottom > view_top + view_height) ImGui::SetScrollY(top - ImGui::GetStyle().ItemSpacing.y);
}

void draw_column(const PanelContext& context) {
  for (const Panel& panel : panel_catalog()) {
    if (panel.is_there != nullptr && !panel.is_there(context.loop)) continue;
    std::set<std::string, std::less<>>& folded = context.memory.folded_panels;
    const bool was_folded = folded.contains(panel.title);
    ImGui::SetNextItemOpen(!was_folded);
    // What a click makes appear is laid out in the frame after.
    const bool has_news = panel.news != nullptr && panel.news(context.memory);
    const float top = ImGui::GetCursorPosY();
    const bool is_open = draw_panel_head(panel, context);
    if (is_open) {
      folded.erase(std::string(panel.title));
      panel.draw(context);
      if (has_news && !ImGui::IsAnyItemActive()) {
        bring_into_sight(top, ImGui::GetCursorPosY());
        panel.news(context.memory) = false;
      }
    } else if (!was_folded) {
      folded.emplace(panel.title);
    }
  }
}

}  // namespace

// Bar on top, bar at the bottom, panels on the right, and in what remains the scene under its caption and above the
// drawer with the plots. Their edges are whole points, as ImGui has its windows: else a column of pixels between two of
// them would be nobody's.
struct Workbench::Layout {
  Rect top, bottom, column;
  Rect caption, scene, drawer;  // of no height where there is no room for them

  Layout(Part part, ImVec2 size, float scale, float bar_height, bool has_drawer) {
    if (part == Part::scene) {
      scene = {{0.0F, 0.0F}, size};
      return;
    }
    const float top_height = std::round(bar_height);
    const float bottom_height = std::round(32.0F * scale);
    const float column_width =
        std::round(std::min(std::clamp(0.335F * size.x, 350.0F * scale, 470.0F * scale), 0.5F * size.x));
    const float middle_height = size.y - top_height - bottom_height;
    top = {{0.0F, 0.0F}, {size.x, top_height}};
    bottom = {{0.0F, size.y - bottom_height}, {size.x, bottom_height}};
    column = {{size.x - column_width, top_height}, {column_width, middle_height}};
    const float scene_width = size.x - column_width;
    float caption_height = std::round(62.0F * scale);
    float drawer_height =
        has_drawer ? std::round(std::clamp(0.4F * middle_height, 200.0F * scale, 340.0F * scale)) : 0.0F;
    if (has_drawer) {
      // Plots that were asked for are whole: in a low window the caption makes room for them, and then the scene.
      const float room = middle_height - drawer_height;
      if (room < caption_height + 100.0F * scale) caption_height = 0.0F;
      if (room < 60.0F * scale) drawer_height = middle_height;
    }
    caption = {{0.0F, top_height}, {scene_width, caption_height}};
    const float scene_height = middle_height - caption_height - drawer_height;
    scene = {{0.0F, top_height + caption_height}, {scene_width, scene_height}};
    drawer = {{0.0F, scene.corner.y + scene_height}, {scene_width, drawer_height}};
  }
};

void Workbench::draw_panels(const PanelContext& context, const Layout& layout, const History& history) {
  begin_piece("strategies", layout.top, fixed_bar);
  draw_strategy_bar(context);
  ImGui::EndChild();
  if (layout.caption.size.y > 0.0F) {
    begin_piece("caption", layout.caption, fixed_bar);
    draw_caption(context);
    ImGui::EndChild();
  }
  // The one window that may hold more than it shows. Its scrollbar lies in the margin, so that nothing becomes
  // narrower where it appears.
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  ImGui::SetNextWindowContentSize({layout.column.size.x - 2.0F * padding.x, 0.0F});
  ImGui::PushStyleVar(ImGuiStyleVar_ScrollbarSize, padding.x - 2.0F * context.scale);
  begin_piece("panels", layout.column, fixed_window & ~ImGuiWindowFlags_NoScrollbar);
  ImGui::PopStyleVar();
  ImGui::SetScrollX(0.0F);  // what lies beneath the scrollbar is empty
  draw_column(context);
  ImGui::EndChild();
  if (context.session.plots.is_open) {
    begin_piece("plots", layout.drawer, fixed_bar);
    draw_plots(context, history);
    ImGui::EndChild();
  }
  // Round the plots, where they have taken the scene's place.
  const Rect& framed = layout.scene.size.y > 0.0F ? layout.scene : layout.drawer;
  begin_piece("motor frame", framed, fixed_window | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoInputs);
  draw_motor_frame(context);
  ImGui::EndChild();
  begin_piece("status", layout.bottom, fixed_bar);
  draw_status_bar(context, layout.caption.size.y > 0.0F);
  ImGui::EndChild();
}

void Workbench::draw(Session& session, const PanelContext& context, const WorkbenchFrame& frame) {
  const Layout layout(frame.part, ImGui::GetIO().DisplaySize, context.scale, strategy_bar_height(context),
                      session.plots.is_open);
  const double unit = static_cast<double>(context.scale) * context.theme.thickness;
  scene_corner_ = layout.scene.corner;
  scene_size_ = {std::max(1.0, static_cast<double>(layout.scene.size.x)),
                 std::max(1.0, static_cast<double>(layout.scene.size.y))};
  begin_screen("workbench");
  if (frame.is_live && layout.scene.size.y > 0.0F) {
    begin_piece("scene", layout.scene, fixed_window | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav);
    gestures_.take(session, context.apply, panes_, scene_size_, unit, frame.moment);
    ImGui::EndChild();
  }
  if (frame.is_live && std::exchange(session.fits_view, false)) {
    session.pane_views.reset();
    if (session.options.compare != Compare::side_by_side) {
      session.shown = view_of_everything(session, panes_, scene_size_, unit);
    }
  }
  if (frame.part == Part::window) draw_panels(context, layout, frame.history);
  ImGui::End();
  // After the panels, so that a change made in this frame is seen in this frame.
  compose(session, context, frame);
}

PictureContent Workbench::content_of(const Session& session, const ShownMoment& moment, const History& history,
                                     const LoopReading& loop, const MeasureText& measure, double scale) const {
  ViewOptions options = session.options;
  options.predictions = options.predictions && !hides_answer(session);
  return {.settings = moment.settings,
          .snapshot = moment.snapshot,
          .history = history,
          .theme = shown_theme(session),
          .options = options,
          .shown = session.shown,
          .pane_views = session.pane_views,
          .size = scene_size_,
          .scale = scale,
          .arrow_scale = session.appearance.arrow_scale,
          .measure = measure,
          .turn_s = turn_to_show(loop),
          .target = target_of(session, loop.motors),
          .linkage = moment.is_past ? std::nullopt : loop.motors.linkage};
}

std::vector<Pane> Workbench::panes_for_file(const Session& session, const ShownMoment& moment, const History& history,
                                            const LoopReading& loop, const MeasureText& measure, double scale) const {
  return compose_panes(content_of(session, moment, history, loop, measure, scale));
}

void Workbench::compose(Session& session, const PanelContext& context, const WorkbenchFrame& frame) {
  const bool is_live = frame.is_live;
  // They are fitted once, and not while something moves: the picture must not swim under the pointer.
  if (session.options.compare != Compare::side_by_side) session.pane_views.reset();
  PictureContent content =
      content_of(session, frame.moment, frame.history, context.loop, frame.measure, static_cast<double>(context.scale));
  content.has_handles = session.has_handles;
  content.is_goal_hot = is_live && points_at(session, HintTarget::goal);
  content.hovered = !is_live                                     ? Handle::none
                    : points_at(session, HintTarget::motor_axis) ? Handle::motor_axis
                                                                 : gestures_.hovered();
  if (session.options.compare == Compare::side_by_side && !session.pane_views) {
    session.pane_views = content.pane_views = fitted_pane_views(content);
  }
  if (is_live) {
    panes_ = compose_panes(content, memory_, frame.interval_s, std::move(panes_));
  } else {
    panes_ = compose_panes(content);
  }
}

}  // namespace ghostforce
