#include "run/results/report_run.h"

#include <filesystem>
#include <utility>

#include "core/base/error.h"
#include "files/atomic_file.h"
#include "files/output_folder.h"
#include "render/ranking.h"
#include "report/campaign_page.h"
#include "report/result_page.h"
#include "result/folder/folder_name.h"
#include "result/folder/result_file.h"
#include "run/results/found_cards.h"
#include "terminal/terminal.h"
#include "text/number_text.h"

namespace tessera {
namespace {

namespace fs = std::filesystem;

bool is_one_result(const ReportArguments& arguments) {
  return arguments.folders.size() == 1 && is_in_result(arguments.folders.front(), kManifestName);
}

std::string page_path(const ReportArguments& arguments) {
  if (!arguments.out.empty()) return arguments.out;
  return arguments.folders.size() == 1 ? path_in_result(arguments.folders.front(), kReportName) : "out/report.html";
}

Page page_of(const ReportArguments& arguments) {
  const int default_mb = is_one_result(arguments) ? kPicture_mb : kCampaignPictures_mb;
  const std::size_t picture_bytes = tile_bytes(arguments.picture_mb > 0 ? arguments.picture_mb : default_mb);
  if (is_one_result(arguments)) {
    if (!arguments.weights.empty()) {
      throw InputError("--weight: found with one result, allowed: with several, which it ranks");
    }
    return result_page(arguments.folders.front(), {.picture_bytes = picture_bytes});
  }
  const RankingWeights weights = ranking_weights(arguments.weights);
  const std::vector<RankedResult> results = ranked(found_cards(arguments.folders), weights);
  const std::string title = arguments.folders.size() == 1 ? folder_name(arguments.folders.front()) : "Results";
  return campaign_page(title, results, weights, picture_bytes);
}

}  // namespace

std::size_t write_report_file(const std::string& path, const Page& page) {
  for (const std::string& warning : page.warnings) print_warning(warning);
  TemporaryFile file(path);
  std::size_t bytes = 0;
  write_page(page, [&](std::string_view part) {
    file.write({reinterpret_cast<const std::uint8_t*>(part.data()), part.size()});
    bytes += part.size();
  });
  file.commit();
  return bytes;
}

std::size_t tile_bytes(int picture_mb) { return std::size_t(picture_mb) * 1'000'000 / 4 * 3; }

void write_result_report(const std::string& folder) {
  write_report_file(path_in_result(folder, kReportName),
                    result_page(folder, {.picture_bytes = tile_bytes(kPicture_mb)}));
}

int run_report(const ReportArguments& arguments) {
  for (const std::string& result : arguments.folders) {
    if (!fs::exists(result)) throw InputError(result + ": no such folder");
  }
  const std::string path = page_path(arguments);
  if (fs::is_directory(path)) {
    throw InputError("--out " + path + ": found a folder, allowed: the name of a file, as in " + path + "/report.html");
  }
  const std::string parent = fs::path(path).parent_path().string();
  const OutputFolder folder(parent.empty() ? "." : parent);
  check_can_be_written(path);
  const std::size_t bytes = write_report_file(path, page_of(arguments));
  if (!arguments.quiet)
    print_line("written: %s, %s MB; open it in a browser", path.c_str(), fixed(double(bytes) / 1e6, 1).c_str());
  return 0;
}

}  // namespace tessera
