// What the drawer shows, as numbers or as a picture.
#include <array>
#include <string>

#include <fmt/format.h>

#include "app/session/plot_view.h"
#include "app/ui/panels/dialogs.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/save_path.h"

namespace ghostforce {
namespace {

constexpr std::array formats{"csv", "png", "svg", "pdf"};

}  // namespace

void draw_save_plots(const PanelContext& context) {
  Session& session = context.session;
  Form& form = session.form;
  if (form.belongs_to != Dialog::save_plots) {
    form.path = proposed_path(fmt::format("{}-{}", file_stem(session.scene->title), plot_tab_name(session.plots.tab)),
                              formats.front());
  }
  if (begin_rows("plots", context)) {
    row("Format", "CSV: the numbers, for a spreadsheet or a script. PNG, SVG and PDF: the picture.");
    draw_format_choice(form.path, formats);
    ImGui::BeginDisabled(session.plots.tab != PlotTab::time);
    row("Times", "Those in sight, or all that the plots remember: a minute at 1000 ticks a second.");
    if (ImGui::RadioButton("in sight", !form.whole_history)) form.whole_history = false;
    ImGui::SameLine();
    if (ImGui::RadioButton("all", form.whole_history)) form.whole_history = true;
    ImGui::EndDisabled();
    end_rows();
  }
  if (!draw_save_path(context)) return;
  if (format_of(form.path, formats) == nullptr) form.path += fmt::format(".{}", formats.front());
  session.wishes.save_plots = PlotWish{form.path, form.whole_history};
  session.dialog = Dialog::none;
}

}  // namespace ghostforce
