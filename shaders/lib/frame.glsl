// The constants of the frame.
#include "shared/bindings.h"
#include "shared/frame_constants.h"

layout(std140, binding = UBO_FRAME) uniform FrameBlock { FrameConstants frame; };
