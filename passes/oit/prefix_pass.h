// Sums of all strips before each strip: in its row, then over the rows.
#pragma once

#include "passes/oit/oit_pass.h"

namespace macula::passes {

class PrefixPass final : public OitPass {
 public:
  /// @param rows false: a row's strips, by a thread a row; true: the rows, by one thread
  PrefixPass(const OitPlan& plan, bool rows)
      : OitPass(plan), rows_(rows), name_(rows ? "oit.prefixRows" : "oit.prefix") {}
  [[nodiscard]] std::string_view name() const override { return name_; }
  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override;

 private:
  [[nodiscard]] bool wanted() const override;
  void declareWork(frame::PassDeclaration& d) const override;
  void run(frame::PassContext& context) override;

  bool rows_;
  std::string_view name_;
  GLuint program_ = 0;
};

}  // namespace macula::passes
