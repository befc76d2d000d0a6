// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The programs of the OpenGL picture (GLSL 3.30 core), for gl_painter.cpp alone.
namespace flatland::ui::shaders {

inline constexpr char kMeshVertex[] = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float share;
uniform mat4 clip;
uniform mat3 axes;
out vec3 seenNormal;
out vec3 seenPlace;
out float ownShare;
void main() {
  gl_Position = clip * vec4(position, 1.0);
  seenNormal = axes * normal;
  seenPlace = axes * position;
  ownShare = share;
}
)";

// The same shading as Painter::shaded in surface_picture.cpp.
inline constexpr char kMeshFragment[] = R"(#version 330 core
in vec3 seenNormal;
in vec3 seenPlace;
in float ownShare;
uniform int style;
uniform bool hasColours;
uniform vec3 light, background, base, dark, warm, cool;
uniform vec3 stops[5];  // of a colour map
uniform vec3 noValue;
out vec4 result;
vec3 mapped() {
  if (ownShare < 0.0) return noValue;
  float place = clamp(ownShare, 0.0, 1.0) * 4.0;
  int below = min(int(place), 3);
  return mix(stops[below], stops[below + 1], place - float(below));
}
void main() {
  if (style == 0) { result = vec4(background, 1.0); return; }
  vec3 n = normalize(seenNormal);
  if (style == 1) {
    n = normalize(cross(dFdx(seenPlace), dFdy(seenPlace)));
    if (dot(n, seenNormal) < 0.0) n = -n;
  }
  if (!gl_FrontFacing) n = -n;
  float lit = dot(n, light);
  vec3 colour = hasColours ? mapped() : base;
  if (style == 1 || style == 2) colour = mix(dark, base, clamp(0.25 + 0.75 * lit, 0.0, 1.0));
  else if (style == 3) colour = mix(dark, base, lit > 0.6 ? 1.0 : lit > 0.2 ? 0.66 : 0.33);
  else if (style == 4) colour = mix(cool, warm, 0.5 + 0.5 * lit);
  else if (style == 5) colour = 0.5 * n + vec3(0.5);
  else colour *= 0.86 + 0.14 * max(lit, 0.0);
  result = vec4(colour, 1.0);
}
)";

inline constexpr char kLineVertex[] = R"(#version 330 core
layout(location = 0) in vec4 placeAndStrength;
uniform mat4 clip;
out float strength;
void main() {
  gl_Position = clip * vec4(placeAndStrength.xyz, 1.0);
  strength = placeAndStrength.w;
}
)";

// A segment becomes a quad of the width on the screen: core OpenGL has no wide lines.
inline constexpr char kLineGeometry[] = R"(#version 330 core
layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;
in float strength[];
uniform vec2 halfSize;
uniform float halfWidth;
uniform float bias;
out float inkStrength;
flat out int axis;  // that dashes are counted along
void main() {
  vec4 a = gl_in[0].gl_Position, b = gl_in[1].gl_Position;
  if (a.w <= 0.0 || b.w <= 0.0) return;
  vec2 from = a.xy / a.w * halfSize, to = b.xy / b.w * halfSize;
  vec2 along = to - from;
  float length2 = dot(along, along);
  along = length2 > 0.0 ? along / sqrt(length2) : vec2(1.0, 0.0);
  // Longer by half a pixel at both ends, so that neighbours leave no gap.
  vec2 cap = along * min(halfWidth, 0.5);
  vec2 side = vec2(-along.y, along.x) * halfWidth;
  int mainAxis = abs(along.x) >= abs(along.y) ? 0 : 1;
  float za = a.z / a.w - bias, zb = b.z / b.w - bias;
  inkStrength = strength[0]; axis = mainAxis;
  gl_Position = vec4((from - cap + side) / halfSize, za, 1.0); EmitVertex();
  inkStrength = strength[0]; axis = mainAxis;
  gl_Position = vec4((from - cap - side) / halfSize, za, 1.0); EmitVertex();
  inkStrength = strength[1]; axis = mainAxis;
  gl_Position = vec4((to + cap + side) / halfSize, zb, 1.0); EmitVertex();
  inkStrength = strength[1]; axis = mainAxis;
  gl_Position = vec4((to + cap - side) / halfSize, zb, 1.0); EmitVertex();
  EndPrimitive();
}
)";

inline constexpr char kLineFragment[] = R"(#version 330 core
in float inkStrength;
uniform vec3 colour;
uniform float opacity;
uniform float threshold;  // 0: no fading
uniform float weakest;
uniform float dashPx;     // as long as a gap; 0: solid
flat in int axis;
out vec4 result;
void main() {
  if (dashPx > 0.0) {
    if (mod(floor(gl_FragCoord[axis] / dashPx), 2.0) > 0.5) discard;
  }
  float ink = 1.0;
  if (threshold > 0.0) {
    ink = clamp(weakest + (1.0 - weakest) * (inkStrength / threshold - 1.0), weakest, 1.0);
  }
  result = vec4(colour, ink * opacity);
}
)";

}  // namespace flatland::ui::shaders
