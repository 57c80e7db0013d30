#version 330 core
// One upright rectangle with a texture over all of it.

uniform vec4 rectangle;  // left, top, right, bottom [px], y down, from the viewport's upper left corner
uniform vec2 viewport;   // [px]

out vec2 at;  // in the texture

void main() {
  at = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  vec2 position = mix(rectangle.xy, rectangle.zw, at);
  gl_Position = vec4(position.x / viewport.x * 2.0 - 1.0, 1.0 - position.y / viewport.y * 2.0, 0.0, 1.0);
}
