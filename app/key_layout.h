// Which key was pressed, on whatever keyboard. Pure, any thread.
#pragma once

namespace ghostforce {

// `key` and `modifiers` as GLFW tells them: the key by its place on a US keyboard. `name` is what the layout has on it,
// as glfwGetKeyName() tells; null: nothing.
//
// Returns the GLFW_KEY_… that is meant. By what is printed on the key where that is a letter, bracket, dot or minus:
// Ctrl+Z is where the Z is. Otherwise by its place: the digits of a French keyboard, what no ASCII sign is printed on,
// and the number pad. A plus is the key at ] of German and Spanish keyboards, and stays that; with Ctrl it is
// GLFW_KEY_EQUAL, which makes things larger.
int key_by_layout(int key, const char* name, int modifiers) noexcept;

}  // namespace ghostforce
