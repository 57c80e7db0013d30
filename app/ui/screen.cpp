#include "app/ui/screen.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/paint/label_painter.h"
#include "app/session/key_bindings.h"
#include "app/ui/panels/caption.h"
#include "app/ui/panels/dialogs.h"
#include "app/ui/panels/panel_catalog.h"
#include "app/ui/plots/drawer.h"
#include "app/ui/plots/plot_pieces.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/style.h"

namespace ghostforce {
namespace {

constexpr ImGuiWindowFlags fixed_window = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                          ImGuiWindowFlags_NoBringToFrontOnFocus;

struct Rect {
  ImVec2 corner;
  ImVec2 size;
};

void begin_fixed(const char* name, const Rect& rect, ImGuiWindowFlags more = 0) {
  ImGui::SetNextWindowPos(rect.corner);
  ImGui::SetNextWindowSize(rect.size);
  ImGui::Begin(name, nullptr, fixed_window | more);
}

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

bool is_escape(const KeyPress& press) {
  return press.key == GLFW_KEY_ESCAPE;
}

Image cut_out(const Image& image, int left, int top, int width, int height) {
  Image part{std::clamp(width, 1, image.width - left), std::clamp(height, 1, image.height - top), {}};
  part.rgb.reserve(3U * static_cast<std::size_t>(part.width) * static_cast<std::size_t>(part.height));
  for (int y = top; y < top + part.height; ++y) {
    const auto begin = image.rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * image.width + left);
    part.rgb.insert(part.rgb.end(), begin, begin + 3 * static_cast<std::ptrdiff_t>(part.width));
  }
  return part;
}

}  // namespace

// Bar on top, bar at the bottom, panels on the right, and in what remains the scene under its caption and above the
// drawer with the plots.
struct Screen::Layout {
  Rect top, bottom, column, caption, scene, drawer;

  Layout(Part part, ImVec2 size, float scale, bool has_drawer) {
    if (part == Part::scene) {
      scene = {{0.0F, 0.0F}, size};
      return;
    }
    const float top_height = 46.0F * scale;
    const float bottom_height = 32.0F * scale;
    const float column_width = std::min(std::clamp(0.335F * size.x, 350.0F * scale, 470.0F * scale), 0.5F * size.x);
    const float middle_height = size.y - top_height - bottom_height;
    top = {{0.0F, 0.0F}, {size.x, top_height}};
    bottom = {{0.0F, size.y - bottom_height}, {size.x, bottom_height}};
    column = {{size.x - column_width, top_height}, {column_width, middle_height}};
    const float caption_height = 62.0F * scale;
    const float scene_width = size.x - column_width;
    caption = {{0.0F, top_height}, {scene_width, caption_height}};
    const float drawer_height = has_drawer ? std::clamp(0.4F * middle_height, 200.0F * scale, 340.0F * scale) : 0.0F;
    const float scene_height = middle_height - caption_height - drawer_height;
    scene = {{0.0F, top_height + caption_height}, {scene_width, scene_height}};
    drawer = {{0.0F, scene.corner.y + scene_height}, {scene_width, drawer_height}};
  }
};

Screen::Screen(Window& window, Part part)
    : window_(window),
      part_(part),
      painter_(window.fonts()),
      measure_(measure_with(window.fonts())),
      gestures_(window.fonts()) {}

void Screen::draw(Session& session, const ShownMoment& moment, const History& history, const LoopReading& loop,
                  double interval_s) {
  if (window_.pixel_width() <= 0 || window_.pixel_height() <= 0) return;  // minimised
  // The style must not change within a frame.
  apply_appearance(session.appearance);
  window_.frame(interval_s, [&] { draw_everything(session, moment, history, loop, part_, true); });
}

Image Screen::picture(const Session& session, const ShownMoment& moment, const History& history,
                      const LoopReading& loop, Part part, int density) {
  // Nobody can take hold of a picture or follow its hints.
  Session copy = session;
  copy.hint.reset();
  copy.has_handles = false;
  const Image image = window_.picture_of(density, [&] { draw_everything(copy, moment, history, loop, part_, false); });
  if (part == Part::window) return image;
  const auto pixels = [&](double points) {
    return static_cast<int>(std::lround(points * image.width / static_cast<double>(ImGui::GetIO().DisplaySize.x)));
  };
  return cut_out(image, pixels(static_cast<double>(scene_corner_.x)), pixels(static_cast<double>(scene_corner_.y)),
                 pixels(scene_size_.x), pixels(scene_size_.y));
}

void Screen::apply_appearance(const Appearance& appearance) {
  const float scale = static_cast<float>(appearance.scale) * window_.display_scale();
  if (appearance == styled_appearance_ && scale == styled_scale_) return;
  apply_style(*appearance.theme, scale);
  apply_plot_style(*appearance.theme, scale);
  styled_appearance_ = appearance;
  styled_scale_ = scale;
}

