// macula replay of a recording: the frames of a walk once more, bit for bit.
#pragma once

#include "replay.h"

namespace macula::tools {

/// Does to a renderer what was done to that of the walk, frame by frame, and writes images and
/// report; where the recording holds image hashes, compares them.
/// @param options its scene is the folder; its settings become those of the recording
/// @throws InputError where the folder is no recording, or options were given that it answers
/// @throws Difference where an image is not the recorded one
void replayRecording(ReplayOptions& options);

}  // namespace macula::tools
