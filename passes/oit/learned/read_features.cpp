#include "passes/oit/learned/read_features.h"

#include <algorithm>
#include <stdexcept>

#include "engine/gl/gl.h"
#include "passes/oit/learned/network_inputs.h"
#include "passes/oit/oit_pass.h"
#include "shared/bindings.h"

namespace macula::passes {
namespace {

GLuint programOf(const network::Network& network, NetworkModel model, int sliceTile,
                 const char* variant, gl::ProgramCache& programs) {
  gl::Defines defines = networkDefines(network, model, sliceTile);
  defines.emplace_back(variant, "1");
  return programs.get({{"oit/network.comp"}, defines, {}});
}

std::vector<float> download(const gl::Buffer& buffer) {
  std::vector<float> values(buffer.bytes() / sizeof(float));
  buffer.download(values.data(), buffer.bytes());
  return values;
}

}  // namespace

std::vector<float> readFeatures(FrameRenderer& renderer, const FrameRenderer& opaque,
                                gl::ProgramCache& programs) {
  const OitPlan& plan = renderer.plan();
  if (plan.network == nullptr || plan.reduced()) {
    throw std::invalid_argument("features are read from a frame with a network, at full rate");
  }
  if (plan.networkModel() == NetworkModel::Learned && !renderer.readBack()) {
    throw std::invalid_argument("features of depth slices are read with RenderSettings::readBack");
  }
  const gl::Texture& behind =
      opaque.resources().textureFor(kHdrColor, GL_TEXTURE_FETCH_BARRIER_BIT);
  if (behind.width() != plan.size.x || behind.height() != plan.size.y) {
    throw std::invalid_argument("features are read with an opaque frame of the same size");
  }
  const auto width = static_cast<std::size_t>(plan.size.x);
  const auto height = static_cast<std::size_t>(plan.size.y);
  const std::size_t row = width * plan.network->features.size();
  const gl::Buffer values("features", row * height * sizeof(float));
  frame::PassDeclaration rows;
  networkInputRows(rows, plan);
  if (plan.networkModel() == NetworkModel::Thesis) totalsRow(rows, frame::Access::Read);
  const std::vector<std::uint32_t> slots = frame::slotsOf(rows, renderer.resources());
  frame::PassContext context = renderer.passContext();
  context.bindConstants(frame::Raster::Image);
  context.beginPass(rows, slots);
  context.beginStep(0);
  // By now transparency lies over the frame's own opaque image.
  if (plan.networkModel() == NetworkModel::Learned) glBindTextureUnit(TEX_INPUT1, behind.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_NETWORK_VALUES, values.id());
  glUseProgram(programOf(*plan.network, plan.networkModel(), plan.importance.tile, "FEATURES_OUT",
                         programs));
  setNetworkUniforms(plan);
  context.dispatch(plan.size, kFullScreenGroup);
  std::vector<float> features = download(values);
  // GL counts rows from the bottom.
  for (std::size_t y = 0; y < height / 2; ++y) {
    const auto at = [&](std::size_t r) {
      return features.begin() + static_cast<std::ptrdiff_t>(r * row);
    };
    std::swap_ranges(at(y), at(y + 1), at(height - 1 - y));
  }
  return features;
}

std::vector<float> evaluateOnGpu(const network::Network& network, NetworkModel model,
                                 const std::vector<float>& features, gl::ProgramCache& programs) {
  const std::size_t inputs = network.features.size();
  const std::size_t outputs = network.outputs.size();
  const std::size_t count = features.size() / inputs;
  std::vector<float> values(count * (inputs + outputs));
  for (std::size_t i = 0; i < count; ++i) {
    std::copy_n(features.begin() + static_cast<std::ptrdiff_t>(i * inputs), inputs,
                values.begin() + static_cast<std::ptrdiff_t>(i * (inputs + outputs)));
  }
  const gl::Buffer buffer("probes", values.size() * sizeof(float), values.data());
  glUseProgram(programOf(network, model, 1, "PROBE", programs));
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_NETWORK_VALUES, buffer.id());
  glDispatchCompute(static_cast<GLuint>((count + LIST_GROUP - 1) / LIST_GROUP), 1, 1);
  values = download(buffer);
  std::vector<float> outputValues;
  for (std::size_t i = 0; i < count; ++i) {
    const auto first =
        values.begin() + static_cast<std::ptrdiff_t>(i * (inputs + outputs) + inputs);
    outputValues.insert(outputValues.end(), first, first + static_cast<std::ptrdiff_t>(outputs));
  }
  return outputValues;
}

}  // namespace macula::passes
