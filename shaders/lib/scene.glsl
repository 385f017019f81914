// Instances and materials.
#include "shared/bindings.h"
#include "shared/scene_data.h"

layout(std430, binding = SSBO_INSTANCES) readonly buffer Instances { Instance instances[]; };
layout(std430, binding = SSBO_MATERIALS) readonly buffer Materials { MaterialData materials[]; };
