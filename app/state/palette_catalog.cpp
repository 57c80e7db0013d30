#include "app/state/palette_catalog.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "app/files/file_exchange.h"
#include "app/files/scene_file.h"
#include "app/state/faces_and_modes.h"
#include "app/state/front_keys.h"
#include "app/state/key_bindings.h"
#include "app/state/lesson_file.h"
#include "app/state/permit.h"
#include "app/state/stage_action.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

using Name = StageLanguage::Actions;

// --- Why not: what permit.h does not know, because it is the loop's or would change nothing ---

struct Circumstances {
  const Session& session;
  const LoopReading& loop;
  const StageLanguage& language;
};

std::string refuse_unless(bool is_allowed, std::string_view words) {
  return is_allowed ? std::string() : std::string(words);
}

template <typename A>
std::string why_not(const Circumstances& /*now*/, const A& /*action*/) {
  return {};
}

// What the motors' button does is allowed, and nothing else.
template <typename A>
bool is_on_motor_button(const MotorReport& motors) {
  const std::optional<Action> action = action_of_motor_button(motors);
  return action && std::holds_alternative<A>(*action);
}

std::string why_not(const Circumstances& now, const ArmMotors&) {
  const MotorReport& motors = now.loop.motors;
  if (is_on_motor_button<ArmMotors>(motors)) return {};
  const std::string_view status_key = front_keys().device_status.shown;
  if (!motors.has_motors) return std::string(now.language.refusals.no_motors);
  if (motors.may_still_push) return filled(now.language.device.motors_may_still_push, status_key);
  if (motors.state != SafetyState::off) return std::string(now.language.refusals.motors_are_on);
  if (motors.reason != OffReason::none) return std::string(now.language.refusals.off_not_read);
  return filled(now.language.warnings.device_not_ready, status_key);
}

std::string why_not(const Circumstances& now, const ConfirmZeroPose&) {
  return refuse_unless(now.loop.motors.waits_for_zero_pose, now.language.refusals.no_zero_pose);
}

std::string why_not(const Circumstances& now, const AcknowledgeOff&) {
  return refuse_unless(is_on_motor_button<AcknowledgeOff>(now.loop.motors), now.language.refusals.nothing_to_dismiss);
}

std::string why_not(const Circumstances& now, const Undo&) {
  return refuse_unless(!now.session.undo_offer.undo.empty(), now.language.refusals.nothing_to_undo);
}

std::string why_not(const Circumstances& now, const Redo&) {
  return refuse_unless(!now.session.undo_offer.redo.empty(), now.language.refusals.nothing_to_redo);
}

std::string why_not(const Circumstances& now, const StartRecording&) {
  return refuse_unless(!now.loop.recording.is_on, now.language.refusals.is_so_already);
}

std::string why_not(const Circumstances& now, const StopRecording&) {
  return refuse_unless(now.loop.recording.is_on, now.language.refusals.is_not_on);
}

std::string why_not(const Circumstances& now, const StartMeasuring&) {
  const bool is_on = now.session.measurement.stage != UserMeasurement::Stage::off;
  return refuse_unless(!is_on, now.language.refusals.is_so_already);
}

std::string why_not(const Circumstances& now, const AimAtTarget& action) {
  if (!now.loop.motors.has_motors) return std::string(now.language.refusals.no_motors);
  return refuse_unless(action.after != now.session.aims_at_target, now.language.refusals.is_so_already);
}

std::string why_not(const Circumstances& now, const LeaveLesson&) {
  return refuse_unless(now.session.lesson.has_value(), now.language.refusals.is_not_on);
}

std::string why_not(const Circumstances& now, const OpenDialog& action) {
  const bool has_curves = action.dialog != Dialog::save_plots || now.session.plots.is_open;
  return refuse_unless(has_curves, now.language.refusals.plots_are_closed);
}

