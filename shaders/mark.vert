// One quad per mark, just large enough for it and its anti-aliased edge; of a half-plane one per part.

layout(location = 0) in vec4 ends;     // from.xy, to.xy [px], y down, from the viewport's upper left corner
layout(location = 1) in vec4 form;     // kind, radius or half width [px], rim width [px], start of the pattern [px]
layout(location = 2) in vec4 pattern;  // of a line: drawn, left out, drawn, left out; of an arrow: 1 without head, and
                                       // from stripe to stripe, 0 for none; of a box: half its width and height [px]
                                       // of a half-plane: upper left corner and size of the part to draw [px]
layout(location = 3) in vec4 fill;
layout(location = 4) in vec4 rim;

uniform vec2 viewport;  // [px]

out vec2 at;  // in the mark's own frame: along and across from its start [px]
flat out float extent;
flat out vec4 mark_form;
flat out vec4 mark_pattern;
flat out vec4 mark_fill;
flat out vec4 mark_rim;

const float half_plane = 5.0;
const float box = 6.0;
const float arrow = 4.0;
const float arrow_head = 2.3;  // half width of the head over that of the shaft; the fragment shader has the same

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  vec2 start = ends.xy;
  vec2 axis = ends.zw - ends.xy;
  vec2 position;
  if (form.x == half_plane) {
    // Its frame: start is a point of the edge, zw the normal; only the distance from the edge matters.
    position = pattern.xy + corner * pattern.zw;
    extent = 0.0;
    at = vec2(dot(position - start, ends.zw), 0.0);
  } else if (form.x == box) {
    // Its frame: upright, from its middle; ends are its upper left and lower right corner.
    float reach = form.z + 1.5;
    position = mix(ends.xy - reach, ends.zw + reach, corner);
    extent = 0.0;
    at = position - 0.5 * (ends.xy + ends.zw);
  } else {
    extent = length(axis);
    axis = extent > 0.0 ? axis / extent : vec2(1.0, 0.0);
    vec2 across = vec2(-axis.y, axis.x);
    float reach = form.y * (form.x == arrow ? arrow_head : 1.5) + form.z + 1.5;
    at = vec2(mix(-reach, extent + reach, corner.x), mix(-reach, reach, corner.y));
    position = start + axis * at.x + across * at.y;
  }
  mark_form = form;
  mark_pattern = pattern;
  mark_fill = fill;
  mark_rim = rim;
  gl_Position = vec4(position.x / viewport.x * 2.0 - 1.0, 1.0 - position.y / viewport.y * 2.0, 0.0, 1.0);
}
