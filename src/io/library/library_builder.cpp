#include "io/library/library_builder.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <stdexcept>

#include "core/base/error.h"
#include "io/artwork/artwork_render.h"
#include "io/library/library_file.h"
#include "io/library/library_names.h"
#include "io/drawing/shape_codec.h"

namespace tessera::io {
namespace {

/// FNV-1a over the outline in steps of a thousandth of a shape unit: equal for equal silhouettes in any colours.
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

/// Runs in the child. One byte for "specks were left out" goes before the shape.
std::string traced(const ShapeLoader& load, const std::string& path) {
  std::variant<ArtworkShape, SkipReason> loaded = load(path);
  if (const auto* reason = std::get_if<SkipReason>(&loaded)) throw InputError(to_string(*reason));
  const auto& artwork = std::get<ArtworkShape>(loaded);
  return (artwork.other_components > 0 ? '\1' : '\0') + encode_shape(artwork.shape);
}

/// Messages begin with the file's name, which the table shows beside the reason.
std::string without_path(const std::string& message, const std::string& path) {
  const std::string prefix = path + ": ";
  return message.starts_with(prefix) ? message.substr(prefix.size()) : message;
}

class Builder {
 public:
  Builder(const ArtworkFiles& files, const std::string& output, const LibraryBuildSettings& settings,
          const BuildMonitor& monitor)
      : files_(files),
        settings_(settings),
        monitor_(monitor),
        writer_(output, settings.pad) {
    report_.files = files.paths.size();
    report_.skipped = files.unreadable;
  }

  void take(std::size_t index, const PoolResult& result) {
    const std::string& path = files_.paths[index];
    if (result.done) {
      take_shape(path, result.output);
    } else {
      skip(path, result.reason);
    }
    monitor_.progress(index + 1, report_.shapes);
  }

  LibraryBuildReport finish() {
    if (report_.shapes > 0 && !(settings_.strict && !report_.skipped.empty())) {
      writer_.finish();
      report_.written = true;
    }
    return std::move(report_);
  }

 private:
  void take_shape(const std::string& path, const std::string& bytes) {
    try {
      add(path, decode_shape(std::string_view(bytes).substr(1)));
      if (bytes[0] != '\0') report_.with_specks.push_back(path);
    } catch (const InputError& error) {
      skip(path, error.what());
    }
  }

  void add(const std::string& path, Shape shape) {
    const std::uint64_t hash = silhouette_hash(shape.outline);
    if (const auto same = name_of_silhouette_.find(hash); same != name_of_silhouette_.end()) {
      report_.merged.push_back({path, same->second});
      return;
    }
    if (settings_.embed) shape.artwork.original = read_artwork_file(path);
    shape.name = names_.unique(shape.name, path);
    writer_.append(shape);
    name_of_silhouette_[hash] = shape.name;
    ++report_.shapes;
  }

  void skip(const std::string& path, const std::string& message) {
    report_.skipped.push_back({path, without_path(message, path)});
  }

  const ArtworkFiles& files_;
  const LibraryBuildSettings& settings_;
  const BuildMonitor& monitor_;
  LibraryWriter writer_;
  LibraryNames names_;
  std::map<std::uint64_t, std::string> name_of_silhouette_;
  LibraryBuildReport report_;
};

}  // namespace

ShapeLoader artwork_loader(const PadParameters& pad) {
  return [pad](const std::string& path) { return shape_from_artwork(read_artwork_file(path), path, pad); };
}

LibraryBuildReport build_library(const ArtworkFiles& files, const std::string& output,
                                 const LibraryBuildSettings& settings, const ShapeLoader& load,
                                 const BuildMonitor& monitor) {
  Builder builder(files, output, settings, monitor);
  const bool finished = work_in_processes(
      files.paths, [&](const std::string& path) { return traced(load, path); },
      [&](std::size_t index, const PoolResult& result) { builder.take(index, result); }, settings.pool,
      monitor.interrupted);
  if (!finished) throw EnvironmentError("interrupted; " + output + " was not written");
  return builder.finish();
}

}  // namespace tessera::io
