#include "engine/measure/report_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "engine/measure/metrics.h"
#include "engine/measure/report_keys.h"

namespace macula::measure {
namespace {

constexpr std::string_view kBegin =
    R"(# Reports: every number, its unit and its meaning

Made from the table of metrics (`engine/measure/metrics.h`) and the keys of the report (`engine/measure/report_keys.h`); `MACULA_UPDATE=1 unit_tests --gtest_filter='Documents.*'` writes it. [report.schema.json](report.schema.json) is the JSON Schema of `report.json` (draft 2020-12), from the same tables.

Every row of the table of metrics is written to all of these, as far as it applies:

| file | written by | place of a metric |
|---|---|---|
| `report.json` | `macula replay` | in each entry of `frames`; bytes once, as of the last frame; `summary` over all frames |
| `results.json` | `macula chart` | in each entry of `points`: `median`, `p5` and `p95` of times over the rounds, other metrics of the last round |
| `results.csv` | `macula chart` | a column; one line for each point. Targets name metrics by these columns |
| `report.html` | `macula chart` | in the table, in the numbers of a point, and in the choices of the axes |
| `results.csv`, `results.json` | `macula hold` | a column, one line for each frame; `summary` over all frames |
| the panel *Numbers*, `--json` | `macula walk` | of the last frame |

)";

constexpr std::string_view kMetricsHead =
    R"(## Metrics

A dot in a name is a level of JSON: `fragments.lost` is `{"fragments": {"lost": ...}}`.

| metric | unit | better | meaning | measured from | no value (JSON null, CSV empty) where |
|---|---|---|---|---|---|
)";

constexpr std::string_view kPlacesHead =
    R"(
`ms.NAME` in `report.json` and in hold's `results.csv`, `ms.passes.NAME` in a chart, is the time of each pass in ms; transparency's passes begin with `oit.`, those of level of detail with `lod.`.

## Where each metric is written

| metric | `report.json` | `summary` | `results.csv` of a chart | its page | hold | walk |
|---|---|---|---|---|---|---|
)";

constexpr std::string_view kKeysHead =
    R"(
## The run: other keys of report.json

| key | unit | meaning | null, or absent, where |
|---|---|---|---|
)";

constexpr std::string_view kEnd =
    R"(
An input is `{"name", "path", "sha256", "files": [{"path", "sha256"}]}`: its name as given, its file and the hash of that (null: no file), and the files that it refers to (null hash: missing).
)";

/// A cell of a table.
std::string cell(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string code(std::string_view text) {
  return fmt::format("`{}`", text);
}

std::string_view wordOf(Better better) {
  switch (better) {
    case Better::Lower:
      return "lower";
    case Better::Higher:
      return "higher";
    case Better::Neither:
      break;
  }
  return "";
}

std::string_view wordOf(Summary summary) {
  switch (summary) {
    case Summary::None:
      break;
    case Summary::Sum:
      return "sum";
    case Summary::Mean:
      return "mean of the frames that have a value";
    case Summary::MeanOfAll:
      return "mean; null where a frame has none";
    case Summary::RootMeanSquare:
      return "root of the mean square";
    case Summary::PsnrOfMeanSquare:
      return "of the mean square error";
    case Summary::Largest:
      return "largest";
    case Summary::MedianAndP95:
      return "`median`, `p95`";
    case Summary::MedianP95AndLargest:
      return "`frames` that have a value, `median`, `p95`, `max`";
  }
  return "";
}

/// The key in a summary where it is another, and how it is made.
std::string summaryCell(const Metric& metric) {
  const std::string_view how = wordOf(metric.summary);
  if (how.empty() || metric.inSummary.empty()) return std::string(how);
  return fmt::format("{}: {}", code(metric.inSummary), how);
}

std::string reportCell(const Metric& metric) {
  if (metric.in(kReport)) return "each frame";
  return metric.in(kReportRun) ? "last frame" : "";
}

std::string columnCell(const Metric& metric) {
  if (!metric.in(kColumn) || !metric.isNumber()) return "";
  const std::string column = code(metric.columnName());
  return metric.spread ? fmt::format("{0}, `{1}.p5`, `{1}.p95`", column, metric.columnName())
                       : column;
}

std::string meaningOf(std::string_view meaning, std::string_view words) {
  if (words.empty()) return cell(meaning);
  std::string text = cell(meaning) + " One of";
  std::string_view before = " ";
  while (!words.empty()) {
    const std::size_t space = std::min(words.find(' '), words.size());
    text += fmt::format("{}`{}`", before, words.substr(0, space));
    words.remove_prefix(std::min(space + 1, words.size()));
    before = ", ";
  }
  return text + ".";
}

std::string keyRow(const ReportKey& key) {
  std::string where = cell(key.none);
  if (!key.absent.empty()) where = "absent: " + cell(key.absent);
  return fmt::format("| {} | {} | {} | {} |\n", code(key.name), cell(key.unit),
                     meaningOf(key.meaning, key.words), where);
}

}  // namespace

std::string reportDocument() {
  std::string page(kBegin);
  page += kMetricsHead;
  for (const Metric& m : kMetrics) {
    page +=
        fmt::format("| {} | {} | {} | {} | {} | {} |\n", code(m.name), cell(m.unit),
                    wordOf(m.better), meaningOf(m.meaning, m.words), cell(m.source), cell(m.none));
  }
  page += kPlacesHead;
  const auto mark = [](bool stands) { return stands ? "yes" : ""; };
  for (const Metric& m : kMetrics) {
    page += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", code(m.name), reportCell(m),
                        m.in(kReport | kHold) ? summaryCell(m) : "", columnCell(m),
                        mark(m.in(kPage)), mark(m.in(kHold)), mark(m.in(kWalk)));
  }
  page += kKeysHead;
  for (const ReportKey& key : kReportKeys) page += keyRow(key);
  page += kEnd;
  return page;
}

}  // namespace macula::measure
