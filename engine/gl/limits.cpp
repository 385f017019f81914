#include "engine/gl/limits.h"

namespace macula::gl {
namespace {

#define ROW(limit, name, what, guaranteed)      \
  LimitRow {                                    \
    Limit::limit, name, #name, what, guaranteed \
  }
constexpr std::array kRows{
    ROW(StorageBindings, GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, "storage bindings", 8),
    ROW(VertexStorageBlocks, GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS,
        "storage blocks of the vertex stage", 0),
    ROW(FragmentStorageBlocks, GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS,
        "storage blocks of the fragment stage", 8),
    ROW(ComputeStorageBlocks, GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS,
        "storage blocks of a compute shader", 8),
    ROW(CombinedStorageBlocks, GL_MAX_COMBINED_SHADER_STORAGE_BLOCKS,
        "storage blocks of all stages together", 8),
    // 4.6 raises it to 2^27.
    ROW(StorageBlockBytes, GL_MAX_SHADER_STORAGE_BLOCK_SIZE, "bytes of a storage block", 1 << 24),
    ROW(ImageUnits, GL_MAX_IMAGE_UNITS, "image units", 8),
    ROW(FragmentImages, GL_MAX_FRAGMENT_IMAGE_UNIFORMS, "images of the fragment stage", 8),
    ROW(ComputeImages, GL_MAX_COMPUTE_IMAGE_UNIFORMS, "images of a compute shader", 8),
    ROW(CombinedImages, GL_MAX_COMBINED_IMAGE_UNIFORMS, "images of all stages together", 8),
    ROW(CombinedOutputs, GL_MAX_COMBINED_SHADER_OUTPUT_RESOURCES,
        "images, storage blocks and outputs together", 8),
    ROW(FragmentTextures, GL_MAX_TEXTURE_IMAGE_UNITS, "textures of the fragment stage", 16),
    ROW(ComputeTextures, GL_MAX_COMPUTE_TEXTURE_IMAGE_UNITS, "textures of a compute shader", 16),
    ROW(TextureUnits, GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, "texture units", 80),
    ROW(ColorAttachments, GL_MAX_COLOR_ATTACHMENTS, "colour attachments", 8),
    ROW(DrawBuffers, GL_MAX_DRAW_BUFFERS, "outputs of the fragment stage", 8),
    ROW(TextureSide, GL_MAX_TEXTURE_SIZE, "texels of a texture's side", 16384),
    ROW(FramebufferWidth, GL_MAX_FRAMEBUFFER_WIDTH, "columns of a framebuffer", 16384),
    ROW(FramebufferHeight, GL_MAX_FRAMEBUFFER_HEIGHT, "rows of a framebuffer", 16384),
    ROW(UniformBindings, GL_MAX_UNIFORM_BUFFER_BINDINGS, "uniform buffer bindings", 84),
    ROW(UniformBlockBytes, GL_MAX_UNIFORM_BLOCK_SIZE, "bytes of a uniform block", 16384),
    ROW(GroupThreads, GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS, "threads of a work group", 1024),
    ROW(GroupBytes, GL_MAX_COMPUTE_SHARED_MEMORY_SIZE, "bytes of a work group's shared memory",
        32768),
};
#undef ROW
static_assert(kRows.size() == kLimits);

}  // namespace

std::span<const LimitRow> limitRows() {
  return kRows;
}

Limits readLimits() {
  Limits limits;
  for (const LimitRow& row : kRows) glGetInteger64v(row.query, &limits[row.limit]);
  return limits;
}

Limits guaranteedLimits() {
  Limits limits;
  for (const LimitRow& row : kRows) limits[row.limit] = row.guaranteed;
  return limits;
}

}  // namespace macula::gl
