// Lessons read from files: what is right comes into its place, and each mistake is told with its place.
#include "app/state/lesson_file.h"

#include <gtest/gtest.h>

#include "app/files/scene_file.h"
#include "app/files/scene_keys.h"
#include "tests/app/state/lesson_text.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::lesson_file_test {
namespace {

// All that is wrong with it; empty: nothing.
std::string words_about(std::string_view text) {
  try {
    read_lesson(text, "ghost.toml");
  } catch (const ReadError& error) {
    EXPECT_EQ(error.kind(), ReadError::Kind::wrong);
    return error.what();
  }
  return "";
}

TEST(LessonFile, PutsEachValueInItsPlace) {
  const Lesson lesson = read_lesson(small_lesson, "folder/ghost.toml");
  EXPECT_EQ(lesson.name, "ghost");
  EXPECT_EQ(lesson.number, 3.5);
  EXPECT_EQ(lesson.secrets, std::set{LessonSecret::slide});
  ASSERT_EQ(lesson.steps.size(), 4U);

  const LessonStep& press = lesson.steps[0];
  EXPECT_EQ(press.name, "press");
  ASSERT_NE(press.set_up, nullptr);
  EXPECT_EQ(press.set_up->goal, Vector<2>(-0.01, 0.01));
  EXPECT_EQ(press.set_up->scene.settings.active, StrategyId::naive);
  EXPECT_EQ(press.controls, (std::set{LessonControl::hand, LessonControl::strategies}));
  ASSERT_TRUE(press.slider);
  EXPECT_EQ(press.slider->key, find_scene_key("user.believed_k_u_N_per_m"));
  EXPECT_EQ(press.slider->least, 50.0);
  EXPECT_EQ(press.slider->greatest, 800.0);
  EXPECT_EQ(press.secrets, (std::set{LessonSecret::numbers, LessonSecret::rest}));
  EXPECT_EQ(press.question, LessonQuestion::choose);
  EXPECT_EQ(press.right_answer, 1U);
  ASSERT_NE(press.reveal, nullptr);
  EXPECT_EQ(press.reveal->goal, Vector<2>(0.01, -0.014));

  const LessonStep& cure = lesson.steps[1];
  EXPECT_EQ(cure.set_up, nullptr);
  EXPECT_EQ(cure.question, LessonQuestion::task);
  ASSERT_EQ(cure.conditions.size(), 2U);
  EXPECT_EQ(cure.conditions[0].quantity, LessonQuantity::ghost_force);
  EXPECT_EQ(cure.conditions[0].greatest, 0.05);
  EXPECT_EQ(cure.conditions[1].quantity, LessonQuantity::depth);
  EXPECT_EQ(cure.conditions[1].least, 5.0);
  EXPECT_EQ(cure.with, StrategyId::naive);
  EXPECT_EQ(lesson.steps[2].question, LessonQuestion::guess);
  EXPECT_EQ(lesson.steps[2].within, 0.004);
  EXPECT_EQ(lesson.steps[3].question, LessonQuestion::none);

  EXPECT_EQ(lesson.words.size(), 2U);
  const LessonWords& spanish = words_in(lesson, "es");
  EXPECT_EQ(spanish.title, "El fantasma");
  EXPECT_EQ(spanish.about, "Lo que hace un motor que falta.");
  EXPECT_EQ(spanish.steps[0].answers, (std::vector<std::string>{"Se queda", "Se desliza"}));
  EXPECT_EQ(spanish.steps[0].right, "Sí.");
  EXPECT_EQ(spanish.steps[1].wrong, "Así.");
  EXPECT_EQ(words_in(lesson, "de").title, "The ghost") << "English where the language is missing";
}

TEST(LessonFile, IsReadInTheLanguageThatItHas) {
  std::string text(small_lesson);
  text.erase(text.find("[en]"), text.find("[es]") - text.find("[en]"));
  ASSERT_EQ(words_about(text), "");
  EXPECT_EQ(words_in(read_lesson(text, "a.toml"), "en").title, "El fantasma");
}

struct Mistake {
  std::string_view in_place_of;
  std::string_view written;
  std::string_view told;  // all of it
};

class LessonMistake : public testing::TestWithParam<Mistake> {};

TEST_P(LessonMistake, IsToldWithItsPlace) {
  EXPECT_EQ(words_about(lesson_with(GetParam().in_place_of, GetParam().written)), GetParam().told);
}

INSTANTIATE_TEST_SUITE_P(
    InTheSteps, LessonMistake,
    testing::Values(
        Mistake{"format = 1", "format = 2",
                "ghost.toml:1:10: the key format: is 2, but this program only knows format 1; a newer version may read "
                "it"},
        Mistake{"number = 3.5\n", "",
                "ghost.toml:1:1: the key number is missing; give the lesson's place among others, as in number = 3"},
        Mistake{
            "number = 3.5\n", "number = 3.5\npicture = \"pres\"\n",
            "ghost.toml:3:11: the key picture: 'pres' is not one of press, cure, guess, end; did you mean 'press'?"},
        Mistake{"controls = [\"hand\", ", "contorls = [\"hand\", ",
                "ghost.toml:7:1: the key step.contorls is unknown; did you mean 'controls'?"},
        Mistake{
            "\"hand\", \"strategies\"", "\"hand\", \"strategie\"",
            "ghost.toml:7:21: the key step.controls: 'strategie' is not one of hand, strategies, wall, motor; did you "
            "mean 'strategies'?"},
        Mistake{"\"hand\", \"strategies\"", "\"hand\", \"hand\"",
                "ghost.toml:7:21: the key step.controls: is there twice; give each word once"},
        Mistake{"controls = [\"hand\", \"strategies\"]", "controls = \"hand\"",
                "ghost.toml:7:12: the key step.controls: is a string; give an array of words, as in [\"hand\"]"},
        Mistake{
            "run wall45 --goal-mm=-10,10 --strategy naive", "run wall45 --goal-mm=-10,10 --strategy naiv",
            "ghost.toml:6:12: the key step.set_up: --strategy: 'naiv' is not one of full, naive, anisotropic; did you "
            "mean 'naive'?"},
        Mistake{"--goal-mm=-10,10 --strategy naive", "--view workbench",
                "ghost.toml:6:12: the key step.set_up: shows the workbench; lessons are shown on the stage: leave out "
                "--view workbench"},
        Mistake{
            "set_up   = \"ghostforce run wall45 --goal-mm=-10,10 --strategy naive\"\n", "",
            "ghost.toml:4:1: the key step: the first step has no set_up; arrange the stage, press Ctrl+C, and paste "
            "the line as its set_up"},
        Mistake{
            "user.believed_k_u_N_per_m", "user.belived_k_u_N_per_m",
            "ghost.toml:8:20: the key step.slider.key: 'user.belived_k_u_N_per_m' is no key of a scene; did you mean "
            "'user.believed_k_u_N_per_m'?"},
        Mistake{
            "user.believed_k_u_N_per_m", "goal.duration_s",
            "ghost.toml:8:20: the key step.slider.key: 'goal.duration_s' is no number that can be changed while the "
            "scene runs; give one such as user.believed_k_u_N_per_m"},
        Mistake{"from = 50, to = 800", "from = 800, to = 50",
                "ghost.toml:8:12: the key step.slider: goes from 800 to 50; let it go from less to more"},
        Mistake{"from = 50, to = 800", "from = 50, to = 1e9",
                "ghost.toml:8:65: the key step.slider.to: 1000000000 is out of range; give 0.1 to 1000000 N/m"},
        Mistake{"user.believed_k_u_N_per_m\", from = 50, to = 800", "wall.normal_deg\", from = -1e300, to = 361",
                "ghost.toml:8:46: the key step.slider.from: -1e+300 is out of range; give -360 to 360 degrees\n"
                "ghost.toml:8:59: the key step.slider.to: 361 is out of range; give -360 to 360 degrees"},
        Mistake{"question = \"choose\"", "question = \"chose\"",
                "ghost.toml:10:12: the key step.question: 'chose' is not one of choose, guess, task; did you mean "
                "'choose'?"},
        Mistake{"right    = 2\n", "right    = 3\n",
                "ghost.toml:11:12: the key step.right: 3 is out of range; the step has 2 answers: give 1 to 2"},
        Mistake{"right    = 2\n", "right    = 0\n",
                "ghost.toml:11:12: the key step.right: 0 is out of range; give a whole number, 1 to 3"},
        Mistake{
            "right    = 2\n", "",
            "ghost.toml:4:1: the key step: the question \"choose\" needs the key right; give the number of the right "
            "answer, from 1"},
        Mistake{
            "right    = 2\n", "right    = 2\nwithin_mm = 2\n",
            "ghost.toml:12:13: the key step.within_mm: belongs to question = \"guess\"; leave it out, or change the "
            "question"},
        Mistake{"name     = \"cure\"", "name     = \"press\"",
                "ghost.toml:15:12: the key step.name: 'press' is the name of an earlier step; give each step a name of "
                "its own\n"
                "ghost.toml:39:5: the key en.cure is unknown; the keys here are title, about, press, guess, end\n"
                "ghost.toml:56:1: the key es.cure is unknown; the keys here are title, about, press, guess, end"},
        Mistake{
            "name     = \"cure\"", "name     = \"The cure\"",
            "ghost.toml:15:12: the key step.name: 'The cure' is no name for a step; give 1 to 40 of a to z, 0 to 9, - "
            "and _\n"
            "ghost.toml:39:5: the key en.cure is unknown; the keys here are title, about, press, guess, end\n"
            "ghost.toml:56:1: the key es.cure is unknown; the keys here are title, about, press, guess, end"},
        Mistake{"controls = [\"hand\"]\nquestion", "question",
                "ghost.toml:14:1: the key step: there is a task, but nothing to do it with; give controls or a slider"},
        Mistake{"ghost_force_N", "ghost_force",
                "ghost.toml:18:26: the key step.until.quantity: 'ghost_force' is not one of depth_mm, force_N, "
                "ghost_force_N, slide_mm, handle_to_target_mm, angle_deg, energy_mJ, turns, belief, hand_N_per_m, "
                "effort, slack_strings, active_walls; did "
                "you mean "
                "'ghost_force_N'?"},
        Mistake{"at_most = 0.05", "at_most = 0.05, at_least = 1",
                "ghost.toml:18:13: the key step.until: wants at least 1 and at most 0.05; no number is both"},
        Mistake{"{ quantity = \"depth_mm\", at_least = 5 }", "{ quantity = \"depth_mm\" }",
                "ghost.toml:18:61: the key step.until: has neither at_least nor at_most; give one of them, or both"},
        Mistake{"with     = \"naive\"", "with     = \"full \"",
                "ghost.toml:19:12: the key step.with: 'full ' is not one of full, naive, anisotropic; did you mean "
                "'full'?"},
        Mistake{"within_mm = 4.0", "within_mm = 0",
                "ghost.toml:24:13: the key step.within_mm: 0 is out of range; give 0.1 to 100 mm"},
        Mistake{
            "name = \"end\"", "name = \"end\"\nhidden = [\"numbers\"]",
            "ghost.toml:28:10: the key step.hidden: belongs to a question, and this step has none; leave it out, or "
            "change the question"}));

INSTANTIATE_TEST_SUITE_P(
    InTheWords, LessonMistake,
    testing::Values(
        Mistake{"[en.end]\ntext = \"The end.\"\n", "",
                "ghost.toml:29:1: the key en.end is missing; add it as a table with the step's text: each step needs "
                "words in each language"},
        Mistake{"[en.end]", "[en.edn]",
                "ghost.toml:29:1: the key en.end is missing; add it as a table with the step's text: each step needs "
                "words in each language\n"
                "ghost.toml:49:5: the key en.edn is unknown; did you mean 'end'?"},
        Mistake{"title = \"The ghost\"\n", "",
                "ghost.toml:29:1: the key en.title is missing; give the lesson's title in this language"},
        Mistake{"[\"Se queda\", \"Se desliza\"]", "[\"Se queda\", \"Se desliza\", \"Sube\"]",
                "ghost.toml:55:43: the key es.press.answers: has 3 of them, but [en] has 2; translate each answer of "
                "[en.press]"},
        Mistake{"[\"It stays\", \"It slides\"]", "[\"It stays\"]",
                "ghost.toml:35:11: the key en.press.answers: has 1 of them; give 2 or 3"},
        Mistake{"[\"It stays\", ", "[4, ",
                "ghost.toml:35:12: the key en.press.answers: is a number; give a string in quotes"},
        Mistake{"\"Cure it.\"", "\"\"",
                "ghost.toml:40:9: the key en.cure.text: is empty; write it: the person reads it on the stage"},
        Mistake{"wrong = \"Like this.\"\n", "",
                "ghost.toml:39:1: the key en.cure.wrong is missing; say what the person learns from another answer, or "
                "from none"},
        Mistake{
            "text = \"The end.\"", "text = \"The end.\"\nright = \"Yes.\"",
            "ghost.toml:51:9: the key en.end.right: belongs to a question, and this step has none; leave it out, or "
            "add a question to the step"},
        Mistake{
            "[es]", "[spanish]",
            "ghost.toml:52:1: the key spanish: is no language; the words of a language stand in a table such as [en] "
            "or [es]"},
        Mistake{"The end.", "The\\nend.",
                "ghost.toml:50:8: the key en.end.text: has more than one line; write it in one: the stage breaks it "
                "where it has to"}));

TEST(LessonFile, TellsWhatIsTooLongInCharacters) {
  const auto text_of = [](std::size_t length) {
    std::string text;
    for (std::size_t i = 0; i < length; ++i) text += "ñ";
    return text;
  };
  EXPECT_EQ(words_about(lesson_with("Cúralo.", text_of(160))), "");
  EXPECT_NE(words_about(lesson_with("Cúralo.", text_of(161)))
                .find("es.cure.text: is 161 characters long; give 160 at most, so that it fits on the stage"),
            std::string::npos);
  EXPECT_EQ(words_about(lesson_with("Se queda", text_of(32))), "");
  EXPECT_NE(words_about(lesson_with("Se queda", text_of(33))).find("is 33 characters long; give 32 at most"),
            std::string::npos);
  EXPECT_NE(words_about(lesson_with("El fantasma", text_of(41))).find("is 41 characters long; give 40 at most"),
            std::string::npos);
}

TEST(LessonFile, TellsWhatAnEmptyLessonLacks) {
  EXPECT_EQ(words_about("format = 1\nnumber = 1\n"),
            "ghost.toml:1:1: the lesson has no steps; begin each step with [[step]]\n"
            "ghost.toml:1:1: the lesson has no words; add a table for a language, such as [en]");
  EXPECT_EQ(words_about("format = 1\nnumber = 1\nstep = []\n[en]\ntitle = \"a\"\nabout = \"b\"\n"),
            "ghost.toml:3:8: the key step: is empty; begin each step with [[step]]");
  EXPECT_NE(words_about("").find("the key format is missing"), std::string::npos);
}

TEST(LessonFile, KnowsASceneWhenItSeesOne) {
  EXPECT_EQ(words_about(scene_text(load_scene("wall45"))),
            "ghost.toml:1:1: this is a scene, not a lesson; ghostforce equilibrium tells whether it is right, and "
            "ghostforce run opens it");
}

TEST(LessonFile, IsFoundByNameOrByPath) {
  EXPECT_EQ(load_lesson("ghost").name, "ghost");
  const TemporaryFolder folder;
  write_whole(folder / "mine.toml", small_lesson);
  EXPECT_EQ(load_lesson(folder / "mine.toml").name, "mine");
  EXPECT_EQ(load_lesson("ghost").file, "");
  EXPECT_EQ(load_lesson(folder / "mine.toml").file, folder / "mine.toml");
  try {
    load_lesson("gost");
    FAIL();
  } catch (const ReadError& error) {
    EXPECT_STREQ(error.what(), "no lesson named 'gost'; did you mean 'ghost'?");
  }
}

}  // namespace
}  // namespace ghostforce::lesson_file_test
