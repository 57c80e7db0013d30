// One upright rectangle with a texture over all of it, and a pixel more for its anti-aliased edge.

uniform vec4 rectangle;  // left, top, right, bottom [px], y down, from the viewport's upper left corner
uniform vec2 viewport;   // [px]

out vec2 place;  // [px]

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  place = mix(rectangle.xy - 1.0, rectangle.zw + 1.0, corner);
  gl_Position = vec4(place.x / viewport.x * 2.0 - 1.0, 1.0 - place.y / viewport.y * 2.0, 0.0, 1.0);
}
