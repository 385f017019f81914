// Checks the order of a frame without GL.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/frame/pass.h"

namespace macula::frame {

/// One pass as validation sees it.
struct DeclaredPass {
  std::string_view name;
  std::vector<Touch> touches;
};

/// Problems of a frame, one line each; empty where it is sound. Found are: two passes of one name,
/// a resource touched twice by one pass, a read that no earlier pass wrote and that has no clear
/// value, a write that nobody reads, a write over a result that nobody read, and history that is
/// overwritten before it is read.
/// @param results resources that leave the frame (shown or read back)
[[nodiscard]] std::vector<std::string> validate(std::span<const DeclaredPass> passes,
                                                std::span<const Resource> results);

}  // namespace macula::frame
