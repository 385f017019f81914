// The device context: what was measured of this device once, before the first frame.
#pragma once

#include <utility>

#include "engine/core/file.h"
#include "engine/gl/capabilities.h"
#include "engine/gl/program.h"
#include "engine/gl/time_source.h"
#include "passes/oit/ordering.h"

namespace macula::passes {

/// Needs a current context and must go before it does.
struct DeviceContext {
  gl::Capabilities capabilities;
  gl::ProgramCache programs;
  gl::TimeSourceCheck time;
  OrderedCheck ordered;

  DeviceContext() : DeviceContext(userBinaries()) {}
  /// @param binaries of programs that were linked before
  explicit DeviceContext(gl::ProgramBinaries binaries)
      : capabilities(gl::readCapabilities()),
        programs(dataFolder("shaders"), std::move(binaries)),
        time(gl::checkTimeSource(programs)),
        ordered(checkOrdered(capabilities, programs)) {
    sumInGroups(!capabilities.isSoftware);
  }

  /// Whether the threads of a work-group add up together (shaders/lib/tile.glsl), as suits a GPU,
  /// or each by itself, as suits a processor. Changes the time that programs take which are made
  /// from now on, and no result.
  void sumInGroups(bool together) {
    programs.setDefines(together ? gl::Defines{{"GROUP_SUMS", "1"}} : gl::Defines{});
  }

 private:
  static gl::ProgramBinaries userBinaries() {
    const auto folder = gl::programBinaryFolder();
    return folder ? gl::ProgramBinaries(*folder) : gl::ProgramBinaries();
  }
};

}  // namespace macula::passes
