// macula schema: the format of report.json and what its numbers mean, for docs/.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "engine/measure/report_document.h"
#include "engine/measure/report_schema.h"

namespace macula::tools {

void addSchema(CLI::App& root) {
  auto page = std::make_shared<bool>(false);
  CLI::App* command =
      root.add_subcommand("schema", "Prints the JSON Schema of replay's report.json");
  command->group("");  // for contributors and tests
  command->add_flag("--page", *page, "What every number means, as Markdown: docs/report.md");
  command->callback([page] {
    fmt::print("{}", *page ? measure::reportDocument() : measure::reportSchema().dump(2) + "\n");
  });
}

}  // namespace macula::tools
