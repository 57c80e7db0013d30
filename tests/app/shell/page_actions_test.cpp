// What a page around this one can have done here.
#include "app/shell/page_actions.h"

#include "app/base/quoted.h"
#include "app/state/lesson_guide.h"
#include "app/state/stage_language.h"
#include "tests/app/shell/driven_window.h"

namespace ghostforce::page_actions_test {
namespace {

class PageActions : public DrivenWindow {
 protected:
  PageActions() { open({.face = Face::stage}); }

  std::string act_by(std::string_view name) {
    std::string why = act_by_name(*application_, name);
    frames(2);
    return why;
  }
};

TEST_F(PageActions, AreDoneByName) {
  EXPECT_EQ(act_by("anisotropic"), "");
  EXPECT_EQ(session().settings.active, StrategyId::anisotropic);
  EXPECT_EQ(act_by("why"), "");
  EXPECT_EQ(session().stage.mode, StageMode::why);
  EXPECT_EQ(act_by("workbench"), "");
  EXPECT_EQ(session().face, Face::workbench);
  EXPECT_EQ(act_by("anistropic"), std::string("'anistropic' is not one of ") + listed(names_of(page_actions())) +
                                      "; did you mean 'anisotropic'?");
}

TEST_F(PageActions, SayWhyTheyCannotBeDone) {
  EXPECT_EQ(begin_lesson_by_name(*application_, "gost").substr(0, 24), "'gost' is not one of fee");
  EXPECT_FALSE(session().lesson);
  EXPECT_EQ(begin_lesson_by_name(*application_, "ghost"), "");
  frames(2);
  ASSERT_TRUE(session().lesson);
  EXPECT_EQ(act_by("workbench"), english_stage.refusals.left_to_lesson);
  EXPECT_EQ(session().face, Face::stage);
  EXPECT_EQ(act_by("answer-1"), "");
  EXPECT_NE(lesson_step_state(*session().lesson).outcome, LessonOutcome::open);
  EXPECT_EQ(act_by("leave-lesson"), "");
  EXPECT_FALSE(session().lesson);
  EXPECT_EQ(act_by("leave-lesson"), english_stage.refusals.is_not_on);
}

// As the palette does, of what would have no effect.
TEST_F(PageActions, SayThatThereIsNothingToUndo) {
  EXPECT_EQ(act_by("undo"), english_stage.refusals.nothing_to_undo);
  EXPECT_EQ(act_by("full"), "");
  EXPECT_EQ(act_by("redo"), english_stage.refusals.nothing_to_redo);
  EXPECT_EQ(act_by("undo"), "");
  EXPECT_EQ(session().settings.active, StrategyId::naive);
}

TEST_F(PageActions, ASetUpIsShownOrRefused) {
  EXPECT_EQ(show_line(*application_, "wall45 --strategy full --goal-mm=5,-5"), "");
  frames(2);
  EXPECT_EQ(session().settings.active, StrategyId::full);
  EXPECT_NEAR(session().goal.x, 0.005, 1e-9);
  EXPECT_NE(show_line(*application_, "wall45 --stratgy full").find("--strategy"), std::string::npos);
}

TEST_F(PageActions, EachHasANameOfItsOwnAndAMeaning) {
  for (const PageAction& action : page_actions()) {
    EXPECT_EQ(std::ranges::count(page_actions(), action.name, &PageAction::name), 1) << action.name;
    open({.face = Face::stage});
    EXPECT_EQ(act_by(action.name).find("is not one of"), std::string::npos) << action.name;
  }
}

}  // namespace
}  // namespace ghostforce::page_actions_test
