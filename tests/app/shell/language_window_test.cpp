// The language in the window: chosen in the View panel or where lessons are chosen, it changes the stage, a lesson and what
// is spoken at once.
#include <string>

#include <fmt/format.h>

#include "app/cli/reading_aloud.h"
#include "app/state/lesson_file.h"
#include "app/state/lesson_guide.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/fake_speech_tool.h"

namespace ghostforce::language_window_test {
namespace {

class LanguageWindow : public DrivenWindow {
 protected:
  void choose_in_view_panel(std::string_view name) {
    if (session().face == Face::stage) press(key::f4);
    session().folded_panels.clear();
    frames(3);
    ImGuiWindow& column = *ImGui::FindWindowByName("panels");
    for (float y = 0.0F; y <= column.ScrollMax.y + column.InnerRect.GetHeight() && !place_of(name);
         y += 0.5F * column.InnerRect.GetHeight()) {
      ImGui::SetScrollY(&column, y);
      frames(3);
    }
    click_on_words(name);
    press(key::f4);
    frames(30);
  }
};

TEST_F(LanguageWindow, TheViewPanelChangesTheStage) {
  open({.face = Face::stage});
  frames(30);
  const std::string english = words_of_scene();
  EXPECT_NE(english.find("your hand pulls here"), std::string::npos) << english;
  choose_in_view_panel("Español");
  EXPECT_EQ(session().language, "es");
  EXPECT_TRUE(scene_says("tu mano tira aquí")) << words_of_scene();
  EXPECT_TRUE(scene_says("fantasma")) << words_of_scene();
  EXPECT_FALSE(scene_says("ghost")) << words_of_scene();
  EXPECT_TRUE(application_->stage_reading().sentence.starts_with("Una fuerza fantasma"));
  press(key::space);
  EXPECT_EQ(application_->stage_reading().sentence, spanish_stage.warnings.paused);
  press(key::space);
  choose_in_view_panel("English");
  EXPECT_EQ(session().language, "en");
  EXPECT_EQ(words_of_scene(), english);
}

// Also with answers given: they stay.
TEST_F(LanguageWindow, ALessonGoesOnInTheOtherLanguage) {
  ApplicationOptions options{.face = Face::stage};
  options.lesson = shipped_lessons()[2];
  open(options);
  frames(60);
  const Lesson& lesson = *shipped_lessons()[2];
  const auto first_words = [&](std::string_view language) {
    return words_in(lesson, language).steps.front().text.substr(0, 12);
  };
  ASSERT_TRUE(scene_says(first_words("en"))) << words_of_scene();
  press(key::digit_1);
  frames(80);
  press(key::page_up);
  const LessonStepState answered = lesson_step_state(*session().lesson);
  EXPECT_NE(answered.outcome, LessonOutcome::open);
  press(key::f5);
  frames(3);
  EXPECT_TRUE(place_of("Lessons"));
  click_on_words("Español");
  EXPECT_TRUE(place_of("Lecciones"));
  EXPECT_TRUE(place_of("Olvidar mi progreso")) << "the dialog speaks it too";
  press(key::escape);
  frames(3);
  ASSERT_TRUE(session().lesson);
  EXPECT_EQ(lesson_step_state(*session().lesson), answered);
  EXPECT_FALSE(scene_says("Next"));
  EXPECT_TRUE(scene_says("Siguiente")) << words_of_scene();
  EXPECT_TRUE(scene_says(words_in(lesson, "es").title)) << words_of_scene();
  press(key::page_down);
  frames(80);
  EXPECT_TRUE(scene_says(words_in(lesson, "es").steps[1].text.substr(0, 12))) << words_of_scene();
}

TEST_F(LanguageWindow, ThePickersWordsHaveRoom) {
  for (const StageLanguage* const language : stage_languages) {
    for (const auto& [width, height] : {std::pair{1024, 640}, std::pair{1280, 720}}) {
      ApplicationOptions options{.face = Face::stage};
      options.language = language->code;
      open(options, "wall45", width, height);
      for (const bool asks : {false, true}) {
        session().dialog = Dialog::lessons;
        frames(2);
        session().form.asks_for_reset = asks;
        frames(3);
        for (const std::string& fault : faults_of(words_on_screen())) {
          ADD_FAILURE() << language->code << " " << width << ": " << fault;
        }
      }
    }
  }
}

TEST_F(LanguageWindow, TheVoiceIsThatOfTheWords) {
  const FakeSpeechTool tool;
  ApplicationOptions options{.face = Face::stage};
  options.language = "es";
  open(options);
  ReadingAloud aloud({}, -1);
  // The tool writes down its call when it comes to it.
  const auto hears = [&](const std::string& call) {
    while (tool.calls().empty() || !tool.calls().back().ends_with(call)) {
      frames(1);
      aloud.follow(*application_, frame_s);
      ASSERT_EQ(session().speech_problem, "");
    }
  };
  session().speaks = true;
  hears(fmt::format("--language es -- {}", spanish_stage.sentences.naive_ghost));
  session().language = "en";
  hears(fmt::format("--language en -- {}", english_stage.sentences.naive_ghost));
}

}  // namespace
}  // namespace ghostforce::language_window_test
