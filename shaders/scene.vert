// The vertex stage of every pass that draws the scene. One invariant position serves them all, so
// that a fragment has the same depth wherever it is drawn. What a program's fragment stage does not
// read is removed by the linker.
// SHADOW: from the light's view. POSITION_ONLY: no attributes. UV_ONLY: for alpha tests. WITH_IDS: ids
// besides the position. VERTEX_COLOR, TEXTURED, SECOND_UV: see lib/material.glsl. LIT with
// VERTEX_LIGHT, for predictions: the light that reaches the vertex on both of its sides, in place of the
// inputs of per-fragment lighting; where neither textures nor alpha tests (HOLED) need it separately, the
// lit colours of both sides.
#include "lib/frame.glsl"
#include "shared/bindings.h"
#if !defined(POSITION_ONLY) && (defined(VERTEX_COLOR) || defined(VERTEX_LIGHT))
#include "lib/run_material.glsl"
#endif
#if defined(LIT) && defined(VERTEX_LIGHT)
#include "lib/lighting.glsl"
#endif
#if defined(VERTEX_LIGHT) && !defined(TEXTURED) && !defined(HOLED)
#define VERTEX_LAYER
#include "lib/predicted_layer.glsl"
#endif

layout(location = ATTR_POSITION) in vec3 position;
// Rows of the 3x4 object-to-world matrix.
layout(location = ATTR_MODEL_ROWS) in vec4 modelRows[3];
#ifndef POSITION_ONLY
layout(location = ATTR_UV0) in vec2 uv0;
layout(location = ATTR_UV1) in vec2 uv1;
layout(location = ATTR_COLOR) in vec4 color;
#ifndef UV_ONLY
layout(location = ATTR_NORMAL) in vec3 normal;
layout(location = ATTR_TANGENT) in vec4 tangent;
// Rows of the inverse transpose; w of the first: -1 where the transform mirrors, else 1.
layout(location = ATTR_NORMAL_ROWS) in vec4 normalRows[3];
#endif
#endif
layout(location = ATTR_IDS) in uvec2 ids;  // id of the first triangle, step of the id (1 or -1 as uint)

#ifdef SHADOW
layout(location = 0) uniform mat4 shadowViewProjection;
#endif

invariant gl_Position;

#ifdef VERTEX_LAYER
layout(location = 3) out vec4 outFrontLayer;  // of the side that is wound counter-clockwise
layout(location = 4) out vec4 outBackLayer;
#else
#if !defined(POSITION_ONLY) || defined(WITH_IDS)
layout(location = 2) flat out uvec2 outIds;
#endif
#ifndef POSITION_ONLY
#ifdef SECOND_UV
layout(location = 0) out vec4 outUv;  // xy: first set, zw: second
#else
layout(location = 0) out vec2 outUv;
#endif
#ifdef VERTEX_COLOR
// The base colour: the product is linear over a triangle, too.
layout(location = 1) out vec4 outColor;
#endif
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

/// A direction of the object in the world.
vec3 turned(vec3 v, vec4 rows[3]) {
  return vec3(dot(rows[0].xyz, v), dot(rows[1].xyz, v), dot(rows[2].xyz, v));
}

void main() {
  vec4 local = vec4(position, 1.0);
  vec3 world = vec3(dot(modelRows[0], local), dot(modelRows[1], local), dot(modelRows[2], local));
#ifdef SHADOW
  gl_Position = shadowViewProjection * vec4(world, 1.0);
#else
  gl_Position = frame.viewProjection * vec4(world, 1.0);
#endif
#if defined(LIT) && defined(VERTEX_LIGHT)
  vec3 direction = turned(normal, normalRows);
  vec3 n = dot(direction, direction) > 0.0 ? normalize(direction) : vec3(0.0, 1.0, 0.0);
  vec3 frontLight = ambientRadiance(n) + irradianceAt(world, n) / kPi;
#ifdef DOUBLE_SIDED
  vec3 backLight = ambientRadiance(-n) + irradianceAt(world, -n) / kPi;
#else
  vec3 backLight = frontLight;
#endif
#endif
#ifdef VERTEX_LAYER
#ifndef LIT
  const vec3 frontLight = vec3(1.0);
  const vec3 backLight = vec3(1.0);
#endif
#ifdef VERTEX_COLOR
  vec4 base = material.baseColor * color;
#else
  vec4 base = material.baseColor;
#endif
  // Single-sided runs show front faces only; for the others a mirroring transform swaps the sides.
  vec4 front = predictedLayer(base, frontLight);
#ifdef DOUBLE_SIDED
  vec4 back = predictedLayer(base, backLight);
  bool mirrors = normalRows[0].w < 0.0;
  outFrontLayer = mirrors ? back : front;
  outBackLayer = mirrors ? front : back;
#else
  outFrontLayer = outBackLayer = front;
#endif
#else
#if !defined(POSITION_ONLY) || defined(WITH_IDS)
  outIds = ids;
#endif
#ifndef POSITION_ONLY
#ifdef SECOND_UV
  outUv = vec4(uv0, uv1);
#else
  outUv = uv0;
#endif
#ifdef VERTEX_COLOR
  outColor = material.baseColor * color;
#endif
#ifndef UV_ONLY
#if defined(LIT) && defined(VERTEX_LIGHT)
  outFrontLight = frontLight;
  outBackLight = backLight;
#else
  outPosition = world;
  outNormal = turned(normal, normalRows);  // not of unit length
  outTangent = vec4(turned(tangent.xyz, modelRows), tangent.w);
#endif
  outMirror = normalRows[0].w;
#endif
#endif
#endif
}
