#version 330 core
// A texture's colours, or one colour where the texture says how much of it there is (texture_painter.cpp).

uniform sampler2D cells;
uniform vec4 tint;

in vec2 at;

out vec4 colour;

void main() {
  colour = tint * texture(cells, at);
}
