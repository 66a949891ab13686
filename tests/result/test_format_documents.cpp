// The numbers and names in docs/checkpoint-format.md, docs/library-format.md and docs/result-format.md equal those of the source.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "checkpoint/checkpoint_columns.h"
#include "checkpoint/checkpoint_seal.h"
#include "core/pad/pad_index.h"
#include "library/storage/library_layout.h"
#include "library/storage/segment_layout.h"
#include "result/folder/result_manifest.h"
#include "support/library_columns.h"
#include "support/scratch_folder.h"
#include "text/number_text.h"

namespace tessera {
namespace test_format_documents {

std::string document(const std::string& name) {
  std::ifstream file(std::string(TESSERA_SOURCE_DIR) + "/docs/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A document whose sentences may have line breaks anywhere.
class Document {
 public:
  explicit Document(const std::string& name) : name_(name), lines_(document(name)), text_(lines_) {
    for (char& c : text_) c = c == '\n' ? ' ' : c;
  }

  void expect(const std::string& text) const {
    EXPECT_NE(text_.find(text), std::string::npos) << "docs/" << name_ << " lacks: " << text;
  }
  void expect_line(const std::string& line) const {
    EXPECT_NE(("\n" + lines_).find("\n" + line + "\n"), std::string::npos) << "docs/" << name_ << " lacks: " << line;
  }
  /// Expects a table row with this beginning.
  void expect_row(const std::string& begin) const {
    EXPECT_NE(lines_.find("\n| " + begin), std::string::npos) << "docs/" << name_ << " lacks a row: " << begin;
  }

 private:
  std::string name_, lines_, text_;
};

/// Turns 4000000 into "4,000,000".
std::string grouped(std::size_t number) {
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, 1, ',');
  return text;
}

constexpr std::size_t kKiB = 1024, kMiB = kKiB * kKiB;

TEST(CheckpointDocument, has_the_seal_that_is_written) {
  const Document text("checkpoint-format.md");
  text.expect_line("version " + std::to_string(kCheckpointVersion));
  text.expect("The first " + std::to_string(kSealBytes) + " bytes are text");
  text.expect("(the " + std::to_string(kSealBytes) + " bytes are its user block");
  text.expect("at most " + std::to_string(kMaxCheckpointBytes / kMiB) + " MiB in all");
}

TEST(CheckpointDocument, has_every_data_set) {
  const Document text("checkpoint-format.md");
  CheckpointColumns columns;
  each_column(columns, [&](const std::string& path, const auto&, int row, const char*, const char*) {
    text.expect("`" + (path.starts_with("/moving/") ? "/moving" : path.substr(0, path.find('/', 1))));
    text.expect(path.substr(path.rfind('/')) + "`");
    if (row > 4) text.expect("x " + std::to_string(row) + " |");
  });
}

TEST(LibraryDocument, has_the_versions) {
  const Document text("library-format.md");
  text.expect_row("`format` | text | `" + std::string(layout::kFormat) + "` |");
  text.expect_row("`version` | int32 | " + std::to_string(layout::kVersion) + ", see below |");
  text.expect("its attribute `version` (" + std::to_string(kModelsVersion) + ")");
  text.expect("`segment_shapes` is " + grouped(kSegmentShapes));
  text.expect_row("`pad_levels` | int32 | n, levels of the PAD, 2 to " + std::to_string(kMaxPadLevels));
}

std::string type_of(const layout::Column& column) {
  switch (column.element) {
    case layout::Element::float32: return "float32";
    case layout::Element::int16: return "int16";
    case layout::Element::int32: return "int32";
    case layout::Element::int64: return "int64";
    case layout::Element::uint64: return "uint64";
    case layout::Element::uint8: return "uint8";
    case layout::Element::text: return "text of " + std::to_string(column.text_bytes) + " bytes";
  }
  return "";
}

TEST(LibraryDocument, has_every_data_set_with_its_type_and_rows) {
  const Document text("library-format.md");
  for (const layout::Column& column : test::columns_beside_levels(layout::library_columns(5))) {
    const std::string begin = "`" + column.path + "` | " + type_of(column) + " |";
    text.expect_row(begin);
    std::string row_dims;
    for (const std::size_t dim : column.row_dims) row_dims += " x " + std::to_string(dim);
    if (!row_dims.empty()) text.expect_row(begin + (column.path == "/outline/points" ? " P" : " N") + row_dims + " |");
  }
}

TEST(LibraryDocument, has_the_smoothing_levels) {
  const Document text("library-format.md");
  std::string sigma = "`sigma`, of the Gaussian along the curve | float32 | shape |";
  std::string points = "`curve_points` | int32 | |", samples = "`samples` | int32 | |";
  for (const SmoothingLevel& level : kSmoothingLevels) {
    sigma += " " + fixed(double(level.sigma), 6) + " |";
    points += " " + std::to_string(level.curve_points) + " |";
    samples += " " + std::to_string(level.samples) + " |";
  }
  for (const std::string& row : {sigma, points, samples}) text.expect_row(row);
}

TEST(LibraryDocument, has_the_limits_of_a_reader) {
  const Document text("library-format.md");
  text.expect_row("all data sets in memory | " + std::to_string(layout::kMaxInflation) + " times the size of the file");
  text.expect_row("shapes | " + grouped(layout::kMaxShapes) + " |");
  text.expect_row("curves of a shape; points of all of them | 1 to " + grouped(layout::kMaxCurvesPerShape) + "; 3 to " +
                  grouped(layout::kMaxPointsPerShape) + " |");
  const std::string most = grouped(std::size_t(layout::kMaxCoordinate));
  text.expect_row("coordinates and distances | -" + most + " to " + most + " shape units |");
  text.expect_row("lengths of curves, radius, extent | " + fixed(double(layout::kLeastLength), 6) + " to " + most);
  const std::string side = std::to_string(layout::kMaxThumbnailSide_px);
  text.expect_row("thumbnail | " + side + " x " + side + " px of 8-bit RGBA, " +
                  std::to_string(layout::kMaxThumbnailBytes / kKiB) + " KiB |");
  text.expect_row("embedded original | " + std::to_string(layout::kMaxOriginalBytes / kMiB) + " MiB |");
}

TEST(ResultDocument, has_the_format_of_the_manifest) {
  const test::ScratchFolder folder;
  write_manifest(folder.path(""), {});
  std::ifstream file(folder.path("manifest.json"));
  const int format = nlohmann::json::parse(file)["format"];
  Document("result-format.md").expect_row("`format` | " + std::to_string(format) + " |");
}

}  // namespace test_format_documents
}  // namespace tessera
