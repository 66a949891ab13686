#include "library/storage/column_readers.h"

#include <algorithm>
#include <span>

#include "library/hdf5/hdf5_attributes.h"
#include "library/storage/library_check.h"
#include "library/storage/library_open.h"
#include "library/storage/part_digest.h"
#include "library/storage/thumbnail_png.h"

namespace tessera {
namespace {

[[noreturn]] void out_of_range(const ColumnReader& column) {
  throw Hdf5Error("data set " + column.column().path + ": a value is out of range");
}

void check_level_attributes(hid_t file, std::size_t k) {
  const Hdf5Handle group(H5Gopen2(file, layout::level_group(k).c_str(), H5P_DEFAULT), layout::level_group(k));
  const SmoothingLevel& expected = kSmoothingLevels[k];
  if (read_float_attribute(group.get(), layout::kSigmaAttribute) != expected.sigma ||
      read_int_attribute(group.get(), layout::kCurvePointsAttribute) != expected.curve_points ||
      read_int_attribute(group.get(), layout::kSamplesAttribute) != expected.samples) {
    throw Hdf5Error("group " + layout::level_group(k) + ": another smoothing than this program's" + kBuildAgain);
  }
}

std::vector<float> read_floats(const ColumnReader& column, std::size_t begin, std::size_t end, float least,
                               float most) {
  std::vector<float> values = column.read<float>(begin, end);
  if (!all_within(values.data(), values.size(), least, most)) out_of_range(column);
  return values;
}

std::vector<float> read_lengths(const ColumnReader& column, std::size_t begin, std::size_t end) {
  return read_floats(column, begin, end, layout::kLeastLength, layout::kMaxCoordinate);
}

std::vector<Vec2> read_points(const ColumnReader& column, std::size_t begin, std::size_t end) {
  std::vector<Vec2> points = column.read<Vec2>(begin, end);
  if (!all_within(points.data(), points.size(), -layout::kMaxCoordinate, layout::kMaxCoordinate)) out_of_range(column);
  return points;
}

std::vector<std::string> read_texts(const ColumnReader& column, std::size_t begin, std::size_t end) {
  const auto bytes = std::ptrdiff_t(column.column().text_bytes);
  const std::vector<char> padded = column.read<char>(begin, end);
  std::vector<std::string> texts;
  for (auto at = padded.begin(); at != padded.end(); at += bytes) {
    texts.emplace_back(at, std::find(at, at + bytes, '\0'));
  }
  return texts;
}

/// Reads offsets [begin, end]; the last one is the end of the last group. Each group has `least` to `most` of `rows` rows.
std::vector<std::uint64_t> read_offsets(const ColumnReader& first, std::size_t begin, std::size_t end, std::size_t rows,
                                        std::size_t least, std::size_t most) {
  // They are stored as signed numbers, which suit numpy better; a negative one is out of range here.
  std::vector<std::uint64_t> offsets = first.read<std::uint64_t>(begin, end + 1);
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    if (offsets[i] > rows) out_of_range(first);
    if (i > 0 && (offsets[i] < offsets[i - 1] + least || offsets[i] - offsets[i - 1] > most)) out_of_range(first);
  }
  return offsets;
}

/// `lengths` holds l_{n-1} .. l_0 r_0 .. r_{n-1}.
ArclengthPyramid make_sample(const float* lengths, const Vec2* keypoints, float convexity, std::size_t n) {
  ArclengthPyramid sample;
  std::reverse_copy(lengths, lengths + n, sample.left.begin());
  std::copy(lengths + n, lengths + 2 * n, sample.right.begin());
  std::copy(keypoints, keypoints + 2 * n + 1, sample.keypoint.begin());
  sample.convexity = convexity;
  return sample;
}

/// The i-th of `count` parts of equal length.
template <class T>
std::span<const T> part_of(const std::vector<T>& rows, std::size_t i, std::size_t count) {
  const std::size_t length = rows.size() / count;
  return std::span(rows).subspan(i * length, length);
}

LevelCurve make_level(const LevelRows& rows, std::size_t n) {
  LevelCurve level{{rows.points.begin(), rows.points.end()}, rows.perimeter, {}};
  for (std::size_t j = 0; j < rows.convexity.size(); ++j) {
    level.samples.push_back(
        make_sample(rows.lengths.data() + j * 2 * n, rows.keypoints.data() + j * (2 * n + 1), rows.convexity[j], n));
  }
  return level;
}

}  // namespace

