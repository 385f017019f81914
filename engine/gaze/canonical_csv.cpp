#include "engine/gaze/canonical_csv.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/interrupt.h"
#include "engine/gaze/log_reader.h"

namespace macula::gaze {
namespace {

// Text is handed to the file in pieces of about this size.
constexpr std::size_t kPiece = 65536;

}  // namespace

void CanonicalColumns::note(const GazeSample& sample) {
  confidence = confidence || sample.confidence.has_value();
  pupil = pupil || sample.pupilMillimetres.has_value();
}

void writeCanonicalHeader(const GazeLogHead& head, const CanonicalColumns& columns,
                          std::string& out) {
  for (const std::string& note : head.notes) out += "# " + oneLine(note) + "\n";
  out += "time_s,x,y,valid";
  if (columns.confidence) out += ",confidence";
  if (columns.pupil) out += ",pupil_mm";
  out += '\n';
}

void writeCanonicalRow(const GazeSample& sample, const CanonicalColumns& columns,
                       std::string& out) {
  const auto end = std::back_inserter(out);
  const bool placed = std::isfinite(sample.position.x) && std::isfinite(sample.position.y);
  fmt::format_to(end, "{},", sample.timeSeconds);
  if (placed) fmt::format_to(end, "{},{}", sample.position.x, sample.position.y);
  out += placed ? "" : ",";
  out += placed && sample.valid ? ",1" : ",0";
  if (columns.confidence) out += ',';
  if (sample.confidence) fmt::format_to(end, "{}", *sample.confidence);
  if (columns.pupil) out += ',';
  if (sample.pupilMillimetres) fmt::format_to(end, "{}", *sample.pupilMillimetres);
  out += '\n';
}

std::string canonicalCsv(const GazeLog& log) {
  CanonicalColumns columns;
  for (const GazeSample& sample : log.samples) columns.note(sample);
  std::string text;
  writeCanonicalHeader(log, columns, text);
  for (const GazeSample& sample : log.samples) writeCanonicalRow(sample, columns, text);
  return text;
}

Conversion convertGazeLog(const std::filesystem::path& path, const std::filesystem::path& out,
                          const LogOptions& options) {
  Conversion done;
  GazeSample sample;
  CanonicalColumns columns;
  GazeLogReader survey(path, options);
  const auto endWhereAsked = [&] {
    if (interruptAsked())
      throw Interrupted(fmt::format("interrupted; {} was not written", out.string()));
  };
  while (survey.next(sample)) {
    endWhereAsked();
    columns.note(sample);
  }
  done.head = survey.head();
  if (done.head.format != "macula-csv") {  // so that the file still says what it was
    done.head.notes.push_back(fmt::format("{}{}; coordinates were {}", kConverted, done.head.format,
                                          describe(done.head.coordinates)));
  }

  writeFileAtomically(out, [&](const std::filesystem::path& part) {
    std::ofstream file(part, std::ios::binary);
    GazeLogReader reader(path, options);
    std::string text;
    writeCanonicalHeader(done.head, columns, text);
    while (reader.next(sample)) {
      endWhereAsked();
      writeCanonicalRow(sample, columns, text);
      ++done.samples;
      if (text.size() < kPiece) continue;
      file << text;
      text.clear();
    }
    file << text;
    file.close();
    if (!file) failInput("{}: cannot be written; check the folder and the disk", out.string());
  });
  return done;
}

}  // namespace macula::gaze
