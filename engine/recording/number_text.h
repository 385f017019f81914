// Numbers as JSON text that any reader of doubles turns into the same bits again.
#pragma once

#include <string>

namespace macula::recording {

/// Appends the shortest text that reads back to the same double. JSON knows no others than finite
/// numbers: those become "nan", "inf" and "-inf" with the quotes.
void appendNumber(double number, std::string& text);

/// The same for a float: the shortest text of a float where reading that as a double and rounding
/// it once more gives the float again (all but one and its negative do), else the shortest of the
/// double.
void appendNumber(float number, std::string& text);

}  // namespace macula::recording
