// What the graphics card runs. Places come from a texture that holds a world's positions as they are, so that neither
// particles nor springs cost the page anything.

const PLACES = `#version 300 es
precision highp float;
precision highp int;
uniform highp sampler2D places;
uniform int wide;
vec3 place(int i) { return texelFetch(places, ivec2(i % wide, i / wide), 0).xyz; }
uniform mat4 view, projection;
uniform bool fromLight;
uniform float halfPixel;
`;

const LIGHT = `#version 300 es
precision highp float;
uniform vec3 light;
uniform vec3 sky, ground, upward;
vec3 lit(vec3 colour, vec3 normal) {
  float key = max(dot(normal, light), 0.0);
  vec3 around = mix(ground, sky, 0.5 + 0.5 * dot(normal, upward));
  float shine = pow(max(dot(reflect(-light, normal), vec3(0.0, 0.0, 1.0)), 0.0), 30.0);
  return colour * (around + 0.75 * key) + 0.22 * shine;
}
`;

export const spring = {
  vertex: `${PLACES}
in vec2 corner;
in uvec2 ends;
in float rest;
uniform float radius, strainEnd;
out float across, strain, share;
out vec3 aside, facing;
void main() {
  vec3 a = (view * vec4(place(int(ends.x)), 1.0)).xyz;
  vec3 b = (view * vec4(place(int(ends.y)), 1.0)).xyz;
  float l = length(b - a);
  strain = rest > 0.0 ? (l - rest) / (rest * strainEnd) : 0.0;
  vec3 p = mix(a, b, corner.x);
  vec3 toEye = fromLight ? vec3(0.0, 0.0, 1.0) : normalize(-p);
  aside = cross(b - a, toEye);
  aside = dot(aside, aside) > 0.0 ? normalize(aside) : vec3(1.0, 0.0, 0.0);
  facing = normalize(cross(aside, b - a) + 1e-9 * toEye);
  float least = halfPixel * (fromLight ? 1.0 : max(-p.z, 0.0));
  float r = max(radius, least);
  share = clamp(radius / r, 0.35, 1.0);
  across = corner.y;
  gl_Position = projection * vec4(p + aside * corner.y * r, 1.0);
}`,
  fragment: `${LIGHT}
in float across, strain, share;
in vec3 aside, facing;
uniform vec3 squeezed, resting, stretched;
out vec4 colour;
void main() {
  vec3 normal = normalize(aside * across + facing * sqrt(max(1.0 - across * across, 0.0)));
  vec3 own = mix(resting, strain < 0.0 ? squeezed : stretched, smoothstep(0.0, 1.0, abs(strain)));
  colour = vec4(lit(own, normal) * share, share);
}`,
};

export const ball = {
  vertex: `${PLACES}
in vec2 corner;
in vec4 look;
uniform float radius;
uniform int marked;
uniform vec3 mark;
out vec2 around;
out vec3 own, middle;
out float r, share;
void main() {
  bool isMarked = marked == gl_InstanceID;
  own = isMarked ? mark : look.rgb;
  middle = (view * vec4(place(gl_InstanceID), 1.0)).xyz;
  float least = 1.6 * halfPixel * (fromLight ? 1.0 : max(-middle.z, 0.0));
  float size = radius * look.a * (isMarked ? 1.7 : 1.0);
  r = max(size, isMarked ? 4.0 * least : least * look.a);
  // Joints that are smaller than a pixel would only be noise: they fade.
  share = look.a > 1.0 || isMarked ? 1.0 : smoothstep(0.3, 1.0, size / least);
  around = corner;
  gl_Position = projection * vec4(middle + vec3(corner * r, 0.0), 1.0);
}`,
  fragment: `${LIGHT}
in vec2 around;
in vec3 own, middle;
in float r, share;
uniform mat4 projection;
out vec4 colour;
void main() {
  float square = dot(around, around);
  float edge = fwidth(square);
  float inside = share * (1.0 - smoothstep(1.0 - edge, 1.0, square));
  if (inside <= 0.0) discard;
  vec3 normal = vec3(around, sqrt(max(1.0 - square, 0.0)));
  vec4 seen = projection * vec4(middle + normal * r, 1.0);
  gl_FragDepth = 0.5 + 0.5 * seen.z / seen.w;
  colour = vec4(lit(own, normal) * inside, inside);
}`,
  shadow: `#version 300 es
precision highp float;
in vec2 around;
in vec3 own, middle;
in float r, share;
void main() { if (dot(around, around) > 1.0) discard; }`,
};

export const springShadow = `#version 300 es
precision highp float;
in float across, strain, share;
in vec3 aside, facing;
void main() {}`;

export const plane = {
  vertex: `#version 300 es
precision highp float;
in vec2 corner;
uniform mat4 both, toLight;
uniform vec3 middle, along, side;
out vec2 tile;
out vec4 inLight;
out vec2 flatPlace;
out vec3 spot;
void main() {
  flatPlace = corner;
  vec3 p = middle + along * corner.x + side * corner.y;
  spot = p;
  tile = vec2(length(along), length(side)) * corner;
  inLight = toLight * vec4(p, 1.0);
  gl_Position = both * vec4(p, 1.0);
}`,
  fragment: `#version 300 es
precision highp float;
precision highp sampler2DShadow;
in vec2 tile;
in vec4 inLight;
in vec2 flatPlace;
in vec3 spot;
// What lies behind another plane is out of everything's reach.
uniform vec4 others[8];
uniform int othersCount;
uniform sampler2DShadow shadows;
uniform vec3 light, even, odd, shade;
uniform vec2 origin;
uniform float spacing, opacity;
out vec4 colour;
float covered() {
  vec3 p = inLight.xyz / inLight.w * 0.5 + 0.5;
  if (any(lessThan(p, vec3(0.0))) || any(greaterThan(p, vec3(1.0)))) return 0.0;
  float sum = 0.0, texel = 1.0 / float(textureSize(shadows, 0).x);
  for (int x = -1; x <= 1; x++)
    for (int y = -1; y <= 1; y++) sum += texture(shadows, vec3(p.xy + 1.5 * texel * vec2(x, y), p.z - 0.002));
  return 1.0 - sum / 9.0;
}
// A chessboard, averaged over what a pixel sees of it.
float chess(vec2 at) {
  vec2 w = max(fwidth(at), 1e-4);
  vec2 i = 2.0 * (abs(fract((at - 0.5 * w) * 0.5) - 0.5) - abs(fract((at + 0.5 * w) * 0.5) - 0.5)) / w;
  return 0.5 - 0.5 * i.x * i.y;
}
void main() {
  for (int i = 0; i < othersCount; i++) if (dot(others[i].xyz, spot) < others[i].w) discard;
  float fade = 1.0 - smoothstep(0.15, 1.0, length(flatPlace));
  vec3 own = mix(even, odd, chess((tile + origin) / spacing));
  own = mix(own, shade, 0.62 * covered());
  float alpha = fade * opacity;
  colour = vec4(own * alpha, alpha);
}`,
};
