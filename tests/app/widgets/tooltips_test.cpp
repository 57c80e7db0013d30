// Explanations: after a moment, beside what they explain, all inside the window, and none round a drag.
#include "app/widgets/tooltips.h"

#include <imgui_internal.h>

#include "app/picture/glossary.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/screen_text.h"

namespace ghostforce::tooltips_test {
namespace {

class TooltipTest : public DrivenWindow {
 protected:
  static const ImGuiWindow* shown() {
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
      if ((window->Flags & ImGuiWindowFlags_Tooltip) != 0 && window->Active && !window->Hidden) return window;
    }
    return nullptr;
  }
  // The middle of these words in the column of panels.
  static Vector<2> on_words(std::string_view text) {
    for (const ScreenWords& words : words_on_screen()) {
      if (words.text == text) {
        const ImVec2 middle = words.ink.GetCenter();
        return {static_cast<double>(middle.x), static_cast<double>(middle.y)};
      }
    }
    ADD_FAILURE() << text << " is not on the screen";
    return {0.0, 0.0};
  }
  void rest_at(const Vector<2>& at, int count = 60) {
    point_at(at);
    frames(count, 0);
  }
};

TEST_F(TooltipTest, StandsBesideItsControlInsideTheWindowAtEveryScale) {
  for (const double scale : {0.75, 1.0, 1.5, 2.0}) {
    session().appearance.scale = scale;
    frames(4, 0);
    const Vector<2> at = on_words("Ratio ρ");
    rest_at({5.0, 5.0}, 4);
    rest_at(at);
    ASSERT_NE(shown(), nullptr) << scale;
    const ImRect place = shown()->Rect();
    EXPECT_TRUE(ImRect({0.0F, 0.0F}, ImGui::GetIO().DisplaySize).Contains(place)) << scale;
    const ImVec2 pointer = ImGui::GetMousePos();
    EXPECT_FALSE(place.Contains(pointer)) << scale;
    if (scale < 2.0) {
      EXPECT_LE(place.Max.x, ImGui::FindWindowByName("panels")->Pos.x) << "beside the panel, at scale " << scale;
    }
  }
}

TEST_F(TooltipTest, HasNoFragments) {
  rest_at(on_words("Rendering kr"));
  ASSERT_NE(shown(), nullptr);
  std::string all;
  for (const ScreenWords& words : words_on_screen()) all += words.text + "\n";
  EXPECT_NE(all.find("Unit: N/m"), std::string::npos) << all;
  EXPECT_EQ(all.find("in N/m"), std::string::npos);
}

TEST_F(TooltipTest, DoesNotComeDuringADragNorTwoSecondsAfter) {
  const Vector<2> other = on_words("Rendering kr");
  const Vector<2> from = on_words("600 N/m");
  press_at(from);
  point_at(from + Vector<2>(30.0, 0.0));
  frames(60, 0);
  EXPECT_EQ(shown(), nullptr) << "while it is held";
  button(GLFW_RELEASE);
  point_at(other);
  frames(115, 0);  // 1.9 s
  EXPECT_EQ(shown(), nullptr) << "just after";
  frames(60, 0);
  EXPECT_NE(shown(), nullptr) << "a while after";
}

TEST_F(TooltipTest, ComesBackWhereADragEndedOnceThePointerHasLeftIt) {
  const Vector<2> end = on_words("Rendering kr");
  press_at(on_words("600 N/m"));
  point_at(end);
  frames(2, 0);
  button(GLFW_RELEASE);
  frames(200, 0);
  EXPECT_EQ(shown(), nullptr) << "it has not been left";
  rest_at(end + Vector<2>(0.0, 300.0), 200);
  rest_at(end);
  EXPECT_NE(shown(), nullptr);
}

}  // namespace
}  // namespace ghostforce::tooltips_test
