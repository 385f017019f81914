#include "engine/gaze/foreign_file.h"

#include <algorithm>
#include <array>
#include <vector>

#include "engine/gaze/cells.h"

namespace macula::gaze {
namespace {

struct Kind {
  std::string_view mark;
  const char* what;
};

constexpr const char* kScene =
    "a glTF scene, not a gaze log; give it in place of SCENE, and a log as --gaze";

constexpr std::array<Kind, 5> kStarts{{
    {"glTF", kScene},
    {"SR_RESEARCH", "an EyeLink EDF, not text; convert it with edf2asc and give the .asc file"},
    {"PK\x03\x04", "a ZIP archive or a spreadsheet (.xlsx); unpack it, or export CSV or TSV"},
    {"\x89HDF", "HDF5, not text; export the gaze as CSV or TSV"},
    {"<", "XML or HTML, not a table; export the gaze as CSV or TSV"},
}};

/// A table by one column that only it has, whatever else it holds.
constexpr std::array<Kind, 6> kTables{{
    {"target_x", "a camera path, not a gaze log; give it as --camera"},
    {"RECORDING_SESSION_LABEL",
     "an EyeLink Data Viewer report, which is not read; convert the EDF with edf2asc and give the "
     ".asc file"},
    {"L POR X [px]",
     "an SMI BeGaze export, which is not read; write its samples as time_s,x,y,valid (macula-csv)"},
    {"R POR X [px]",
     "an SMI BeGaze export, which is not read; write its samples as time_s,x,y,valid (macula-csv)"},
    {"left_gaze_x",
     "gaze of PsychoPy's ioHub, which is not read; write its samples as time_s,x,y,valid "
     "(macula-csv)"},
    {"clx", "GazeBaseVR, which is not read; write its samples as time_s,x,y,valid (macula-csv)"},
}};

/// Tabs and ends of lines are the only control characters of a table. In its comments others are
/// harmless, but for zeros, which no text has.
bool isBinary(std::string_view start) {
  bool atBegin = true;
  bool comment = false;
  for (const char c : start) {
    if (atBegin) comment = c == '#';
    atBegin = c == '\n';
    const bool control = (c > '\0' && c < '\t') || (c > '\r' && c < ' ');
    if (c == '\0' || (control && !comment)) return true;
  }
  return false;
}

/// Every other byte of the first ones, so that it is UTF-16 rather than binary data.
bool isUtf16(std::string_view start) {
  if (start.size() < 2) return false;
  return start.starts_with("\xFF\xFE") || start.starts_with("\xFE\xFF") ||
         (start[0] == '\0') != (start[1] == '\0');
}

}  // namespace

std::optional<std::string> foreignBytes(std::string_view start) {
  for (const Kind& kind : kStarts) {
    if (start.starts_with(kind.mark)) return kind.what;
  }
  if (trimmed(start).starts_with('{')) {
    if (start.find("\"asset\"") != std::string_view::npos) return kScene;
    return "JSON, not a gaze log; the description of a BIDS recording goes with its .tsv, as "
           "--gaze.sidecar, and a .gltf in place of SCENE";
  }
  if (!isUtf16(start) && isBinary(start)) {
    return "binary data, not a gaze log; export the gaze as CSV or TSV";
  }
  return std::nullopt;
}

std::optional<std::string> foreignTable(std::string_view header) {
  for (const char separator : {',', ';', '\t'}) {
    std::vector<std::string_view> cells;
    splitQuotedCells(header, separator, cells);
    for (const Kind& kind : kTables) {
      if (std::find(cells.begin(), cells.end(), kind.mark) != cells.end()) return kind.what;
    }
  }
  return std::nullopt;
}

}  // namespace macula::gaze