std::string why_not(const Circumstances& now, const ChooseInput& action) {
  return refuse_unless(action.name != now.session.input, now.language.refusals.is_so_already);
}

template <auto Session::*member>
requires std::equality_comparable<decltype(Change<member>::after)> std::string why_not(const Circumstances& now,
                                                                                       const Change<member>& action) {
  return refuse_unless(!(now.session.*member == action.after), now.language.refusals.is_so_already);
}

std::string refusal_of(const Circumstances& now, const Action& action) {
  if (const auto refusal = permit(now.session, action)) return std::string(now.language.refusals.*refusal->words);
  return std::visit([&](const auto& wanted) { return why_not(now, wanted); }, action);
}

// --- The entries ---

struct Entries {
  Circumstances now;
  std::vector<PaletteEntry> all{};
  ActionGroup group{};  // of what is added

  void add(std::string words, std::string_view also, Action action, std::string key = {}) {
    std::string refusal = refusal_of(now, action);
    all.push_back({std::move(words), also, std::move(key), std::move(action), std::move(refusal), group});
  }
  void add(ActionWords named, Action action, std::string key = {}) {
    const StageLanguage::Action& said = now.language.actions.*named;
    add(std::string(said.words), said.also, std::move(action), std::move(key));
  }
  // One of many that differ in what they are about.
  void add(ActionWords named, std::string_view about, Action action, std::string key = {}) {
    const StageLanguage::Action& said = now.language.actions.*named;
    add(filled(said.words, about), said.also, std::move(action), std::move(key));
  }
};

// What Enter does before anything is typed turns them off.
void add_motors(Entries& entries) {
  entries.group = ActionGroup::devices;
  entries.add(&Name::stop_motors, StopMotors{});
  entries.add(&Name::arm_motors, ArmMotors{});
  entries.add(&Name::confirm_zero_pose, ConfirmZeroPose{});
  entries.add(&Name::dismiss_off, AcknowledgeOff{});
}

// The number that chooses it also answers lessons.
std::string number_key_of(StrategyId id) {
  for (const KeyBinding& binding : key_table()) {
    const auto* const by_number = binding.action ? std::get_if<ChooseByNumber>(&*binding.action) : nullptr;
    if (by_number != nullptr && by_number->id == id) return chord_of(binding);
  }
  return {};
}

void add_strategies(Entries& entries) {
  entries.group = ActionGroup::strategies;
  for (const Strategy& each : strategy_catalog()) {
    const StrategyWords words =
        strategy_words(entries.now.language, each.id, has_strings(entries.now.session.settings));
    entries.add(&Name::strategy, fmt::format("{} ({})", words.name, words.about), ChooseStrategy{each.id},
                number_key_of(each.id));
  }
}

void add_modes(Entries& entries) {
  entries.group = ActionGroup::stage;
  for (const StageModeEntry& mode : stage_mode_catalog()) {
    const StageLanguage::Mode& said = entries.now.language.modes.*mode.words;
    const Action action = mode.id == StageMode::measure ? Action(MeasureHand{}) : ToggleMode{mode.id};
    entries.add(fmt::format("{}: {}", said.title, said.about), {}, action, std::string(mode.key));
  }
}

void add_keys(Entries& entries) {
  for (const KeyBinding& binding : key_table()) {
    if (!binding.group.empty()) entries.group = action_group_of(binding.group);
    if (binding.named != nullptr) entries.add(binding.named, *binding.action, chord_of(binding));
  }
}

