// What the page asks of the browser that Emscripten's headers have no function for. Main thread.
#pragma once

#include <string>

namespace ghostforce::browser {

// Of the page's address: the value of ?NAME=VALUE, decoded; empty: it is not there, or empty.
std::string query(const std::string& name);
bool has_query(const std::string& name);
// What follows the #, decoded; empty: nothing.
std::string fragment();
// From now on that follows the #, without a new entry in the browser's history.
void set_fragment(const std::string& text);
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
// The tab's own clock since the page began to load [s].
double clock_s();

// Copies, as far as the browser allows; and what was pasted last.
void copy_text(const std::string& text);
std::string pasted_text();
// The person has pasted something since the last call.
bool take_paste();

void toggle_full_screen();
bool is_full_screen();

// From now on the browser tells the page of these by itself: what is pasted, files that are dropped, a new fragment.
void listen();

// Whether leaving the page would lose something: then the browser asks before it does.
void keep_from_leaving(bool has_unsaved);

// For screen readers.
void tell_listeners(const std::string& words);

// Tells the page's own script that the first picture is there.
void tell_ready();
// Shows these words in place of the program.
void tell_problem(const std::string& words);

}  // namespace ghostforce::browser
