#include "cli/build_summary.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

#include "io/library/library_names.h"

namespace tessera::cli {
namespace {

constexpr std::size_t kNamesShown = 3;
constexpr std::size_t kMergedShown = 10;
constexpr int kMaxReasonWidth = 60;

std::string file_name(const std::string& path) { return io::printable_utf8(std::filesystem::path(path).filename()); }

/// Where a reason has details after a colon (a parser's message), the table counts what stands before it.
std::string reason_class(const std::string& reason) { return io::printable_utf8(reason.substr(0, reason.find(": "))); }

std::string text_of(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// Collections keep copies of one drawing in several folders: a name is shown once.
std::string first_names(const std::vector<std::string>& paths) {
  std::vector<std::string> names;
  for (const std::string& path : paths) {
    if (const std::string name = file_name(path); std::find(names.begin(), names.end(), name) == names.end()) {
      if (names.size() == kNamesShown) return text_of(names) + ", ...";
      names.push_back(name);
    }
  }
  return text_of(names);
}

std::string table_row(const std::string& reason, int width, const std::string& count, const std::string& names) {
  char text[64];
  std::snprintf(text, sizeof text, "  %6s  ", count.c_str());
  const int padding = std::max(0, width - int(reason.size()));
  return "  " + reason + std::string(std::size_t(padding), ' ') + text + names + "\n";
}

std::string skipped_table(const std::vector<io::UnusedFile>& skipped) {
  std::map<std::string, std::vector<std::string>> paths_of_reason;
  for (const io::UnusedFile& file : skipped) paths_of_reason[reason_class(file.reason)].push_back(file.path);
  std::vector<std::pair<std::string, std::vector<std::string>>> rows(paths_of_reason.begin(), paths_of_reason.end());
  std::stable_sort(rows.begin(), rows.end(),
                   [](const auto& a, const auto& b) { return a.second.size() > b.second.size(); });
  int width = 0;
  for (const auto& [reason, paths] : rows) width = std::max(width, int(reason.size()));
  width = std::min(width, kMaxReasonWidth);
  std::string text = "skipped " + std::to_string(skipped.size()) + ":\n" + table_row("reason", width, "files", "first");
  for (const auto& [reason, paths] : rows) {
    text += table_row(reason, width, std::to_string(paths.size()), first_names(paths));
  }
  return text;
}

std::string merged_lines(const std::vector<io::LibraryBuildReport::Merged>& merged) {
  std::string text = "merged " + std::to_string(merged.size()) + " with the same silhouette and colour:\n";
  for (std::size_t i = 0; i < std::min(merged.size(), kMergedShown); ++i) {
    text += "  " + file_name(merged[i].path) + " = " + merged[i].name + "\n";
  }
  if (merged.size() > kMergedShown) text += "  ... and " + std::to_string(merged.size() - kMergedShown) + " more\n";
  return text;
}

}  // namespace

std::string build_summary(const io::LibraryBuildReport& report) {
  std::string text;
  if (!report.with_specks.empty()) {
    text += "specks beside the largest part left out in " + std::to_string(report.with_specks.size()) + ": " +
            first_names(report.with_specks) + "\n";
  }
  if (!report.merged.empty()) text += merged_lines(report.merged);
  if (!report.skipped.empty()) text += skipped_table(report.skipped);
  return text;
}

}  // namespace tessera::cli
