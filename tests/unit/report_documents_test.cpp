// What docs/ says of reports is current, or MACULA_UPDATE=1 writes it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "engine/core/file.h"
#include "engine/measure/report_document.h"
#include "engine/measure/report_schema.h"

namespace macula::measure {
namespace {

void expectCurrent(const char* name, const std::string& text) {
  const std::string file = std::string(MACULA_SOURCE_DIR "/docs/") + name;
  if (std::getenv("MACULA_UPDATE") != nullptr) writeFileAtomically(file, text);
  EXPECT_TRUE(readTextFile(file) == text)
      << file << " is not current: run this test with MACULA_UPDATE=1";
}

TEST(Documents, SchemaOfTheReport) {
  expectCurrent("report.schema.json", reportSchema().dump(2) + "\n");
}

TEST(Documents, PageOfTheReport) {
  expectCurrent("report.md", reportDocument());
}

}  // namespace
}  // namespace macula::measure
