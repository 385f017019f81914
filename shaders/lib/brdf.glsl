// The glTF metallic-roughness model (glTF 2.0 specification, appendix B).

const float kPi = 3.14159265358979;
/// Reflectance of dielectrics at normal incidence: index of refraction 1.5 (appendix B.2.2).
const float kDielectricF0 = 0.04;
/// Below this a highlight is smaller than a pixel and GGX overflows half floats.
const float kMinRoughness = 0.045;

struct Reflection {
  vec3 diffuse;   // diffuse albedo
  vec3 f0;        // specular reflectance at normal incidence
  float alpha;    // GGX roughness, perceptual roughness squared
};

Reflection reflectionOf(vec3 baseColor, float metallic, float roughness) {
  Reflection r;
  r.diffuse = baseColor * (1.0 - metallic);
  r.f0 = mix(vec3(kDielectricF0), baseColor, metallic);
  float rough = max(roughness, kMinRoughness);
  r.alpha = rough * rough;
  return r;
}

vec3 fresnelSchlick(vec3 f0, float vDotH) {
  float x = 1.0 - vDotH;
  float x2 = x * x;
  return f0 + (1.0 - f0) * (x2 * x2 * x);
}

/// Derivative of fresnelSchlick() by f0.
float fresnelSlope(float vDotH) {
  float x = 1.0 - vDotH;
  float x2 = x * x;
  return 1.0 - x2 * x2 * x;
}

/// GGX distribution times height-correlated Smith visibility (appendix B.3.2; Heitz 2014).
float specularGgx(float alpha, float nDotH, float nDotL, float nDotV) {
  float a2 = alpha * alpha;
  float d = nDotH * nDotH * (a2 - 1.0) + 1.0;
  float v = nDotL * sqrt(nDotV * nDotV * (1.0 - a2) + a2) +
            nDotV * sqrt(nDotL * nDotL * (1.0 - a2) + a2);
  return a2 / (kPi * d * d) * 0.5 / max(v, 1e-5);  // v vanishes where both angles are grazing
}

/// Directional albedo of the specular lobe, fitted (Karis 2014, "Physically Based Shading on
/// Mobile"): x times the reflectance at normal incidence, plus y.
vec2 environmentBrdf(float roughness, float nDotV) {
  const vec4 c0 = vec4(-1.0, -0.0275, -0.572, 0.022);
  const vec4 c1 = vec4(1.0, 0.0425, 1.04, -0.04);
  vec4 r = roughness * c0 + c1;
  float a004 = min(r.x * r.x, exp2(-9.28 * nDotV)) * r.x + r.y;
  return vec2(-1.04, 1.04) * a004 + r.zw;
}
