// Checks the order of a frame without GL.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/frame/binding.h"

namespace macula::frame {

/// One pass as validation sees it.
struct DeclaredPass {
  std::string_view name;
  PassDeclaration table;
};

/// Problems of a frame, one line each; empty where it is sound. Only active rows count. Found are:
/// two passes of one name; two rows of one step at one unit, or alike; a read that no earlier pass
/// or step wrote, of a resource without initial contents; a write that no pass reads; a write over
/// contents that no pass has read; history that is overwritten before it is read; a resource that
/// is bound as what it is not; and sizes that are missing or differ.
/// @param results resources that leave the frame (shown or read back)
[[nodiscard]] std::vector<std::string> validate(std::span<const DeclaredPass> passes,
                                                std::span<const Resource* const> results);

}  // namespace macula::frame
