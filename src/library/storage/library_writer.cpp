#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>

#include "core/base/error.h"
#include "files/atomic_file.h"
#include "library/storage/library_check.h"
#include "library/storage/library_column.h"
#include "library/storage/library_create.h"
#include "library/storage/library_file.h"
#include "library/storage/part_digest.h"
#include "library/storage/segment_columns.h"

namespace tessera {
namespace {

constexpr float kLargestStep = 32767;  // of a quantised distance

class LevelWriter {
 public:
  LevelWriter(hid_t file, const layout::LevelColumns& columns)
      : points_(file, columns.points),
        perimeter_(file, columns.perimeter),
        lengths_(file, columns.lengths),
        keypoints_(file, columns.keypoints),
        convexity_(file, columns.convexity) {}

  /// Like all append() functions here, returns the digest of what was written.
  std::uint64_t append(const LevelCurve& level, int n) {
    std::vector<float> lengths, convexity;
    std::vector<Vec2> keypoints;
    for (const ArclengthPyramid& sample : level.samples) {
      for (int i = n - 1; i >= 0; --i) lengths.push_back(sample.left[i]);
      lengths.insert(lengths.end(), sample.right.begin(), sample.right.begin() + n);
      keypoints.insert(keypoints.end(), sample.keypoint.begin(), sample.keypoint.begin() + 2 * n + 1);
      convexity.push_back(sample.convexity);
    }
    points_.append(level.points.data(), 1);
    perimeter_.append(&level.perimeter, 1);
    lengths_.append(lengths.data(), 1);
    keypoints_.append(keypoints.data(), 1);
    convexity_.append(convexity.data(), 1);
    return level_digest({level.points, level.perimeter, lengths, keypoints, convexity});
  }

 private:
  ColumnWriter points_, perimeter_, lengths_, keypoints_, convexity_;
};

/// Writes any number of rows for each shape: the data, and the offset at which each shape's rows begin. The last offset is
/// the end.
class RaggedWriter {
 public:
  RaggedWriter(hid_t file, const layout::Column& first, const layout::Column& data)
      : first_(file, first),
        data_(file, data) {
    append_offset(0);
  }

  void append(const void* rows, std::size_t count) {
    data_.append(rows, count);
    append_offset(data_.rows());
  }
  std::size_t groups() const { return first_.rows() - 1; }

 private:
  void append_offset(std::uint64_t offset) { first_.append(&offset, 1); }

  ColumnWriter first_, data_;
};

bool are_multiples(const std::vector<float>& distances, float step) {
  return std::all_of(distances.begin(), distances.end(), [&](float d) { return std::round(d / step) * step == d; });
}

/// The size of one step of the field's 16 bits. The largest distance of a field that came from a library is rounded. Then
/// the step is a near one that reproduces all its distances, so that a copy has the same bits.
float step_of(const ShapeField& field) {
  constexpr int kRoundings = 4;
  const std::vector<float>& distances = field.distance.data();
  float largest = 1e-3f;
  for (const float d : distances) largest = std::max(largest, std::abs(d));
  const float step = largest / kLargestStep;
  float candidate = step;
  for (int i = 0; i < kRoundings / 2; ++i) candidate = std::nextafter(candidate, 0.f);
  for (int i = 0; i <= kRoundings; ++i, candidate = std::nextafter(candidate, largest)) {
    if (are_multiples(distances, candidate)) return candidate;
  }
  return step;
}

/// A field in 16 bits, with a step for each shape: about a ten-thousandth of a shape unit.
struct QuantisedField {
  explicit QuantisedField(const ShapeField& field) : step(step_of(field)) {
    distance.reserve(field.distance.data().size());
    for (const float d : field.distance.data()) {
      distance.push_back(std::int16_t(std::clamp(std::round(d / step), -kLargestStep, kLargestStep)));
    }
  }

  float step;
  std::vector<std::int16_t> distance;
};

class FieldWriter {
 public:
  FieldWriter(hid_t file, const layout::Columns& columns)
      : distance_(file, columns.field_distance),
        scale_(file, columns.field_scale),
        extent_(file, columns.field_extent) {}

