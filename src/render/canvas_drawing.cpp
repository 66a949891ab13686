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

bool shows_keep_out(const Job& job) { return job.output.keep_out != kNoKeepOut; }

DrawerSettings settings_of(const Job& job, double seconds) {
  const bool shows_file = shows_keep_out(job) || !job.output.ground.empty();
  return canvas_drawer_settings(job.canvas, seconds, shows_file ? kMaxArtworkSide_px : kEdgeSide_px);
}

/// Messages begin with the job.
void check(const Job& job, const std::string& key, const std::string& use, const std::function<void()>& draw) {
  try {
    draw();
  } catch (const InputError& error) {
    throw InputError(job.path + ": " + key + error.what() + use);
  }
}

}  // namespace

DrawerSettings canvas_picture_settings(const Job& job) {
  return settings_of(job, kLongerAtTheEnd * DrawerSettings{}.seconds_per_drawing);
}

CanvasDrawing draw_canvas(const Job& job, const Canvas& canvas, Drawers& drawers) {
  CanvasDrawing drawing{canvas_edge(job.canvas, drawers), {}, {}};
  if (shows_keep_out(job)) drawing.keep_out = draw_keep_out(job, canvas, drawers);
  drawing.ground = draw_ground(job, canvas, drawers);
  return drawing;
}

void check_canvas_drawing(const Job& job, const Canvas& canvas, double seconds) {
  drawer_program();
  Drawers drawers(settings_of(job, seconds));
  const std::string simpler =
      "; the pictures need it 4096 px large or larger: make the drawing simpler, above all its filters";
  check(job, "canvas.file: ", simpler, [&] { check_canvas_edge(job.canvas, canvas, drawers); });
  if (shows_keep_out(job)) {
    check(job, "canvas.keep_out: ", simpler + ", or give output.keep_out = \"" + kNoKeepOut + "\"",
          [&] { draw_keep_out(job, canvas, drawers); });
  }
  check(job, "", "", [&] { draw_ground(job, canvas, drawers); });
}

}  // namespace tessera
