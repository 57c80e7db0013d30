// What is open in front of the picture, as words and controls: what a dialog's fields and buttons lead to, with what it
// proposes.
#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "app/stage/control_pieces.h"
#include "app/state/device_status.h"
#include "app/state/key_bindings.h"
#include "app/state/lesson_file.h"
#include "app/state/lesson_guide.h"
#include "app/state/palette_catalog.h"
#include "app/state/proposed_path.h"

namespace ghostforce {
namespace {

using Kind = StageControlKind;

// Does something, and closes the dialog.
void add_closing_button(const ControlSource& source, ControlParts& parts, std::string id, std::string_view words,
                        const Action& action) {
  StageControl button = button_control(source, std::move(id), std::string(words), action);
  button.act = [action](double) { return std::vector<Action>{action, CloseDialog{}}; };
  parts.push_back(std::move(button));
}

// The same for what is saved, under the name that the dialog proposes when the button is pressed.
template <typename Save>
void add_saving_button(const ControlSource& source, ControlParts& parts, std::string id, std::string_view words,
                       const Save& save) {
  StageControl button = button_control(source, std::move(id), std::string(words), save);
  button.act = [save, &session = source.session](double) {
    Save named = save;
    named.path = proposed_path(session, session.dialog);
    return std::vector<Action>{named, CloseDialog{}};
  };
  parts.push_back(std::move(button));
}

// Of a list that stands folded at the end while no dialog shows it.
void add_rows(StageControl list, ControlParts& parts) {
  std::ranges::move(list.parts, std::back_inserter(parts));
}

void add_file(const ControlSource& source, ControlParts& parts) {
  parts.push_back(text_control("open-file", Kind::file, std::string(source.language.picker.open_file)));
}

void add_lessons(const ControlSource& source, ControlParts& parts) {
  const StageLanguage::Picker& said = source.language.picker;
  const Session& session = source.session;
  if (!session.lesson_gone_through.empty()) {
    const std::size_t next = lesson_to_go_on_with(session);
    parts.push_back(button_control(source, "next-lesson", filled(said.next, numbered_title(next, session.language)),
                                   OpenLesson{shipped_lessons().at(next)->name}));
  }
  add_rows(lesson_list(source), parts);
  if (session.lesson_progress != LessonProgress{}) {
    ControlParts answer{button_control(source, "forget-lessons", std::string(said.forget_yes), ForgetLessons{})};
    parts.push_back(group_control("forget", Kind::folded, said.forget_question, std::move(answer)));
  }
  add_file(source, parts);
  parts.back().act = [](double) { return std::vector<Action>{CloseDialog{}}; };  // what is chosen would be behind it
}

void add_help(const ControlSource& source, ControlParts& parts) {
  parts.push_back(text_control("help-subject", Kind::text, std::string(source.language.help.subject)));
  add_rows(key_list(source), parts);
}

// The dialog is closed first: what an action opens is in its place.
void add_palette(const ControlSource& source, ControlParts& parts) {
  StageControl list = action_list(source);
  for (StageControl& group : list.parts) {
    for (StageControl& row : group.parts) {
      row.act = [act = std::move(row.act)](double value) {
        std::vector<Action> actions = act(value);
        actions.insert(actions.begin(), CloseDialog{});
        return actions;
      };
    }
  }
  add_rows(std::move(list), parts);
}

// In English, as all that the picture says of devices there.
void add_device_status(const ControlSource& source, ControlParts& parts) {
  parts.push_back(text_control("device-status", Kind::status, why_no_readiness(source.loop)));
  parts.back().language = english_stage.code;
}

void add_scenes(const ControlSource& source, ControlParts& parts) {
  if (const std::string& problem = source.session.form.problem; !problem.empty()) {
    parts.push_back(text_control("open-problem", Kind::alert, problem));
    parts.back().language = english_stage.code;
  }
  for (PaletteEntry& entry : palette_catalog(source.session, source.loop)) {
    const auto* const opens = std::get_if<OpenScene>(&entry.action);
    if (opens == nullptr) continue;
    parts.push_back(button_control(source, "open-" + opens->name_or_path, std::move(entry.words), entry.action));
  }
  add_file(source, parts);
}

void add_save_scene(const ControlSource& source, ControlParts& parts) {
  add_saving_button(source, parts, "save-scene", source.language.actions.save_scene.words, SaveScene{});
}

void add_save_picture(const ControlSource& source, ControlParts& parts) {
  const StageLanguage::Controls& all = source.language.controls;
  const int density = Form{}.density;
  add_saving_button(source, parts, "save-window", all.save_window, SavePicture{{}, density, false});
  add_saving_button(source, parts, "save-scene-alone", all.save_scene_alone, SavePicture{{}, density, true});
  add_closing_button(source, parts, "copy-picture", source.language.actions.copy_picture.words,
                     CopyPicture{density, false});
}

void add_save_plots(const ControlSource& source, ControlParts& parts) {
  const StageLanguage::Controls& all = source.language.controls;
  add_saving_button(source, parts, "save-shown", all.save_shown_times, SavePlots{{}, false});
  if (is_over_time(source.session.plots.tab)) {
    add_saving_button(source, parts, "save-all", all.save_all_times, SavePlots{{}, true});
  }
}

void add_reset_preferences(const ControlSource& source, ControlParts& parts) {
  const StageLanguage::Reset& said = source.language.reset;
  parts.push_back(text_control("reset-about", Kind::text, std::string(said.about)));
  add_closing_button(source, parts, "reset-yes", said.yes, ResetPreferences{});
}

using Name = StageLanguage::Actions;

// Clips are saved on the desktop alone.
struct Entry {
  Dialog dialog;
  ActionWords named;  // as the action that opens it; null: the palette, which no action is called after
  void (*add)(const ControlSource& source, ControlParts& parts);
};
constexpr std::array entries{Entry{Dialog::help, &Name::help, add_help},
                             Entry{Dialog::doctor, &Name::device_status, add_device_status},
                             Entry{Dialog::lessons, &Name::lessons, add_lessons},
                             Entry{Dialog::open_scene, &Name::open_scene, add_scenes},
                             Entry{Dialog::save_scene, &Name::save_scene, add_save_scene},
                             Entry{Dialog::save_picture, &Name::save_picture, add_save_picture},
                             Entry{Dialog::save_plots, &Name::save_plots, add_save_plots},
                             Entry{Dialog::palette, nullptr, add_palette},
                             Entry{Dialog::reset_preferences, &Name::reset_preferences, add_reset_preferences}};

}  // namespace

void add_dialog(const ControlSource& source, ControlParts& parts) {
  const auto entry = std::ranges::find(entries, source.session.dialog, &Entry::dialog);
  if (entry == entries.end()) return;
  const StageLanguage& language = source.language;
  const std::string_view name =
      entry->named != nullptr ? (language.actions.*entry->named).words : language.palette.title;
  ControlParts inside{button_control(source, "dialog-close", std::string(language.picker.close), CloseDialog{})};
  entry->add(source, inside);
  // It says that it has been opened, for whoever is elsewhere.
  const bool is_on_stage = source.session.face == Face::stage;
  const std::string_view opened = is_on_stage ? language.controls.dialog : language.controls.dialog_in_picture;
  parts.push_back(text_control("dialog-open", Kind::status, filled(opened, name)));
  parts.push_back(group_control("dialog", Kind::dialog, name, std::move(inside)));
  parts.back().about = filled(language.controls.closed, name);
}

}  // namespace ghostforce