HeadReader::HeadReader(hid_t file, const layout::Columns& columns)
    : name_(file, columns.name),
      perimeter_(file, columns.perimeter),
      radius_(file, columns.radius),
      mean_lab_(file, columns.mean_lab),
      colour_spread_(ColumnReader::if_present(file, columns.colour_spread)),
      drawn_scale_(ColumnReader::if_present(file, columns.drawn_scale)),
      colour_grid_(ColumnReader::if_present(file, columns.colour_grid)) {}

std::vector<const ColumnReader*> HeadReader::columns() const {
  std::vector<const ColumnReader*> all{&name_, &perimeter_, &radius_, &mean_lab_};
  for (const auto* column : {&colour_spread_, &drawn_scale_, &colour_grid_}) {
    if (*column) all.push_back(&**column);
  }
  return all;
}

void HeadReader::read(const ShapeBatch& range) const {
  const auto name = read_texts(name_, range.begin, range.end);
  const auto perimeter = read_lengths(perimeter_, range.begin, range.end);
  const auto radius = read_lengths(radius_, range.begin, range.end);
  const auto lab = read_floats(mean_lab_, range.begin, range.end, -layout::kMaxLab, layout::kMaxLab);
  if (colour_spread_) {
    const auto spread = read_floats(*colour_spread_, range.begin, range.end, -1, layout::kMaxLab);
    for (std::size_t i = 0; i < range.count(); ++i) range.shapes[i].colour_spread = spread[i];
  }
  if (drawn_scale_) {
    const auto scale_px = read_floats(*drawn_scale_, range.begin, range.end, 0, layout::kMaxDrawnScale_px);
    for (std::size_t i = 0; i < range.count(); ++i) range.shapes[i].drawn_scale_px = scale_px[i];
  }
  if (colour_grid_) {
    const auto grids = colour_grid_->read<ColourGrid>(range.begin, range.end);
    for (std::size_t i = 0; i < range.count(); ++i) range.shapes[i].colour_grid = grids[i];
  }
  for (std::size_t i = 0; i < range.count(); ++i) {
    Shape& shape = range.shapes[i];
    if (name[i].empty()) out_of_range(name_);
    shape.name = name[i];
    shape.perimeter = perimeter[i];
    shape.radius = radius[i];
    shape.mean_lab = {lab[3 * i], lab[3 * i + 1], lab[3 * i + 2]};
  }
}

OutlineReader::OutlineReader(hid_t file, const layout::Columns& columns)
    : first_curve_(file, columns.first_curve),
      first_point_(file, columns.first_point),
      points_(file, columns.outline_points) {
  if (first_point_.rows() == 0) out_of_range(first_point_);
}

std::vector<std::uint64_t> OutlineReader::read(const ShapeBatch& range) const {
  const auto curves = read_offsets(first_curve_, range.begin, range.end, this->curves(), 1, layout::kMaxCurvesPerShape);
  const auto points =
      read_offsets(first_point_, curves.front(), curves.back(), points_.rows(), 3, layout::kMaxPointsPerShape);
  for (std::size_t i = 0; i < range.count(); ++i) {
    if (points[curves[i + 1] - curves[0]] - points[curves[i] - curves[0]] > layout::kMaxPointsPerShape)
      out_of_range(first_point_);
  }
  const std::vector<Vec2> xy = read_points(points_, points.front(), points.back());
  const auto start = [&](std::uint64_t curve) {
    return xy.begin() + std::ptrdiff_t(points[curve - curves[0]] - points[0]);
  };
  std::vector<std::uint64_t> digests;
  for (std::size_t i = 0; i < range.count(); ++i) {
    for (std::uint64_t c = curves[i]; c < curves[i + 1]; ++c) {
      range.shapes[i].outline.curves.emplace_back(start(c), start(c + 1));
    }
    digests.push_back(outline_digest(range.shapes[i].outline));
  }
  return digests;
}

