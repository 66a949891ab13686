#include "run/recognition/recognition_files.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/geometry/degrees.h"
#include "files/atomic_file.h"
#include "library/sheet.h"
#include "library/sheet_cell.h"
#include "recognition/answer_score.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

constexpr int kCell_px = 140;
constexpr int kCaptions_px = 34;
constexpr std::size_t kMostColumns = 10;
constexpr std::size_t kMostRows = 100;
constexpr double kMargin = 0.06;  // of a cell

RecognisedShape told(const Recognition& recognition, const Shape& head) {
  const Similarity& pose = recognition.query_from_shape;
  RecognisedShape shape;
  shape.name = head.name;
  shape.similarity = recognition.similarity;
  shape.score = answer_score(recognition, head.outline);
  if (head.drawn_scale_px > 0) shape.scale = double(pose.scale()) / double(head.drawn_scale_px);
  shape.rotation_deg = kDegreesPerRad * double(pose.rotation_rad());
  return shape;
}

void draw_query(cairo_t* cairo, const DrawnCurves& query, double x_px, double y_px) {
  Vec2 low = query.curves.front().points.front();
  Vec2 high = low;
  for (const Curve& curve : query.curves) {
    for (const Vec2 p : curve.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  const double side = std::max({double(high.x - low.x), double(high.y - low.y), 1.0});
  const double scale = kCell_px * (1 - 2 * kMargin) / side;
  cairo_save(cairo);
  cairo_translate(cairo, x_px + kCell_px / 2.0, y_px + kCell_px / 2.0);
  cairo_scale(cairo, scale, scale);
  cairo_translate(cairo, -double(low.x + high.x) / 2, -double(low.y + high.y) / 2);
  cairo_new_path(cairo);
  for (const Curve& curve : query.curves) {
    cairo_new_sub_path(cairo);
    for (const Vec2 p : curve.points) cairo_line_to(cairo, double(p.x), double(p.y));
    cairo_close_path(cairo);
  }
  cairo_set_source_rgb(cairo, 0.2, 0.2, 0.2);
  cairo_fill(cairo);
  cairo_restore(cairo);
}

}  // namespace

std::vector<RecognisedQuery> recognised_queries(const std::vector<std::string>& files, const Recognitions& found,
                                                const LibraryFile& library) {
  std::vector<RecognisedQuery> queries;
  for (std::size_t q = 0; q < files.size(); ++q) {
    RecognisedQuery query{files[q], {}};
    for (const Recognition& recognition : found[q]) {
      const std::size_t id = index_of(recognition.shape);
      const LibraryParts outline_alone{.outline = true, .field = false, .levels = 0, .artwork = false};
      const Shape head = library.read(id, id + 1, outline_alone).front();
      query.shapes.push_back(told(recognition, head));
    }
    queries.push_back(std::move(query));
  }
  return queries;
}

void write_recognitions(const std::string& path, const std::string& library,
                        const std::vector<RecognisedQuery>& queries, const std::vector<UnreadQuery>& unread) {
  nlohmann::ordered_json json;
  json["library"] = printable_utf8(library);
  json["queries"] = nlohmann::ordered_json::array();
  for (const RecognisedQuery& query : queries) {
    nlohmann::ordered_json shapes = nlohmann::ordered_json::array();
    for (const RecognisedShape& shape : query.shapes) {
      nlohmann::ordered_json one;
      one["shape"] = shape.name;
      one["similarity"] = shape.similarity;
      one["score"] = shape.score;
      if (shape.scale > 0) one["scale"] = shape.scale;
      one["rotation_deg"] = shape.rotation_deg;
      shapes.push_back(std::move(one));
    }
    json["queries"].push_back({{"file", printable_utf8(query.file)}, {"shapes", std::move(shapes)}});
  }
  for (const UnreadQuery& query : unread) {
    json["unread"].push_back({{"file", printable_utf8(query.file)}, {"reason", printable_utf8(query.reason)}});
  }
  write_file_atomically(path, json.dump(1) + "\n");
}

void write_recognition_sheet(const std::string& path, const std::vector<RecognisedQuery>& queries,
                             const std::vector<DrawnCurves>& drawn, const Recognitions& found,
                             const LibraryFile& library) {
  std::size_t most = 0;
  for (const std::vector<Recognition>& shapes : found) most = std::max(most, shapes.size());
  const std::size_t columns = 1 + std::min(most, kMostColumns - 1);
  const std::size_t rows = std::min(queries.size(), kMostRows);
  const SheetLayout layout{kCell_px, kCell_px, kCaptions_px, int(columns), int(rows)};
  const Sheet sheet(layout, sheet_title(library, library.size()));
  Drawers drawers({});
  for (std::size_t row = 0; row < rows; ++row) {
    const std::size_t first = row * columns;
    draw_query(sheet.cairo(), drawn[row], layout.x_px(first), layout.y_px(first));
    sheet.caption(first, 0, printable_utf8(std::filesystem::path(queries[row].file).filename().string()));
    for (std::size_t k = 0; k + 1 < columns && k < found[row].size(); ++k) {
      const std::size_t cell = first + 1 + k;
      const Shape shape = shape_for_sheet(library, index_of(found[row][k].shape));
      draw_on_sheet(sheet.cairo(), drawers, shape,
                    {double(layout.x_px(cell)), double(layout.y_px(cell)), double(kCell_px), true});
      sheet.caption(cell, 0, printable_utf8(shape.name));
      sheet.caption(cell, 1, "score " + std::to_string(queries[row].shapes[k].score).substr(0, 5));
    }
  }
  write_file_atomically(path, sheet.png(path));
}

}  // namespace tessera
