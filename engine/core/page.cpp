#include "engine/core/page.h"

#include "engine/core/file.h"

namespace macula {

std::string scriptSafe(std::string_view json) {
  std::string safe;
  safe.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

std::string htmlSafe(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '&':
        safe += "&amp;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string fillPage(std::string_view page, const std::map<std::string, std::string>& texts) {
  std::string filled;
  while (!page.empty()) {
    const std::size_t open = page.find("{{");
    const std::size_t close = open == std::string_view::npos ? open : page.find("}}", open);
    if (close == std::string_view::npos) break;
    const auto text = texts.find(std::string(page.substr(open + 2, close - open - 2)));
    filled += page.substr(0, open);
    filled += text == texts.end() ? std::string(page.substr(open, close + 2 - open)) : text->second;
    page.remove_prefix(close + 2);
  }
  return filled + std::string(page);
}

std::string interruptedBanner(std::string_view howFar) {
  if (howFar.empty()) return {};
  return "<p id=\"interrupted\" role=\"alert\">Interrupted: " + htmlSafe(howFar) +
         ". What follows is of those alone.</p>";
}

std::string reportPageOf(const std::filesystem::path& assets, const std::string& name,
                         std::string_view json, std::map<std::string, std::string> texts) {
  const std::filesystem::path report = assets / "report";
  const std::filesystem::path vendor = report / "vendor";
  texts.try_emplace("interrupted", "");
  texts["style"] = readTextFile(vendor / "uPlot.min.css") + readTextFile(report / "report.css");
  texts["licence"] = readTextFile(vendor / "uPlot.LICENSE");
  texts["vendor"] = readTextFile(vendor / "uPlot.iife.min.js");
  texts["data"] = scriptSafe(json);
  texts["script"] = readTextFile(report / "charts.js") + readTextFile(report / (name + ".js")) +
                    readTextFile(report / "provenance.js");
  return fillPage(readTextFile(report / (name + ".html")), texts);
}

}  // namespace macula
