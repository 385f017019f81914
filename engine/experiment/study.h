// Reading the part of an experiment that says what is measured where.
#pragma once

#include "engine/experiment/experiment.h"
#include "engine/settings/typed_reader.h"

namespace macula::experiment {

/// Reads the keys that a study and the experiment's top level share into `study`, whose present
/// values stand where a key is missing.
void readStudyKeys(settings::TypedReader& reader, Study& study);

/// Fills what may be left out and checks the names.
/// @throws InputError naming the study's place
void completeStudy(Study& study, const std::vector<Variant>& variants);

/// Throws where `name` is none of `known`.
/// @param what the name should be, "variant"
void requireKnown(const std::string& name, const std::vector<std::string>& known,
                  std::string_view what, std::string_view place);

}  // namespace macula::experiment
