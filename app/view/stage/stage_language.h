// StageLanguage: all words of the stage and of lessons that are the program's own, in one language. A language is one
// file with such a table (english.cpp, spanish.cpp …) and its line in the catalog. Immutable, any thread.
//
// "{}" stands for a number or a name that is put in. Numbers keep their decimal point and their units in all languages.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "core/safety.h"
#include "core/strategy.h"

namespace ghostforce {

// Made of std::string_view alone, which words_of() walks. No entry has a default: one that is forgotten does not compile.
struct StageLanguage {
  std::string_view code;  // of ISO 639-1
  std::string_view name;  // in the language itself

  // Above the scene. Which one is true of what is shown: stage_sentence.cpp, and the modes.
  struct Sentences {
    std::string_view in_hand;  // nobody knows the goal
    std::string_view aim_and_push;
    std::string_view push;
    std::string_view aimed_with_ghost;
    std::string_view aimed_without_ghost;
    std::string_view drag_into_wall;
    std::string_view in_front_of_wall;
    std::string_view two_motors;
    std::string_view one_becomes_two;
    std::string_view two_become_one;
    std::string_view motor_along_wall;
    std::string_view on_way_to_cure;
    std::string_view on_way_to_naive;
    std::string_view on_way_without_ghost;
    std::string_view naive_ghost;
    std::string_view naive_too_little;
    std::string_view straight_at_wall;
    std::string_view press_deeper;
    std::string_view cured;
    std::string_view cured_but_for_tones;
    std::string_view hold_still;
    std::string_view stiffer_than_believed;
    std::string_view softer_than_believed;
    std::string_view wrong_ratio;
    std::string_view ghost_will_remain;

    std::string_view guess_was_off;  // mm
    std::string_view guess_is_tried;
    std::string_view guess_needs_wall;
    std::string_view guess_with_two_motors;
    std::string_view guess_with_one_motor;

    std::string_view why_two_motors;
    std::string_view why_nothing_given;
    std::string_view why_all_given;
    std::string_view why_cured;
    std::string_view why_ghost;
    std::string_view why_needs_wall;

    std::string_view round_begins;
    std::string_view round_leaves_wall;
    std::string_view round_gives;
    std::string_view round_gives_though_cured;
    std::string_view round_takes;
    std::string_view round_is_fair;

    std::string_view drag_along_ribbon;

    std::string_view measure_runs;
    std::string_view measure_needs_wall;
    std::string_view measure_needs_motors;
    std::string_view hand_known;     // its stiffness, give or take, and the force for a centimetre
    std::string_view hand_believed;  // stiffness
    std::string_view hand_left_wall;
    std::string_view hand_not_moved;
    std::string_view hand_at_limit;
    std::string_view hand_damaged;
    std::string_view hand_too_slowly;
    std::string_view hand_too_restless;
    std::string_view hand_out_of_range;
  } sentences;

  // Beside the things of the scene.
  struct Labels {
    std::string_view ghost;  // and its force; so the next two
    std::string_view wall;
    std::string_view motor;
    std::string_view slid;  // so far
    std::string_view handle;
    std::string_view target;
    std::string_view should_rest;
    std::string_view should_hold;
    std::string_view virtual_wall;
    std::string_view hand;
    std::string_view hand_in_wall;  // how deep [mm]
    std::string_view hand_to_drag;
    std::string_view hand_inferred;
    std::string_view motor_to_turn;
    std::string_view motor_measures;  // tones sound without a mode that tells of them
    std::string_view motor_pushes;    // a direction:
    std::string_view left_and_right;
    std::string_view up_and_down;
    std::string_view at_angle;  // degrees
    std::string_view guess;
    std::string_view guess_to_drag;
    std::string_view guess_off;    // mm
    std::string_view first_round;  // is not complete
    std::string_view energy_a_round;
    std::string_view measuring;
    std::string_view hand_measured;       // its stiffness, give or take
    std::string_view hand_before;         // what was measured before
    std::string_view hand_asked_softer;   // of a lesson, where another one was measured: at most so stiff
    std::string_view hand_asked_stiffer;  // at least
    std::string_view hand_unknown;
  } labels;

  // Below the large numbers.
  struct Numbers {
    std::string_view ghost_force;
    std::string_view ghost_force_too_little;
    std::string_view ghost_force_unknown;
    std::string_view slide;
    std::string_view slide_unknown;
  } numbers;

  struct StrategyButton {
    std::string_view in_full;
    std::string_view in_short;
  };
  PerStrategy<StrategyButton> strategies;

  // A mode, as its icon explains itself.
  struct Mode {
    std::string_view title;
    std::string_view about;
  };
  struct Modes {
    Mode predict;
    Mode why;
    Mode landscape;
    Mode round;
    Mode ribbon;
    Mode measure;
  } modes;

  // Other things that explain themselves under the pointer.
  struct Hovers {
    std::string_view lessons;  // their key
    std::string_view workbench;
    std::string_view leave_lesson;
    std::string_view wall;
    std::string_view motor;
  } hovers;

