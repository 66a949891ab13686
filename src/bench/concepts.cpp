// Draws the figures of docs/concepts from a library.
#include <filesystem>

#include "bench/benchmarks.h"
#include "bench/concepts/figures.h"
#include "core/base/error.h"
#include "files/atomic_file.h"
#include "result/collage_files.h"

namespace tessera::bench {
namespace {

ShapeId shape_named(concepts::CollageStage& stage, const LibraryFile& library, const std::string& name) {
  for (std::uint32_t i = 0; i < library.size(); ++i) {
    if (stage.shapes().shape(ShapeId(i)).name == name) return ShapeId(i);
  }
  throw InputError(library.path() + ": has no shape named " + name +
                   "; allowed: a name that `tessera library info` lists");
}

}  // namespace

void draw_concepts(const ConceptsOptions& options) {
  const LibraryFile library(options.library);
  prepare_output_directory(options.folder);
  const auto write = [&](const char* name, const std::string& svg) {
    write_file_atomically((std::filesystem::path(options.folder) / name).string() + ".svg", svg);
  };
  concepts::CollageStage stage(library, options.devices, {44, 120});
  const ShapeId shown = options.shape.empty() ? ShapeId{0} : shape_named(stage, library, options.shape);
  write("shapes", concepts::shapes_figure(stage.with_levels(shown), library.pad_parameters()));
  constexpr std::size_t kHalfFilled = 7;
  stage.place(kHalfFilled);
  write("target", concepts::target_figure(stage));
  write("pairs", concepts::pairs_figure(stage));
  write("choice", concepts::choice_figure(stage));
  write("merge", concepts::merge_figure(stage));
  write("ranks", concepts::ranks_figure(stage));
  write("dockings", concepts::dockings_figure(stage));
  concepts::CollageStage full(library, options.devices, {24, 60});
  write("improving", concepts::improving_figure(full));
}

}  // namespace tessera::bench
