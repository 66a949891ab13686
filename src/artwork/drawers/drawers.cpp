#include "artwork/drawers/drawers.h"

#include <signal.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <filesystem>
#include <future>
#include <mutex>
#include <system_error>
#include <thread>

#include "artwork/artwork_render.h"
#include "artwork/drawers/drawer_process.h"
#include "artwork/images/image_decoding.h"
#include "artwork/outlines/svg_outlines.h"
#include "artwork/protocol/outlines_codec.h"
#include "artwork/protocol/shape_answer.h"
#include "artwork/protocol/warp_codec.h"
#include "core/base/error.h"
#include "core/base/process_limits.h"
#include "files/signals_blocked.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

std::string text_of(std::span<const std::uint8_t> bytes) { return {bytes.begin(), bytes.end()}; }

[[noreturn]] void throw_garbled(const std::string& path) {
  throw InputError(path + ": tessera-drawer sent an invalid answer");
}

cv::Mat image_of(const DrawingAnswer& answer, const std::string& path, int longest_side_px) {
  const std::int64_t columns = answer.header.columns, rows = answer.header.rows;
  const bool is_sane = std::min(columns, rows) >= 1 && std::max(columns, rows) <= longest_side_px &&
                       std::uint64_t(4 * columns * rows) == answer.bytes().size();
  if (!is_sane) throw_garbled(path);
  return answer.payload.reshape(4, int(rows));
}

void check_side(int longest_side_px, const std::string& path) {
  if (longest_side_px >= 1 && longest_side_px <= kMaxArtworkSide_px) return;
  throw InputError(path + ": cannot be drawn " + std::to_string(longest_side_px) + " px large; allowed are 1 to " +
                   std::to_string(kMaxArtworkSide_px));
}

}  // namespace

/// Threads that own one process each. A process dies with the thread that started it (PR_SET_PDEATHSIG), so that must
/// not be a caller's thread.
class Drawers::DrawerPool {
 public:
  explicit DrawerPool(const DrawerSettings& settings) : settings_(settings) {
    const int count = std::max(1, settings.processes);
    for (int i = 0; i < count; ++i)
      processes_.push_back(
          std::make_unique<DrawerProcess>(settings.bytes_per_process, settings.seconds_to_start, settings.program));
    const SignalsBlocked blocked;  // only other threads of the program shall receive them
    for (const auto& process : processes_) {
      try {
        threads_.emplace_back([this, &process] { work(*process); });
      } catch (const std::system_error& error) {  // fewer threads do the same work
        if (threads_.empty()) throw no_thread(error);
        break;
      }
    }
  }

  ~DrawerPool() {
    stop();
    {
      const std::lock_guard lock(mutex_);
      closing_ = true;
    }
    wake_.notify_all();
  }

  /// Sends a request and waits for the answer. Throws InputError with the drawer's reason.
  DrawingAnswer draw(const DrawingRequest& request) {
    Task task{request, {}};
    std::future<DrawingAnswer> answer = task.answer.get_future();
    {
      const std::lock_guard lock(mutex_);
      tasks_.push_back(&task);
    }
    wake_.notify_one();
    return answer.get();
  }

  void stop() {
    stopped_ = true;
    for (const auto& process : processes_) process->kill();
  }

  DrawerLayers layers() {
    const std::lock_guard lock(mutex_);
    return layers_;
  }

 private:
  struct Task {
    const DrawingRequest& request;
    std::promise<DrawingAnswer> answer;
  };

  void work(DrawerProcess& process) {
    while (Task* task = next_task()) {
      // The caller destroys the task as soon as it has the answer.
      std::promise<DrawingAnswer> promise = std::move(task->answer);
      try {
        promise.set_value(answered(process, task->request));
      } catch (...) {
        promise.set_exception(std::current_exception());
      }
    }
  }

  Task* next_task() {
    std::unique_lock lock(mutex_);
    wake_.wait(lock, [&] { return closing_ || !tasks_.empty(); });
    if (tasks_.empty()) return nullptr;
    Task* task = tasks_.front();
    tasks_.pop_front();
    return task;
  }

  /// Answers a request, with a second attempt in a fresh process where one fails that has made drawings before: these
  /// may have left it little memory, and must not affect this one. After a time-out there is no second attempt: CPU
  /// time is counted from the beginning of a drawing, so it would only take as long again.
  DrawingAnswer answered(DrawerProcess& process, const DrawingRequest& request) {
    const bool was_used = process.started();
    std::optional<DrawingAnswer> answer = attempt(process, request);
    if (!answer && was_used && !process.took_too_long()) answer = attempt(process, request);
    if (!answer) throw InputError(request.path + ": " + process.failure());
    if (answer->header.status == DrawingStatus::done) return std::move(*answer);
    throw InputError(request.path + ": " + printable_utf8(text_of(answer->bytes())));
  }

  /// The answer; nullopt where the process was lost.
  std::optional<DrawingAnswer> attempt(DrawerProcess& process, const DrawingRequest& request) {
    std::optional<DrawingAnswer> answer;
    try {
      if (!stopped_ && !process.started()) note(process.start());
      // stop() sets the flag first: it either ends the process that has just started, or the flag is seen here.
      if (!stopped_) answer = process.ask(request, settings_.seconds_per_drawing);
    } catch (const EnvironmentError&) {  // also where stop() ended a process during its start
      if (!stopped_) throw;
    }
    if (stopped_) throw DrawingStopped();
    return answer;
  }

  void note(const DrawerLayers& layers) {
    const std::lock_guard lock(mutex_);
    layers_ = worse_of(layers_, layers);
  }

