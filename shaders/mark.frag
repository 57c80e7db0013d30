// Colours a pixel by its signed distance to the mark's outline: edges are anti-aliased exactly, without multisampling,
// which costs a software renderer two to four times the frame.

in vec2 at;
flat in float extent;
flat in vec4 mark_form;
flat in vec4 mark_pattern;
flat in vec4 mark_fill;
flat in vec4 mark_rim;

out vec4 colour;

const float line = 0.0;
const float disc = 1.0;
const float diamond = 2.0;
const float triangle = 3.0;
const float arrow = 4.0;
const float half_plane = 5.0;
const float box = 6.0;
const float arrow_head = 2.3;
const float stripe_share = 0.4;  // of the way from stripe to stripe

float to_segment(vec2 p, float length_along) {
  return length(p - vec2(clamp(p.x, 0.0, length_along), 0.0));
}

float to_interval(float x, float from, float to) {
  return max(from - x, x - to);
}

// Negative on a dash, positive in a gap.
float to_dash(float along) {
  float period = dot(mark_pattern, vec4(1.0));
  float x = mod(along, period);
  float second = mark_pattern.x + mark_pattern.y;
  float nearest = min(to_interval(x, 0.0, mark_pattern.x), to_interval(x, second, second + mark_pattern.z));
  // The dash that begins the next period, and the one that ended the last.
  nearest = min(nearest, period - x);
  return min(nearest, to_interval(x + period, second, second + mark_pattern.z));
}

// Exact distance to the arrow's outline, a polygon of seven corners symmetric about the axis.
float to_arrow(vec2 p, float length_along, float half_width) {
  float half_head = arrow_head * half_width;
  float head = min(1.9 * half_head, 0.8 * length_along);
  vec2 corners[7] = vec2[7](vec2(0.0, -half_width), vec2(length_along - head, -half_width),
                            vec2(length_along - head, -half_head), vec2(length_along, 0.0),
                            vec2(length_along - head, half_head), vec2(length_along - head, half_width),
                            vec2(0.0, half_width));
  float nearest = 1e9;
  bool inside = false;
  for (int i = 0, j = 6; i < 7; j = i++) {
    vec2 edge = corners[j] - corners[i];
    vec2 offset = p - corners[i];
    nearest = min(nearest, length(offset - edge * clamp(dot(offset, edge) / dot(edge, edge), 0.0, 1.0)));
    if ((corners[i].y > p.y) != (corners[j].y > p.y) && p.x < edge.x * offset.y / edge.y + corners[i].x) {
      inside = !inside;
    }
  }
  return inside ? -nearest : nearest;
}

float to_box(vec2 p, vec2 half_size, float radius) {
  vec2 q = abs(p) - half_size + radius;
  return length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - radius;
}

// Equilateral, point up (y is down), with the area of a disc of the same radius or a little more.
float to_triangle(vec2 p, float radius) {
  const float k = 1.7320508;
  float side = 1.25 * radius;
  p = vec2(abs(p.x) - side, -p.y + side / k - 0.12 * radius);
  if (p.x + k * p.y > 0.0) p = vec2(p.x - k * p.y, -k * p.x - p.y) / 2.0;
  p.x -= clamp(p.x, -2.0 * side, 0.0);
  return -length(p) * sign(p.y);
}

float to_outline() {
  float radius = mark_form.y;
  if (mark_form.x == line) {
    float distance = to_segment(at, extent) - radius;
    return mark_pattern.x > 0.0 ? max(distance, to_dash(mark_form.w + at.x)) : distance;
  }
  if (mark_form.x == disc) return length(at) - radius;
  if (mark_form.x == diamond) return (abs(at.x) + abs(at.y) - 1.3 * radius) * 0.70710678;
  if (mark_form.x == triangle) return to_triangle(at, radius);
  if (mark_form.x == arrow) {
    if (mark_pattern.x == 0.0) return to_arrow(at, extent, radius);
    return to_box(at - vec2(0.5 * extent, 0.0), vec2(0.5 * extent, radius), 0.0);
  }
  if (mark_form.x == box) return to_box(at, mark_pattern.xy, min(radius, min(mark_pattern.x, mark_pattern.y)));
  return at.x;  // half plane
}

// How much of this pixel stripes cover that lie at 45° across an arrow, still where its tail is.
float striped() {
  float period = mark_pattern.y;
  float from_middle = abs(mod((at.x + at.y) * 0.70710678, period) - 0.5 * period);
  return clamp(0.5 - (from_middle - 0.5 * stripe_share * period), 0.0, 1.0);
}

void main() {
  float distance = to_outline();
  float half_rim = 0.5 * mark_form.z;
  float covered = clamp(0.5 - (distance - half_rim), 0.0, 1.0);
  float filled = clamp(0.5 - (distance + half_rim), 0.0, 1.0);
  vec4 inside = mark_fill;
  if (mark_form.x == arrow && mark_pattern.y > 0.0) inside = mix(mark_fill, mark_rim, striped());
  colour = mix(mark_rim, inside, filled);
  colour.a *= covered;
  if (colour.a <= 0.0) discard;
}
