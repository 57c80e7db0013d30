// Keys and modifiers by name, the same whatever window tells of them. A key that types a sign has that sign's number, a
// letter's that of the upper-case one. The numbers are GLFW's, so that the desktop's window passes them on as they are:
// app/shell/desktop compares them.
#pragma once

namespace ghostforce::key {

inline constexpr int space = ' ', apostrophe = '\'', comma = ',', minus = '-', period = '.', slash = '/',
                     semicolon = ';', equal = '=', left_bracket = '[', backslash = '\\', right_bracket = ']',
                     grave_accent = '`';

inline constexpr int digit_0 = '0', digit_1 = '1', digit_2 = '2', digit_3 = '3', digit_4 = '4', digit_5 = '5',
                     digit_6 = '6', digit_7 = '7', digit_8 = '8', digit_9 = '9';

inline constexpr int a = 'A', b = 'B', c = 'C', d = 'D', e = 'E', f = 'F', g = 'G', h = 'H', i = 'I', j = 'J', k = 'K',
                     l = 'L', m = 'M', n = 'N', o = 'O', p = 'P', q = 'Q', r = 'R', s = 'S', t = 'T', u = 'U', v = 'V',
                     w = 'W', x = 'X', y = 'Y', z = 'Z';

// Where a US keyboard has none: beside the left Shift, for instance.
inline constexpr int world_1 = 161, world_2 = 162;

inline constexpr int escape = 256, enter = 257, tab = 258, backspace = 259, insert = 260, delete_forward = 261,
                     right = 262, left = 263, down = 264, up = 265, page_up = 266, page_down = 267, home = 268,
                     end = 269, caps_lock = 280, scroll_lock = 281, number_lock = 282, print_screen = 283, pause = 284;

inline constexpr int f1 = 290, f2 = 291, f3 = 292, f4 = 293, f5 = 294, f6 = 295, f7 = 296, f8 = 297, f9 = 298,
                     f10 = 299, f11 = 300, f12 = 301, f24 = 313;

// One after another from 0 to 9.
inline constexpr int number_pad_0 = 320, number_pad_7 = 327, number_pad_9 = 329;
inline constexpr int number_pad_decimal = 330, number_pad_divide = 331, number_pad_multiply = 332,
                     number_pad_subtract = 333, number_pad_add = 334, number_pad_enter = 335, number_pad_equal = 336;

inline constexpr int left_shift = 340, left_control = 341, left_alt = 342, left_super = 343, right_shift = 344,
                     right_control = 345, right_alt = 346, right_super = 347, menu = 348;

inline constexpr int last = menu;

}  // namespace ghostforce::key

// The keys that are held down with another, as bits of one number.
namespace ghostforce::modifier {

inline constexpr int shift = 1, control = 2, alt = 4, super = 8;

}  // namespace ghostforce::modifier
