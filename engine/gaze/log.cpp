#include "engine/gaze/log.h"

#include "engine/gaze/log_reader.h"

namespace macula::gaze {
namespace {

GazeLog drain(GazeLogReader& reader) {
  GazeLog log;
  GazeSample sample;
  while (reader.next(sample)) log.samples.push_back(sample);
  static_cast<GazeLogHead&>(log) = reader.head();
  return log;
}

}  // namespace

GazeLog readGazeLog(const std::filesystem::path& path, const LogOptions& options) {
  GazeLogReader reader(path, options);
  return drain(reader);
}

GazeLog readGazeLog(std::istream& in, std::string_view name, const LogOptions& options) {
  GazeLogReader reader(in, name, options);
  return drain(reader);
}

}  // namespace macula::gaze
