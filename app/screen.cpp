#include "app/screen.h"

#include <algorithm>
#include <cmath>

#include "app/keys.h"
#include "app/paint/label_painter.h"
#include "app/panels/controls.h"
#include "app/panels/panel_catalog.h"
#include "app/panels/style.h"

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

}  // namespace

// Bar on top, bar at the bottom, panels on the right, and the scene in what remains.
struct Screen::Layout {
  Rect top, bottom, column, scene;

  Layout(Part part, ImVec2 size, float scale) {
    if (part == Part::scene) {
      scene = {{0.0F, 0.0F}, size};
      return;
    }
    const float top_height = 46.0F * scale;
    const float bottom_height = 30.0F * scale;
    const float column_width = std::min(std::clamp(0.335F * size.x, 350.0F * scale, 470.0F * scale), 0.5F * size.x);
    const float middle_height = size.y - top_height - bottom_height;
    top = {{0.0F, 0.0F}, {size.x, top_height}};
    bottom = {{0.0F, size.y - bottom_height}, {size.x, bottom_height}};
    column = {{size.x - column_width, top_height}, {column_width, middle_height}};
    scene = {{0.0F, top_height}, {size.x - column_width, middle_height}};
  }
};

Screen::Screen(Window& window, const ScreenOptions& options)
    : window_(window), options_(options), measure_(measure_text) {}

void Screen::draw(Session& session, const Snapshot& snapshot, const History& history, const LoopReading& loop) {
  if (window_.pixel_width() <= 0 || window_.pixel_height() <= 0) return;  // minimised
  const float scale = options_.scale * window_.display_scale();
  if (scale != styled_scale_) {
    apply_style(*options_.theme, scale);
    styled_scale_ = scale;
  }
  window_.frame([&] {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const Layout layout(options_.part, size, scale);
    scene_corner_ = layout.scene.corner;
    camera_ = camera_on(session.scene.view.center, session.scene.view.width,
                        {std::max(1.0, static_cast<double>(layout.scene.size.x)),
                         std::max(1.0, static_cast<double>(layout.scene.size.y))});
    act_on_keys(session);

    begin_fixed("scene", layout.scene, ImGuiWindowFlags_NoBackground);
    take_pointer(session);
    ImGui::End();

    if (options_.part == Part::window) {
      const Fonts fonts{window_.regular_font(), window_.bold_font(), window_.number_font()};
      const PanelContext context{session, snapshot, loop, *options_.theme, fonts, scale};
      begin_fixed("strategies", layout.top, ImGuiWindowFlags_NoScrollWithMouse);
      draw_strategy_bar(context);
      ImGui::End();
      begin_fixed("status", layout.bottom, ImGuiWindowFlags_NoScrollWithMouse);
      draw_status_bar(context);
      ImGui::End();
      // The one window that may hold more than it shows.
      ImGui::SetNextWindowPos(layout.column.corner);
      ImGui::SetNextWindowSize(layout.column.size);
      ImGui::Begin("panels", nullptr, fixed_window & ~ImGuiWindowFlags_NoScrollbar);
      for (const Panel& panel : panel_catalog()) {
        ImGui::PushFont(fonts.bold, 0.0F);
        ImGui::SeparatorText(panel.title.data());
        ImGui::PopFont();
        panel.draw(context);
      }
      ImGui::End();
    }
    // After the panels, so that a change made in this frame is seen in this frame.
    draw_scene(session, snapshot, history);
  });
}

void Screen::draw_scene(Session& session, const Snapshot& snapshot, const History& history) {
  const Theme& theme = *options_.theme;
  marks_ = compose({.settings = session.settings,
                    .snapshot = snapshot,
                    .history = history,
                    .theme = theme,
                    .camera = camera_,
                    .compare = session.compare,
                    .scale = static_cast<double>(styled_scale_),
                    .measure = measure_});

  const double density = static_cast<double>(ImGui::GetIO().DisplayFramebufferScale.x);
  const auto pixels = [density](double points) { return static_cast<int>(std::lround(points * density)); };
  const int height = pixels(camera_.size.y);
  glDisable(GL_SCISSOR_TEST);
  glViewport(0, 0, window_.pixel_width(), window_.pixel_height());
  glClearColor(static_cast<float>(theme.background.red) / 255.0F, static_cast<float>(theme.background.green) / 255.0F,
               static_cast<float>(theme.background.blue) / 255.0F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  painter_.paint(
      marks_, camera_,
      {pixels(static_cast<double>(scene_corner_.x)),
       window_.pixel_height() - pixels(static_cast<double>(scene_corner_.y)) - height, pixels(camera_.size.x), height},
      density);
  paint_labels(marks_, camera_, scene_corner_, static_cast<double>(styled_scale_) * theme.thickness,
               *ImGui::GetBackgroundDrawList());
}

void Screen::take_pointer(Session& session) const {
  if (!session.pointer_moves_goal) return;
  ImGui::SetCursorPos({0.0F, 0.0F});
  ImGui::InvisibleButton("goal", {static_cast<float>(camera_.size.x), static_cast<float>(camera_.size.y)});
  session.drags_goal = ImGui::IsItemActive();
  if (!session.drags_goal) return;
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  const Vector<2> at{static_cast<double>(pointer.x - scene_corner_.x),
                     static_cast<double>(pointer.y - scene_corner_.y)};
  // A pointer dragged out of the scene leaves the goal at its edge.
  session.goal = to_world(camera_, glm::clamp(at, Vector<2>(0.0), camera_.size));
}

}  // namespace ghostforce