void Screen::draw_everything(Session& session, const ShownMoment& moment, const History& history,
                             const LoopReading& loop, Part part, bool is_live) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const Layout layout(part, size, styled_scale_, session.plots.is_open);
  const Theme& theme = *styled_appearance_.theme;
  const double unit = static_cast<double>(styled_scale_) * theme.thickness;
  scene_corner_ = layout.scene.corner;
  scene_size_ = {std::max(1.0, static_cast<double>(layout.scene.size.x)),
                 std::max(1.0, static_cast<double>(layout.scene.size.y))};
  const PanelContext context{session, moment.snapshot, moment.settings, loop, theme, window_.fonts(), styled_scale_};

  if (is_live) {
    std::vector<KeyPress> presses = window_.take_key_presses();
    // An open menu takes Esc for itself, but not what matters most about it.
    if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup) && std::erase_if(presses, is_escape) > 0) {
      ++session.offs_asked;
    }
    act_on_keys(session, presses, ImGui::GetIO().WantTextInput);
    begin_fixed("scene", layout.scene, ImGuiWindowFlags_NoBackground);
    gestures_.take(session, panes_, scene_size_, unit, moment);
    ImGui::End();
    if (std::exchange(session.requests.fit_view, false)) {
      session.shown = view_of_everything(session, panes_, scene_size_, unit);
    }
  }
  if (part == Part::window) {
    begin_fixed("strategies", layout.top, ImGuiWindowFlags_NoScrollWithMouse);
    draw_strategy_bar(context);
    ImGui::End();
    begin_fixed("caption", layout.caption, ImGuiWindowFlags_NoScrollWithMouse);
    draw_caption(context);
    ImGui::End();
    begin_fixed("status", layout.bottom, ImGuiWindowFlags_NoScrollWithMouse);
    draw_status_bar(context);
    ImGui::End();
    if (session.plots.is_open) {
      begin_fixed("plots", layout.drawer, ImGuiWindowFlags_NoScrollWithMouse);
      draw_plots(context, history.plots());
      ImGui::End();
    }
    // The one window that may hold more than it shows. Its scrollbar lies in the margin, so that nothing becomes
    // narrower where it appears.
    const ImVec2 padding = ImGui::GetStyle().WindowPadding;
    ImGui::SetNextWindowPos(layout.column.corner);
    ImGui::SetNextWindowSize(layout.column.size);
    ImGui::SetNextWindowContentSize({layout.column.size.x - 2.0F * padding.x, 0.0F});
    ImGui::PushStyleVar(ImGuiStyleVar_ScrollbarSize, padding.x - 2.0F * styled_scale_);
    ImGui::Begin("panels", nullptr, fixed_window & ~ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar();
    ImGui::SetScrollX(0.0F);  // what lies beneath the scrollbar is empty
    draw_column(context);
    ImGui::End();
  }
  if (is_live) {
    session.is_editing = ImGui::IsAnyItemActive();
    hints_.follow(session);
  }
  // After the panels, so that a change made in this frame is seen in this frame.
  compose_scene(session, moment, history, is_live);
  painter_.paint(panes_, theme, scene_corner_, unit, window_.pixel_width(), window_.pixel_height());
  if (!is_live) return;
  draw_shader_problem(context, layout.scene.corner, layout.scene.size);
  draw_notice(context, layout.scene.corner, layout.scene.size);
  draw_dialog(context);
}

void Screen::draw_column(const PanelContext& context) {
  for (const Panel& panel : panel_catalog()) {
    if (panel.is_there != nullptr && !panel.is_there(context.loop)) continue;
    std::set<std::string, std::less<>>& folded = context.session.folded_panels;
    const bool was_folded = folded.contains(panel.title);
    ImGui::SetNextItemOpen(!was_folded);
    // What a click makes appear is laid out in the frame after.
    const bool has_news = panel.news != nullptr && panel.news(context.session);
    const float top = ImGui::GetCursorPosY();
    const bool is_open = draw_panel_head(panel, context);
    if (is_open) {
      folded.erase(std::string(panel.title));
      panel.draw(context);
      if (has_news && !ImGui::IsAnyItemActive()) {
        bring_into_sight(top, ImGui::GetCursorPosY());
        panel.news(context.session) = false;
      }
    } else if (!was_folded) {
      folded.emplace(panel.title);
    }
  }
}

void Screen::compose_scene(const Session& session, const ShownMoment& moment, const History& history, bool is_live) {
  const Handle hovered = !is_live                                     ? Handle::none
                         : points_at(session, HintTarget::motor_axis) ? Handle::motor_axis
                                                                      : gestures_.hovered();
  panes_ = compose_panes({.settings = moment.settings,
                          .snapshot = moment.snapshot,
                          .history = history,
                          .theme = *styled_appearance_.theme,
                          .options = session.options,
                          .shown = session.shown,
                          .size = scene_size_,
                          .scale = static_cast<double>(styled_scale_),
                          .measure = measure_,
                          .has_handles = session.has_handles,
                          .hovered = hovered,
                          .is_goal_hot = is_live && points_at(session, HintTarget::goal),
                          .target = session.measurement.target},
                         std::move(panes_));
}

}  // namespace ghostforce
