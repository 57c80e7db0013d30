#include "app/workbench/language_choice.h"

#include "app/widgets/controls.h"

namespace ghostforce {

void draw_language_choice(const PanelContext& context) {
  const StageLanguage& shown = stage_language(context.session.language);
  for (const StageLanguage* const language : stage_languages) {
    const float width = ImGui::GetFrameHeightWithSpacing() + ImGui::CalcTextSize(language->name.data()).x;
    if (language != stage_languages.front()) same_line_if_room(width);
    if (ImGui::RadioButton(language->name.data(), &shown == language)) {
      context.apply(ChooseLanguage{std::string(language->code)});
    }
  }
}

}  // namespace ghostforce
