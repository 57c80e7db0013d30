// Finds places for what is on the stage, and a view of the world. Letters grow with the window's height and with the UI
// scale, as far as everything fits. Points of the window, y down; pure, any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/picture/camera.h"
#include "app/picture/text.h"
#include "app/stage/stage_places.h"
#include "core/scene.h"

namespace ghostforce {

// Sizes of the stage are in points of a picture that is so high.
inline constexpr double height_of_design = 720.0;

StageLayout stage_layout(const Vector<2>& size, double scale, const MeasureText& measure, const StageFrameWords& words);

// The UI scale of what lies over the stage, such as dialogs: it grows with the window's height as the stage's letters
// do, as far as dialogs have room. Not below `scale`, and in steps, so that a window that is being resized needs other
// letters only now and then.
double scale_over_stage(const Vector<2>& size, double scale) noexcept;

// The same for a scene without sentence, numbers and buttons, which then has all of the picture.
StageLayout bare_stage_layout(const Vector<2>& size, double scale);

// What must be seen of a view (app/state/stage_view.h) lies in the room beside or below the numbers, whichever shows it
// larger; there its middle stands a little to the right of and below the window's, if it can. The same for every
// sentence.
Camera stage_camera(const SceneView& shown, const StageLayout& layout);

// How to say what a button does when it is pressed, and its key.
std::string hover_words(const StageAction& action, const StageLanguage& language, const StageKeys& keys);

// What some keys of a page do, as short words, without their places; those that matter most first. On the desktop none.
std::vector<StageButton> key_hints(const StageLanguage& language, const StageKeys& keys);

// The menu's rows, without their places.
std::vector<StageMenuRow> stage_menu(const StageLanguage& language, const StageKeys& keys);

}  // namespace ghostforce
