#include "cli/result_drawing_run.h"

#include <optional>
#include <utility>

#include "cli/collage_warnings.h"
#include "cli/progress_bar.h"
#include "cli/terminal.h"
#include "io/drawing/drawers.h"
#include "io/result/run_log.h"

namespace tessera::cli {
namespace {

class DrawingProgress : public io::DrawingObserver {
 public:
  DrawingProgress(bool quiet, std::function<bool()> stop) : quiet_(quiet), stop_(std::move(stop)) {}

  /// A bar for each picture.
  void progressed(const char* picture, std::size_t done, std::size_t total) override {
    if (quiet_) return;
    if (picture_ != picture) bar_.emplace(picture_ = picture, total);
    bar_->update(done);
  }

  bool stop_requested() override { return stop_(); }

 private:
  bool quiet_;
  std::function<bool()> stop_;
  std::string picture_;
  std::optional<ProgressBar> bar_;
};

/// What a user could mend goes to stderr, too.
void warn(const std::string& folder, const std::string& warning, io::RunLog& log) {
  if (warning.empty()) return;
  print_warning(folder + ": " + warning);
  log.warning(warning);
}

}  // namespace

void tell_layers(const std::string& folder, const io::DrawerLayers& layers, io::RunLog& log) {
  const std::string note = io::layers_note(layers);
  if (io::any_failed(layers)) return warn(folder, note, log);
  if (!note.empty()) log.info(note);
}

bool draw(const std::string& folder, const io::PictureRequest& request, bool quiet, std::function<bool()> stop) {
  DrawingProgress progress(quiet, std::move(stop));
  const std::string& pictures = request.to.empty() ? folder : request.to;
  io::RunLog log(pictures);
  try {
    const io::DrawingNotes notes = io::draw_result(folder, request, progress);
    warn(pictures, io::drawing_warning(notes), log);
    tell_layers(pictures, notes.layers, log);
    if (!quiet && notes.afar) print_lines(io::afar_text(*notes.afar));
    log.info("drawn");
    return true;
  } catch (const io::DrawingStopped&) {
    log.info("drawing interrupted");
    return false;
  }
}

}  // namespace tessera::cli
