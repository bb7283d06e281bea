#include "demos/render/shaders.h"

namespace demos::render::shaders {

const char* const thingVertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in mat4 model;    // of the instance
layout(location = 6) in vec4 tint;     // linear colour; alpha below 1 is glass
layout(location = 7) in uvec2 tag;     // number of the thing, 1 for terrain
uniform mat4 worldToClip;
out vec3 worldPosition;
out vec3 worldNormal;
out vec3 meshPosition;
out vec3 meshNormal;
flat out vec4 colour;
flat out uvec2 kind;
void main() {
  vec4 world = model * vec4(position, 1);
  worldPosition = world.xyz;
  worldNormal = mat3(model) * normal;
  meshPosition = position;
  meshNormal = normal;
  colour = tint;
  kind = tag;
  gl_Position = worldToClip * world;
}
)";

const char* const depthFragment = R"(#version 330 core
void main() {}
)";

const char* const thingFragment = R"(#version 330 core
in vec3 worldPosition;
in vec3 worldNormal;
in vec3 meshPosition;
in vec3 meshNormal;
flat in vec4 colour;
flat in uvec2 kind;
layout(location = 0) out vec4 light;
layout(location = 1) out uint number;

uniform vec3 eye;
uniform vec3 up;
uniform vec3 sun;                 // towards it
uniform mat4 worldToShadow;       // to texture coordinates and depth
uniform float shadowTexel;        // metres
uniform sampler2DShadow shadowMap;
uniform sampler2D occlusion;
uniform vec2 pixels;              // of the target, samples
uniform float gridSpacing;        // metres
uniform vec3 stageCentre;
uniform float stageRadius;
uniform vec3 skyLow, skyHigh;

// Share of a pixel that lies on grid lines, whose width is a share of the spacing (box filter after
// Quilez).
float grid(vec2 metres, float spacing, float width) {
  vec2 p = metres / spacing + 0.5 * width;
  vec2 w = max(abs(dFdx(p)) + abs(dFdy(p)), 1e-4);
  vec2 a = p + 0.5 * w, b = p - 0.5 * w;
  vec2 covered = (floor(a) * width + min(fract(a), width) - floor(b) * width - min(fract(b), width)) / w;
  return 1 - (1 - covered.x) * (1 - covered.y);
}

vec2 alongSurface() {
  vec3 n = abs(meshNormal);
  if (n.y >= n.x && n.y >= n.z) return meshPosition.xz;
  return n.x > n.z ? meshPosition.yz : meshPosition.xy;
}

// Nine bilinear look-ups, a sample and a half apart: a soft edge without grain.
float sunlit(vec3 n) {
  vec3 place = worldPosition + n * 2.0 * shadowTexel;
  vec3 at = (worldToShadow * vec4(place, 1)).xyz;
  if (any(lessThan(at, vec3(0))) || any(greaterThan(at, vec3(1)))) return 1.0;
  vec2 texel = 1.5 / vec2(textureSize(shadowMap, 0));
  float sum = 0.0;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j) sum += texture(shadowMap, vec3(at.xy + texel * vec2(i, j), at.z));
  return sum / 9.0;
}

void main() {
  vec3 toEye = normalize(eye - worldPosition);
  vec3 n = normalize(worldNormal);
  if (dot(n, toEye) < 0.0) n = -n;

  vec3 albedo = colour.rgb;
  if (kind.y == 1u) {
    vec2 metres = alongSurface();
    albedo *= 1.0 - 0.22 * grid(metres, gridSpacing, 0.016) - 0.18 * grid(metres, 10.0 * gridSpacing, 0.0024);
  }

  float facing = max(dot(n, sun), 0.0);
  float direct = facing > 0.0 ? facing * sunlit(n) : 0.0;
  float open = texture(occlusion, gl_FragCoord.xy / pixels).r;
  float height = 0.5 + 0.5 * dot(n, up);
  vec3 hemisphere = mix(vec3(0.33, 0.31, 0.29), vec3(0.52, 0.56, 0.62), height) * open;
  vec3 halfway = normalize(sun + toEye);
  float gloss = direct > 0.0 ? 0.10 * pow(max(dot(n, halfway), 0.0), 40.0) * direct : 0.0;
  vec3 lit = albedo * (hemisphere + 0.78 * vec3(1.0, 0.97, 0.91) * direct) + gloss;

  // The ground ends in the sky, well behind what stands on it.
  if (kind.y == 1u) {
    vec3 away = worldPosition - stageCentre;
    float far = smoothstep(1.6 * stageRadius, 7.0 * stageRadius, length(away - up * dot(away, up)));
    lit = mix(lit, mix(skyLow, skyHigh, gl_FragCoord.y / pixels.y), far);
  }
  light = vec4(lit, colour.a);
  number = kind.x | kind.y << 31;
}
)";

const char* const screenVertex = R"(#version 330 core
out vec2 place;
void main() {
  place = vec2((gl_VertexID & 1) * 2, gl_VertexID & 2);
  gl_Position = vec4(2.0 * place - 1.0, 1, 1);
}
)";

