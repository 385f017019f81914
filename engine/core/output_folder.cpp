#include "engine/core/output_folder.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/file.h"

namespace macula {
namespace fs = std::filesystem;

namespace {

constexpr std::string_view kHead = "macula ";

/// What versions without a manifest left behind: a JSON report with this key.
struct EarlierReport {
  std::string_view subcommand, file, key;
};
constexpr std::array<EarlierReport, 5> kEarlierReports{{{"replay", "report.json", "frames"},
                                                        {"hold", "results.json", "law"},
                                                        {"hold", "results.json", "laws"},
                                                        {"gaze study", "results.json", "logs"},
                                                        {"chart", "results.json", "points"}}};

std::vector<std::string> linesOf(const fs::path& manifest) {
  std::istringstream text(readTextFile(manifest));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

/// A shell may have made the log of this very run in the folder: `> out/log`.
bool isOwnOutput(const fs::path& file) {
  struct stat there {};
  if (::stat(file.c_str(), &there) != 0) return false;
  return std::ranges::any_of(std::array{STDOUT_FILENO, STDERR_FILENO}, [&](int descriptor) {
    struct stat here {};
    return ::fstat(descriptor, &here) == 0 && here.st_dev == there.st_dev &&
           here.st_ino == there.st_ino;
  });
}

std::vector<std::string> entriesOf(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (auto at = fs::directory_iterator(folder, error); !error && at != fs::directory_iterator();
       at.increment(error)) {
    if (!isOwnOutput(at->path())) names.push_back(at->path().filename().string());
  }
  if (error) failInput("{}: cannot be read ({}); check it", folder.string(), error.message());
  std::ranges::sort(names);
  return names;
}

bool holdsReport(const fs::path& folder, const EarlierReport& report) {
  const fs::path file = folder / report.file;
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return false;
  const auto json = nlohmann::json::parse(readTextFile(file), nullptr, false);
  return json.is_object() && json.contains("schema") && json.contains(report.key);
}

/// The subcommand whose output a folder holds; none where it holds something else.
std::optional<std::string> ownerOf(const fs::path& folder, const std::vector<std::string>& names) {
  if (std::ranges::find(names, kOutputManifest) != names.end()) {
    const std::vector<std::string> lines = linesOf(folder / kOutputManifest);
    if (lines.empty() || !lines.front().starts_with(kHead)) return {};
    return lines.front().substr(kHead.size());
  }
  for (const EarlierReport& report : kEarlierReports) {
    if (holdsReport(folder, report)) return std::string(report.subcommand);
  }
  // These two have finished parts before they have a report.
  std::error_code error;
  if (fs::is_regular_file(folder / "points.jsonl", error)) return "chart";
  const auto isSplit = [](const std::string& name) {
    return name == "training" || name == "validation" || name == "test";
  };
  if (!names.empty() && std::ranges::all_of(names, isSplit)) return "features";
  return {};
}

/// Whatever a manifest says, nothing outside the folder is touched.
bool isPlainName(const std::string& name) {
  return !name.empty() && name != "." && name != ".." && name != kOutputManifest &&
         name.find('/') == std::string::npos && name == oneLine(name);
}

}  // namespace

OutputFolder::OutputFolder(fs::path folder, std::string subcommand, bool force)
    : folder_(std::move(folder)), subcommand_(std::move(subcommand)) {
  std::error_code error;
  if (!force && fs::is_directory(folder_, error)) {
    const std::vector<std::string> names = entriesOf(folder_);
    const auto owner = ownerOf(folder_, names);
    if (owner && *owner != subcommand_) {
      failInput(
          "{}: holds the output of 'macula {}'; choose another folder with --out, or add "
          "--force to write into it",
          folder_.string(), oneLine(*owner));
    }
    if (!owner && !names.empty()) {
      failInput(
          "{}: holds '{}'{}, which is not from 'macula {}'; choose another folder with "
          "--out, or add --force to write into it",
          folder_.string(), oneLine(names.front()),
          names.size() > 1 ? fmt::format(" and {} more", names.size() - 1) : "", subcommand_);
    }
  }
  makeOutputFolder(folder_);
}

void OutputFolder::begin() {
  removeEarlier();
  const fs::path manifest = folder_ / kOutputManifest;
  writeFileAtomically(manifest, fmt::format("{}{}\n", kHead, subcommand_));
  manifest_.open(manifest, std::ios::binary | std::ios::app);
}

void OutputFolder::removeEarlier() const {
  const fs::path manifest = folder_ / kOutputManifest;
  std::error_code error;
  if (!fs::exists(manifest, error)) return;
  const std::vector<std::string> lines = linesOf(manifest);
  if (lines.empty() || lines.front() != std::string(kHead) + subcommand_) return;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (!isPlainName(lines[i])) continue;
    const fs::path file = folder_ / lines[i];
    const fs::file_status status = fs::symlink_status(file, error);  // a link goes, not its target
    if (fs::is_regular_file(status) || fs::is_symlink(status)) fs::remove(file, error);
  }
}

fs::path OutputFolder::file(const std::string& name) {
  if (!manifest_.is_open()) begin();
  manifest_ << name << '\n' << std::flush;
  if (!manifest_) {
    failInput("{}: cannot be written; check the folder and the space left",
              (folder_ / kOutputManifest).string());
  }
  return folder_ / name;
}

}  // namespace macula
