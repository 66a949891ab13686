#include "cli/library/build_summary.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

#include "core/base/count_text.h"
#include "core/base/split_text.h"
#include "text/utf8_text.h"

namespace tessera::cli {
namespace {

constexpr std::size_t kNamesShown = 3;
constexpr std::size_t kMergedShown = 10;

std::string file_name(const std::string& path) { return printable_utf8(std::filesystem::path(path).filename()); }

/// The count column of a line.
std::string count_column(std::size_t count) {
  char text[32];
  std::snprintf(text, sizeof text, "  %5zu  ", count);
  return text;
}

/// The part of a reason before a colon; files are counted by it. Details (a parser's message) follow the colon.
std::string reason_class(const std::string& reason) { return printable_utf8(reason.substr(0, reason.find(": "))); }

/// The first names, each once: collections keep copies of one drawing in several folders.
std::string first_names(const std::vector<std::string>& paths) {
  std::vector<std::string> names;
  for (const std::string& path : paths) {
    if (const std::string name = file_name(path); std::find(names.begin(), names.end(), name) == names.end()) {
      if (names.size() == kNamesShown) return joined(names) + ", ...";
      names.push_back(name);
    }
  }
  return joined(names);
}

std::string skipped_lines(const std::vector<UnusedFile>& skipped) {
  std::map<std::string, std::vector<std::string>> paths_of_reason;
  for (const UnusedFile& file : skipped) paths_of_reason[reason_class(file.reason)].push_back(file.path);
  std::vector<std::pair<std::string, std::vector<std::string>>> rows(paths_of_reason.begin(), paths_of_reason.end());
  std::stable_sort(rows.begin(), rows.end(),
                   [](const auto& a, const auto& b) { return a.second.size() > b.second.size(); });
  std::string text = "skipped " + std::to_string(skipped.size()) + ":\n";
  for (const auto& [reason, paths] : rows) {
    text += count_column(paths.size()) + reason + ": " + first_names(paths) + "\n";
  }
  return text;
}

std::string merged_lines(const std::vector<LibraryBuildReport::Merged>& merged) {
  std::string text = "merged " + std::to_string(merged.size()) + " with the same silhouette and colour:\n";
  for (std::size_t i = 0; i < std::min(merged.size(), kMergedShown); ++i) {
    text += "  " + file_name(merged[i].path) + " = " + printable_utf8(merged[i].name) + "\n";
  }
  if (merged.size() > kMergedShown) text += "  ... and " + std::to_string(merged.size() - kMergedShown) + " more\n";
  return text;
}

}  // namespace

std::string build_summary(const LibraryBuildReport& report) {
  std::string text;
  if (!report.trimmed.empty()) {
    text += "parts that do not touch the largest one are not in the silhouettes of " +
            std::to_string(report.trimmed.size()) + ": " + first_names(report.trimmed) +
            "\n  join the parts to include them; if a soft shadow joins them, --edge-opacity 0.05 includes them\n";
  }
  if (!report.textless.empty()) {
    text += "text is not drawn, as fontconfig finds no font here, in " + std::to_string(report.textless.size()) + ": " +
            first_names(report.textless) + "\n  install a font to include it, e.g. fonts-dejavu-core\n";
  }
  if (!report.first_pictures.empty()) {
    text += "only the first picture of an animation or of several pages is in the library, for " +
            std::to_string(report.first_pictures.size()) + ": " + first_names(report.first_pictures) + "\n";
  }
  if (!report.faint.empty()) {
    text += "parts that are too faint (an opacity below 0.08) or too thin are not in the silhouettes of " +
            std::to_string(report.faint.size()) + ": " + first_names(report.faint) + "\n";
  }
  if (!report.hollow.empty()) {
    text += count_text(report.hollow.size(), "encloses twice what it covers", "enclose twice what they cover") +
            " or more, which leaves gaps; --fill-holes counts it as " +
            by_count(report.hollow.size(), "its own", "theirs") + ": " + first_names(report.hollow) + "\n";
  }
  if (!report.merged.empty()) text += merged_lines(report.merged);
  if (!report.skipped.empty()) text += skipped_lines(report.skipped);
  return text;
}

std::string build_counts(const LibraryBuildReport& report) {
  std::string text = count_text(report.files, "file") + ": " + count_text(report.shapes, "shape");
  if (!report.merged.empty()) text += ", " + std::to_string(report.merged.size()) + " merged with these";
  if (!report.skipped.empty()) text += ", " + std::to_string(report.skipped.size()) + " skipped";
  return text;
}

}  // namespace tessera::cli
