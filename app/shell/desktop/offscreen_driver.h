// Which driver draws offscreen: the software renderer that Mesa chooses by itself, whatever the environment says. What
// somebody has set for the programs on their desktop (another driver, another version of OpenGL) makes Mesa draw other
// pictures, or crash where there is no desktop.
#pragma once

namespace ghostforce {

// Takes such variables out of the environment, and says so on the standard error. Before any OpenGL is loaded and any
// thread is started.
void choose_offscreen_driver();

}  // namespace ghostforce
