#include "walk/second_view.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/core/error.h"
#include "engine/ui/widgets.h"
#include "passes/resources.h"
#include "shared/bindings.h"
#include "shared/dispatch.h"

namespace macula::tools {
namespace {

constexpr float kFirstScale = 8.0F;  ///< shows differences from 1/8 down to a few 255ths
constexpr float kMostScale = 128.0F;
constexpr float kLeastSplit = 0.02F;  ///< the line never leaves the window

/// What is first set against a method: the exact image.
constexpr const char* kFirstSecond = "ab-sbuffer";

/// Settings that method B does not have to itself.
void copyShared(const passes::RenderSettings& from, passes::RenderSettings& to) {
  const passes::OitSettings oit = to.oit;
  const passes::ImportanceSettings importance = to.importance;
  to = from;
  to.oit = oit;
  to.importance = importance;
}

}  // namespace

const std::vector<std::string>& viewModeNames() {
  static const std::vector<std::string> names{"one", "split", "side", "difference"};
  return names;
}

SecondView::SecondView(const passes::RenderSettings& first, passes::DeviceContext& device)
    : first_(first), device_(device), panel_(registry_), scale_(kFirstScale) {
  passes::registerSettings(registry_, settings_);
  settings_.oit.method = kFirstSecond;
}

void SecondView::setMode(ViewMode mode) {
  mode_ = mode;
  dragging_ = false;
  if (shown()) return;
  dropRenderer();
  difference_ = {};
  time_ = {};
}

glm::ivec2 SecondView::pictureSize(glm::ivec2 window) const {
  if (mode_ != ViewMode::SideBySide) return window;
  return {std::max(1, window.x / 2), window.y};
}

void SecondView::dropRenderer() {
  renderer_.reset();
  result_ = {};  // it names passes of the renderer
}

void SecondView::waitForResult() {
  if (shown() && renderer_) result_ = renderer_->waitForResult();
}

void SecondView::adoptResult(const passes::FrameResult& result) {
  result_ = result;
  if (result.timed) time_.add(settings_.oit.method, result.totalMs);
}

void SecondView::makeRenderer(const FrameEvents& events, const scene::GpuScene& gpu) {
  renderer_ = std::make_unique<passes::FrameRenderer>(settings_, device_);
  renderer_->resize(events.pictureSize);
  renderer_->setScene(gpu);
}

void SecondView::render(const FrameEvents& events, const scene::GpuScene& gpu, bool firstChanged,
                        const passes::Wanted& wanted) {
  std::optional<ui::SettingChange> change = panel_.takeChange();
  copyShared(first_, settings_);
  const auto draw = [&](bool changed) {
    const bool begins = !renderer_ || changed;
    if (!renderer_) {
      makeRenderer(events, gpu);
    } else if (changed) {
      renderer_->resize(events.pictureSize);
    }
    renderer_->want(wanted);
    if (begins) return adoptResult(renderer_->render(events.camera, events.gaze, events.cut));
    renderer_->draw(events.camera, events.gaze, events.cut);
    if (const auto result = renderer_->takeResult()) adoptResult(*result);
  };
  bool changed = firstChanged || change;
  for (;;) {
    try {
      draw(changed);
      return;
    } catch (const InputError& error) {
      if (!change) throw;
      panel_.setRefusal(error.what());
      if (change->cycled && change->advance()) continue;
      change->undo();
      change.reset();
      changed = true;
    }
  }
}

void SecondView::compose(const Screen& screen, const passes::FrameRenderer& first,
                         glm::ivec2 window) {
  const gl::Texture& a = first.shownTexture();
  if (!shown() || !renderer_) {
    screen.show(a);
    return;
  }
  const gl::Texture& b = renderer_->shownTexture();
  const glm::ivec2 size(a.width(), a.height());
  switch (mode_) {
    case ViewMode::Split: {
      const int line = static_cast<int>(split_ * static_cast<float>(size.x));
      screen.show(a, {{0, 0}, {line, size.y}}, {0, 0});
      screen.show(b, {{line, 0}, {size.x - line, size.y}}, {line, 0});
      break;
    }
    case ViewMode::SideBySide:
      screen.clear(glm::vec3(0.0F));  // a column is left over where the width is odd
      screen.show(a);
      screen.show(b, {{0, 0}, size}, {window.x - size.x, 0});
      break;
    case ViewMode::Difference:
      // Of the images, never of false colours.
      drawDifference(
          first.resources().textureFor(passes::kDisplayColor, GL_TEXTURE_FETCH_BARRIER_BIT),
          renderer_->resources().textureFor(passes::kDisplayColor, GL_TEXTURE_FETCH_BARRIER_BIT));
      screen.show(difference_);
      break;
    case ViewMode::One:
      break;
  }
}

void SecondView::drawDifference(const gl::Texture& first, const gl::Texture& second) {
  const glm::ivec2 size(first.width(), first.height());
  if (difference_.width() != size.x || difference_.height() != size.y) {
    difference_ = gl::Texture("difference map", GL_RGBA8, size.x, size.y);
  }
  glUseProgram(device_.programs.get({{"difference.comp"}, {}, {}}));
  glUniform1f(0, scale_);
  glBindTextureUnit(TEX_INPUT0, first.id());
  glBindTextureUnit(TEX_INPUT1, second.id());
  glBindImageTexture(IMG_0, difference_.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
  const glm::ivec2 groups = (size + FULLSCREEN_GROUP - 1) / FULLSCREEN_GROUP;
  glDispatchCompute(static_cast<GLuint>(groups.x), static_cast<GLuint>(groups.y), 1);
}

image::Legend SecondView::differenceLegend() const {
  return {fmt::format("largest |A - B| of R, G, B, times {:g}", scale_),
          1.0 / static_cast<double>(scale_), true, "equal"};
}

void SecondView::scaleDifference(bool up) {
  // "Up" is a legend that reaches further, so that less is amplified.
  scale_ = std::clamp(up ? 0.5F * scale_ : 2.0F * scale_, 1.0F, kMostScale);
}

void SecondView::drawOverlay(const ui::MethodTime& first, bool pointerFree, float top) {
  if (mode_ != ViewMode::Split && mode_ != ViewMode::SideBySide) return;
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 size = io.DisplaySize;
  constexpr float kMiddle = 0.5F;
  float x = std::floor((mode_ == ViewMode::Split ? split_ : kMiddle) * size.x);
  if (mode_ == ViewMode::Split) {
    const float reach = 0.6F * ImGui::GetFontSize();
    const bool over = pointerFree && std::abs(io.MousePos.x - x) <= reach;
    if (over && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) dragging_ = true;
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) dragging_ = false;
    if (dragging_) {
      split_ = std::clamp(io.MousePos.x / size.x, kLeastSplit, 1.0F - kLeastSplit);
      x = std::floor(split_ * size.x);
    }
    if (over || dragging_) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  }
  ImDrawList* list = ImGui::GetBackgroundDrawList();
  list->AddLine({x, 0.0F}, {x, size.y}, IM_COL32(0, 0, 0, 200), 3.0F);
  list->AddLine({x, 0.0F}, {x, size.y}, IM_COL32(255, 255, 255, 220), 1.0F);
  if (mode_ == ViewMode::Split) {
    const float grip = 0.5F * ImGui::GetFontSize();
    list->AddCircleFilled({x, 0.5F * size.y}, grip, IM_COL32(255, 255, 255, 230));
    list->AddCircle({x, 0.5F * size.y}, grip, IM_COL32(0, 0, 0, 200), 0, 1.5F);
  }
  const float gap = 0.6F * ImGui::GetFontSize();
  const auto label = [](const ui::MethodTime& time) {
    return fmt::format("{}  {:.1f} ms", time.method(), time.medianMs());
  };
  ui::pictureLabel(label(first), {x - gap, top}, 1.0F);
  ui::pictureLabel(label(time_), {x + gap, top}, 0.0F);
}

}  // namespace macula::tools
