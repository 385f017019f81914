// Materials, textures and samplers of a glTF file: specification sections 3.8 and 3.9.
#pragma once

#include "engine/scene/gltf_document.h"
#include "engine/scene/gltf_loader.h"

namespace macula::scene::gltf {

/// Fills scene.materials and scene.images, both in the order of the file; decodes the images that
/// the materials read.
/// @throws InputError on a texture, sampler or image index that leads nowhere
void readMaterials(Document& document, const GltfLimits& limits, Scene& scene);

}  // namespace macula::scene::gltf
