// Samples to pixels, exposure, tone curve, encoding for the display.
#pragma once

#include <string>

#include "engine/frame/pass.h"
#include "engine/frame/pass_context.h"

namespace macula::passes {

class TonemapPass final : public frame::Pass {
 public:
  struct Settings {
    std::string curve = "neutral";  ///< none, neutral, aces
    double exposure = 0.0;          ///< stops
    int ssaa = 1;                   ///< samples per axis of a pixel: 1, 2, 4
    bool linearOut = false;         ///< also write the image before encoding
  };
  explicit TonemapPass(const Settings& settings) : settings_(settings) {}
  [[nodiscard]] std::string_view name() const override { return "tonemap"; }
  void declare(frame::PassDeclaration& d, const frame::FrameInputs& in) const override;
  [[nodiscard]] bool hasWork(const frame::FrameInputs& in) const override;
  [[nodiscard]] std::string reason(const frame::FrameInputs& in) const override;
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;
  void execute(frame::PassContext& context) override;

 private:
  const Settings& settings_;
  GLuint program_ = 0;
};

}  // namespace macula::passes
