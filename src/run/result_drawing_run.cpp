#include "run/result_drawing_run.h"

#include <optional>
#include <utility>

#include "artwork/drawers/drawers.h"
#include "core/base/stop.h"
#include "result/folder/run_log.h"
#include "terminal/progress_bar.h"
#include "terminal/terminal.h"

namespace tessera {
namespace {

class DrawingProgress : public DrawingObserver {
 public:
  DrawingProgress(bool quiet, StopQuestion shall_stop) : quiet_(quiet), shall_stop_(std::move(shall_stop)) {}

  /// Shows a bar for each picture.
  void progressed(const char* picture, std::size_t done, std::size_t total) override {
    if (quiet_) return;
    if (picture_ != picture) bar_.emplace(picture_ = picture, total);
    bar_->update(done);
  }

  std::optional<StopReason> stop_requested() override { return shall_stop_(); }

 private:
  bool quiet_;
  StopQuestion shall_stop_;
  std::string picture_;
  std::optional<ProgressBar> bar_;
};

/// Logs a warning. It goes to stderr, too, because the user may be able to help.
void warn(const std::string& folder, const std::string& warning, RunLog& log) {
  if (warning.empty()) return;
  print_warning(folder + ": " + warning);
  log.warning(warning);
}

}  // namespace

void tell_layers(const std::string& folder, const DrawerLayers& layers, RunLog& log) {
  const std::string note = layers_note(layers);
  if (any_failed(layers)) return warn(folder, note, log);
  if (!note.empty()) log.info(note);
}

bool draw(const std::string& folder, const PictureRequest& request, bool quiet, StopQuestion shall_stop) {
  DrawingProgress progress(quiet, std::move(shall_stop));
  const std::string& pictures = request.to.empty() ? folder : request.to;
  RunLog log(pictures);
  try {
    const DrawingNotes notes = draw_result(folder, request, progress);
    warn(pictures, drawing_warning(notes), log);
    tell_layers(pictures, notes.layers, log);
    if (!quiet && notes.afar) print_lines(afar_text(*notes.afar));
    log.info("drawn");
    return true;
  } catch (const DrawingStopped&) {
    log.info("drawing interrupted");
    return false;
  }
}

}  // namespace tessera