  std::uint64_t append(const QuantisedField& field, float extent) {
    distance_.append(field.distance.data(), 1);
    scale_.append(&field.step, 1);
    extent_.append(&extent, 1);
    return field_digest(field.distance, field.step, extent);
  }

 private:
  ColumnWriter distance_, scale_, extent_;
};

class TextWriter {
 public:
  TextWriter(hid_t file, const layout::Column& column) : bytes_(column.text_bytes), column_(file, column) {}

  void append(const std::string& text) {
    std::vector<char> padded(bytes_, '\0');
    std::memcpy(padded.data(), text.data(), std::min(text.size(), bytes_ - 1));
    column_.append(padded.data(), 1);
  }

 private:
  std::size_t bytes_;
  ColumnWriter column_;
};

class ArtworkWriter {
 public:
  /// `folder`: the library's, absolute.
  ArtworkWriter(hid_t file, const layout::Columns& columns, const std::filesystem::path& folder)
      : folder_(folder),
        path_(file, columns.artwork_path),
        beside_(file, columns.artwork_beside),
        sha256_(file, columns.artwork_sha256),
        reader_(file, columns.artwork_reader),
        size_(file, columns.artwork_size),
        centroid_(file, columns.artwork_centroid),
        unit_(file, columns.artwork_unit),
        thumbnail_(file, columns.first_thumbnail_byte, columns.thumbnail_bytes),
        original_(file, columns.first_original_byte, columns.original_bytes),
        surroundings_(file, columns.first_surroundings_byte, columns.surroundings_bytes),
        margin_(file, columns.surroundings_margin) {}

  void append(const Artwork& artwork) {
    const std::int32_t size[2] = {artwork.width_px, artwork.height_px};
    path_.append(artwork.path);
    // The artwork of a copied shape may lie where its library was moved to.
    beside_.append(path_from_library(artwork.path_beside_library.empty() ? artwork.path : artwork.path_beside_library));
    sha256_.append(artwork.sha256.value_or(Sha256{}).data(), 1);
    const auto reader = std::int32_t(artwork.reader);
    reader_.append(&reader, 1);
    size_.append(size, 1);
    centroid_.append(&artwork.centroid_px, 1);
    unit_.append(&artwork.unit_px, 1);
    thumbnail_.append(artwork.thumbnail_png.data(), artwork.thumbnail_png.size());
    original_.append(artwork.original.data(), artwork.original.size());
    surroundings_.append(artwork.surroundings_png.data(), artwork.surroundings_png.size());
    const auto margin = std::int32_t(artwork.surroundings_margin_px);
    margin_.append(&margin, 1);
  }

 private:
  /// The path relative to the library. Empty where it would be too long.
  std::string path_from_library(const std::string& path) const {
    if (path.empty()) return {};
    const std::string relative = std::filesystem::path(path).lexically_relative(folder_);
    return relative.size() < layout::kPathBytes ? relative : std::string();
  }

  std::filesystem::path folder_;
  TextWriter path_, beside_;
  ColumnWriter sha256_, reader_, size_, centroid_, unit_;
  RaggedWriter thumbnail_, original_, surroundings_;
  ColumnWriter margin_;
};

class OutlineWriter {
 public:
  OutlineWriter(hid_t file, const layout::Columns& columns)
      : first_curve_(file, columns.first_curve),
        curves_(file, columns.first_point, columns.outline_points) {
    append_first_curve();
  }

  std::uint64_t append(const Outline& outline) {
    for (const std::vector<Vec2>& curve : outline.curves) curves_.append(curve.data(), curve.size());
    append_first_curve();
    return outline_digest(outline);
  }

 private:
  void append_first_curve() {
    const std::uint64_t first = curves_.groups();
    first_curve_.append(&first, 1);
  }

  ColumnWriter first_curve_;
  RaggedWriter curves_;
};

/// The shape in the form in which it will be read; its models are made of this.
Shape as_read(const Shape& shape, const QuantisedField& field) {
  Shape read = shape;
  read.artwork = {};
  std::transform(field.distance.begin(), field.distance.end(), read.field.distance.data().begin(),
                 [&](std::int16_t steps) { return float(steps) * field.step; });
  return read;
}

}  // namespace

struct LibraryWriter::State {
  State(const std::string& target, const PadParameters& parameters)
      : path(target),
        pad(parameters),
        file(create_library_file(target)) {}

