#include "job/pieces/wish_resolution.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include "core/base/error.h"
#include "core/geometry/degrees.h"
#include "core/style/style_weight.h"
#include "job/job_keys.h"
#include "job/job_tables.h"
#include "job/pieces/wish_parts.h"
#include "library/name_globs.h"
#include "library/name_index.h"
#include "library/style_reference.h"
#include "text/nearest_name.h"
#include "text/number_text.h"
#include "text/pose.h"

namespace tessera {
namespace {

/// The value of the column; null where the row has none.
const JobValue* cell(const JobRow& row, const std::string& column) {
  const auto at = row.find(column);
  return at == row.end() ? nullptr : &at->second;
}

void read_poses(const JobRow& row, PoseWish& poses) {
  if (const JobValue* value = cell(row, "scale_px")) poses.scale_px = intervals_of(*value, 1);
  if (const JobValue* value = cell(row, "rotation_deg")) poses.rotation_rad = intervals_of(*value, kDegreesPerRad);
}

std::vector<std::string> names_of(const std::vector<NamedShape>& shapes) {
  std::vector<std::string> names;
  for (const NamedShape& shape : shapes) names.push_back(shape.name);
  return names;
}

class Resolution {
 public:
  Resolution(const std::vector<NamedShape>& shapes, const std::vector<std::string>& other_names, const Job& job)
      : shapes_(shapes),
        job_(job),
        shape_rows_(rows_of(job, "shapes")),
        region_rows_(rows_of(job, "regions")),
        given_rows_(rows_of(job, "given")),
        names_(names_of(shapes), other_names) {}

