// ImGui's OpenGL backend saves OpenGL's state before it draws and restores it afterwards. In a browser each such question
// waits until all that was drawn so far is done: a frame of 2 ms takes 100. Nobody here needs that state, since every
// painter sets what it draws with. So for that one source (page_sources.cmake) the questions lead here.
#pragma once

#include <GLES3/gl3.h>

#ifdef __cplusplus
extern "C" {
#endif

// As glGetIntegerv for what stays the same; else a state that can be set without an error.
void ghostforce_get_integer(GLenum name, GLint* values);
// True: ImGui then uses the program that it was told of above, which is none.
GLboolean ghostforce_is_program(GLuint program);

#ifdef __cplusplus
}
#endif

#define glGetIntegerv ghostforce_get_integer
#define glIsProgram ghostforce_is_program