  /// Members are destroyed from the last to the first, so the columns are closed before their file.
  struct Content {
    Content(hid_t file, const layout::Columns& columns, const PadParameters& pad, const std::filesystem::path& folder)
        : name(file, columns.name),
          perimeter(file, columns.perimeter),
          radius(file, columns.radius),
          mean_lab(file, columns.mean_lab),
          colour_spread(file, columns.colour_spread),
          drawn_scale(file, columns.drawn_scale),
          colour_grid(file, columns.colour_grid),
          style(file, columns.style),
          outline(file, columns),
          field(file, columns),
          artwork(file, columns, folder),
          part_digest(file, columns.part_digest),
          variant_of(file, columns.variant_of),
          segments(file, pad) {
      for (const layout::LevelColumns& level : columns.levels) levels.emplace_back(file, level);
    }

    TextWriter name;
    ColumnWriter perimeter, radius, mean_lab, colour_spread, drawn_scale, colour_grid, style;
    OutlineWriter outline;
    FieldWriter field;
    ArtworkWriter artwork;
    ColumnWriter part_digest, variant_of;
    std::vector<LevelWriter> levels;
    SegmentWriter segments;
  };

  std::string path;
  PadParameters pad;
  NewLibraryFile file;
  std::optional<Content> content;
};

namespace {

EnvironmentError write_error(const std::string& path, const Hdf5Error& error) {
  return EnvironmentError("cannot write " + path + ": " + error.what());
}

}  // namespace

LibraryWriter::LibraryWriter(const std::string& path, const PadParameters& pad) {
  const Hdf5Silence silence;
  try {
    state_ = std::make_unique<State>(path, pad);
    const hid_t file = state_->file.hdf5.get();
    write_library_header(file, pad);
    state_->content.emplace(file, layout::library_columns(pad.levels), pad,
                            std::filesystem::absolute(path).lexically_normal().parent_path());
  } catch (const Hdf5Error& error) {
    state_.reset();
    throw write_error(path, error);
  }
}

LibraryWriter::~LibraryWriter() {
  const Hdf5Silence silence;
  state_.reset();
}

void LibraryWriter::append(const Shape& shape, std::optional<std::uint32_t> variant_of, const StyleFeatures& style) {
  const Hdf5Silence silence;
  check_fits_library(shape, style);
  try {
    State::Content& to = *state_->content;
    to.name.append(shape.name);
    to.perimeter.append(&shape.perimeter, 1);
    to.radius.append(&shape.radius, 1);
    to.mean_lab.append(shape.mean_lab.data(), 1);
    to.colour_spread.append(&shape.colour_spread, 1);
    to.drawn_scale.append(&shape.drawn_scale_px, 1);
    to.colour_grid.append(shape.colour_grid.bytes.data(), 1);
    to.style.append(&style, 1);
    const QuantisedField field(shape.field);
    PartDigests digests{to.outline.append(shape.outline), to.field.append(field, shape.field.extent)};
    for (std::size_t k = 0; k < to.levels.size(); ++k) {
      digests[2 + k] = to.levels[k].append(shape.levels[k], state_->pad.levels);
    }
    to.segments.append(as_read(shape, field), segment_owner(shape, digests));
    const auto first = std::int32_t(variant_of.value_or(std::uint32_t(to.variant_of.rows())));
    to.part_digest.append(digests.data(), 1);
    to.variant_of.append(&first, 1);
    to.artwork.append(shape.artwork);
  } catch (const Hdf5Error& error) {
    throw write_error(state_->path, error);
  }
}

void LibraryWriter::finish() {
  const Hdf5Silence silence;
  State& state = *state_;
  try {
    state.content->segments.finish();
    // Flushes while the columns are open, because closing a column cannot report that the disk is full.
    hdf5_checked(H5Fflush(state.file.hdf5.get(), H5F_SCOPE_GLOBAL), "flush");
    state.content.reset();
    if (!state.file.hdf5.close()) throw Hdf5Error("close: " + last_hdf5_message());
  } catch (const Hdf5Error& error) {
    throw write_error(state.path, error);
  }
  state.file.disk->commit();
}

}  // namespace tessera
