// GLSL of the renderer. Lighting is done at the vertices, in a space of gamma 2: sRGB = albedo * sqrt(light).
#pragma once

namespace amiss::sim::internal {

inline constexpr const char* kVertexShader = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec2 vertex_uv;
layout(location = 3) in vec4 vertex_colour;
layout(location = 4) in vec4 vertex_matt;
uniform mat4 T_camera_body;
uniform mat3 R_world_body;
uniform vec4 lens;          // x / z, y / z -> clip space: two factors, two offsets
uniform vec2 depth_range;   // z -> clip space: factor, offset
uniform vec3 ambient;
uniform vec3 light_direction[2];
uniform vec3 light_colour[2];
uniform float two_sided;
out vec4 surface;           // lit colour, reflectance
#ifdef TEXTURED
out vec2 uv;
#endif
#ifdef TRANSPARENT
out float alpha;
#else
out float facing;           // z * cosine of the angle between ray and normal * length of the ray to z = 1
#endif
void main() {
  vec3 p = (T_camera_body * vec4(position, 1.0)).xyz;
  gl_Position = vec4(lens.xy * p.xy + lens.zw * p.z, depth_range.x * p.z + depth_range.y, p.z);
  float towards = dot(mat3(T_camera_body) * normal.xyz, p);
  float side = two_sided > 0.5 && towards > 0.0 ? -1.0 : 1.0;
  vec3 n = side * (R_world_body * normal.xyz);
  vec3 light = ambient * (0.85 + 0.3 * n.z);  // more from the sky than from the floor
  for (int i = 0; i < 2; ++i) {
    float turned = 0.5 - 0.5 * dot(n, light_direction[i]);  // half Lambert: no side is flat
    light += light_colour[i] * (turned * turned);
  }
  surface.rgb = vertex_colour.rgb * sqrt(light);
  surface.a = dot(vertex_colour.rgb * vertex_colour.rgb, vec3(0.30, 0.59, 0.11)) * vertex_matt.x;
#ifdef TEXTURED
  uv = vertex_uv;
#endif
#ifdef TRANSPARENT
  alpha = vertex_colour.a;
#else
  facing = towards;
#endif
}
)";

inline constexpr const char* kFragmentShader = R"(
in vec4 surface;
#ifdef TEXTURED
in vec2 uv;
uniform sampler2D picture;
#endif
layout(location = 0) out vec4 colour;
#ifdef TRANSPARENT
in float alpha;
#else
uniform vec4 ray;           // pixel -> x / z, y / z: two factors, two offsets
uniform uint instance;
in float facing;
layout(location = 1) out uint facts;   // instance, reflectance << 16, incidence << 24
#endif
void main() {
  vec4 seen = surface;
#ifdef TEXTURED
  vec3 texel = texture(picture, uv).rgb;
  seen *= vec4(texel, dot(texel * texel, vec3(0.30, 0.59, 0.11)));
#endif
#ifdef TRANSPARENT
  colour = vec4(seen.rgb, alpha);
#else
  colour = vec4(seen.rgb, 1.0);
  vec2 ray_xy = gl_FragCoord.xy * ray.xy + ray.zw;
  float cosine = abs(facing) * gl_FragCoord.w * inversesqrt(1.0 + dot(ray_xy, ray_xy));
  uint reflected = uint(min(seen.a, 1.0) * 255.0 + 0.5), turned = uint(min(cosine, 1.0) * 255.0 + 0.5);
  facts = instance | (reflected << 16u) | (turned << 24u);
#endif
}
)";

}  // namespace amiss::sim::internal
