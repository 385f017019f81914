// Ambient occlusion found on the screen, in the manner of Crytek's (Mittring 2007, "Finding Next
// Gen"): points around a surface point that lie behind what the depth buffer shows are taken for
// occluded. The same points for every pixel: a smooth signal, which a lower rate can carry.
// Needs depthTexture.

const float kGoldenAngle = 2.39996322972865;
/// Kronecker sequence of the plastic number's square: spreads the distances over the directions.
const float kDistanceStep = 0.569840290998;
/// Points as near as this share of the radius belong to the surface itself.
const float kSurfaceShare = 0.02;

/// 1: nothing occludes. Directions are cosine-distributed about the normal: a unit sphere on it.
float ambientOcclusion(vec3 position, vec3 normal, float radius, int samples) {
  mat2 turn = mat2(cos(kGoldenAngle), sin(kGoldenAngle), -sin(kGoldenAngle), cos(kGoldenAngle));
  vec2 around = vec2(1.0, 0.0);
  float occluded = 0.0;
  float inverse = 1.0 / float(samples);
  for (int i = 0; i < samples; ++i) {
    float z = 1.0 - (2.0 * float(i) + 1.0) * inverse;
    vec3 sphere = vec3(around * sqrt(1.0 - z * z), z);
    around = turn * around;
    float share = fract(0.5 + kDistanceStep * float(i));
    vec3 toPoint = normalize(normal * 1.001 + sphere) * (radius * mix(kSurfaceShare, 1.0, share * share));
    vec4 clip = frame.viewProjection * vec4(position + toPoint, 1.0);
    vec2 uv = clip.xy / clip.w * 0.5 + 0.5;
    float depth = textureLod(depthTexture, uv, 0.0).r;
    float behind = clip.w - 1.0 / (depth * frame.depthScale + frame.depthOffset);
    // What stands far before the point does not occlude it: there is air between.
    float near = clamp(2.0 - behind / radius, 0.0, 1.0);
    occluded += behind > kSurfaceShare * radius ? near : 0.0;
  }
  return 1.0 - occluded * inverse;
}