  // The four steps of Why?, beside their forces.
  struct Why {
    std::string_view push;   // and its force; so the next one
    std::string_view share;  // what the motor can give
    std::string_view no_share_missing;
    std::string_view no_share_excess;
    std::string_view all_share_missing;
    std::string_view all_share_excess;
    std::string_view cured_missing;
    std::string_view cured_excess;
    std::string_view missing;
    std::string_view hardly_any_excess;
    std::string_view excess;  // and its force
  } why;

  // The map. Several ways to break words into lines: lines are separated by "\n", ways by "|", the widest first.
  struct Map {
    std::string_view title;
    std::string_view stiffness_axis;
    std::string_view angle_axis;
    std::string_view you_are_here;  // the share
    std::string_view off_the_map;   // so
    std::string_view no_ghost;
    std::string_view too_much;
    std::string_view too_little;
    std::string_view verdict;   // which of the last two
    std::string_view sentence;  // share, which
    std::string_view sentence_without_ghost;
    std::string_view drag_ring;
    std::string_view two_motors;
    std::string_view naive;
    std::string_view optimal;
    std::string_view chosen_ratio;
    std::string_view slide_to_cure;
    std::string_view slide_for_less;
  } map;

  struct Ribbon {
    std::string_view now;
    std::string_view milliseconds_ago;
    std::string_view seconds_ago;
    std::string_view title;        // the greatest force
    std::string_view short_title;  // so
    std::string_view title_unknown;
  } ribbon;

  // Buttons and hints at the lower edge.
  struct Buttons {
    std::string_view lessons;  // their key
    std::string_view keys;     // so
    std::string_view link;     // so
    std::string_view cure_hint;
    std::string_view show_guess;
    std::string_view skip;
    std::string_view guess_again;
    std::string_view next_step;
    std::string_view back;  // out of a mode
    std::string_view measure;
    std::string_view measure_again;
    std::string_view measure_again_in_lesson;
    std::string_view measuring;
    std::string_view believe;  // what was measured
  } buttons;

  // In place of the sentence.
  struct Warnings {
    std::string_view unstable;
    std::string_view unstable_on_workbench;
    std::string_view device_not_ready;  // the key of its status
    std::string_view device_not_ready_for_visitors;
    std::string_view paused;
  } warnings;

  // The motors' button.
  struct Motors {
    std::string_view none;
    std::string_view off_by_key;
    std::string_view off;  // a reason
    std::string_view arm;
    std::string_view not_ready;
    std::string_view arming;
    std::string_view on;
    // The same while no key reaches the window.
    std::string_view arming_without_keys;
    std::string_view on_without_keys;
    std::string_view fading;
    std::array<std::string_view, static_cast<std::size_t>(OffReason::fault) + 1> reasons;  // in the order of OffReason
  } motors;

  // Round a lesson.
  struct Lessons {
    std::string_view place;  // step, how many
    std::string_view back;
    std::string_view next;
    std::string_view show;       // the answer to a question that is open
    std::string_view answer;     // what a guess is given with
    std::string_view not_quite;  // then the right answer
    std::string_view finish;
    // Its sliders: what the number is.
    std::string_view k_u;
    std::string_view believed_k_u;
    std::string_view k_r;
    std::string_view tracking_ratio;
    std::string_view wall_angle;
    std::string_view motor_angle;
  } lessons;

  struct Picker {
    std::string_view title;
    std::string_view steps;  // how many
    std::string_view step;   // number, how many
    std::string_view done;
    std::string_view right;  // number, how many
    std::string_view about;
    std::string_view forget;
    std::string_view forget_question;
    std::string_view forget_yes;
    std::string_view forget_no;
    std::string_view open_file;
    std::string_view close;
  } picker;

  // What is told in passing.
  struct Notices {
    std::string_view copied_set_up;
    std::string_view pasted_set_up;
    std::string_view picture_shown;  // path
    std::string_view copied_picture;
    std::string_view saved;      // path
    std::string_view saving;     // path, percent
    std::string_view not_saved;  // path
    std::string_view problem;    // above what has gone wrong
    std::string_view close;
  } notices;
};

extern const StageLanguage english_stage;
extern const StageLanguage spanish_stage;
// All of them, English first.
std::span<const StageLanguage* const> stage_language_catalog() noexcept;

// English for a language that is not in the catalog.
const StageLanguage& stage_language(std::string_view code) noexcept;

// All entries of a table, or of a part of one, in their order.
template <typename Table>
auto words_of(const Table& table) noexcept {
  return std::bit_cast<std::array<std::string_view, sizeof(Table) / sizeof(std::string_view)>>(table);
}

// The words with these values in place of "{}".
template <typename... Values>
std::string filled(std::string_view words, const Values&... values) {
  return fmt::format(fmt::runtime(words), values...);
}

}  // namespace ghostforce
