// Keys as Dear ImGui calls them: as its own backend for GLFW has them.
#include "app/shell/window.h"

#include <gtest/gtest.h>

#include "app/state/keys.h"

// Of the GLFW backend, which exports it for those who feed Dear ImGui themselves, but declares it nowhere.
ImGuiKey ImGui_ImplGlfw_KeyToImGuiKey(int key, int scancode);

namespace ghostforce::imgui_keys_test {
namespace {

TEST(ImguiKey, IsTheBackendsForEveryKey) {
  for (int key = -1; key <= key::last + 1; ++key) {
    EXPECT_EQ(imgui_key(key), ImGui_ImplGlfw_KeyToImGuiKey(key, 0)) << key;
  }
  EXPECT_EQ(imgui_key(key::q), ImGuiKey_Q);
}

}  // namespace
}  // namespace ghostforce::imgui_keys_test
