// A texture's colours, or one colour where the texture says how much of it there is (gl_painter.cpp).

uniform vec4 rectangle;  // as in the vertex shader
uniform sampler2D cells;
uniform vec4 tint;
uniform bool holds_shares;  // of the tint, in the first channel

in vec2 place;

out vec4 colour;

void main() {
  vec2 covered = clamp(min(place - rectangle.xy, rectangle.zw - place) + 0.5, 0.0, 1.0);
  vec4 cell = texture(cells, (place - rectangle.xy) / (rectangle.zw - rectangle.xy));
  colour = tint * (holds_shares ? vec4(1.0, 1.0, 1.0, cell.r) : cell);
  colour.a *= covered.x * covered.y;
}
