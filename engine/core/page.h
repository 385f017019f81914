// HTML pages from templates.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace macula {

/// JSON text for the inside of a <script>: it must not close it, nor begin a comment.
[[nodiscard]] std::string scriptSafe(std::string_view json);

/// Text for the body of a page.
[[nodiscard]] std::string htmlSafe(std::string_view text);

/// Replaces {{name}} by the text of that name, in one pass: what is put in is not searched again.
/// Unknown names stay as they are.
[[nodiscard]] std::string fillPage(std::string_view page,
                                   const std::map<std::string, std::string>& texts);

/// For "interrupted" of reportPageOf().
/// @param howFar "12 of 60 frames were drawn"; empty: the run was complete, and so is the banner
[[nodiscard]] std::string interruptedBanner(std::string_view howFar);

/// A page that needs no network: NAME.html of assets/report with the shared style and charts,
/// uPlot, NAME.js, the texts, and a foot from the data's "provenance" (measure::toJson()).
/// @param json the page's data @param texts further ones that the template names, ready for HTML;
///   "interrupted" is a notice above all else, empty where it is missing
/// @throws InputError where a file of assets/report is missing
[[nodiscard]] std::string reportPageOf(const std::filesystem::path& assets, const std::string& name,
                                       std::string_view json,
                                       std::map<std::string, std::string> texts = {});

}  // namespace macula
