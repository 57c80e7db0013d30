// The experiments in the window, driven: one panel open, its buttons found and pressed.
#pragma once

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <cmath>
#include <optional>
#include <string_view>

#include "app/state/user_measurement_guide.h"
#include "app/workbench/panel_catalog.h"
#include "tests/app/shell/driven_window.h"

namespace ghostforce {

class ExperimentsWindow : public DrivenWindow {
 protected:
  // All panels folded but one.
  static ApplicationOptions with_panel(std::string_view open_panel) {
    ApplicationOptions options;
    for (const Panel& panel : panel_catalog()) {
      if (panel.title != open_panel) options.folded_panels.emplace(panel.title);
    }
    return options;
  }
  // Where things are at 1280×800 with that panel alone open.
  static constexpr Vector<2> start_button{930.0, 199.0};
  static constexpr Vector<2> take_button{900.0, 321.0};
  static constexpr Vector<2> cancel_button{995.0, 321.0};
  static constexpr Vector<2> circle_button{930.0, 170.0};  // whether it starts or ends
  static constexpr Vector<2> clockwise_box{1027.0, 202.0};
  static constexpr float button_x = 40.0F;  // in the column
  static constexpr double radius_y = 231.0;
  static constexpr double slider_left = 1012.0;
  static constexpr double slider_right = 1254.0;
  static constexpr double slider_y = 290.0;

  // Few frames and many ticks: drawing is what takes the time.
  static constexpr int ticks = 200;

  void click(const Vector<2>& at) {
    press_at(at);
    release();
  }
  UserMeasurement& measurement() { return session().measurement; }
  // The heights between which the first button of a row can be clicked in the column of panels; empty: nowhere.
  std::optional<ImVec2> clickable(const char* button) {
    ImGuiWindow& column = *ImGui::FindWindowByName("panels");
    const ImGuiID wanted = column.GetID(button);
    const auto is_there = [&](float y) {
      point_at(static_cast<double>(column.Pos.x + button_x), static_cast<double>(y));
      frames(1, 0);
      return ImGui::GetCurrentContext()->HoveredId == wanted;
    };
    const float end = column.Pos.y + column.Size.y;
    float y = column.Pos.y;
    while (y < end && !is_there(y)) y += 10.0F;
    if (y >= end) return std::nullopt;
    ImVec2 range{y, y};
    while (is_there(range.x - 1.0F)) range.x -= 1.0F;
    while (is_there(range.y + 1.0F)) range.y += 1.0F;
    return range;
  }
  void click_button(const char* button) {
    const std::optional<ImVec2> found = clickable(button);
    ASSERT_TRUE(found) << button;
    click({static_cast<double>(ImGui::FindWindowByName("panels")->Pos.x + button_x),
           static_cast<double>(0.5F * (found->x + found->y))});
  }
  void expect_all_of_it_in_sight(const char* button) {
    const std::optional<ImVec2> found = clickable(button);
    ASSERT_TRUE(found) << button;
    EXPECT_GE(found->y - found->x, ImGui::GetFrameHeight() - 2.0F) << button;
  }
  // With the ratio that is right for the hand, known to the test.
  void take_readings(std::size_t count) {
    const Stiffnesses& k = session().settings.stiffnesses;
    for (std::size_t i = 0; i < count; ++i) {
      session().settings.stiffnesses.chosen_tracking_ratio = optimal_tracking_ratio(k.k_r, k.k_u);
      frames(5, ticks);
      take_reading(session());
    }
  }
  // As a person does: drags the slider of ρ, this way and that, until the drift is gone.
  void null_the_drift() {
    double low = slider_left;
    double high = slider_right;
    press_at({0.5 * (low + high), slider_y});
    while (high - low > 1.0) {
      const double middle = std::floor(0.5 * (low + high));
      point_at(middle, slider_y);
      frames(2, ticks);
      ASSERT_TRUE(measurement().drift);
      (*measurement().drift > 0.0 ? low : high) = middle;
    }
    // Of the two nearest points, the better one.
    const double at_high = std::abs(measurement().drift.value_or(1.0));
    point_at(low, slider_y);
    frames(2, ticks);
    if (std::abs(measurement().drift.value_or(1.0)) > at_high) point_at(high, slider_y);
    frames(2, ticks);
    release();
    frames(2, ticks);
  }
};

}  // namespace ghostforce
