#include "chart_oracle.h"

#include "engine/core/error.h"

namespace macula::tools {

// HOOK: the oracles of engine/measure belong here. Read the fragments of `reference`, let the
// oracle choose k, and return its image; everything else of the experiment is ready for it.
OracleAnswer askOracle(experiment::Oracle oracle, const Contender&, const Stage&, std::uint64_t) {
  failInput("the oracle '{}' is not part of this build", experiment::nameOf(oracle));
}

}  // namespace macula::tools