  Wishes wishes() {
    if (!region_rows_.empty() && job_.settings.pieces.fit_all) {
      fail("pieces.fit: found \"all\" where there are [[regions]], allowed: \"free\"");
    }
    for (const JobRow& row : region_rows_) add_region(row);
    if (!shape_rows_.empty() || job_.drawn_sizes || wishes_style(job_) || !job_.start.not_anew.empty()) add_classes();
    for (const JobRow& row : given_rows_) wishes_.given.push_back(given_piece(row));
    return std::move(wishes_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(job_.path + ": " + what); }

  /// Reports a mistake in a row of [[shapes]]; rows of the table beside the library come first.
  [[noreturn]] void fail_in_row(std::size_t row, const std::string& what) const {
    const std::vector<std::string>& places = job_.wishes_places;
    throw InputError((row < places.size() ? places[row] : job_.path) + ": [[shapes]] " + what);
  }

  /// The shapes that the row names.
  std::vector<std::uint32_t> chosen_by(std::size_t row) const {
    try {
      return chosen_names(names_, {shape_rows_[row].at("names").texts, {}}, "the library");
    } catch (const NamesNotFound& error) {
      fail_in_row(row, "names: " + error.reason());
    }
  }

  /// Shapes of start.not_anew with their mirror images.
  std::vector<std::uint32_t> not_anew() const {
    std::set<std::string> names(job_.start.not_anew.begin(), job_.start.not_anew.end());
    std::set<std::string> known;
    std::vector<std::uint32_t> shapes;
    for (std::uint32_t i = 0; i < shapes_.size(); ++i) {
      if (!names.contains(shapes_[i].name)) continue;
      known.insert(shapes_[i].name);
      shapes.push_back(i);
    }
    for (const std::string& name : names) {
      if (!known.contains(name)) fail("start.not_anew: the library has no shape \"" + name + "\"");
    }
    return shapes;
  }

  [[noreturn]] void fail_no_shape(const std::string& name) const {
    const std::string nearest = nearest_name(name, names_.names());
    fail("[[given]] shape: the library has no shape \"" + name + "\"" +
         (nearest.empty() ? "" : " (did you mean \"" + nearest + "\"?)") +
         "; tessera library info FILE --names lists them");
  }

  GivenPiece given_piece(const JobRow& row) const {
    const auto place = names_.find(row.at("shape").text);
    if (!place) fail_no_shape(row.at("shape").text);
    const JobValue* turned = cell(row, "rotation_deg");
    const std::vector<double>& at_px = row.at("at_px").numbers;
    return {ShapeId(*place),
            pose_of(row.at("scale_px").numbers[0], turned ? turned->numbers[0] : 0, at_px[0], at_px[1])};
  }

  void add_region(const JobRow& row) {
    RegionWish region;
    read_poses(row, region.poses);
    wishes_.regions.push_back(region);
    const std::string& name = row.at("name").text;
    const auto alike = std::count_if(region_rows_.begin(), region_rows_.end(), [&](const JobRow& other) {
      return other.at("name").text == name || other.at("colour").text == row.at("colour").text;
    });
    if (alike > 1) fail("[[regions]]: two with the name \"" + name + "\" or the colour " + row.at("colour").text);
  }

  /// The drawn size of a shape as the only one. With pieces.fit = "all" any size is allowed: only their proportions
  /// count.
  Interval as_drawn(std::size_t shape) const {
    const JobKey& range = *find_job_key("pieces", "scale_px");
    const float scale_px = shapes_[shape].drawn_scale_px;
    const std::string sizes = "pieces.sizes: found \"drawn\", but the shape \"" + shapes_[shape].name + "\" ";
    if (scale_px == 0)
      fail(sizes + "does not say how large it was drawn; build its library again with tessera library build");
    if (!job_.settings.pieces.fit_all && (scale_px < float(range.min) || scale_px > float(range.max))) {
      fail(sizes + "was drawn at " + fixed(scale_px, 1) + " px, allowed: " + fixed(range.min, 0) + " to " +
           fixed(range.max, 0) + " px, or a scale_px in [[shapes]], or pieces.fit = \"all\"");
    }
    return {scale_px, scale_px};
  }

  /// The step of style for each shape; empty where no style is wished for.
  std::vector<int> style_steps() const {
    if (!wishes_style(job_)) return {};
    std::vector<StylePlace> places;
    for (const NamedShape& shape : shapes_) {
      if (!shape.style.known()) fail("style.like: " + unknown_style_text("the library", shape.name));
      places.push_back(style_place(shape.style));
    }
    const StylePlace wished = wished_style(places);
    std::vector<int> steps;
    for (const StylePlace& place : places)
      steps.push_back(style_step(style_distance(place, wished), float(job_.style.weight)));
    return steps;
  }

  StylePlace wished_style(const std::vector<StylePlace>& places) const {
    try {
      return style_reference(names_, places, job_.style.like);
    } catch (const NamesNotFound& error) {
      fail("style.like: " + error.reason());
    }
  }

  /// Makes the classes: shapes with the same rows, drawn size and step of style are one class.
  void add_classes() {
    WishParts parts(shapes_.size());
    for (std::size_t row = 0; row < shape_rows_.size(); ++row) {
      parts.add_row(chosen_by(row), [&](ShapeWish& wish) { read_row(row, wish); });
    }
    if (!job_.start.not_anew.empty()) parts.add_row(not_anew(), [](ShapeWish& wish) { wish.weight = 0; });
    const std::vector<int> steps = style_steps();
    std::map<std::tuple<std::uint32_t, float, int>, std::uint32_t> class_of;  // by part, drawn size and step of style
    for (std::size_t shape = 0; shape < shapes_.size(); ++shape) {
      const std::uint32_t part = parts.part_of(shape);
      const ShapeWish& wish = parts.wish(part);
      const bool drawn = job_.drawn_sizes && wish.weight > 0 && wish.poses.scale_px.empty();
      const Interval scale_px = drawn ? as_drawn(shape) : Interval{};
      const int step = steps.empty() ? 0 : steps[shape];
      const auto [at, is_new] = class_of.try_emplace({part, scale_px.min, step}, std::uint32_t(wishes_.classes.size()));
      if (is_new) wishes_.classes.push_back(wish);
      if (is_new) wishes_.classes.back().weight *= style_worth(step);
      if (is_new && drawn) wishes_.classes.back().poses.scale_px = {scale_px};
      wishes_.class_of_shape.push_back(at->second);
    }
  }

  void read_row(std::size_t i, ShapeWish& wish) const {
    const JobRow& row = shape_rows_[i];
    read_poses(row, wish.poses);
    if (const JobValue* value = cell(row, "weight")) wish.weight = float(value->numbers[0]);
    if (const JobValue* value = cell(row, "uses")) {
      wish.least_uses = int(value->numbers[0]);
      wish.uses = int(value->numbers[1]);
    }
    if (const JobValue* value = cell(row, "apart_px")) wish.apart = {std::uint32_t(i), float(value->numbers[0])};
    if (const JobValue* value = cell(row, "deform")) wish.deforms = value->text == "yes";
    if (const JobValue* value = cell(row, "regions")) wish.in_region = regions_named(value->texts, i);
  }

  std::vector<std::uint8_t> regions_named(const std::vector<std::string>& names, std::size_t shape_row) const {
    std::vector<std::uint8_t> in_region(std::max<std::size_t>(1, region_rows_.size()), 0);
    for (const std::string& name : names) {
      const auto at = std::find_if(region_rows_.begin(), region_rows_.end(),
                                   [&](const JobRow& row) { return row.at("name").text == name; });
      if (at == region_rows_.end()) {
        fail_in_row(shape_row, "regions: there are no [[regions]] with the name \"" + name + "\"");
      }
      in_region[std::size_t(at - region_rows_.begin())] = 1;
    }
    return in_region;
  }

  const std::vector<NamedShape>& shapes_;
  const Job& job_;
  const std::vector<JobRow>& shape_rows_;
  const std::vector<JobRow>& region_rows_;
  const std::vector<JobRow>& given_rows_;
  const NameIndex names_;
  Wishes wishes_;
};

/// Sizes of shapes and regions may lie outside [pieces] scale_px; drawn sizes always do.
void widen_scales(PieceSettings& pieces, const Wishes& wishes, bool drawn_sizes) {
  pieces.several.scale_px = pieces.poses().scale_px;
  const auto has_sizes = [](const ShapeWish& shape) { return !shape.poses.scale_px.empty(); };
  if (drawn_sizes && std::any_of(wishes.classes.begin(), wishes.classes.end(), has_sizes)) {
    pieces.min_scale_px = std::numeric_limits<float>::max();
    pieces.max_scale_px = 0;
  }
  const auto widen = [&](const PoseWish& poses) {
    for (const Interval& scale_px : poses.scale_px) {
      pieces.min_scale_px = std::min(pieces.min_scale_px, scale_px.min);
      pieces.max_scale_px = std::max(pieces.max_scale_px, scale_px.max);
    }
  };
  for (const ShapeWish& shape : wishes.classes) widen(shape.poses);
  for (const RegionWish& region : wishes.regions) widen(region.poses);
}

}  // namespace

bool wishes_style(const Job& job) { return !job.style.like.empty() && job.style.weight > 0; }

bool has_shape_wishes(const Job& job) {
  return job.drawn_sizes || wishes_style(job) || !job.start.not_anew.empty() || !rows_of(job, "shapes").empty() ||
         !rows_of(job, "given").empty();
}

void resolve_wishes(const std::vector<NamedShape>& shapes, Job& job, const std::vector<std::string>& other_names) {
  job.settings.wishes = Resolution(shapes, other_names, job).wishes();
  widen_scales(job.settings.pieces, job.settings.wishes, job.drawn_sizes);
}

}  // namespace tessera