FieldReader::FieldReader(hid_t file, const layout::Columns& columns)
    : distance_(file, columns.field_distance),
      scale_(file, columns.field_scale),
      extent_(file, columns.field_extent) {}

std::vector<std::uint64_t> FieldReader::read(const ShapeBatch& range) const {
  const auto quantised = distance_.read<std::int16_t>(range.begin, range.end);
  const auto step = read_floats(scale_, range.begin, range.end, 1e-9f, 1);
  const auto extent = read_lengths(extent_, range.begin, range.end);
  std::vector<std::uint64_t> digests;
  for (std::size_t i = 0; i < range.count(); ++i) {
    const std::span<const std::int16_t> steps = part_of(quantised, i, range.count());
    ShapeField& field = range.shapes[i].field;
    field.extent = extent[i];
    field.distance = Grid<float>(layout::kFieldNodes, layout::kFieldNodes);
    std::transform(steps.begin(), steps.end(), field.distance.data().begin(),
                   [&](std::int16_t steps_away) { return float(steps_away) * step[i]; });
    digests.push_back(field_digest(steps, step[i], extent[i]));
  }
  return digests;
}

LevelReader::LevelReader(hid_t file, const layout::LevelColumns& columns, std::size_t level)
    : level_(level),
      points_(file, columns.points),
      perimeter_(file, columns.perimeter),
      lengths_(file, columns.lengths),
      keypoints_(file, columns.keypoints),
      convexity_(file, columns.convexity) {
  check_level_attributes(file, level);
}

std::vector<std::uint64_t> LevelReader::read(const ShapeBatch& range, int pad_levels) const {
  const auto points = read_points(points_, range.begin, range.end);
  const auto perimeter = read_lengths(perimeter_, range.begin, range.end);
  const auto lengths = read_floats(lengths_, range.begin, range.end, 0, layout::kMaxCoordinate);
  const auto keypoints = read_points(keypoints_, range.begin, range.end);
  const auto convexity = read_floats(convexity_, range.begin, range.end, -1, 1);
  std::vector<std::uint64_t> digests;
  for (std::size_t i = 0; i < range.count(); ++i) {
    const LevelRows rows{part_of(points, i, range.count()), perimeter[i], part_of(lengths, i, range.count()),
                         part_of(keypoints, i, range.count()), part_of(convexity, i, range.count())};
    range.shapes[i].levels[level_] = make_level(rows, std::size_t(pad_levels));
    digests.push_back(level_digest(rows));
  }
  return digests;
}

BytesReader::BytesReader(hid_t file, const layout::Column& first, const layout::Column& bytes, std::size_t most)
    : most_(most),
      first_(file, first),
      bytes_(file, bytes) {}

void BytesReader::read(const ShapeBatch& range, std::vector<std::uint8_t> Artwork::*target) const {
  const auto first = read_offsets(first_, range.begin, range.end, bytes_.rows(), 0, most_);
  for (std::size_t i = 0; i < range.count(); ++i) {
    range.shapes[i].artwork.*target = bytes_.read<std::uint8_t>(first[i], first[i + 1]);
  }
}

SurroundingsReader::SurroundingsReader(hid_t file, const layout::Columns& columns)
    : margin_(ColumnReader::if_present(file, columns.surroundings_margin)) {
  if (margin_)
    png_.emplace(file, columns.first_surroundings_byte, columns.surroundings_bytes, layout::kMaxSurroundingsBytes);
}

std::vector<const ColumnReader*> SurroundingsReader::columns() const {
  if (!margin_) return {};
  std::vector<const ColumnReader*> all = png_->columns();
  all.push_back(&*margin_);
  return all;
}

