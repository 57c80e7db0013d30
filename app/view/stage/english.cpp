// The words of the stage in English.
#include <algorithm>

#include "app/view/stage/stage_language.h"

namespace ghostforce {
namespace {

// As the workbench has them.
auto titles_of_off_reasons() {
  decltype(StageLanguage::Motors::reasons) titles{};
  std::ranges::transform(off_reason_catalog(), titles.begin(), &OffReasonEntry::title);
  return titles;
}

}  // namespace

const StageLanguage english_stage{
    .code = "en",
    .name = "English",
    .sentences =
        {
            .in_hand = "In your hand: the goal is inferred, so the ghost force cannot be known.",
            .aim_and_push = "Aim at the target and push the handle into the wall.",
            .push = "Push the handle into the wall.",
            .aimed_with_ghost = "You aim at the target, and a ghost force drags you along the wall.",
            .aimed_without_ghost = "You aim at the target, and there is no ghost force.",
            .drag_into_wall = "Drag the hand into the wall.",
            .in_front_of_wall = "The handle is in front of the wall: nothing pushes it.",
            .two_motors = "Two motors: the wall feels right.",
            .one_becomes_two = "One motor becomes two.",
            .two_become_one = "Two motors become one.",
            .motor_along_wall = "The only motor pushes along the wall: it cannot hold the hand.",
            .on_way_to_cure = "On the way to the cure: still a ghost force.",
            .on_way_to_naive = "On the way back to naïve: a ghost force.",
            .on_way_without_ghost = "On the way between the two: no ghost force.",
            .naive_ghost = "A ghost force drags the handle along the wall.",
            .naive_too_little = "The motor pushes too little while the hand moves.",
            .straight_at_wall = "One motor, straight at the wall: no ghost force here.",
            .press_deeper = "Press deeper: there is hardly any ghost force here.",
            .cured = "Same motor, same hand: the ghost force is gone.",
            .cured_but_for_tones = "All that is left is the trembling that measures your hand.",
            .hold_still = "Hold the hand still, and the ghost force goes away.",
            .stiffer_than_believed = "The hand is stiffer than believed: a ghost force is left.",
            .softer_than_believed = "The hand is softer than believed: a ghost force is left.",
            .wrong_ratio = "This ratio does not fit the hand: a ghost force is left.",
            .ghost_will_remain = "Hold the hand still: a small ghost force will remain.",

            .guess_was_off = "Your guess was {} mm off.",
            .guess_is_tried = "The hand presses in, slowly.",
            .guess_needs_wall = "Drag the hand into the wall, then guess.",
            .guess_with_two_motors = "Two motors. Where will the handle come to rest?",
            .guess_with_one_motor = "One motor. Where will the handle come to rest?",

            .why_two_motors = "Two motors push straight out, as a wall does.",
            .why_nothing_given = "The motor pushes along the wall: it can give none of the push.",
            .why_all_given = "Here the motor pushes straight out too: no ghost force.",
            .why_cured = "The cure: where the motor cannot push, the wall gives way.",
            .why_ghost = "A wall pushes straight out. One motor cannot.",
            .why_needs_wall = "Drag the hand deeper into the wall first.",

            .round_begins = "Round and round: a real wall would give the hand nothing.",
            .round_leaves_wall = "The handle leaves the wall on its way round.",
            .round_gives = "Each round the wall gives energy: it pushes the hand along.",
            .round_gives_though_cured = "No ghost force at rest, and yet each round gives energy.",
            .round_takes = "Each round the wall takes energy from the hand.",
            .round_is_fair = "Round and round, and hardly anything is gained or lost.",

            .drag_along_ribbon = "Drag along the ribbon: the last minute again.",

            .measure_runs = "Keep pressing: the motor trembles to feel how far your hand gives way.",
            .measure_needs_wall = "Press into the wall: there the motor can feel your hand.",
            .measure_needs_motors = "Turn the motors on: they have to move your hand a little.",
            .hand_known = "Your hand: {} ± {} N/m. A push of {} N moves it 1 cm.",
            .hand_believed = "Anisotropic (3) now counts on a hand of {} N/m.",
            .hand_left_wall = "Your hand came out of the wall. Press in, and measure again.",
            .hand_not_moved = "The motor could not move your hand. Please measure again.",
            .hand_at_limit = "The motor was at its limit. Press less hard, and measure again.",
            .hand_damaged = "Some of the motion was lost. Please measure again.",
            .hand_too_slowly = "This wall is computed too slowly to measure a hand.",
            .hand_too_restless = "Your hand moved too much by itself. Hold still, and measure again.",
            .hand_out_of_range = "This does not move like a hand. Use a medium grip, and try again.",
        },
    .labels =
        {
            .ghost = "ghost",
            .wall = "wall",
            .motor = "motor",
            .slid = "slid",
            .handle = "handle",
            .target = "aim here",
            .should_rest = "where it should rest",
            .should_hold = "the wall should hold here",
            .virtual_wall = "virtual wall",
            .hand = "your hand pulls here",
            .hand_in_wall = "your hand pulls here, {} mm deep",
            .hand_to_drag = "drag me: your hand pulls here",
            .hand_inferred = "your hand, inferred",
            .motor_to_turn = "turn the motor by its ends",
            .motor_measures = "the motor trembles to measure your hand",
            .motor_pushes = "the only motor pushes {}",
            .left_and_right = "left and right",
            .up_and_down = "up and down",
            .at_angle = "at {}°",
            .guess = "your guess",
            .guess_to_drag = "your guess: drag me",
            .guess_off = "your guess: {} mm off",
            .first_round = "the first round",
            .energy_a_round = "{} mJ a round",
            .measuring = "measuring your hand…",
            .hand_measured = "your hand: {} ± {} N/m",
            .hand_before = "before: {} N/m",
            .hand_asked_softer = "wanted: {} N/m or less",
            .hand_asked_stiffer = "wanted: {} N/m or more",
            .hand_unknown = "your hand: unknown",
        },
    .numbers =
        {
            .ghost_force = "ghost force",
            .ghost_force_too_little = "ghost force (too little)",
            .ghost_force_unknown = "ghost force: unknown",
            .slide = "slid along the wall",
            .slide_unknown = "slide: unknown",
        },
    .strategies = std::to_array<StageLanguage::StrategyButton>({
        {.in_full = "Two motors", .in_short = "Two motors"},
        {.in_full = "One motor, naïve", .in_short = "Naïve"},
        {.in_full = "One motor, anisotropic", .in_short = "Anisotropic"},
    }),
    .modes =
        {
            .predict = {.title = "Predict", .about = "Guess where the handle comes to rest."},
            .why = {.title = "Why?", .about = "Where the ghost force comes from, in four steps."},
            .landscape = {.title = "Landscape", .about = "How strong the ghost force is, for every wall and hand."},
            .round = {.title = "Round and round",
                      .about = "How much energy the wall gives to a hand that circles in it."},
            .ribbon = {.title = "Last minute", .about = "Look again at what has just happened."},
            .measure = {.title = "Measure my hand",
                        .about = "The motor trembles for 2 seconds and feels how stiff your hand is."},
        },
    .hovers =
        {
            .lessons = "Lessons ({}): short sessions that ask, and then show.",
            .workbench = "Workbench (F4): all settings, numbers and plots.",
            .leave_lesson = "Leave the lesson (Esc).",
            .wall = "Drag to turn the wall.",
            .motor = "Drag to turn the motor.",
        },
    .why =
        {
            .push = "1  the wall pushes straight out:",
            .share = "2  the motor can give this much of it:",
            .no_share_missing = "3  all of it is missing",
            .no_share_excess = "4  and there is no ghost force",
            .all_share_missing = "3  nothing is missing",
            .all_share_excess = "4  so nothing slides: no ghost force",
            .cured_missing = "3  no motor gives this, and the wall gives way",
            .cured_excess = "4  so nothing slides: no ghost force",
            .missing = "3  no motor gives this: the handle slides",
            .hardly_any_excess = "4  hardly any ghost force",
            .excess = "4  and the slide pulls: ghost",
        },
    .map =
        {
            .title = "Where is it bad?",
            .stiffness_axis = "wall stiffness : hand stiffness",
            .angle_axis = "angle between the wall's push and the motor|angle between the wall's push\nand the motor",
            .you_are_here = "you are here: {}",
            .off_the_map = "off the map: {}",
            .no_ghost = "no ghost force here",
            .too_much = "too much",
            .too_little = "too little",
            .verdict = "of the wall's push, {},\nat this wall and this hand|"
                       "of the wall's push,\n{}, at this wall\nand this hand",
            .sentence = "At this wall and this hand: {} of the wall's push, {}.",
            .sentence_without_ghost = "At this wall and this hand: no ghost force here.",
            .drag_ring = "Drag the ring: wall and stiffness follow.|Drag the ring:\nwall and stiffness follow.",
            .two_motors = "Two motors: no ghost force at any wall.|Two motors:\nno ghost force at any wall.|"
                          "Two motors:\nno ghost force\nat any wall.",
            .naive = "naïve",
            .optimal = "optimal",
            .chosen_ratio = "as chosen",
            .slide_to_cure = "slide me: the red drains away|slide me:\nthe red drains away",
            .slide_for_less = "slide me: less red",
        },
    .ribbon =
        {
            .now = "now",
            .milliseconds_ago = "{} ms ago",
            .seconds_ago = "{} s ago",
            .title = "ghost force, 0 to {} N",
            .short_title = "0 to {} N",
            .title_unknown = "ghost force: cannot be known",
        },
    .buttons =
        {
            .lessons = "{} lessons",
            .keys = "{} keys",
            .link = "{} link",
            .cure_hint = "press 3: the cure",
            .show_guess = "Enter: show me",
            .skip = "Enter: skip",
            .guess_again = "Enter: guess again",
            .next_step = "Enter: next step",
            .back = "Esc: back",
            .measure = "Measure my hand",
            .measure_again = "Enter: measure again",
            .measure_again_in_lesson = "Measure again",
            .measuring = "Measuring…",
            .believe = "Enter: use it",
        },
    .warnings =
        {
            .unstable = "These settings make the simulation unstable. Press F4 and lower the rendering stiffness.",
            .unstable_on_workbench = "These settings make the simulation unstable. Lower the rendering stiffness.",
            .device_not_ready = "The device is not ready: {} says what to do.",
            .device_not_ready_for_visitors = "The device is not ready. Please ask for help.",
            .paused = "Paused. Press Space to go on.",
        },
    .motors =
        {
            .none = "no motor",
            .off_by_key = "Motors off. Dismiss",
            .off = "Motors off: {}. Dismiss",
            .arm = "Arm the motors",
            .not_ready = "Motors not ready",
            .arming = "Arming… Esc: off",
            .on = "MOTORS ON. Esc: off",
            .arming_without_keys = "Arming…",
            .on_without_keys = "MOTORS ON",
            .fading = "MOTORS turning off",
            .reasons = titles_of_off_reasons(),
        },
    .lessons =
        {
            .place = "{} of {}",
            .back = "Back",
            .next = "Next",
            .show = "Show me",
            .answer = "That is my guess",
            .not_quite = "Not quite. {}",
            .finish = "Finish",
            .k_u = "how stiff the hand is",
            .believed_k_u = "how stiff we believe the hand is",
            .k_r = "how stiff the wall is",
            .tracking_ratio = "from naïve to the cure",
            .wall_angle = "angle of the wall",
            .motor_angle = "angle of the motor",
        },
    .picker =
        {
            .title = "Lessons",
            .steps = "{} steps",
            .step = "Step {} of {}",
            .done = "Done",
            .right = "{} of {} right",
            .about = "Each asks what will happen before it shows it. Enter or a click begins one; Esc ends it.",
            .forget = "Forget my progress…",
            .forget_question = "Forget how far you have come in all lessons?",
            .forget_yes = "Forget it",
            .forget_no = "Keep it",
            .open_file = "Open a file…",
            .close = "Close",
        },
    .notices =
        {
            .copied_set_up =
                "Copied this set-up as a command. Ctrl+V shows it again; so does running it in a terminal.",
            .pasted_set_up = "This is the set-up that was pasted. Ctrl+Z takes it back.",
            .picture_shown = "This is what {} shows. Ctrl+Z takes it back.",
            .copied_picture = "Copied a picture. It can be pasted into other programs.",
            .saved = "Saved {}",
            .saving = "Saving {}: {} %. Close this, or press Esc, to cancel.",
            .not_saved = "{} was not saved.",
            .problem = "Please note",
            .close = "Close",
        },
};

}  // namespace ghostforce