  DrawerSettings settings_;
  std::atomic<bool> stopped_ = false;
  std::mutex mutex_;  // guards tasks_, closing_ and layers_
  std::condition_variable wake_;
  std::deque<Task*> tasks_;
  bool closing_ = false;
  DrawerLayers layers_;
  std::vector<std::unique_ptr<DrawerProcess>> processes_;
  std::vector<std::jthread> threads_;  // joined before the processes are destroyed
};

Drawers::Drawers(const DrawerSettings& settings) : crew_(std::make_unique<DrawerPool>(settings)) {}

Drawers::~Drawers() = default;

void Drawers::stop() { crew_->stop(); }

DrawerLayers Drawers::layers() const { return crew_->layers(); }

cv::Mat Drawers::render(std::span<const std::uint8_t> bytes, const std::string& path, int longest_side_px,
                        Background background) {
  check_side(longest_side_px, path);
  const DrawingRequest request{.kind = background == Background::cut_out ? DrawingKind::page : DrawingKind::uncut_page,
                               .longest_side_px = longest_side_px,
                               .path = path,
                               .bytes = bytes};
  return image_of(crew_->draw(request), path, longest_side_px);
}

cv::Mat Drawers::decode_png(std::span<const std::uint8_t> bytes, const std::string& path, int longest_side_px) {
  check_side(longest_side_px, path);
  const DrawingRequest request{
      .kind = DrawingKind::png, .longest_side_px = longest_side_px, .path = path, .bytes = bytes};
  return image_of(crew_->draw(request), path, longest_side_px);
}

DrawerSettings photo_drawer_settings(int processes) {
  return {.processes = processes, .bytes_per_process = std::size_t(1) << 30};
}

cv::Mat Drawers::whole_picture(std::span<const std::uint8_t> bytes, const std::string& path, int longest_side_px) {
  check_side(longest_side_px, path);
  const DrawingRequest request{
      .kind = DrawingKind::whole, .longest_side_px = longest_side_px, .path = path, .bytes = bytes};
  return image_of(crew_->draw(request), path, longest_side_px);
}

cv::Mat Drawers::photo(std::span<const std::uint8_t> bytes, const std::string& path) {
  const DrawingRequest request{.kind = DrawingKind::photo, .path = path, .bytes = bytes};
  return image_of(crew_->draw(request), path, int(kMaxImagePixels));
}

cv::Mat Drawers::labels(std::span<const std::uint8_t> bytes, const std::string& path) {
  const DrawingRequest request{.kind = DrawingKind::labels, .path = path, .bytes = bytes};
  const cv::Mat packed = image_of(crew_->draw(request), path, int(kMaxImagePixels));
  return cv::Mat(packed.size(), CV_32SC1, packed.data, packed.step).clone();
}

cv::Size2d Drawers::natural_size(std::span<const std::uint8_t> bytes, const std::string& path) {
  const DrawingAnswer answer = crew_->draw({.kind = DrawingKind::natural_size, .path = path, .bytes = bytes});
  double sides[2];
  if (answer.bytes().size() != sizeof sides) throw_garbled(path);
  std::memcpy(sides, answer.bytes().data(), sizeof sides);
  const auto is_sane = [](double side) { return std::isfinite(side) && side > 0; };
  if (!is_sane(sides[0]) || !is_sane(sides[1])) throw_garbled(path);
  return {sides[0], sides[1]};
}

std::string Drawers::import_svg(std::span<const std::uint8_t> bytes, const std::string& path,
                                const std::string& scope_id) {
  const DrawingAnswer answer =
      crew_->draw({.kind = DrawingKind::svg_import, .path = path, .scope_id = scope_id, .bytes = bytes});
  return text_of(answer.bytes());
}

std::string Drawers::warped_svg(std::span<const std::uint8_t> bytes, const std::string& path,
                                const std::string& scope_id, const Warp& page_warp) {
  DrawingRequest request{.kind = DrawingKind::warped_svg, .path = path, .scope_id = scope_id, .bytes = bytes};
  request.warp = encode_warp(page_warp);
  return text_of(crew_->draw(request).bytes());
}

SvgOutlines Drawers::svg_outlines(std::span<const std::uint8_t> bytes, const std::string& path, double px_per_inch) {
  const DrawingAnswer answer =
      crew_->draw({.kind = DrawingKind::outlines, .px_per_inch = px_per_inch, .path = path, .bytes = bytes});
  try {
    return decode_outlines(answer.bytes());
  } catch (const std::runtime_error&) {
    throw_garbled(path);
  }
}

std::variant<ArtworkShape, SkipReason> Drawers::shape(std::span<const std::uint8_t> bytes, const std::string& path,
                                                      const TracingSettings& settings) {
  const DrawingAnswer answer =
      crew_->draw({.kind = DrawingKind::shape, .tracing = settings, .path = path, .bytes = bytes});
  try {
    ShapeOrReason result = decode_shape_answer(answer.bytes());
    if (auto* artwork = std::get_if<ArtworkShape>(&result)) {
      artwork->shape.artwork.path = std::filesystem::absolute(path);
    }
    return result;
  } catch (const std::runtime_error&) {
    throw_garbled(path);
  }
}

std::vector<std::uint8_t> Drawers::pdf_of_svg(std::span<const std::uint8_t> svg, double width_pt) {
  const auto drawn = [&](DrawingKind kind) -> std::vector<std::uint8_t> {
    const DrawingAnswer answer = crew_->draw({.kind = kind, .width_pt = width_pt, .path = "the collage", .bytes = svg});
    return {answer.bytes().begin(), answer.bytes().end()};
  };
  try {
    return drawn(DrawingKind::pdf);
  } catch (const InputError&) {  // cairo 1.16 asserts more about recordings than holds for every drawing
    return drawn(DrawingKind::plain_pdf);
  }
}

}  // namespace tessera
