#include "engine/gaze/log_options.h"

#include "engine/gaze/log.h"

namespace macula::gaze {

void registerSettings(settings::Registry& registry, LogOptions& options) {
  std::vector<std::string> formats = gazeFormatNames();
  formats.insert(formats.begin(), "auto");
  registry.addChoice({.key = "gaze.format", .help = "format of a gaze log; auto: by its content"},
                     options.format, formats);
  registry.addChoice({.key = "gaze.unit", .help = "unit of a gaze log's coordinates"}, options.unit,
                     {"file", "px", "0..1", "deg"});
  registry.addChoice({.key = "gaze.origin", .help = "where a gaze log's coordinates begin"},
                     options.origin, {"file", "top-left", "bottom-left", "centre", "centre-up"});
  registry.addChoice({.key = "gaze.timeUnit", .help = "unit of a gaze log's times"},
                     options.timeUnit, {"file", "s", "ms", "us", "ns"});
  registry.add({.key = "gaze.screen",
                .unit = "px",
                .help = "WIDTHxHEIGHT that a gaze log's pixels are of; empty: from the file"},
               options.screen);
  registry.add({.key = "gaze.sidecar",
                .help = "JSON that describes a BIDS recording; empty: beside the file"},
               options.sidecar);
  registry.add({.key = "gaze.minConfidence",
                .help = "Pupil Core samples below this confidence are lost",
                .share = true},
               options.minConfidence, {.min = 0.0, .max = 1.0});
  registry.add({.key = "gaze.sceneCameraAsDisplay",
                .help = "degrees also from places in a scene camera's picture, as if it were the "
                        "display"},
               options.sceneCameraAsDisplay);
}

}  // namespace macula::gaze
