// The material of the run that is drawn. ALPHA_BLEND, ALPHA_MASK: its alphaMode (glTF 2.0, section 3.9.4);
// neither: OPAQUE, which ignores alpha.
#include "shared/bindings.h"
#include "shared/scene_data.h"

layout(std140, binding = UBO_MATERIAL) uniform MaterialUniforms { MaterialData material; };

float alphaOf(float alpha) {
#if defined(ALPHA_BLEND)
  return alpha;
#elif defined(ALPHA_MASK)
  return step(material.surface.w, alpha);
#else
  return 1.0;
#endif
}
