#include "library/library_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "artwork/artwork_render.h"
#include "artwork/images/sha256.h"
#include "core/base/error.h"
#include "files/work_in_order.h"
#include "library/library_names.h"
#include "library/same_colour.h"
#include "library/skip_reason_text.h"
#include "library/storage/library_file.h"

namespace tessera {
namespace {

/// FNV-1a over the outline in steps of a thousandth of a shape unit: equal for equal silhouettes.
std::uint64_t silhouette_hash(const Outline& outline) {
  constexpr float kStepsPerUnit = 1000;
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&](std::int64_t value) { hash = (hash ^ std::uint64_t(value)) * 0x100000001b3u; };
  for (const std::vector<Vec2>& curve : outline.curves) {
    add(std::int64_t(curve.size()));
    for (const Vec2 p : curve) {
      add(std::lround(p.x * kStepsPerUnit));
      add(std::lround(p.y * kStepsPerUnit));
    }
  }
  return hash;
}

/// A shape that was kept.
struct Variant {
  std::uint32_t index;
  std::string name;
  std::array<float, 3> mean_lab;
};

struct NoShape {
  std::string reason;
};

using Loaded = std::variant<ArtworkShape, NoShape>;

Loaded loaded(const ShapeLoader& loader, const std::string& path) {
  try {
    std::variant<ArtworkShape, SkipReason> shape = loader.load(path);
    if (const auto* reason = std::get_if<SkipReason>(&shape)) return NoShape{skip_reason_text(*reason)};
    return std::move(std::get<ArtworkShape>(shape));
  } catch (const InputError& error) {
    return NoShape{error.what()};
  }
}

/// The message without the file's name at its beginning, because the table shows the name beside it.
std::string without_path(const std::string& message, const std::string& path) {
  const std::string prefix = path + ": ";
  return message.starts_with(prefix) ? message.substr(prefix.size()) : message;
}

class Builder {
 public:
  Builder(const ArtworkFiles& files, const std::string& output, const LibraryBuildSettings& settings,
          const BuildProgress& progress)
      : files_(files),
        settings_(settings),
        progress_(progress),
        writer_(output, settings.tracing.pad) {
    report_.files = files.paths.size() + files.left_out.size();
    report_.skipped = files.left_out;
  }

  void take(std::size_t index, Loaded loaded) {
    const std::string& path = files_.paths[index];
    if (auto* artwork = std::get_if<ArtworkShape>(&loaded)) {
      take_shape(path, std::move(*artwork));
    } else {
      skip(path, std::get<NoShape>(loaded).reason);
    }
    progress_(index + 1, report_.shapes);
  }

  LibraryBuildReport finish() {
    if (report_.shapes > 0 && !(settings_.strict && !report_.skipped.empty())) {
      writer_.finish();
      report_.written = true;
    }
    return std::move(report_);
  }

 private:
  void take_shape(const std::string& path, ArtworkShape artwork) {
    try {
      if (!add(path, std::move(artwork.shape), artwork.style)) return;
      if (artwork.other_components > 0) report_.trimmed.push_back(path);
      if (artwork.loses_text) report_.textless.push_back(path);
      if (artwork.loses_pictures) report_.first_pictures.push_back(path);
      if (artwork.loses_parts) report_.faint.push_back(path);
      if (artwork.hollowness >= kHollow && !settings_.tracing.rules.fill_holes) report_.hollow.push_back(path);
    } catch (const InputError& error) {
      skip(path, error.what());
    }
  }

  /// Adds the shape. False where the library has it already.
  bool add(const std::string& path, Shape shape, const StyleFeatures& style) {
    std::vector<Variant>& variants = variants_of_silhouette_[silhouette_hash(shape.outline)];
    const auto same = std::find_if(variants.begin(), variants.end(),
                                   [&](const Variant& v) { return same_colour(v.mean_lab, shape.mean_lab); });
    if (same != variants.end() && !settings_.keep_twins) {
      report_.merged.push_back({path, same->name});
      return false;
    }
    if (settings_.embed) embed(path, shape.artwork);
    shape.name = names_.unique(shape.name, path);
    const auto index = std::uint32_t(report_.shapes);
    writer_.append(shape, variants.empty() ? index : variants.front().index, style);
    variants.push_back({index, shape.name, shape.mean_lab});
    ++report_.shapes;
    return true;
  }

  static void embed(const std::string& path, Artwork& artwork) {
    artwork.original = read_artwork_file(path);
    if (artwork.sha256 && *artwork.sha256 != sha256_of(artwork.original))
      throw InputError(path + ": it changed while the library was built");
  }

  void skip(const std::string& path, const std::string& message) {
    report_.skipped.push_back({path, without_path(message, path)});
  }

  const ArtworkFiles& files_;
  const LibraryBuildSettings& settings_;
  const BuildProgress& progress_;
  LibraryWriter writer_;
  LibraryNames names_;
  std::map<std::uint64_t, std::vector<Variant>> variants_of_silhouette_;
  LibraryBuildReport report_;
};

}  // namespace

ShapeLoader artwork_loader(Drawers& drawers, const TracingSettings& settings) {
  const auto load = [&drawers, settings](const std::string& path) {
    return drawers.shape(read_artwork_file(path), path, settings);
  };
  return {.load = load, .stop = [&drawers] { drawers.stop(); }};
}

LibraryBuildReport build_library(const ArtworkFiles& files, const std::string& output,
                                 const LibraryBuildSettings& settings, const ShapeLoader& loader,
                                 const BuildProgress& progress) {
  Builder builder(files, output, settings, progress);
  work_in_order<Loaded>({.count = files.paths.size(),
                         .threads = settings.files_at_a_time,
                         .work = [&](std::size_t index) { return loaded(loader, files.paths[index]); },
                         .consume = [&](std::size_t index, Loaded result) { builder.take(index, std::move(result)); },
                         .stop = loader.stop});
  return builder.finish();
}

}  // namespace tessera