void SurroundingsReader::read(const ShapeBatch& range) const {
  if (!margin_) return;
  png_->read(range, &Artwork::surroundings_png);
  const auto margin = margin_->read<std::int32_t>(range.begin, range.end);
  for (std::size_t i = 0; i < range.count(); ++i) {
    if (margin[i] < 0 || margin[i] > layout::kMaxSurroundingsMargin_px) out_of_range(*margin_);
    range.shapes[i].artwork.surroundings_margin_px = margin[i];
  }
}

ArtworkReader::ArtworkReader(hid_t file, const layout::Columns& columns, const std::filesystem::path& folder)
    : folder_(folder),
      path_(file, columns.artwork_path),
      size_(file, columns.artwork_size),
      centroid_(file, columns.artwork_centroid),
      unit_(file, columns.artwork_unit),
      thumbnail_(file, columns.first_thumbnail_byte, columns.thumbnail_bytes, layout::kMaxThumbnailBytes),
      beside_(ColumnReader::if_present(file, columns.artwork_beside)),
      sha256_(ColumnReader::if_present(file, columns.artwork_sha256)),
      reader_(ColumnReader::if_present(file, columns.artwork_reader)) {}

std::vector<const ColumnReader*> ArtworkReader::columns() const {
  std::vector<const ColumnReader*> all{&path_, &size_, &centroid_, &unit_};
  for (const ColumnReader* column : thumbnail_.columns()) all.push_back(column);
  for (const auto* column : {&beside_, &sha256_, &reader_}) {
    if (*column) all.push_back(&**column);
  }
  return all;
}

void ArtworkReader::read(const ShapeBatch& range) const {
  constexpr auto kLimit = float(layout::kMaxArtworkSize_px);
  const auto size = size_.read<std::int32_t>(range.begin, range.end);
  const auto centroid = read_floats(centroid_, range.begin, range.end, -kLimit, kLimit);
  const auto unit = read_floats(unit_, range.begin, range.end, layout::kLeastLength, kLimit);
  for (const std::int32_t side : size) {
    if (side < 1 || side > layout::kMaxArtworkSize_px) out_of_range(size_);
  }
  for (std::size_t i = 0; i < range.count(); ++i) {
    Artwork& artwork = range.shapes[i].artwork;
    artwork.width_px = size[2 * i];
    artwork.height_px = size[2 * i + 1];
    artwork.centroid_px = {centroid[2 * i], centroid[2 * i + 1]};
    artwork.unit_px = unit[i];
  }
  read_files(range);
  thumbnail_.read(range, &Artwork::thumbnail_png);
  for (std::size_t i = 0; i < range.count(); ++i) {
    const auto& png = range.shapes[i].artwork.thumbnail_png;
    if (!png.empty() && !is_thumbnail_png(png)) {
      throw Hdf5Error("damaged: the thumbnail of shape " + std::to_string(range.begin + i) +
                      " is not a PNG as tessera library build makes it");
    }
  }
}

void ArtworkReader::read_files(const ShapeBatch& range) const {
  const auto path = read_texts(path_, range.begin, range.end);
  for (std::size_t i = 0; i < range.count(); ++i) range.shapes[i].artwork.path = path[i];
  if (beside_) {
    const auto beside = read_texts(*beside_, range.begin, range.end);
    for (std::size_t i = 0; i < range.count(); ++i) {
      if (!beside[i].empty()) range.shapes[i].artwork.path_beside_library = (folder_ / beside[i]).lexically_normal();
    }
  }
  if (sha256_) {
    const auto sha256 = sha256_->read<Sha256>(range.begin, range.end);
    for (std::size_t i = 0; i < range.count(); ++i) {
      if (sha256[i] != Sha256{}) range.shapes[i].artwork.sha256 = sha256[i];
    }
  }
  constexpr std::int32_t kFirstReader = 1;  // of libraries that do not say it
  const auto reader =
      reader_ ? reader_->read<std::int32_t>(range.begin, range.end) : std::vector(range.count(), kFirstReader);
  for (std::size_t i = 0; i < range.count(); ++i) {
    if (reader[i] < kFirstReader || reader[i] > kArtworkReader) out_of_range(*reader_);
    range.shapes[i].artwork.reader = reader[i];
  }
}

}  // namespace tessera
