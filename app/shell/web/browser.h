// What the page asks of the browser that Emscripten's headers have no function for. Main thread.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/picture/system_theme.h"

namespace ghostforce::browser {

// Of the page's address, as it is written there (app/shell/page_address.h): what stands from the ? to the #, and what
// follows the #. Empty: nothing.
std::string query();
std::string fragment();
// From now on that follows the #, without a new entry in the browser's history.
void set_fragment(const std::string& text);
// From now on the address names this lesson and step, from 1, and nothing follows the #. Without a name, no lesson.
void set_lesson(const std::string& name, std::size_t step);
// Whether this is the origin of a page, by http or https, written as this browser writes it.
bool is_origin(const std::string& value);
// Shows the address of this page with that text behind the #, for others to open, and its QR code where others can
// reach this page.
void show_link(const std::string& text);
// Whether that is on the screen.
bool shows_dialog();
// The person has changed it since the last call, by hand or with a link.
bool take_fragment_change();

// Whether the tab is in sight.
bool is_visible();
bool has_focus();
// Whether there is a page around this one.
bool is_in_frame();
// What the person has set for all pages: that they move as little as possible.
bool wants_less_motion();
// The colours that the person has set for all pages; empty: each page has its own. Slow: not in each frame.
std::optional<SystemColours> forced_colours();
// The tab's own clock since the page began to load [s].
double clock_s();

// Copies, as far as the browser allows; and what was pasted last.
void copy_text(const std::string& text);
std::string pasted_text();
// The person has pasted something since the last call.
bool take_paste();

// Whether the browser lets this page fill the screen at all.
bool offers_full_screen();
void toggle_full_screen();
bool is_full_screen();

// From now on the browser tells the page of these by itself: what is pasted, files that are dropped, a new fragment.
void listen();

// Whether leaving the page would lose something: then the browser asks before it does.
void keep_from_leaving(bool has_unsaved);

// The words and controls beside the canvas (page_controls.h), as JSON.
void show_controls(const std::string& json);
// The focus goes to them, which brings them into sight.
void enter_controls();

// Whether keys are meant for the canvas: it has the focus, or nothing has, leave_canvas() has not given them back since,
// and the page is no part of another one.
bool canvas_has_keys();
bool canvas_has_focus();
// The focus leaves the canvas, and with it the keys.
void leave_canvas();

// Tells the page's own script that the first picture is there; from now on it exchanges messages with the page around
// this one, if that is of this origin. Empty: with none.
void tell_ready(const std::string& embedder);
// What of a lesson has changed, as JSON, for that page.
void tell_lesson(const std::string& lesson);
// What somebody does, as action_text(), likewise.
void tell_action(const std::string& action);
// Over the picture: words, and a button that loads the page again. Empty words: they go.
void offer_to_load_again(const std::string& words, const std::string& button);
// Shows these words in place of the program.
void tell_problem(const std::string& words);

}  // namespace ghostforce::browser
