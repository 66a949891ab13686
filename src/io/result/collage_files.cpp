#include "io/result/collage_files.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "core/base/error.h"
#include "core/collage/quality.h"
#include "io/atomic_file.h"
#include "io/result/card_output.h"
#include "io/result/geojson_output.h"
#include "io/result/png_output.h"
#include "io/result/svg_output.h"

namespace tessera::io {
namespace {

namespace fs = std::filesystem;

std::string in_directory(const std::string& dir, const char* name) { return (fs::path(dir) / name).string(); }

Quality measured_quality(const CollageReport& report) {
  return measure_quality(*report.canvas, report.placements,
                         [&](std::uint32_t index) -> const Shape& { return report.shape(index); });
}

}  // namespace

std::size_t CollageReport::slot_of(std::uint32_t index) const {
  const auto found = std::find(shape_index.begin(), shape_index.end(), index);
  if (found == shape_index.end()) throw std::out_of_range("shape " + std::to_string(index) + " is not in the report");
  return std::size_t(found - shape_index.begin());
}

void prepare_output_directory(const std::string& dir) {
  std::error_code error;
  fs::create_directories(dir, error);
  if (error) throw EnvironmentError("cannot create the output directory " + dir + ": " + error.message());
  const std::string probe = in_directory(dir, ".tessera-write-test");
  write_file_atomically(probe, "write test\n");
  fs::remove(probe, error);
}

std::string write_collage(const std::string& dir, const CollageReport& report, bool quick) {
  // Cheapest first: whoever interrupts again still has the pieces.
  write_file_atomically(in_directory(dir, "pieces.geojson"), geojson_text(report));
  const Quality quality = measured_quality(report);
  const CollageSettings& settings = report.job->settings;
  const std::string card = card_text(quality, report.statistics, settings);
  write_file_atomically(in_directory(dir, "card.json"), card_json(quality, report.statistics, settings, report.ranks, report.record));
  write_file_atomically(in_directory(dir, "card.txt"), card);
  write_file_atomically(in_directory(dir, "job.toml"), to_toml(*report.job));
  write_file_atomically(in_directory(dir, "collage.svg"), collage_svg(report, quick));
  write_file_atomically(in_directory(dir, "collage.png"), collage_png(report, quick));
  return card;
}

}  // namespace tessera::io
