// Reading what the results of an experiment are held against.
#pragma once

#include "engine/experiment/experiment.h"
#include "engine/settings/typed_reader.h"

namespace macula::experiment {

/// Reads a [[target]] of an experiment whose variants and studies are read.
/// @throws InputError naming the place, see parseExperiment()
[[nodiscard]] Target readTarget(settings::TypedReader& reader, const Experiment& experiment);

}  // namespace macula::experiment
