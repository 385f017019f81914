// Instances and materials.
#include "shared/bindings.h"
#include "shared/scene_data.h"

layout(std430, binding = SSBO_INSTANCES) readonly buffer Instances { Instance instances[]; };
layout(std430, binding = SSBO_MATERIALS) readonly buffer Materials { MaterialData materials[]; };

/// glTF 2.0, section 3.9.4: OPAQUE ignores alpha, MASK cuts it.
float alphaOf(MaterialData m, float alpha) {
  if ((m.flags.x & MATERIAL_BLEND) != 0u) return alpha;
  return (m.flags.x & MATERIAL_MASK) != 0u ? step(m.surface.w, alpha) : 1.0;
}
