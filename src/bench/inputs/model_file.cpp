#include "bench/inputs/model_file.h"

#include <algorithm>
#include <filesystem>
#include <functional>

#include "core/base/digest.h"
#include "files/atomic_file.h"
#include "files/regular_file.h"
#include "library/storage/segment_bytes.h"
#include "library/storage/stored_models.h"

namespace tessera::bench {
namespace {

constexpr std::uint64_t kHeadBytes = sizeof(std::uint64_t);  // a digest that identifies the content

std::uint64_t digest_of(const VariedShapes& shapes, std::uint32_t count, const SegmentKind& kind) {
  Digest digest;
  digest.add(shapes.content_digest());
  digest.add(std::uint64_t(kModelsVersion));
  digest.add(count);
  digest.add(std::uint64_t(kind.pad_levels));
  for (const int level : kind.levels) digest.add(std::uint64_t(level));
  return digest.value();
}

/// The places in the file where segments begin, and its end.
std::vector<std::uint64_t> segment_begins(const SegmentKind& kind, std::uint32_t count) {
  std::vector<std::uint64_t> begins{kHeadBytes};
  for (std::uint32_t first = 0; first < count; first += kSegmentShapes) {
    begins.push_back(begins.back() + SegmentLayout(kind, std::min(kSegmentShapes, count - first)).bytes);
  }
  return begins;
}

bool is_there(const std::string& path, std::uint64_t digest, std::uint64_t bytes) {
  std::error_code error;
  if (std::filesystem::file_size(path, error) != bytes) return false;
  std::uint64_t found = 0;
  read_at(path, open_regular_file(path), 0, {reinterpret_cast<std::uint8_t*>(&found), sizeof found});
  return found == digest;
}

/// Models [begin, end) of shapes that repeat outlines; `different` has the models of the first ones.
std::vector<ShapeModel> again(const ModelSource& different, const ShapeRange& range) {
  std::vector<ShapeModel> models;
  for (std::uint32_t at = range.begin; at < range.end;) {
    const std::uint32_t first = at % VariedShapes::kDifferent;
    const std::uint32_t count = std::min(range.end - at, VariedShapes::kDifferent - first);
    for (ShapeModel& model : different.models({first, first + count}, {})) {
      change_pads(model, at++);
      models.push_back(std::move(model));
    }
  }
  return models;
}

using MakeModels = std::function<std::vector<ShapeModel>(const ShapeRange&)>;

void write(const std::string& path, std::uint64_t digest, std::uint32_t count, const SegmentKind& kind,
           const MakeModels& make) {
  TemporaryFile file(path);
  file.write({reinterpret_cast<const std::uint8_t*>(&digest), sizeof digest});
  for (std::uint32_t first = 0; first < count; first += kSegmentShapes) {
    const ShapeRange range{first, std::min(count, first + kSegmentShapes)};
    file.write(segment_bytes(kind, make(range), std::vector<SegmentOwner>(range.size())));
  }
  file.commit();
}

}  // namespace

std::shared_ptr<const ModelSource> models_in_file(const std::string& folder, const VariedShapes& shapes,
                                                  std::uint32_t count, const MatchingContext& context) {
  const std::string path = folder + "/models_" + std::to_string(count);
  const SegmentKind kind{context.pad.levels, context.levels};
  const std::uint64_t digest = digest_of(shapes, count, kind);
  std::vector<std::uint64_t> begins = segment_begins(kind, count);
  if (!is_there(path, digest, begins.back())) {
    if (count <= VariedShapes::kDifferent) {
      write(path, digest, count, kind, [&](const ShapeRange& range) { return shapes.models(range, context); });
    } else {
      const auto different = models_in_file(folder, shapes, VariedShapes::kDifferent, context);
      write(path, digest, count, kind, [&](const ShapeRange& range) { return again(*different, range); });
    }
  }
  begins.pop_back();
  auto reader = std::make_shared<const SegmentReader>(
      path, std::make_shared<const FileDescriptor>(open_regular_file(path)), kind, count, std::move(begins));
  return std::make_shared<StoredModels>(
      std::move(reader), context, [](const ShapeRange& range) { return std::vector<SegmentOwner>(range.size()); });
}

std::shared_ptr<const ModelSource> varied_models(const VariedShapes& shapes, std::uint32_t count,
                                                 const MatchingContext& context, const std::string& folder) {
  if (!folder.empty()) return models_in_file(folder, shapes, count, context);
  return std::make_shared<MadeModels>(
      [&shapes, context](const ShapeRange& range) { return shapes.models(range, context); });
}

}  // namespace tessera::bench
