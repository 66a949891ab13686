#include "run/messages/place_advice.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/collage/any_place.h"
#include "core/matching/stances.h"
#include "job/canvas/canvas_file.h"
#include "run/messages/written_keys.h"

namespace tessera {
namespace {

constexpr std::size_t kShapesTried = 24;  // of many shapes, evenly spread
constexpr std::size_t kMostTrials = 96;
constexpr float kSmallerStep = 0.8f;
constexpr float kLeastTried_px = 1;
constexpr float kRoomBeside = 0.03f;  // part of the canvas' longer side; has_any_place misses half of it
constexpr LibraryParts kOutlines{.outline = true, .field = false, .levels = 0, .artwork = false};

using PosesWished = std::vector<Interval> PoseWish::*;

/// Whether a key of [pieces] decides for one of the shapes in one of the regions.
bool pieces_decide(const Wishes& wishes, const UnplacedShapes& unplaced, PosesWished wished) {
  const auto says_nothing = [&](ShapeId shape) {
    return wishes.classes.empty() || (wishes.classes[wishes.class_of_shape[index_of(shape)]].poses.*wished).empty();
  };
  return std::any_of(unplaced.shapes.begin(), unplaced.shapes.end(), says_nothing) &&
         std::any_of(unplaced.regions.begin(), unplaced.regions.end(), [&](std::uint32_t region) {
           return wishes.regions.empty() || (wishes.regions[region].poses.*wished).empty();
         });
}

/// The rows of tables, and the key of [pieces], that decide this wish for the shapes.
std::string where_it_stands(const WrittenKeys& keys, const Wishes& wishes, const UnplacedShapes& unplaced,
                            const char* column, PosesWished wished) {
  std::vector<std::uint32_t> regions = keys.rows_with("regions", column);
  std::erase_if(regions, [&](std::uint32_t region) {
    return std::find(unplaced.regions.begin(), unplaced.regions.end(), region) == unplaced.regions.end();
  });
  std::vector<std::string> places = {keys.rows_with_values("shapes", column, keys.rows_with("shapes", column)),
                                     keys.rows_with_values("regions", column, regions)};
  const bool drawn = wished == &PoseWish::scale_px && has_drawn_sizes(keys);
  if (drawn || pieces_decide(wishes, unplaced, wished)) {
    places.push_back(keys.with_value("pieces", drawn ? "sizes" : column));
  }
  std::string text;
  for (const std::string& place : places) text += (text.empty() || place.empty() ? "" : " or ") + place;
  return text;
}

/// One stance of one of the shapes, at its smallest size.
struct Trial {
  const Outline* outline;
  float scale_px;
  DirectionRange rotations;
  std::uint32_t region;
};

class KeyTrials {
 public:
  KeyTrials(const WrittenKeys& keys, const CanvasSpec& spec, const CollageSettings& sized, const ShapeLibrary& library,
            const Canvas& canvas, const UnplacedShapes& unplaced)
      : keys_(keys),
        spec_(spec),
        sized_(sized),
        canvas_(canvas),
        unplaced_(unplaced) {
    const StanceTable whole(sized, std::uint32_t(library.size()));
    const std::vector<ShapeId>& shapes = unplaced.shapes;
    const std::size_t count = std::min(shapes.size(), kShapesTried);
    outlines_.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const ShapeId shape = shapes[i * shapes.size() / count];
      outlines_.push_back(std::move(library.read(index_of(shape), index_of(shape) + 1, kOutlines).front().outline));
      add_trials(whole, shape);
    }
  }

  std::vector<std::string> keys_that_help() const {
    std::vector<std::string> keys;
    if (trials_.empty() || any_fits(canvas_, kept_px(), false)) return keys;
    if (const std::optional<Smaller> smaller = largest_that_fits()) keys.push_back(sizes_text(*smaller));
    std::erase(keys, "");
    if (any_fits(canvas_, kept_px(), true))
      keys.push_back("other rotations, " +
                     where_it_stands(keys_, sized_.wishes, unplaced_, "rotation_deg", &PoseWish::rotation_rad));
    if (sized_.pieces.padding_px > 0 && any_fits(canvas_, -sized_.pieces.overlap_px, false)) {
      keys.push_back("less " + keys_.with_value("pieces", "padding_px"));
    }
    if (canvas_.has_zones() && any_fits(without_zones(), kept_px(), false)) {
      keys.push_back("smaller zones that pieces keep out of (canvas.keep_out, [[keep_out]])");
    }
    return keys;
  }

