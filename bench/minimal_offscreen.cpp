// The least that draws into memory: OSMesa through GLFW's null platform, cleared once; what a start of `render` is held
// against.
#include <glad/gl.h>

#include <GLFW/glfw3.h>

#include <vector>

int main() {
  glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_NULL);
  if (glfwInit() != GLFW_TRUE) return 6;
  glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_OSMESA_CONTEXT_API);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  constexpr int width = 1280;
  constexpr int height = 800;
  GLFWwindow* const window = glfwCreateWindow(width, height, "minimal", nullptr, nullptr);
  if (window == nullptr) return 6;
  glfwMakeContextCurrent(window);
  gladLoadGL(glfwGetProcAddress);
  glClearColor(0.9F, 0.9F, 0.9F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  std::vector<unsigned char> picture(3U * width * height);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, picture.data());
  glfwDestroyWindow(window);
  glfwTerminate();
  return picture.front() == 0 ? 1 : 0;
}
