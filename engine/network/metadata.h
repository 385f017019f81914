// The texts of a network's file: names, normalisation, where it came from.
#pragma once

#include <map>
#include <string>

#include "engine/network/network.h"

namespace macula::network {

/// A network without layers. Further keys are left alone.
/// @param name of the file in messages
/// @throws InputError naming file, key and mend
[[nodiscard]] Network parseMetadata(const std::map<std::string, std::string>& metadata,
                                    const std::string& name);

}  // namespace macula::network
