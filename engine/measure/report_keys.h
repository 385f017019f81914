// The keys of report.json that say what a run was. What was measured of its frames is in metrics.h.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace macula::measure {

enum class Shape : std::uint8_t {
  Flag,
  Count,
  Integer,
  Number,
  Text,
  Texts,     ///< an array
  Input,     ///< what a run was given by name; see provenance.h
  Inputs,    ///< an object of them
  Settings,  ///< an object of values of any kind
  Counts,    ///< an object of counts
  Group,     ///< an object whose keys are other rows
};

struct ReportKey {
  std::string_view name;  ///< a dot for each level
  std::string_view unit = {};
  std::string_view meaning = {};
  Shape shape = Shape::Text;
  std::string_view none = {};    ///< why it may be null; empty: it never is
  std::string_view absent = {};  ///< why it may be missing; empty: it never is
  std::string_view words = {};   ///< values that a text can have, split by spaces; empty: any
};

inline constexpr auto kReportKeys = std::to_array<ReportKey>({
    {"schema", "", "Version of this format: 1.", Shape::Count},
    {"commit", "", "Commit of the program, 12 digits; `-dirty` where the source differed."},
    {"scene", "", "The scene as it was named."},
    {"width", "pixels", "Width of the image.", Shape::Count},
    {"height", "pixels", "Height of the image.", Shape::Count},
    {"gl.renderer", "", "GL_RENDERER."},
    {"gl.version", "", "GL_VERSION."},
    {.name = "gl.time_source",
     .meaning = "What times are from: glFinish and a steady clock, or timer queries.",
     .words = "finish query"},
    {"method", "", "`oit.method`."},
    {.name = "sync",
     .meaning = "How the fragments of a pixel are ordered or kept apart while they are inserted.",
     .none = "the method does not insert in order",
     .words = "interlock spinlock ordered none"},
    {"settings", "", "All settings by key.", Shape::Settings},
    {"provenance.command", "", "The command line, quoted for a shell."},
    {"provenance.version", "", "Version of the program."},
    {"provenance.commit", "", "As `commit`."},
    {.name = "provenance.settings",
     .meaning = "Files that settings name, by the setting's key.",
     .shape = Shape::Inputs,
     .absent = "no setting names a file"},
    {"provenance.scene", "", "The scene.", Shape::Input},
    {"provenance.gaze", "", "Gaze log, point or `center`; the recording's folder.", Shape::Input},
    {"provenance.camera", "", "Path, `auto` or `scene`; the recording's folder.", Shape::Input},
    {"provenance.fps", "1/s", "Frames a second.", Shape::Number,
     "a recording has times of its own"},
    {"provenance.seed", "", "`frame.seed`.", Shape::Integer},
    {"bytes.buffers", "bytes",
     "Each buffer and texture of transparency by name, while it is alive. Buffers whose lives in a "
     "frame do not meet share memory, so they add up to `bytes.total` or more.",
     Shape::Counts},
    {"interrupted", "", "Ctrl-C came before the last frame; numbers are of those that were drawn.",
     Shape::Flag},
    {"summary.gaze_error_deg.basis", "", "What the gaze error is measured against."},
    {"summary.load_ms", "ms", "Time to load the scene.", Shape::Number},
    {"summary.first_frame_ms", "ms", "From the start of the command to the end of the first frame.",
     Shape::Number},
    {"gaze_log", "", "The gaze log, and how it was read.", Shape::Group, "the gaze is no log"},
    {"gaze_log.format", "", "Format of the log."},
    {"gaze_log.coordinates", "", "Unit and origin of its places."},
    {"gaze_log.of", "", "What its places are of: a window, a screen, a scene camera, ..."},
    {"gaze_log.end_s", "s", "Time of its last sample.", Shape::Number},
    {"gaze_log.display.width_mm", "mm", "Width of the display.", Shape::Number},
    {"gaze_log.display.height_mm", "mm", "Height of the display.", Shape::Number},
    {"gaze_log.display.distance_mm", "mm", "From the eye to the display.", Shape::Number},
    {"gaze_log.display.size_by", "", "Where the size is from."},
    {"gaze_log.display.distance_by", "", "Where the distance is from."},
    {"gaze_log.has_degrees", "", "Whether degrees can be told from its places.", Shape::Flag},
    {"gaze_log.warnings", "", "What was assumed of it.", Shape::Texts},
    {.name = "recording",
     .meaning = "How the images compare with a recording.",
     .shape = Shape::Group,
     .absent = "no recording was replayed"},
    {"recording.frames", "frames", "That were recorded.", Shape::Count},
    {"recording.truncated_lines", "lines", "Lines that were cut off and left out.", Shape::Count},
    {"recording.unrecorded_frames", "frames", "Drawn between recorded ones, and not recorded.",
     Shape::Count},
    {"recording.hashes_compared", "frames", "Frames whose image hash was recorded and can repeat.",
     Shape::Count},
    {"recording.hashes_equal", "frames", "Of them, those whose image is the recorded one.",
     Shape::Count},
    {"recording.first_difference", "", "Index of the first frame whose image differs.",
     Shape::Count, "all are equal"},
});

}  // namespace macula::measure
