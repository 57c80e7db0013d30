// What lies over the stage: dialogs as large as its letters, notices that cover none of its buttons, and the keys that
// open and close them.
#include <array>
#include <string>
#include <utility>

#include <imgui_internal.h>

#include "app/state/stage_language.h"
#include "app/widgets/focus.h"
#include "app/widgets/pointing.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/screen_text.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::over_stage_test {
namespace {

constexpr std::array dialogs{
    Dialog::help,         Dialog::doctor,    Dialog::lessons,    Dialog::open_scene,        Dialog::save_scene,
    Dialog::save_picture, Dialog::save_clip, Dialog::save_plots, Dialog::reset_preferences, Dialog::palette};

class OverStage : public DrivenWindow {
 protected:
  void open_stage(int width, int height, const std::string& language = "en") {
    ApplicationOptions options{.face = Face::stage};
    options.language = language;
    open(options, "wall45", width, height);
  }
  static const ImGuiWindow& front_window() { return *ImGui::GetCurrentContext()->NavWindow->RootWindow; }
  ImRect box_of(Dialog dialog) {
    session().dialog = dialog;
    frames(6);
    const ImRect box = front_window().Rect();
    session().dialog = Dialog::none;
    frames(2);
    return box;
  }
  static double letters() { return static_cast<double>(ImGui::GetStyle().FontScaleMain); }
};

TEST_F(OverStage, DialogsAreOnALargeScreenAsOnASmallOneButLarger) {
  for (const Dialog dialog : dialogs) {
    open_stage(1280, 720);
    const ImVec2 small = box_of(dialog).GetSize();
    const double small_letters = letters();
    open_stage(3840, 2160);
    const ImVec2 large = box_of(dialog).GetSize();
    const auto grown = static_cast<float>(letters() / small_letters);
    EXPECT_GE(grown, 3.0F);
    // Words are measured anew, and lines are broken by whole points.
    EXPECT_NEAR(large.x, grown * small.x, 0.03F * large.x) << static_cast<int>(dialog);
    EXPECT_NEAR(large.y, grown * small.y, 0.06F * large.y) << static_cast<int>(dialog);
  }
}

TEST_F(OverStage, TheWorkbenchStaysAsItIs) {
  open_stage(3840, 2160);
  EXPECT_EQ(letters(), static_cast<double>(static_cast<float>(50.0 / 15.0)));
  act(SwitchFace{});
  frames(2);
  EXPECT_EQ(letters(), 1.0);
  session().appearance.scale = 1.5;
  frames(2);
  EXPECT_EQ(letters(), 1.5);
}

TEST_F(OverStage, APictureOfManyPixelsChangesNoLetters) {
  open_stage(1280, 800);
  const double before = letters();
  const TemporaryFolder folder;
  act(SavePicture{folder / "a.png", 2, false});
  for (int i = 0; i < 3; ++i) {
    frames(1);
    EXPECT_EQ(letters(), before) << i;
  }
  EXPECT_EQ(folder.count(), 1);
}

// A bar that cannot be moved only takes room away.
TEST_F(OverStage, NoDialogHasAScrollBarWithNothingToScroll) {
  for (const Vector<2>& size : {Vector<2>(1024.0, 640.0), Vector<2>(1280.0, 800.0), Vector<2>(1920.0, 1080.0)}) {
    open_stage(static_cast<int>(size.x), static_cast<int>(size.y));
    for (const Dialog dialog : dialogs) {
      session().dialog = dialog;
      frames(6);
      for (const ImGuiWindow* const window : ImGui::GetCurrentContext()->Windows) {
        if (!window->WasActive) continue;
        constexpr float least = 3.0F;  // a person sees no less move
        EXPECT_FALSE(window->ScrollbarY && window->ScrollMax.y < least) << size.x << ' ' << window->Name;
        EXPECT_FALSE(window->ScrollbarX && window->ScrollMax.x < least) << size.x << ' ' << window->Name;
      }
      session().dialog = Dialog::none;
      frames(2);
    }
  }
}

// What its steps speak of is to be seen.
TEST_F(OverStage, TheDevicesStatusLeavesTheHandFree) {
  for (const Vector<2>& size : {Vector<2>(1024.0, 640.0), Vector<2>(1280.0, 800.0), Vector<2>(1920.0, 1080.0)}) {
    for (const Vector<2>& goal : {Vector<2>(0.014, -0.014), Vector<2>(-0.03, -0.02)}) {
      open_stage(static_cast<int>(size.x), static_cast<int>(size.y));
      session().goal = goal;
      frames(150);
      session().dialog = Dialog::doctor;
      frames(6);
      const Vector<2> hand = to_screen(screen().stage().picture().pane.camera, session().goal);
      EXPECT_FALSE(front_window().Rect().Contains(imgui_vector(hand))) << size.x << ' ' << hand.x;
    }
  }
}

TEST_F(OverStage, DialogsFitAndCanBeRead) {
  for (const auto& [width, height] : {std::pair{640, 700}, std::pair{1024, 640}, std::pair{1280, 800},
                                      std::pair{1280, 1440}, std::pair{3840, 2160}}) {
    for (const StageLanguage* const language : stage_languages) {
      open_stage(width, height, std::string(language->code));
      for (const Dialog dialog : dialogs) {
        session().dialog = dialog;
        frames(6);
        const std::string where =
            fmt::format("dialog {}, {}×{}, {}", static_cast<int>(dialog), width, height, language->code);
        const ImRect box = front_window().Rect();
        EXPECT_GE(box.Min.x, 0.0F) << where;
        EXPECT_GE(box.Min.y, 0.0F) << where;
        EXPECT_LE(box.Max.x, static_cast<float>(width)) << where;
        EXPECT_LE(box.Max.y, static_cast<float>(height)) << where;
        for (const std::string& fault : faults_of(words_on_screen())) ADD_FAILURE() << where << ": " << fault;
        session().dialog = Dialog::none;
        frames(2);
      }
    }
  }
}

TEST_F(OverStage, NoticesCoverNoButtonOfTheStage) {
  std::string words = "Something that has to be told. ";
  for (int i = 0; i < 5; ++i) words += words;
  for (const auto& [width, height] :
       {std::pair{640, 700}, std::pair{1024, 640}, std::pair{1280, 800}, std::pair{3840, 2160}}) {
    open_stage(width, height);
    for (const StageMode mode : {StageMode::none, StageMode::predict, StageMode::why, StageMode::landscape,
                                 StageMode::round, StageMode::ribbon, StageMode::measure}) {
      for (const bool has_menu : {false, true}) {
        act(SwitchFace{});
        act(SwitchFace{});
        if (mode != StageMode::none) act(ToggleMode{mode});
        if (has_menu) act(ToggleMenu{});
        session().notice = Notice{.words = words, .is_problem = true};
        frames(5);
        const ImRect box = ImGui::FindWindowByName("notice")->Rect();
        EXPECT_GT(box.GetHeight(), 60.0F);
        for (const StageButton& button : screen().stage().picture().buttons) {
          const ImRect place{imgui_vector(button.box.least), imgui_vector(button.box.most)};
          EXPECT_FALSE(box.Overlaps(place)) << button.words << " in mode " << static_cast<int>(mode) << " at " << width
                                            << "×" << height << (has_menu ? ", menu" : "");
        }
        act(CloseNotice{});
      }
    }
  }
}

// There is no next step of Why? before there is a force to explain.
TEST_F(OverStage, TheLastButtonIsTheWayBackWhereNothingComesNext) {
  open_stage(1280, 800);
  act(ToggleMode{StageMode::why});
  frames(3);
  const auto last_button = [&] { return screen().stage().picture().buttons.back().words; };
  EXPECT_EQ(last_button(), stage_language("en").buttons.next_step);
  session().goal = {-0.03, 0.03};  // in front of the wall
  frames(3);
  EXPECT_EQ(last_button(), stage_language("en").buttons.back);
}

TEST_F(OverStage, NoticesCoverNoControlOfTheWorkbench) {
  std::string words = "Something that has to be told. ";
  for (int i = 0; i < 5; ++i) words += words;
  for (const auto& [width, height] : {std::pair{1024, 640}, std::pair{1280, 800}, std::pair{3840, 2160}}) {
    open({.face = Face::workbench}, "wall45", width, height);
    for (const double scale : {0.75, 1.0, 1.5, 2.0}) {
      for (const bool has_plots : {false, true}) {
        session().appearance.scale = scale;
        session().plots.is_open = has_plots;
        session().notice = Notice{.words = words, .is_problem = true};
        frames(5);
        const ImRect box = ImGui::FindWindowByName("notice")->Rect();
        const std::string where = fmt::format("{}×{}, scale {}, plots {}", width, height, scale, has_plots);
        EXPECT_GT(box.GetHeight(), 60.0F * static_cast<float>(scale)) << where;
        for (const char* const piece : {"strategies", "panels", "status"}) {
          EXPECT_FALSE(box.Overlaps(ImGui::FindWindowByName(piece)->Rect())) << piece << ", " << where;
        }
        if (!has_plots) continue;
        // Above the plots themselves.
        ImRect buttons = ImGui::FindWindowByName("plots")->Rect();
        buttons.Max.y = buttons.Min.y + ImGui::GetFrameHeight() + ImGui::GetStyle().WindowPadding.y;
        EXPECT_FALSE(box.Overlaps(buttons)) << where;
      }
    }
  }
}

TEST_F(OverStage, EscDoesAtOnceWhatIsSaidThoughTabWasPressed) {
  open_stage(1280, 800);
  press(key::q);
  ASSERT_EQ(session().stage.mode, StageMode::predict);
  press(key::tab);
  ASSERT_TRUE(has_focus());
  const std::uint32_t offs = session().offs_asked;
  press(key::escape);
  EXPECT_EQ(session().stage.mode, StageMode::none);
  EXPECT_FALSE(has_focus());
  EXPECT_GT(session().offs_asked, offs);
}

TEST_F(OverStage, WhatOpensADialogClosesIt) {
  for (const auto& [width, height] : {std::pair{1280, 720}, std::pair{1920, 1080}, std::pair{1280, 800}}) {
    open_stage(width, height);
    for (const Dialog expected : {Dialog::lessons, Dialog::none}) {
      click_on(StageCommand::lessons);
      EXPECT_EQ(session().dialog, expected) << width << "×" << height;
      frames(3);
    }
  }
  for (const int opens : {key::f1, key::f2, key::f5}) {
    press(opens);
    frames(4);
    EXPECT_NE(session().dialog, Dialog::none) << opens;
    press(opens);
    EXPECT_EQ(session().dialog, Dialog::none) << opens;
    // With the keyboard at a card of the picker that the arrows have moved to.
    press(opens);
    frames(4);
    press(key::down);
    press(key::tab);
    press(opens);
    EXPECT_EQ(session().dialog, Dialog::none) << opens;
  }
}

TEST_F(OverStage, ToStopMotorsWhereThereAreNoneSaysSo) {
  for (const StageLanguage* const language : stage_languages) {
    open_stage(1280, 800, std::string(language->code));
    press(key::p, modifier::control);
    frames(3);
    type("motor");
    press(key::enter);
    frames(3);
    EXPECT_EQ(session().dialog, Dialog::none);
    EXPECT_EQ(notice(), language->refusals.no_motors);
    EXPECT_FALSE(is_problem());
  }
  press(key::escape);
  ASSERT_FALSE(session().notice);
  press(key::escape);
  EXPECT_FALSE(session().notice) << "Esc does it too, without a word";
}

}  // namespace
}  // namespace ghostforce::over_stage_test
