#include <memory>

#include "cli/commands.h"
#include "run/results/report_run.h"

namespace tessera::cli {
namespace {

constexpr const char* kReportExamples =
    "Examples:\n"
    "  tessera report out/animals                         out/animals/report.html\n"
    "  tessera report out/animals -o animals.html         elsewhere\n"
    "  tessera report out/animals --picture-mb 60         a sharper picture in a larger file\n"
    "  tessera report out/animals-campaign                all results of a campaign, side by side\n"
    "  tessera report out/a out/b -o both.html\n"
    "The page is one file. It opens in a browser from the disk, without a server and without a network: Chrome or "
    "Edge\n"
    "123, Firefox 120, Safari 17.5 or later. It shows the picture with all its pieces, gaps, contact, growth, the "
    "quality\n"
    "card and the job. Pieces can be marked on it; the page then shows the command (tessera refine) that replaces "
    "them.\n"
    "The page holds what the result's folder holds, paths of drawings and the command line among it "
    "(docs/result-format.md,\n"
    "\"What may be private\").";

}  // namespace

void add_report_command(CLI::App& app, Command& selected) {
  const auto arguments = std::make_shared<ReportArguments>();
  CLI::App* report = app.add_subcommand("report", "Write a page to look at a result, or to compare several");
  report->footer(kReportExamples);
  report->add_option("RESULT", arguments->folders, "The folder of a result; or several, or folders of results")
      ->required()
      ->type_name("DIR...");
  report->add_option("-o,--out", arguments->out, "The page; default: report.html in DIR, for several out/report.html")
      ->type_name("FILE");
  report
      ->add_option("--picture-mb", arguments->picture_mb,
                   "MB of the page for its pictures, which are made smaller to keep to it; default: " +
                       std::to_string(kPicture_mb) + ", for several results " + std::to_string(kCampaignPictures_mb))
      ->type_name("N")
      ->check(CLI::Range(1, 1000));
  report
      ->add_option("--weight", arguments->weights,
                   "Weight of a measure in the ranking, as in tessera rank; may be repeated")
      ->type_name("NAME=WEIGHT")
      ->allow_extra_args(false)
      ->take_all();
  report->add_flag("--quiet", arguments->quiet, "Print only warnings");
  report->callback([arguments, &selected] { selected.run = [arguments] { return run_report(*arguments); }; });
}

}  // namespace tessera::cli
