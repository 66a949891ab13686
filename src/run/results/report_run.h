// tessera report: writes a page to look at results.
#pragma once

#include <string>
#include <vector>

#include "report/page.h"

namespace tessera {

/// MB of a page for its pictures, unless the user sets another number.
inline constexpr int kPicture_mb = 16;
inline constexpr int kCampaignPictures_mb = 24;

struct ReportArguments {
  std::vector<std::string> folders;  // results, or folders of results
  std::string out;                   // the page; empty: report.html in the only folder, else out/report.html
  int picture_mb = 0;                // MB of the page for its pictures; 0: the default
  std::vector<std::string> weights;  // "NAME=WEIGHT", for several results
  bool quiet = false;
};

/// Writes the page of one result, or of several. Returns the exit code; throws InputError and EnvironmentError.
int run_report(const ReportArguments& arguments);

/// Writes a page, prints as warnings what it lacks, and returns its size in bytes. Throws EnvironmentError.
std::size_t write_report_file(const std::string& path, const Page& page);

/// Writes the page of the result in a folder, in that folder.
void write_result_report(const std::string& folder);

/// The bytes of tiles that make this many MB of a page, where they stand as base64.
std::size_t tile_bytes(int picture_mb);

}  // namespace tessera
