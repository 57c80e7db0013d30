// Ctrl+P in the window: typed, moved through, clicked and closed, on both faces.
#include <array>
#include <string>

#include "app/state/palette_catalog.h"
#include "tests/app/shell/driven_window.h"

namespace ghostforce::palette_window_test {
namespace {

class PaletteWindow : public DrivenWindow {
 protected:
  void open_palette() {
    press(key::p, modifier::control);
    frames(3);
    ASSERT_EQ(session().dialog, Dialog::palette);
  }
  void look_for(const std::string& words) {
    open_palette();
    type(words);
    frames(2);
  }
};

TEST_F(PaletteWindow, DoesWhatIsTypedOnBothFaces) {
  for (const Face face : {Face::stage, Face::workbench}) {
    open({.face = face});
    look_for("landscape");
    press(key::enter);
    EXPECT_EQ(session().dialog, Dialog::none);
    EXPECT_EQ(session().stage.mode, StageMode::landscape);
    EXPECT_EQ(session().face, Face::stage);
  }
}

TEST_F(PaletteWindow, SpeaksTheStagesLanguage) {
  ApplicationOptions options{.face = Face::workbench};
  options.language = "es";
  open(options);
  look_for("oscuro");
  EXPECT_TRUE(says("Todas las acciones"));
  press(key::enter);
  frames(2);
  EXPECT_TRUE(session().appearance.theme->dark);
}

TEST_F(PaletteWindow, MayOpenAnotherDialog) {
  look_for("help");
  press(key::enter);
  frames(3);
  EXPECT_EQ(session().dialog, Dialog::help);
  look_for("save picture");
  press(key::enter);
  frames(3);
  EXPECT_EQ(session().dialog, Dialog::save_picture);
  EXPECT_NE(session().form.path, "") << "with fields of its own";
}

TEST_F(PaletteWindow, DoesNotDoWhatIsDimmedAndSaysWhy) {
  look_for("arm the motors");
  const std::uint32_t arms = session().arms_asked;
  EXPECT_TRUE(says("has motors")) << "the reason";
  press(key::enter);
  frames(3);
  EXPECT_EQ(session().dialog, Dialog::palette);
  EXPECT_EQ(session().arms_asked, arms);
  const std::uint32_t offs = session().offs_asked;
  press(key::escape);
  EXPECT_EQ(session().dialog, Dialog::none);
  EXPECT_GT(session().offs_asked, offs) << "Esc turns motors off here too";
}

TEST_F(PaletteWindow, TheKeyThatOpensItClosesIt) {
  look_for("qwerty");
  EXPECT_TRUE(says("Nothing is called that"));
  press(key::enter);
  EXPECT_EQ(session().dialog, Dialog::palette);
  press(key::p, modifier::control);
  EXPECT_EQ(session().dialog, Dialog::none);
  open_palette();
  EXPECT_EQ(session().form.sought, "");
}

TEST_F(PaletteWindow, ArrowsAndPagesMoveTheMark) {
  open_palette();
  const Vector<2> goal = session().goal;
  press(key::down);
  press(key::down);
  press(key::up);
  EXPECT_EQ(session().form.marked_action, 1U);
  press(key::up);
  press(key::up);
  EXPECT_EQ(session().form.marked_action, 0U) << "no step leads beyond the ends";
  press(key::page_down);
  frames(2);
  const std::size_t page = session().form.marked_action;
  EXPECT_GT(page, 5U);
  press(key::page_up);
  frames(2);
  EXPECT_LE(session().form.marked_action, page);
  EXPECT_EQ(session().goal, goal) << "the arrows are the palette's";
  for (int i = 0; i < 40; ++i) press(key::down);
  const std::size_t mark = session().form.marked_action;
  EXPECT_GT(mark, 40U);
  frames(3);
  EXPECT_EQ(session().form.marked_action, mark) << "it is in sight";
  press(key::escape);
  open_palette();
  frames(2);
  EXPECT_EQ(session().form.marked_action, 0U) << "it begins anew at the top";
  type("s");
  EXPECT_EQ(session().form.marked_action, 0U);
}

TEST_F(PaletteWindow, AClickDoesItAndTheFieldKeepsTheKeyboard) {
  const auto click_first = [&] {
    const ImGuiWindow& dialog = *ImGui::FindWindowByName("###palette");
    const ImVec2 list = dialog.DC.ChildWindows.front()->Rect().Min;
    click_at(static_cast<double>(list.x) + 60.0, static_cast<double>(list.y) + 8.0);
    frames(3);
  };
  look_for("arm the motors");
  click_first();
  ASSERT_EQ(session().dialog, Dialog::palette) << "it is dimmed";
  type("trails");
  frames(3);
  EXPECT_NE(session().form.sought.find("trails"), std::string::npos) << session().form.sought;
  press(key::escape);
  look_for("trails");
  click_first();
  EXPECT_EQ(session().dialog, Dialog::none);
  EXPECT_FALSE(session().options.trails);
}

TEST_F(PaletteWindow, ItsWordsHaveRoom) {
  for (const StageLanguage* const language : stage_languages) {
    for (const auto& [width, height] : {std::array{800, 600}, std::array{1280, 800}}) {
      ApplicationOptions options{.face = Face::stage};
      options.language = language->code;
      open(options, "wall45", width, height);
      open_palette();
      for (int i = 0; i < 6; ++i) {
        press(key::page_down);
        frames(2);
        for (const std::string& fault : faults_of(words_on_screen())) {
          ADD_FAILURE() << language->code << " " << width << ": " << fault;
        }
      }
    }
  }
}

}  // namespace
}  // namespace ghostforce::palette_window_test