void add_looks(Entries& entries) {
  entries.group = ActionGroup::view;
  const Session& session = entries.now.session;
  constexpr std::array themes{&Name::light_theme, &Name::dark_theme, &Name::projector_theme};
  for (std::size_t i = 0; i < themes.size(); ++i) {
    Appearance look = session.appearance;
    look.theme = &theme_catalog()[i];
    entries.add(themes[i], ChangeAppearance{look});
  }
  entries.add(&Name::full_motion, ChangeMotion{ScreenMotion::full});
  entries.add(&Name::reduced_motion, ChangeMotion{ScreenMotion::reduced});
  entries.add(&Name::system_motion, ChangeMotion{ScreenMotion::as_system});
  constexpr std::array comparisons{std::pair{&Name::overlay, Compare::overlay},
                                   std::pair{&Name::side_by_side, Compare::side_by_side},
                                   std::pair{&Name::active_only, Compare::active_only}};
  for (const auto& [named, compare] : comparisons) {
    ViewOptions options = session.options;
    options.compare = compare;
    entries.add(named, ChangeViewOptions{options});
  }
  entries.add(&Name::next_comparison, NextCompareMode{});
  entries.add(&Name::ghost_forces, ToggleViewOption{&ViewOptions::ghost_forces});
  entries.add(&Name::predictions, ToggleViewOption{&ViewOptions::predictions});
  entries.add(&Name::trails, ToggleViewOption{&ViewOptions::trails});
  entries.group = ActionGroup::window;
  for (const StageLanguage* const each : stage_languages) {
    entries.add(&Name::language, each->name, ChooseLanguage{std::string(each->code)});
  }
  if (session.offers_audience) entries.add(&Name::audience, ToggleAudience{});
  if (session.offers_speech) {
    entries.add(&Name::read_aloud, SwitchSpeech{true});
    entries.add(&Name::stop_reading_aloud, SwitchSpeech{false});
  }
}

void add_experiments(Entries& entries) {
  entries.group = ActionGroup::devices;
  for (const InputChoice& input : entries.now.loop.inputs) {
    const std::string_view title = counterpart(english_stage.inputs, entries.now.language.inputs, input.title);
    entries.add(&Name::choose_input, title, ChooseInput{std::string(input.name)});
  }
  entries.group = ActionGroup::hand;
  entries.add(&Name::largest_drift, TurnWallToLargestDrift{});
  entries.add(&Name::switch_motor, SwitchMotor{});
  entries.group = ActionGroup::devices;
  entries.add(&Name::aim_at_target, AimAtTarget{true});
  entries.add(&Name::no_target, AimAtTarget{false});
  entries.add(&Name::start_measuring, StartMeasuring{});
  entries.add(&Name::start_recording, StartRecording{entries.now.session.recording_path});
  entries.add(&Name::stop_recording, StopRecording{});
  entries.group = ActionGroup::files;
  entries.add(&Name::save_plots, OpenDialog{Dialog::save_plots});
  if (save_place().paints_files) entries.add(&Name::save_clip, OpenDialog{Dialog::save_clip});
}

void add_lessons_and_scenes(Entries& entries) {
  entries.group = ActionGroup::stage;
  entries.add(&Name::leave_lesson, LeaveLesson{});
  for (const auto& lesson : shipped_lessons()) {
    entries.add(&Name::lesson, words_in(*lesson, entries.now.session.language).title, OpenLesson{lesson->name});
  }
  entries.group = ActionGroup::scenes;
  for (const std::string_view name : shipped_scene_names()) {
    entries.add(&Name::scene, name, OpenScene{std::string(name)});
  }
}

}  // namespace

ActionGroup action_group_of(std::string_view key_group) noexcept {
  const StageLanguage::KeyGroups& all = english_stage.key_groups;
  const std::array rows{std::pair{all.strategies, ActionGroup::strategies},
                        std::pair{all.stage, ActionGroup::stage},
                        std::pair{all.change, ActionGroup::hand},
                        std::pair{all.time, ActionGroup::hand},
                        std::pair{all.view, ActionGroup::view},
                        std::pair{all.files, ActionGroup::files},
                        std::pair{all.device, ActionGroup::devices}};
  const auto* const found = std::ranges::find(rows, key_group, [](const auto& row) { return row.first; });
  return found == rows.end() ? ActionGroup::window : found->second;
}

