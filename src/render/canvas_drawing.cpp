#include "render/canvas_drawing.h"

#include <functional>
#include <string>

#include "artwork/artwork_render.h"
#include "artwork/drawers/drawer_program.h"
#include "core/base/error.h"
#include "job/canvas/canvas_file.h"

namespace tessera {
namespace {

constexpr double kLongerAtTheEnd = 3;

bool shows_keep_out(const OutputSpec& output) { return output.keep_out != kNoKeepOut; }

DrawerSettings settings_of(const CanvasSpec& spec, const OutputSpec& output, double seconds) {
  const bool shows_file = shows_keep_out(output) || !output.ground.empty();
  return canvas_drawer_settings(spec, seconds, shows_file ? kMaxArtworkSide_px : kEdgeSide_px);
}

void check(const std::string& key, const std::string& use, const std::function<void()>& draw) {
  try {
    draw();
  } catch (const InputError& error) {
    throw InputError(key + error.what() + use);
  }
}

}  // namespace

DrawerSettings canvas_picture_settings(const CanvasSpec& spec, const OutputSpec& output) {
  return settings_of(spec, output, kLongerAtTheEnd * DrawerSettings{}.seconds_per_drawing);
}

CanvasDrawing draw_canvas(const CanvasSpec& spec, const OutputSpec& output, const Canvas& canvas, Drawers& drawers) {
  CanvasDrawing drawing{canvas_edge(spec, drawers), {}, {}};
  if (shows_keep_out(output)) drawing.keep_out = draw_keep_out(spec.keep_out, output, canvas, drawers);
  drawing.ground = draw_ground(output, canvas, drawers);
  return drawing;
}

void check_canvas_drawing(const CanvasSpec& spec, const OutputSpec& output, const Canvas& canvas, double seconds) {
  drawer_program();
  Drawers drawers(settings_of(spec, output, seconds));
  const std::string simpler =
      "; the pictures need it 4096 px large or larger: make the drawing simpler, above all its filters";
  check("canvas.file: ", simpler, [&] { check_canvas_edge(spec, canvas, drawers); });
  if (shows_keep_out(output)) {
    check("canvas.keep_out: ", simpler + ", or give output.keep_out = \"" + kNoKeepOut + "\"",
          [&] { draw_keep_out(spec.keep_out, output, canvas, drawers); });
  }
  draw_ground(output, canvas, drawers);
}

}  // namespace tessera
