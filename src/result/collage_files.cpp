#include "result/collage_files.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "core/base/error.h"
#include "core/quality/quality.h"
#include "files/atomic_file.h"
#include "files/output_folder.h"
#include "result/card_output.h"
#include "result/folder/folder_name.h"
#include "result/folder/result_file.h"
#include "result/folder/result_manifest.h"
#include "result/geojson_output.h"

namespace tessera {
namespace {

namespace fs = std::filesystem;

std::string in_directory(const std::string& dir, const char* name) { return (fs::path(dir) / name).string(); }

Quality measured_quality(const CollageReport& report, const std::optional<SizeRange>& sizes) {
  std::vector<JudgedPiece> pieces =
      judged_pieces(report.placements, [&](ShapeId id) -> const Shape& { return report.shape(id); });
  for (std::size_t i = 0; i < report.styles.size(); ++i) pieces[i].style = report.styles[i];
  return measure_quality(*report.canvas, pieces, sizes);
}

void remove_file(const std::string& path) {
  std::error_code error;
  fs::remove(path, error);
  if (error) throw EnvironmentError("cannot remove " + path + ": " + error.message());
}

/// The files that are made from a result.
std::vector<const char*> drawn_names() {
  std::vector<const char*> names(std::begin(kPictureNames), std::end(kPictureNames));
  names.push_back(kReportName);
  return names;
}

/// Removes the manifest and the pictures of the run before, so that its result is none any more.
void remove_earlier_result(const std::string& dir) {
  remove_file(in_directory(dir, kManifestName));
  remove_file(in_directory(dir, kShownPictureName));
  for (const char* picture : drawn_names()) {
    remove_file(in_directory(dir, picture));
    remove_file(temporary_path(in_directory(dir, picture)));
  }
}

ResultManifest manifest_of(const CollageReport& report, const ResultSource& source, bool finished,
                           const std::string& pieces) {
  ResultManifest manifest;
  manifest.finished = finished;
  manifest.pieces_digest = text_digest(pieces);
  manifest.job_digest = text_digest(source.origin.job);
  manifest.library = source.library;
  manifest.library_digest = source.origin.library_digest;
  manifest.canvas_digest = source.origin.canvas_digest;
  manifest.overlay_digest = source.origin.overlay_digest;
  manifest.start = source.start;
  manifest.start_digest = source.start_digest;
  manifest.deformed = report.deformed.has_value();
  if (report.deformed) {
    manifest.shapes = report.deformed->shapes;
  } else {
    for (const Placement& placement : report.placements) manifest.shapes.push_back(placement.shape);
  }
  manifest.missing = pieces_of(report.missing);
  manifest.colours = report.colours;
  manifest.covered = report.covered;
  return manifest;
}

/// Writes the cards and returns the text of card.txt.
std::string write_cards(const std::string& dir, const CollageReport& report, const ResultSource& source) {
  const Quality quality = measured_quality(report, source.sizes);
  std::optional<DeformationFigures> deformation;
  if (report.deformed) deformation = report.deformed->figures;
  const std::string card = card_text(quality, report.statistics, source.card, deformation, report.missing);
  write_file_atomically(in_directory(dir, "card.json"), card_json(quality, report.statistics, source.card, report.ranks,
                                                                  report.record, deformation, report.missing));
  write_file_atomically(in_directory(dir, "card.txt"), card);
  return card;
}

}  // namespace

void prepare_output_directory(const std::string& dir) {
  make_folder(dir);
  check_takes_files(dir);
}

void check_can_be_published(const std::string& dir) {
  std::vector<const char*> names = {kManifestName, "pieces.geojson",  "job.toml",      "card.json",
                                    "card.txt",    kShownPictureName, "checkpoint.h5", "checkpoint.previous.h5"};
  for (const char* name : drawn_names()) names.push_back(name);
  for (const char* name : names) check_can_be_written(in_directory(dir, name));
}

void check_nothing_foreign_is_replaced(const std::string& dir, const std::string& job_file) {
  const auto is_there = [&](const char* name) {
    std::error_code error;
    return fs::exists(fs::path(dir) / name, error);
  };
  std::error_code error;
  if (fs::equivalent(fs::path(dir) / "job.toml", job_file, error) && !is_there(kManifestName)) {
    throw InputError(dir + ": a result there would replace the job file " + job_file + "; give another --out");
  }
  constexpr const char* kOurs[] = {kManifestName, "run.log", "card.json", "checkpoint.h5", "checkpoint.previous.h5"};
  if (std::any_of(std::begin(kOurs), std::end(kOurs), is_there)) return;
  std::vector<const char*> names = {"pieces.geojson", "card.txt", "job.toml", kShownPictureName};
  for (const char* name : drawn_names()) names.push_back(name);
  for (const char* name : names) {
    if (!is_there(name)) continue;
    throw InputError(in_directory(dir, name) +
                     ": exists, and no run of tessera wrote it; give another --out, or remove it");
  }
}

std::string publish_result(const std::string& dir, const CollageReport& report, const ResultSource& source,
                           bool finished) {
  remove_earlier_result(dir);
  const std::string pieces = geojson_text(report);
  write_file_atomically(in_directory(dir, "pieces.geojson"), pieces);
  write_file_atomically(in_directory(dir, "job.toml"), source.origin.job);
  if (source.shown_png) write_file_atomically(in_directory(dir, kShownPictureName), *source.shown_png);
  const ResultManifest manifest = manifest_of(report, source, finished, pieces);
  if (!finished) {
    for (const char* card : {"card.json", "card.txt"}) remove_file(in_directory(dir, card));
    write_manifest(dir, manifest);
  }
  const std::string card = write_cards(dir, report, source);
  if (finished) write_manifest(dir, manifest);
  return card;
}

}  // namespace tessera
