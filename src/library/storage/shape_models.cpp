#include "library/storage/shape_models.h"

#include <algorithm>

#include "core/matching/matching_context.h"

namespace tessera {
namespace {

constexpr std::size_t kShapesAtATime = 128;  // about 20 MB

LibraryParts parts_for(const std::vector<int>& levels) {
  LibraryParts parts{.outline = true, .field = true, .levels = 0, .artwork = false, .original = false};
  for (const int level : levels) parts.levels |= 1u << level;
  return parts;
}

}  // namespace

std::vector<ShapeModel> read_models(const ShapeLibrary& library, const ShapeRange& range,
                                    const MatchingContext& context) {
  std::vector<ShapeModel> models;
  for (std::size_t begin = range.begin; begin < range.end; begin += kShapesAtATime) {
    const std::size_t end = std::min<std::size_t>(range.end, begin + kShapesAtATime);
    for (const Shape& shape : library.read(begin, end, parts_for(context.levels))) {
      models.push_back(make_shape_model(shape, library.pad_parameters(), context.pad, context.levels));
    }
  }
  return models;
}

std::shared_ptr<const ModelSource> models_of(const ShapeLibrary& library, const MatchingContext& context) {
  if (auto stored = library.stored_models(context)) return stored;
  return std::make_shared<MadeModels>(
      [&library, context](const ShapeRange& range) { return read_models(library, range, context); });
}

}  // namespace tessera
