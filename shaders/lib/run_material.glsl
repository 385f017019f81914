// The material of the run that is drawn.
#include "shared/bindings.h"
#include "shared/scene_data.h"

layout(std140, binding = UBO_MATERIAL) uniform MaterialUniforms { MaterialData material; };

/// glTF 2.0, section 3.9.4: OPAQUE ignores alpha, MASK cuts it.
float alphaOf(float alpha) {
  if ((material.flags.x & MATERIAL_BLEND) != 0u) return alpha;
  return (material.flags.x & MATERIAL_MASK) != 0u ? step(material.surface.w, alpha) : 1.0;
}
