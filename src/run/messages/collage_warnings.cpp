#include "run/messages/collage_warnings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "core/base/count_text.h"
#include "core/base/stop.h"
#include "core/collage/former_pieces.h"
#include "core/collage/standing_check.h"
#include "job/canvas/canvas_enclosure.h"
#include "job/job_keys.h"
#include "job/job_tables.h"
#include "job/job_value.h"
#include "master/relaxing.h"
#include "master/replacing.h"
#include "text/number_text.h"

namespace tessera {
namespace {

double covered_fraction(const Canvas& canvas, const master::CollageResult& result) {
  double covered_px2 = 0;
  for (const Placement& piece : result.placements) {
    const double scale_px = piece.canvas_from_shape.scale();
    covered_px2 += scale_px * scale_px;
  }
  return covered_px2 / canvas.area_px2;
}

/// The text about those places in `found` (ascending) that lie from `begin` to `end`; empty where there are none.
std::string misplaced_text(const std::vector<std::size_t>& found, std::size_t begin, std::size_t end, const char* where,
                           const std::function<std::string(std::size_t)>& name) {
  const auto first = std::lower_bound(found.begin(), found.end(), begin);
  const auto last = std::lower_bound(found.begin(), found.end(), end);
  if (first == last) return "";
  return count_text(std::size_t(last - first), "lies", "lie") + " " + where + ", the first is number " +
         std::to_string(*first - begin) + ", \"" + name(*first) + "\"";
}

std::string text_of(master::NoRelaxing reason, const PieceSettings& pieces) {
  switch (reason) {
    case master::NoRelaxing::not_wanted: return "improve.relax is false";
    case master::NoRelaxing::sizes_by_place: return "their sizes depend on the place (pieces.size_map)";
    case master::NoRelaxing::colours_by_place: return "they are chosen by what they cover (colour.image)";
    case master::NoRelaxing::sizes_fixed: return "their sizes are fixed (pieces.scale_px, pieces.sizes, [[shapes]])";
    case master::NoRelaxing::sizes_differ: break;
  }
  char text[200];
  std::snprintf(
      text, sizeof text,
      "their sizes differ too much, %g to %g px (pieces.scale_px); allowed: a largest of %g times the smallest",
      double(pieces.min_scale_px), double(pieces.max_scale_px), double(master::kMostRelaxedSizeRatio));
  return text;
}

/// The warning of a drawing that is only an outline, otherwise empty. `covered`: part of what the drawing encloses. `used`:
/// what the program does with the lines.
std::string outline_text(const std::string& key, const std::string& file, double covered, const std::string& used) {
  if (covered >= kMostCoveredByOutline) return "";
  const std::string percent = covered < 0.01 ? "less than 1" : fixed(100 * covered, 0);
  return key + ": " + file + ": the drawing covers " + percent + " % of what it encloses, so that only its lines are " +
         used +
         "; fill its path in the drawing (in an SVG fill=\"black\" instead of \"none\") if you meant the whole area";
}

std::string idle_deform_warning(const Job& job) {
  const DeformKind kind = job.settings.deform.kind;
  if (kind == DeformKind::capped) return "";
  for (const char* key : {"most_px", "most_part", "most_area", "most_pad"}) {
    if (!WrittenKeys(job).is_default("deform", key))
      return WrittenKeys(job).with_value("deform", key) + " means nothing without deform.kind = \"capped\"";
  }
  return "";
}

}  // namespace

std::string replaced_result_warning(const EarlierResult& earlier, const Job& job) {
  if (!earlier.damage.empty()) {
    return earlier.folder + ": this run replaces a result that is not whole: " + earlier.damage;
  }
  const std::string differences = earlier.finished() ? result_differences(earlier.whole->job, job) : "";
  if (differences.empty()) return "";
  return earlier.folder + ": the finished result of another job is replaced as soon as a piece is placed" +
         differences + "; another --out keeps it";
}

std::string limit_that_ended(const RunStatistics& run) {
  const auto by = run.stopped_by;
  const bool is_limit = by == StopReason::seconds || by == StopReason::pieces || by == StopReason::coverage;
  return is_limit ? std::string(stop_word(*by)) : "";
}

std::string empty_result_warning(const std::string& folder, const WrittenKeys& keys,
                                 const master::CollageResult& result, const std::vector<std::string>& what_to_try) {
  if (result.unfinished || !result.placements.empty()) return "";
  const std::string text = folder + ": the collage is empty: ";
  if (const std::string limit = limit_that_ended(result.statistics); !limit.empty()) {
    return text + keys.with_value("stop", limit.c_str()) + " ended it before the first piece";
  }
  if (what_to_try.empty()) {
    return text +
           "no shape may stand: weights, regions and names of [[shapes]], style.like and start.not_anew leave none";
  }
  return text + "nothing fits; try " + joined_warnings(what_to_try);
}

std::string incomplete_warning(const std::string& folder, const ResultManifest& manifest) {
  if (manifest.complete()) return "";
  if (manifest.shapes.empty()) return folder + ": the collage is empty; run.log says why";
  return folder + ": " + count_text(manifest.missing, "piece is", "pieces are") + " missing; card.txt names them";
}

std::string used_up_warning(const PieceSettings& pieces, bool drawn_sizes, const Canvas& canvas,
                            const master::CollageResult& result) {
  constexpr double kFilled = 0.85;  // of the canvas, by a library that fits it
  const double covered = covered_fraction(canvas, result);
  if (result.statistics.stopped_by != StopReason::used_up || pieces.fit_all) return "";
  if (covered <= 0 || covered >= kFilled - 0.1) return "";
  const double factor = std::sqrt(kFilled / covered);
  const std::string sizes = "pieces.scale_px = [" + fixed(factor * double(pieces.min_scale_px), 0) + ", " +
                            fixed(factor * double(pieces.max_scale_px), 0) + "], or ";
  return "the library is used up with " + fixed(100 * covered, 0) + " % of the canvas covered; pieces " +
         fixed(factor, 1) + " times as large would fill it: " + (drawn_sizes ? "" : sizes) +
         "pieces.fit = \"all\"; so would more uses (pieces.uses)";
}

std::string standing_warning(const CollageSettings& collage, std::size_t first_of_start, StartKeep keep,
                             const Canvas& canvas, const std::function<const Shape&(ShapeId)>& shape) {
  const std::vector<GivenPiece>& pieces = collage.wishes.given;
  const auto name = [&](std::size_t piece) { return shape(pieces[piece].shape).name; };
  const PieceSettings& settings = collage.pieces;
  const GivenPieceCheck found =
      check_given_pieces(canvas, pieces, settings.padding_px > 0 ? 0 : settings.overlap_px, shape);
  const std::size_t end_of_overlaps = keep == StartKeep::standing ? first_of_start : pieces.size();
  const char* in_a_zone = "in a zone that pieces keep out of";
  const std::string given = misplaced_text(found.kept_out, 0, first_of_start, in_a_zone, name);
  std::string start;
  for (const std::string& part :
       {misplaced_text(found.kept_out, first_of_start, pieces.size(), in_a_zone, name),
        misplaced_text(found.outside, first_of_start, pieces.size(), "outside the canvas", name),
        misplaced_text(found.overlapping, first_of_start, end_of_overlaps, "on pieces before them", name)}) {
    if (!part.empty()) start += (start.empty() ? "" : "; ") + part;
  }
  std::string text;
  if (!given.empty()) text = "of [[given]] " + given;
  if (!start.empty()) text += (text.empty() ? "" : "; ") + ("of start.pieces " + start);
  return text.empty() ? text : text + "; they stand as they are";
}

std::string idle_dpi_warning(const Job& job) {
  if (WrittenKeys(job).is_default("output", "dpi") || job.output.width_mm > 0 || job.canvas.width_mm > 0) return "";
  return WrittenKeys(job).with_value("output", "dpi") +
         " means nothing without a size on paper: output.width_mm, or canvas.size_mm; the picture is " +
         std::to_string(job.output.width_px) + " px wide (output.width_px)";
}

std::string idle_shift_warning(const Job& job) {
  if (WrittenKeys(job).is_default("colour", "shift") || !job.colour.image.empty()) return "";
  return WrittenKeys(job).with_value("colour", "shift") + " means nothing without colour.image";
}

std::string idle_light_warning(const Job& job) {
  if (WrittenKeys(job).is_default("output", "background_light") || job.output.background == kImageBackground) return "";
  return WrittenKeys(job).with_value("output", "background_light") +
         " means nothing without output.background = \"image\"";
}

std::string idle_keys_warning(const Job& job) {
  std::vector<std::string> warnings = {idle_dpi_warning(job)};
  if (job.settings.pieces.padding_px > 0 && !WrittenKeys(job).is_default("pieces", "overlap_px")) {
    warnings.push_back(WrittenKeys(job).with_value("pieces", "overlap_px") + " does not count beside " +
                       WrittenKeys(job).with_value("pieces", "padding_px") + ", which keeps all pieces apart");
  }
  if (!job.settings.pieces.fit_all && !WrittenKeys(job).is_default("pieces", "least_scale_px")) {
    warnings.push_back(WrittenKeys(job).with_value("pieces", "least_scale_px") +
                       " means nothing without pieces.fit = \"all\"");
  }
  if (WrittenKeys(job).is_default("library", "colours") && !WrittenKeys(job).is_default("library", "colours_within")) {
    warnings.push_back(WrittenKeys(job).with_value("library", "colours_within") +
                       " means nothing without library.colours");
  }
  if (job.colour.image.empty() && !WrittenKeys(job).is_default("colour", "weight")) {
    warnings.push_back(WrittenKeys(job).with_value("colour", "weight") + " means nothing without colour.image");
  }
  warnings.push_back(idle_shift_warning(job));
  warnings.push_back(idle_light_warning(job));
  warnings.push_back(idle_deform_warning(job));
  return joined_warnings(warnings);
}

namespace {

/// "30, 5, 60" where the intervals are three or more single sizes that do not rise; otherwise empty.
std::string values_that_do_not_rise(const std::vector<double>& intervals) {
  std::vector<double> sizes;
  std::string text;
  for (std::size_t i = 0; i + 1 < intervals.size(); i += 2) {
    if (intervals[i] != intervals[i + 1]) return "";
    sizes.push_back(intervals[i]);
    text += (text.empty() ? "" : ", ") + significant(intervals[i], 6);
  }
  return sizes.size() >= 3 && !std::is_sorted(sizes.begin(), sizes.end()) ? text : "";
}

/// The warning of a decimal comma; empty where `intervals` show none.
std::string decimal_comma_text(const std::string& place, const std::string& key, const std::vector<double>& intervals) {
  const std::string values = values_that_do_not_rise(intervals);
  if (values.empty()) return "";
  return place + key + " = [" + values + "] is " +
         count_text(intervals.size() / 2, key == "scale_px" ? "size" : "angle") +
         ", one after the other; where a decimal comma was meant, write a point: 30.5, not 30,5";
}

}  // namespace

std::string decimal_comma_warning(const Job& job) {
  std::vector<std::string> warnings;
  for (const char* key : {"scale_px", "rotation_deg"}) {
    warnings.push_back(decimal_comma_text("pieces.", key, find_job_key("pieces", key)->get(job).numbers));
    std::size_t number = 0;
    for (const JobRow& row : rows_of(job, "shapes")) {
      ++number;
      const auto values = row.find(key);
      if (values == row.end()) continue;
      warnings.push_back(
          decimal_comma_text("[[shapes]] " + std::to_string(number) + ": ", key, values->second.numbers));
    }
  }
  return joined_warnings(warnings);
}

std::string unable_library_warning(const ColourSpec& colour, std::size_t shapes, bool one_colour) {
  constexpr std::size_t kFew = 50;
  if (colour.image.empty()) return "";
  if (one_colour && colour.pieces != "palette") {
    return "nearly all shapes of the library have one colour and cannot show colour.image; colour.pieces = "
           "\"palette\" draws them in the colours of the palette that are nearest to it";
  }
  if (shapes >= kFew || colour.pieces == "palette") return "";
  return "a library of " + count_text(shapes, "shape") +
         " has few colours to show colour.image, and few shapes to cover it with (3 to 40 shapes covered 78 to 81 % of "
         "a "
         "picture, 419 covered 84); a photo needs 500 or more";
}

std::string outline_alone_warning(const CanvasSpec& spec, const Canvas& canvas) {
  std::vector<std::string> warnings;
  if (!spec.file.empty() && spec.region_colours.empty())
    warnings.push_back(outline_text("canvas.file", spec.file, covered_share(canvas), "filled"));
  if (!spec.keep_out.empty() && spec.keep_out_rectangles.empty())
    warnings.push_back(outline_text("canvas.keep_out", spec.keep_out, zones_part_of_enclosed(canvas), "kept free"));
  return joined_warnings(warnings);
}

std::string idle_relaxing_warning(const CollageSettings& settings) {
  const std::optional<master::NoRelaxing> reason = master::why_not_relaxed(settings);
  return reason ? "the pieces are not relaxed, as " + text_of(*reason, settings.pieces) : "";
}

std::string empty_room_warning(std::size_t removed, std::size_t given, const master::CollageResult& result) {
  if (removed == 0 || result.unfinished || result.placements.size() > given) return "";
  return "no piece was placed for the " + count_text(removed, "piece") +
         " of start.remove: no shape that may stand there fits, or a limit of [stop] was reached";
}

std::string come_back_warning(const std::vector<GivenPiece>& removed, std::size_t given, const Canvas& canvas,
                              const master::CollageResult& result, const std::vector<std::uint32_t>& silhouettes) {
  if (result.unfinished) return "";
  const std::size_t standing = std::min(given, result.placements.size());
  const auto back = std::count_if(removed.begin(), removed.end(), [&](const GivenPiece& piece) {
    return std::any_of(result.placements.begin() + std::ptrdiff_t(standing), result.placements.end(),
                       [&](const Placement& p) {
                         return silhouettes[index_of(p.shape)] == silhouettes[index_of(piece.shape)] &&
                                is_at_former_place(piece.canvas_from_shape, p.canvas_from_shape, canvas.period);
                       });
  });
  if (back == 0) return "";
  return std::to_string(back) + " of " + count_text(removed.size(), "piece") +
         " of start.remove came back to where they lay: the library, [[shapes]] and pieces.uses " +
         "allow no other drawing there";
}

std::string nothing_gained_warning(const CollageSettings& settings, const master::CollageResult& result) {
  const RunStatistics& run = result.statistics;
  if (result.unfinished || run.trials == 0 || run.trials_kept > 0 || master::why_not_relaxed(settings)) return "";
  return "no trial was an improvement, out of " + std::to_string(run.trials) + ": the pieces have not moved" +
         (master::pays_to_replace(settings) ? "; with more --trials pieces are exchanged, too" : "");
}

std::string joined_warnings(const std::vector<std::string>& warnings) {
  std::string text;
  for (const std::string& warning : warnings) text += (text.empty() || warning.empty() ? "" : "; ") + warning;
  return text;
}

}  // namespace tessera
