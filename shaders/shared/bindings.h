// Binding numbers, once for C++ and GLSL.
#ifndef MACULA_SHARED_BINDINGS_H
#define MACULA_SHARED_BINDINGS_H

// Uniform buffers
#define UBO_FRAME 0
#define UBO_LIGHTS 1
#define UBO_MATERIAL 2

// Shader storage buffers. Every device has 8 bindings (OpenGL 4.5, chapter 23), so buffers that no
// pass uses together share one.
#define SSBO_FRAGMENT_KEYS 0
#define SSBO_FRAGMENT_COLORS 1
#define SSBO_OIT_TOTALS 2
#define SSBO_FRAGMENT_LINKS 3
#define SSBO_STRIP_SUMS 3
#define SSBO_DEEP_TILES 3
#define SSBO_NETWORK_VALUES 3
#define SSBO_SLICES 4
#define SSBO_OCCUPANCY 4
#define SSBO_OIT_STATISTICS 4
#define SSBO_COVERED 5
#define SSBO_LOD_TOTALS 0
#define SSBO_LOD_TILES 1
#define SSBO_LOD_HOLES 2

// Textures of a material (one draw run each)
#define TEX_BASE_COLOR 0
#define TEX_METALLIC_ROUGHNESS 1
#define TEX_NORMAL 2
#define TEX_OCCLUSION 3
#define TEX_EMISSIVE 4
#define MATERIAL_TEXTURES 5
// Textures of the lighting
#define TEX_SHADOW_MAP 5
#define TEX_ENVIRONMENT 6
// Inputs of a full-screen pass
#define TEX_INPUT0 8
#define TEX_INPUT1 9
#define TEX_INPUT2 10
#define TEX_INPUT3 11
#define TEX_INPUT4 12
#define TEX_INPUT5 13
#define TEX_INPUT6 14

// Images
#define IMG_0 0
#define IMG_1 1
#define IMG_2 2
#define IMG_3 3
#define IMG_4 4

// Vertex attributes
#define ATTR_POSITION 0
#define ATTR_NORMAL 1
#define ATTR_TANGENT 2
#define ATTR_UV0 3
#define ATTR_UV1 4
#define ATTR_COLOR 5
// Of an instance
#define ATTR_MODEL_ROWS 6   // three
#define ATTR_NORMAL_ROWS 9  // three
#define ATTR_IDS 12

#endif