 private:
  void add_trials(const StanceTable& whole, ShapeId shape) {
    for (const std::uint32_t region : unplaced_.regions) {
      const StanceTable table = whole.limited({.region = region});
      const StanceList& list = table.list(shape);
      for (const Stance& stance : table.of(list)) {
        if (stance.poses.min_scale_px > list.min_scale_px || trials_.size() == kMostTrials) break;
        trials_.push_back({&outlines_.back(), stance.poses.min_scale_px, stance.poses.rotations, region});
      }
    }
  }

  float kept_px() const { return sized_.pieces.padding_px > 0 ? sized_.pieces.padding_px : -sized_.pieces.overlap_px; }

  bool fits(const Trial& trial, const Canvas& canvas, float kept_px, float factor, bool any_rotation) const {
    const CanvasField& room = canvas.regions.empty() ? canvas.distance : canvas.regions[trial.region].distance;
    const DirectionRange rotations = any_rotation ? DirectionRange{} : trial.rotations;
    return has_any_place(*trial.outline, factor * trial.scale_px, rotations, {room, canvas.period, kept_px});
  }

  bool any_fits(const Canvas& canvas, float kept_px, bool any_rotation) const {
    return std::any_of(trials_.begin(), trials_.end(),
                       [&](const Trial& trial) { return fits(trial, canvas, kept_px, 1, any_rotation); });
  }

  /// The largest size, in steps, at which one of the shapes fits with some room beside it. Without such room only one exact
  /// place would do, and no collage finds that.
  struct Smaller {
    float factor;
    float scale_px;
  };
  std::optional<Smaller> largest_that_fits() const {
    const float room_beside_px = kept_px() + kRoomBeside * float(std::max(canvas_.width_px, canvas_.height_px));
    float largest_px = 0;
    for (const Trial& trial : trials_) largest_px = std::max(largest_px, trial.scale_px);
    for (float factor = kSmallerStep; factor * largest_px >= kLeastTried_px; factor *= kSmallerStep) {
      for (const Trial& trial : trials_) {
        if (fits(trial, canvas_, room_beside_px, factor, false)) return Smaller{factor, factor * trial.scale_px};
      }
    }
    return {};
  }

  /// What to write in the job to allow such sizes. Empty where the job already allows the smallest sizes there are.
  std::string sizes_text(const Smaller& smaller) const {
    if (sized_.pieces.fit_all) {
      return keys_.is_default("pieces", "least_scale_px")
                 ? ""
                 : "smaller pieces, " + keys_.with_value("pieces", "least_scale_px");
    }
    if (has_drawn_sizes(keys_)) {
      const std::string text = "drawings " + std::to_string(int(100 * smaller.factor)) + " % as large, " +
                               where_sizes_stand(keys_, sized_.wishes, unplaced_);
      return may_fit_all(keys_) ? text + "; pieces.fit = \"all\", which finds such sizes" : text;
    }
    return "pieces of " + keys_.length_text(double(smaller.scale_px)) + " or less, " +
           where_sizes_stand(keys_, sized_.wishes, unplaced_);
  }

  /// The canvas without its zones. Where its file can no longer be read, the canvas stays as it is: this is only for a
  /// message about a finished collage.
  Canvas without_zones() const {
    CanvasSpec spec = spec_;
    spec.keep_out.clear();
    spec.keep_out_rectangles.clear();
    try {
      return load_canvas(spec);
    } catch (const InputError&) {
    } catch (const EnvironmentError&) {
    }
    return canvas_;
  }

  const WrittenKeys& keys_;
  const CanvasSpec& spec_;
  const CollageSettings& sized_;
  const Canvas& canvas_;
  const UnplacedShapes& unplaced_;
  std::vector<Outline> outlines_;
  std::vector<Trial> trials_;
};

}  // namespace

std::vector<std::string> keys_that_keep_out(const WrittenKeys& keys, const CanvasSpec& spec,
                                            const CollageSettings& sized, const ShapeLibrary& library,
                                            const Canvas& canvas, const UnplacedShapes& unplaced) {
  return KeyTrials(keys, spec, sized, library, canvas, unplaced).keys_that_help();
}

bool may_fit_all(const WrittenKeys& keys) { return !keys.has_rows("regions"); }

bool has_drawn_sizes(const WrittenKeys& keys) { return !keys.is_default("pieces", "sizes"); }

std::string where_sizes_stand(const WrittenKeys& keys, const Wishes& wishes, const UnplacedShapes& unplaced) {
  return where_it_stands(keys, wishes, unplaced, "scale_px", &PoseWish::scale_px);
}

}  // namespace tessera
