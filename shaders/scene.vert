// The vertex stage of every pass that draws the scene. One invariant position serves them all, so
// that a fragment has the same depth wherever it is drawn.
// SHADOW: from the light's view. POSITION_ONLY: no attributes. UV_ONLY: for alpha tests. WITH_IDS: ids
// besides the position. LIT with VERTEX_LIGHT, for predictions: the light that reaches the vertex on both
// of its sides, in place of the inputs of per-fragment lighting; where neither textures (TEXTURED) nor
// alpha tests (HOLED) need it separately, the lit colours of both sides.
#include "lib/frame.glsl"
#include "lib/scene.glsl"
#if defined(LIT) && defined(VERTEX_LIGHT)
#include "lib/lighting.glsl"
#endif
#if defined(VERTEX_LIGHT) && !defined(TEXTURED) && !defined(HOLED)
#define VERTEX_LAYER
#include "lib/predicted_layer.glsl"
#endif

layout(location = ATTR_POSITION) in vec3 position;
layout(location = ATTR_INSTANCE) in uint instanceNumber;
#ifndef POSITION_ONLY
layout(location = ATTR_UV0) in vec2 uv0;
layout(location = ATTR_UV1) in vec2 uv1;
layout(location = ATTR_COLOR) in vec4 color;
#ifndef UV_ONLY
layout(location = ATTR_NORMAL) in vec3 normal;
layout(location = ATTR_TANGENT) in vec4 tangent;
#endif
#endif

#ifdef SHADOW
layout(location = 0) uniform mat4 shadowViewProjection;
#endif

invariant gl_Position;

#ifdef VERTEX_LAYER
layout(location = 3) out vec4 outFrontLayer;  // of the side that is wound counter-clockwise
layout(location = 4) out vec4 outBackLayer;
#else
#if !defined(POSITION_ONLY) || defined(WITH_IDS)
layout(location = 2) flat out uvec3 outIds;  // material, id of the first triangle, id step
#endif
#ifndef POSITION_ONLY
layout(location = 0) out vec4 outUv;  // xy: first set, zw: second
layout(location = 1) out vec4 outColor;
#ifndef UV_ONLY
#if defined(LIT) && defined(VERTEX_LIGHT)
layout(location = 3) out vec3 outFrontLight;
layout(location = 4) out vec3 outBackLight;
#else
layout(location = 3) out vec3 outPosition;
layout(location = 4) out vec3 outNormal;
layout(location = 5) out vec4 outTangent;
#endif
layout(location = 6) flat out float outMirror;
#endif
#endif
#endif

#if !defined(POSITION_ONLY) && !defined(UV_ONLY)
/// Not of unit length.
vec3 turnedNormal(Instance instance) {
  return vec3(dot(instance.normalRow0.xyz, normal), dot(instance.normalRow1.xyz, normal),
              dot(instance.normalRow2.xyz, normal));
}
#endif

void main() {
  Instance instance = instances[instanceNumber];
  vec4 local = vec4(position, 1.0);
  vec3 world =
      vec3(dot(instance.modelRow0, local), dot(instance.modelRow1, local), dot(instance.modelRow2, local));
#ifdef SHADOW
  gl_Position = shadowViewProjection * vec4(world, 1.0);
#else
  gl_Position = frame.viewProjection * vec4(world, 1.0);
#endif
#if defined(LIT) && defined(VERTEX_LIGHT)
  vec3 turned = turnedNormal(instance);
  vec3 n = dot(turned, turned) > 0.0 ? normalize(turned) : vec3(0.0, 1.0, 0.0);
  vec3 frontLight = ambientRadiance(n) + irradianceAt(world, n) / kPi;
  vec3 backLight = ambientRadiance(-n) + irradianceAt(world, -n) / kPi;
#endif
#ifdef VERTEX_LAYER
#ifndef LIT
  const vec3 frontLight = vec3(1.0);
  const vec3 backLight = vec3(1.0);
#endif
  // Single-sided runs show front faces only; for the others a mirroring transform swaps the sides.
  MaterialData m = materials[instance.ids.x];
  bool twoSided = (m.flags.x & MATERIAL_DOUBLE_SIDED) != 0u;
  bool mirrors = twoSided && instance.normalRow0.w < 0.0;
  vec4 front = predictedLayer(m, m.baseColor * color, frontLight);
  vec4 back = twoSided ? predictedLayer(m, m.baseColor * color, backLight) : front;
  outFrontLayer = mirrors ? back : front;
  outBackLayer = mirrors ? front : back;
#else
#if !defined(POSITION_ONLY) || defined(WITH_IDS)
  outIds = instance.ids.xyz;
#endif
#ifndef POSITION_ONLY
  outUv = vec4(uv0, uv1);
  outColor = color;
#ifndef UV_ONLY
#if defined(LIT) && defined(VERTEX_LIGHT)
  outFrontLight = frontLight;
  outBackLight = backLight;
#else
  outPosition = world;
  outNormal = turnedNormal(instance);
  outTangent = vec4(dot(instance.modelRow0.xyz, tangent.xyz), dot(instance.modelRow1.xyz, tangent.xyz),
                    dot(instance.modelRow2.xyz, tangent.xyz), tangent.w);
#endif
  outMirror = instance.normalRow0.w;
#endif
#endif
#endif
}
