#include "app/shell/page_actions.h"

#include <algorithm>
#include <array>
#include <exception>
#include <vector>

#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/shell/application.h"
#include "app/state/lesson_file.h"
#include "app/state/palette_catalog.h"

namespace ghostforce {
namespace {

const std::array action_table{
    PageAction{"full", ChooseStrategy{StrategyId::full}},
    PageAction{"naive", ChooseStrategy{StrategyId::naive}},
    PageAction{"anisotropic", ChooseStrategy{StrategyId::anisotropic}},
    PageAction{"pause", TogglePause{}},
    PageAction{"step-on", StepOn{}},
    PageAction{"step-back", StepBack{}},
    PageAction{"reset", Restart{}},
    PageAction{"reset-settings", Restart{.with_scene_settings = true}},
    PageAction{"fit", FitView{}},
    PageAction{"stage", ShowFace{Face::stage}},
    PageAction{"workbench", ShowFace{Face::workbench}},
    PageAction{"predict", ToggleMode{StageMode::predict}},
    PageAction{"why", ToggleMode{StageMode::why}},
    PageAction{"landscape", ToggleMode{StageMode::landscape}},
    PageAction{"round", ToggleMode{StageMode::round}},
    PageAction{"ribbon", ToggleMode{StageMode::ribbon}},
    PageAction{"confirm", Confirm{}},
    PageAction{"numbers", ToggleNumbers{}},
    PageAction{"next-step", NextStep{}},
    PageAction{"previous-step", PreviousStep{}},
    PageAction{"answer-1", AnswerLesson{0}},
    PageAction{"answer-2", AnswerLesson{1}},
    PageAction{"answer-3", AnswerLesson{2}},
    PageAction{"answer-4", AnswerLesson{3}},
    PageAction{"leave-lesson", LeaveLesson{}},
    PageAction{"undo", Undo{}},
    PageAction{"redo", Redo{}},
};

std::string page_refusal_of(Application& application, const Action& action) {
  return palette_refusal(application.session(), application.reading(), action);
}

std::string act_unless_refused(Application& application, const Action& action) {
  std::string refusal = page_refusal_of(application, action);
  if (refusal.empty()) application.act_at_once(action);
  return refusal;
}

}  // namespace

std::span<const PageAction> page_actions() {
  return action_table;
}

std::string act_by_name(Application& application, std::string_view name) {
  if (std::string problem = not_one_of(name, names_of(action_table)); !problem.empty()) return problem;
  const auto* const found = std::ranges::find(action_table, name, &PageAction::name);
  return act_unless_refused(application, found->action);
}

std::string show_line(Application& application, const std::string& line) {
  if (std::string refusal = page_refusal_of(application, PasteSetUp{line}); !refusal.empty()) return refusal;
  try {
    application.show_set_up(line);
    return {};
  } catch (const std::exception& error) {
    return error.what();
  }
}

std::string begin_lesson_by_name(Application& application, std::string_view name) {
  if (std::string problem = not_one_of(name, shipped_lesson_names()); !problem.empty()) return problem;
  return act_unless_refused(application, OpenLesson{std::string(name)});
}

}  // namespace ghostforce
