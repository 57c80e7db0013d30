// The language in the window: chosen in the View panel or where lessons are chosen, it changes the stage, a lesson and what
// is spoken at once.
#include <optional>
#include <string>

#include <fmt/format.h>

#include "app/cli/reading_aloud.h"
#include "app/state/lesson_file.h"
#include "app/state/lesson_guide.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/fake_speech_tool.h"
#include "tests/support/screen_text.h"

namespace ghostforce::language_window_test {
namespace {

class LanguageWindow : public DrivenWindow {
 protected:
  static std::optional<ScreenWords> words_beginning(std::string_view text) {
    for (const ScreenWords& words : words_on_screen()) {
      if (words.text.starts_with(text)) return words;
    }
    return std::nullopt;
  }
  void click_on(std::string_view text) {
    const auto words = words_beginning(text);
    ASSERT_TRUE(words) << text << " is not on the screen";
    const ImVec2 middle = words->ink.GetCenter();
    click_at(static_cast<double>(middle.x), static_cast<double>(middle.y));
    frames(2);
  }
  // All of the scene's words, in the order in which they are drawn.
  std::string words_of_stage() const {
    std::string all;
    for (const Mark& mark : screen().panes().front().marks) {
      if (const auto* const label = std::get_if<Label>(&mark.form)) all += label->text + " ";
    }
    return all;
  }
  bool stage_says(std::string_view words) const { return words_of_stage().find(words) != std::string::npos; }
  void choose_in_view_panel(std::string_view name) {
    if (session().face == Face::stage) press(key::f4);
    session().folded_panels.clear();
    frames(3);
    ImGuiWindow& column = *ImGui::FindWindowByName("panels");
    for (float y = 0.0F; y <= column.ScrollMax.y + column.InnerRect.GetHeight() && !words_beginning(name);
         y += 0.5F * column.InnerRect.GetHeight()) {
      ImGui::SetScrollY(&column, y);
      frames(3);
    }
    click_on(name);
    press(key::f4);
    frames(30);
  }
};

TEST_F(LanguageWindow, TheViewPanelChangesTheStage) {
  open({.face = Face::stage});
  frames(30);
  const std::string english = words_of_stage();
  EXPECT_NE(english.find("your hand pulls here"), std::string::npos) << english;
  choose_in_view_panel("Español");
  EXPECT_EQ(session().language, "es");
  EXPECT_TRUE(stage_says("tu mano tira aquí")) << words_of_stage();
  EXPECT_TRUE(stage_says("fantasma")) << words_of_stage();
  EXPECT_FALSE(stage_says("ghost")) << words_of_stage();
  EXPECT_TRUE(application_->stage_reading().sentence.starts_with("Una fuerza fantasma"));
  press(key::space);
  EXPECT_EQ(application_->stage_reading().sentence, spanish_stage.warnings.paused);
  press(key::space);
  choose_in_view_panel("English");
  EXPECT_EQ(session().language, "en");
  EXPECT_EQ(words_of_stage(), english);
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
  ASSERT_TRUE(stage_says(first_words("en"))) << words_of_stage();
  press(key::digit_1);
  frames(80);
  press(key::page_up);
  const LessonStepState answered = lesson_step_state(*session().lesson);
  EXPECT_NE(answered.outcome, LessonOutcome::open);
  press(key::f5);
  frames(3);
  EXPECT_TRUE(words_beginning("Lessons"));
  click_on("Español");
  EXPECT_TRUE(words_beginning("Lecciones"));
  EXPECT_TRUE(words_beginning("Olvidar mi progreso")) << "the dialog speaks it too";
  press(key::escape);
  frames(3);
  ASSERT_TRUE(session().lesson);
  EXPECT_EQ(lesson_step_state(*session().lesson), answered);
  EXPECT_FALSE(stage_says("Next"));
  EXPECT_TRUE(stage_says("Siguiente")) << words_of_stage();
  EXPECT_TRUE(stage_says(words_in(lesson, "es").title)) << words_of_stage();
  press(key::page_down);
  frames(80);
  EXPECT_TRUE(stage_says(words_in(lesson, "es").steps[1].text.substr(0, 12))) << words_of_stage();
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