std::string palette_refusal(const Session& session, const LoopReading& loop, const Action& action) {
  return refusal_of({session, loop, stage_language(session.language)}, action);
}

std::vector<PaletteEntry> palette_catalog(const Session& session, const LoopReading& loop) {
  Entries entries{{session, loop, stage_language(session.language)}};
  add_motors(entries);
  add_strategies(entries);
  add_modes(entries);
  add_looks(entries);
  add_keys(entries);
  add_experiments(entries);
  add_lessons_and_scenes(entries);
  entries.group = ActionGroup::window;
  // The last one: what it takes back is not to be found first by who looks for another reset.
  entries.add(&Name::reset_preferences, OpenDialog{Dialog::reset_preferences});
  return std::move(entries.all);
}

namespace {

constexpr bool is_of_word(char letter) noexcept {
  const auto byte = static_cast<unsigned char>(letter);
  return byte >= 0x80 || (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9');
}

bool begins_word(std::string_view text, std::size_t at) noexcept {
  return at == 0 || !is_of_word(text[at - 1]);
}

bool has_word_with(std::string_view text, std::string_view beginning) noexcept {
  for (std::size_t at = text.find(beginning); at != std::string_view::npos; at = text.find(beginning, at + 1)) {
    if (begins_word(text, at)) return true;
  }
  return false;
}

std::vector<std::string_view> words_in_line(std::string_view line) {
  std::vector<std::string_view> words;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find(' '), line.size());
    if (end > 0) words.push_back(line.substr(0, end));
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return words;
}

constexpr int part_of_word = 3;

// How far from what was meant: its first word, a word of it, one of its further words, a part of one. Empty: nowhere.
std::optional<int> distance_of(std::string_view words, std::string_view also, std::string_view sought) {
  if (words.starts_with(sought)) return 0;
  if (has_word_with(words, sought)) return 1;
  if (has_word_with(also, sought)) return 2;
  if (words.find(sought) != std::string_view::npos || also.find(sought) != std::string_view::npos) return part_of_word;
  return std::nullopt;
}

}  // namespace

std::string folded(std::string_view text) {
  // U+00C0 to U+00FF, which UTF-8 writes as 0xC3 and one byte more.
  constexpr std::string_view plain = "aaaaaaaceeeeiiiidnooooo*ouuuuytsaaaaaaaceeeeiiiidnooooo/ouuuuyty";
  static_assert(plain.size() == 64);
  std::string small;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char letter = text[i];
    if (letter == '\xC3' && i + 1 < text.size()) {
      small += plain[static_cast<unsigned char>(text[++i]) & 0x3FU];
    } else {
      small += letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    }
  }
  return small;
}

std::vector<std::size_t> find_in_palette(std::span<const PaletteEntry> entries, std::string_view sought) {
  const std::string line = folded(sought);
  const std::vector<std::string_view> wanted = words_in_line(line);
  struct Found {
    std::tuple<int, bool, std::size_t> order;
    bool is_part;  // something that was sought only stands within a word
  };
  std::vector<Found> found;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string words = folded(entries[i].words);
    const std::string also = folded(entries[i].also);
    int sum = 0;
    bool is_part = false;
    const bool has_all = std::ranges::all_of(wanted, [&](std::string_view each) {
      const std::optional<int> distance = distance_of(words, also, each);
      sum += distance.value_or(0);
      is_part = is_part || distance == part_of_word;
      return distance.has_value();
    });
    if (has_all) found.push_back({{sum, !entries[i].refusal.empty(), i}, is_part});
  }
  // "fault" is not to find "default" where something is about faults.
  if (!std::ranges::all_of(found, &Found::is_part))
    std::erase_if(found, [](const Found& each) { return each.is_part; });
  std::ranges::sort(found, {}, &Found::order);
  std::vector<std::size_t> numbers;
  for (const Found& each : found) numbers.push_back(std::get<std::size_t>(each.order));
  return numbers;
}

}  // namespace ghostforce
