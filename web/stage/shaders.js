// The two programs of the tilted view. The engine's constants (light.def) come before the surfaces' second part.

export const SURFACES = {
  vertex: `
layout(location=0) in vec3 point;
layout(location=1) in vec3 normal;
layout(location=2) in float curvature;
uniform mat4 clip, eye;
uniform float deep;
out vec3 n, e;
out float k;
void main() {
  gl_Position = clip * vec4(point, 1);
  n = mat3(eye) * normal;
  e = mix(vec3(0, 0, 1), -(eye * vec4(point, 1)).xyz, deep);
  k = curvature;
}`,
  fragment: `
in vec3 n, e;
in float k;
uniform vec4 colour;
uniform int look;
uniform float range;
out vec4 paint;
void main() {
  vec3 toEye = normalize(e), seen = normalize(gl_FrontFacing ? n : -n), rgb;
  float away = dot(seen, toEye), lit = 1.;
  if (away < 0.) seen = normalize(seen - toEye * away);
  if (look == 1) {
    float x = clamp(2. * dot(seen, toEye) * seen.y - toEye.y, -1., 1.), last = 1., wave = x;
    for (int i = 1; i < int(STRIPES); i++) {
      float next = 2. * x * wave - last;
      last = wave;
      wave = next;
    }
    rgb = mix(STRIPE_DARK, STRIPE_LIGHT, clamp(.5 + wave / max(fwidth(wave), 1e-6), 0., 1.));
  } else if (look == 2 || look == 3) {
    float share = range > 0. ? clamp(k / range, -1., 1.) : 0.;
    rgb = mix(NEUTRAL, share < 0. ? COLD : WARM, abs(share));
    lit = SOFT + (1. - SOFT) * matte(seen);
  } else {
    rgb = (colour.r < 0. ? CLAY : colour.rgb) * (gl_FrontFacing ? vec3(1) : BACK);
    lit = matte(seen);
  }
  paint = vec4(min(rgb * lit, 1.), 1) * colour.a;
}`,
};

/** A piece runs from \`a\` to \`b\`; \`p\` is before it, \`q\` behind. Lengths are device pixels. */
export const LINES = {
  vertex: `
layout(location=0) in vec4 p;
layout(location=1) in vec4 a;
layout(location=2) in vec4 b;
layout(location=3) in vec4 q;
uniform mat4 clip;
uniform vec2 middle, before;
uniform float wide;
out vec2 at;
out float s;
flat out float size;
flat out vec2 ends;
vec4 see(vec4 x) { return clip * vec4(x.xyz, 1); }
vec4 put(vec4 c) {
  return vec4(c.xy / c.w * middle, (c.z + before.x * c.w) / (c.w + before.y * c.w), c.w);
}
void main() {
  vec4 A = see(a), B = see(b);
  float start = A.z + A.w, stop = B.z + B.w; // before the near plane, or behind the eye
  if (b.w <= a.w || (start <= 0. && stop <= 0.)) { // from one line to the next, or not seen
    gl_Position = vec4(2, 2, 2, 1);
    return;
  }
  float from = start < 0. ? start / (start - stop) : 0., to = stop < 0. ? start / (start - stop) : 1.;
  vec4 whole = B - A, P = see(p), Q = see(q);
  B = put(A + to * whole), A = put(A + from * whole);
  bool end = (gl_VertexID & 1) == 1;
  float side = (gl_VertexID & 2) == 2 ? 1. : -1., reach = wide + 1.;
  size = length(B.xy - A.xy);
  vec2 d = size > 1e-4 ? (B.xy - A.xy) / size : vec2(1, 0), across = vec2(-d.y, d.x);
  vec4 there = end ? Q : P, other = put(there), here = end ? B : A;
  vec2 way = end ? other.xy - B.xy : A.xy - other.xy;
  ends = vec2(a.w == 0. || from > 0. || P.z + P.w <= 0., q.w <= b.w || to < 1. || Q.z + Q.w <= 0.);
  bool last = (end ? ends.y : ends.x) > 0.;
  float turn = last || length(way) < 1e-4 ? 0. : dot(normalize(way), d);
  vec2 off = across * side * reach + d * (end ? reach : -reach);
  at = vec2(end ? size + reach : -reach, side * reach);
  if (turn > .7) { // the pieces share their corners
    vec2 mean = normalize(normalize(way) + d);
    off = vec2(-mean.y, mean.x) * side * reach / dot(mean, d);
    at.x = end ? size : 0.;
  }
  s = mix(a.w, b.w, end ? to : from);
  gl_Position = vec4((here.xy + off) / middle, here.z, 1);
}`,
  fragment: `
in vec2 at;
in float s;
flat in float size;
flat in vec2 ends;
uniform vec4 colour;
uniform float wide, dash;
uniform int cap;
out vec4 paint;
void main() {
  float beyond = max(-at.x, at.x - size), cover = min(2. * wide, 1.);
  if (cap == 1 || (2. * at.x < size ? ends.x : ends.y) == 0.) // round, as all joints are
    cover *= clamp(wide + .5 - length(vec2(max(beyond, 0.), at.y)), 0., 1.);
  else
    cover *= clamp(wide + .5 - abs(at.y), 0., 1.) * clamp((cap == 2 ? wide : 0.) + .5 - beyond, 0., 1.);
  if (cover <= 0. || (dash > 0. && fract(s * dash) > .55)) discard;
  paint = vec4(colour.rgb, 1) * (colour.a * cover);
}`,
};
