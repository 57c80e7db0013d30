// OpenGL in a browser: ES 3.0, which is WebGL 2. It has no texture swizzles, whatever the header declares.
#pragma once

#include <GLES3/gl3.h>

namespace ghostforce::gl {

// The first line of a shader, and everything that stands before what a file of shaders/ holds.
inline constexpr const char* shader_version = "#version 300 es";
inline constexpr const char* shader_prologue =
    "#version 300 es\n"
    "precision highp float;\n"
    "precision highp int;\n";

}  // namespace ghostforce::gl