const char* const backgroundFragment = R"(#version 330 core
in vec2 place;
layout(location = 0) out vec4 light;
layout(location = 1) out uint number;
uniform vec3 skyLow, skyHigh;
void main() {
  light = vec4(mix(skyLow, skyHigh, place.y), 1);
  number = 0u;
}
)";

// Scalable ambient obscurance (McGuire, Mara, Luebke 2012): points near this one that stand above
// its tangent plane.
const char* const occlusionFragment = R"(#version 330 core
in vec2 place;
layout(location = 0) out float open;
uniform sampler2D depths;
uniform mat4 clipToEye;
uniform float radius;             // metres
uniform float pixelsPerMetre;     // at one metre from the eye
const int samples = 14;

vec3 eyePosition(ivec2 pixel) {
  vec2 size = vec2(textureSize(depths, 0));
  vec3 clip = vec3((vec2(pixel) + 0.5) / size, texelFetch(depths, pixel, 0).r) * 2.0 - 1.0;
  vec4 p = clipToEye * vec4(clip, 1);
  return p.xyz / p.w;
}

// The shorter of the two differences, so that the normal does not straddle an outline.
vec3 difference(vec3 here, ivec2 pixel, ivec2 offset) {
  vec3 ahead = eyePosition(pixel + offset) - here, behind = here - eyePosition(pixel - offset);
  return abs(ahead.z) < abs(behind.z) ? ahead : behind;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy), last = textureSize(depths, 0) - 1;
  open = 1.0;
  if (texelFetch(depths, pixel, 0).r >= 1.0) return;
  vec3 here = eyePosition(pixel);
  ivec2 inner = clamp(pixel, ivec2(1), last - 1);
  here = eyePosition(inner);
  vec3 n = normalize(cross(difference(here, inner, ivec2(1, 0)), difference(here, inner, ivec2(0, 1))));
  float reach = clamp(radius * pixelsPerMetre / -here.z, 3.0, 120.0);
  // Sixteen turns in a square of 4 x 4 pixels, which the blur averages.
  float turn = float((pixel.x & 3) * 4 + (pixel.y & 3)) * (6.2831853 / 16.0);
  float sum = 0.0;
  for (int i = 0; i < samples; ++i) {
    float share = (float(i) + 0.5) / float(samples);
    float angle = turn + share * 6.2831853 * 5.0;
    ivec2 other = clamp(inner + ivec2(reach * share * vec2(cos(angle), sin(angle))), ivec2(0), last);
    vec3 v = eyePosition(other) - here;
    float vv = dot(v, v), f = max(radius * radius - vv, 0.0) / (radius * radius);
    sum += f * f * f * max((dot(v, n) - 0.02 * radius) * radius / (vv + 0.01 * radius * radius), 0.0);
  }
  open = max(0.0, 1.0 - 1.3 * sum / float(samples));
}
)";

const char* const blurFragment = R"(#version 330 core
in vec2 place;
layout(location = 0) out float open;
uniform sampler2D occlusion;
uniform sampler2D depths;
uniform vec2 nearFar;
float distanceAt(ivec2 pixel) {
  float z = 2.0 * texelFetch(depths, pixel, 0).r - 1.0;
  return 2.0 * nearFar.x * nearFar.y / (nearFar.y + nearFar.x - z * (nearFar.y - nearFar.x));
}
void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy), last = textureSize(depths, 0) - 1;
  float here = distanceAt(pixel), sum = 0.0, weights = 0.0;
  for (int i = -2; i < 2; ++i)
    for (int j = -2; j < 2; ++j) {
      ivec2 other = clamp(pixel + ivec2(i, j), ivec2(0), last);
      float weight = abs(distanceAt(other) - here) < 0.02 * here ? 1.0 : 1e-4;
      sum += weight * texelFetch(occlusion, other, 0).r;
      weights += weight;
    }
  open = sum / weights;
}
)";

const char* const resolveFragment = R"(#version 330 core
layout(location = 0) out vec4 pixel;
uniform sampler2D lights;
uniform usampler2D numbers;
uniform int perPixel;             // samples along each side
uniform float outline;            // how dark, 0 to 1
// Outlines part things from each other and from the ground, but not the ground (highest bit) from
// the sky (0).
bool parted(uint a, uint b) {
  return a != b && !((a == 0u || a >> 31 == 1u) && (b == 0u || b >> 31 == 1u));
}
float toSrgb(float x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055; }
void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * perPixel, last = textureSize(lights, 0) - 1;
  vec3 sum = vec3(0);
  for (int i = 0; i < perPixel; ++i)
    for (int j = 0; j < perPixel; ++j) {
      ivec2 at = first + ivec2(i, j);
      uint here = texelFetch(numbers, at, 0).r;
      bool border = parted(here, texelFetch(numbers, min(at + ivec2(1, 0), last), 0).r) ||
                    parted(here, texelFetch(numbers, min(at + ivec2(0, 1), last), 0).r);
      vec3 light = min(texelFetch(lights, at, 0).rgb, vec3(1));
      sum += border ? light * (1.0 - outline) : light;
    }
  sum /= float(perPixel * perPixel);
  pixel = vec4(toSrgb(sum.r), toSrgb(sum.g), toSrgb(sum.b), 1);
}
)";

}  // namespace demos::render::shaders
