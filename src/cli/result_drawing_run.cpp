#include "cli/result_drawing_run.h"

#include <optional>
#include <utility>

#include "cli/collage_warnings.h"
#include "cli/progress_bar.h"
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

}  // namespace

bool draw(const std::string& folder, const io::DrawingRequest& request, bool quiet, std::function<bool()> stop) {
  DrawingProgress progress(quiet, std::move(stop));
  io::RunLog log(folder);
  try {
    const std::string warning = io::drawing_warning(io::draw_result(folder, request, progress));
    if (!warning.empty()) {
      print_warning(folder + ": " + warning);
      log.warning(warning);
    }
    log.info("drawn");
    return true;
  } catch (const io::DrawingStopped&) {
    log.info("drawing interrupted");
    return false;
  }
}

}  // namespace tessera::cli
