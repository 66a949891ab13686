#include "job/pieces/start_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <unordered_map>

#include "core/base/error.h"
#include "core/geometry/period.h"
#include "files/output_lock.h"
#include "job/job_entry.h"
#include "job/job_keys.h"
#include "job/pieces/feature_properties.h"
#include "text/nearest_name.h"
#include "text/number_text.h"
#include "text/pose.h"

namespace tessera {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kMostBytes = std::size_t(512) << 20;  // of the file: about 50,000 pieces with their polygons

/// An allowed range, as in the columns of [[given]].
struct Range {
  const char* key;
  double min;
  double max;
};
constexpr Range kScale{"scale", 0.01, 20000};  // fit = "all" may make pieces of less than 2 px
constexpr Range kRotation{"rotation_deg", -360, 360};
constexpr Range kX{"x_px", -20000, 40000};
constexpr Range kY{"y_px", -20000, 40000};
constexpr Range kScore{"score", -1e9, 1e9};
constexpr Range kMatched{"matched_px", 0, 1e9};
constexpr const char* kPose = "canvas_from_shape";

[[noreturn]] void refuse_piece(const std::string& key, const std::string& found, const std::string& allowed) {
  throw InputError(key + ": found " + found + ", allowed: " + allowed);
}

std::string found_text(const json& value) {
  return printable(value.dump(-1, ' ', false, json::error_handler_t::replace));
}

const json& member(const json& object, const char* key, const std::string& allowed) {
  if (!object.is_object() || !object.contains(key)) refuse_piece(key, "nothing", allowed);
  return object.at(key);
}

double number(const json& properties, const Range& range) {
  const std::string allowed = "a number from " + fixed(range.min, range.min > 0 ? 2 : 0) + " to " + fixed(range.max, 0);
  const json& value = member(properties, range.key, allowed);
  if (!value.is_number()) refuse_piece(range.key, found_text(value), allowed);
  const double found = value.get<double>();
  if (!(found >= range.min && found <= range.max)) refuse_piece(range.key, found_text(value), allowed);
  return found;
}

/// The property, or false where the feature does not have it.
bool flag(const json& properties, const char* key) {
  if (!properties.contains(key)) return false;
  const json& value = properties.at(key);
  if (!value.is_boolean()) refuse_piece(key, found_text(value), "true or false");
  return value.get<bool>();
}

class Names {
 public:
  explicit Names(const std::vector<NamedShape>& shapes) {
    for (std::uint32_t i = 0; i < shapes.size(); ++i) {
      names_.push_back(shapes[i].name);
      index_[shapes[i].mirrored].try_emplace(shapes[i].name, i);
    }
  }

  ShapeId id(const json& properties) const {
    const std::string allowed = "the name of a shape of the library (tessera library info FILE --names lists them)";
    const json& value = member(properties, "shape", allowed);
    if (!value.is_string()) refuse_piece("shape", found_text(value), allowed);
    const std::string name = value.get<std::string>();
    const bool mirrored = flag(properties, "mirrored");
    if (const auto found = index_[mirrored].find(name); found != index_[mirrored].end()) return ShapeId{found->second};
    if (index_[!mirrored].contains(name)) {
      refuse_piece(
          "mirrored", mirrored ? "true" : "false",
          mirrored ? "false, as pieces.mirrored says of this shape" : "true, as pieces.mirrored says of this shape");
    }
    const std::string nearest = nearest_name(name, names_);
    refuse_piece("shape", found_text(value), allowed + (nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?"));
  }

 private:
  std::vector<std::string> names_;
  std::array<std::unordered_map<std::string, std::uint32_t>, 2> index_;  // of the drawings and of their mirror images
};

/// The pose with all its digits; nullopt where the feature does not have it.
std::optional<Similarity> exact_pose(const json& properties) {
  if (!properties.contains(kPose)) return {};
  const json& value = properties.at(kPose);
  std::array<float, 4> numbers{};
  bool right = value.is_array() && value.size() == numbers.size();
  for (std::size_t i = 0; right && i < numbers.size(); ++i) {
    right = value[i].is_number() && std::abs(value[i].get<double>()) <= kY.max;
    if (right) numbers[i] = float(value[i].get<double>());
  }
  if (!right)
    refuse_piece(kPose, found_text(value), "four numbers from " + fixed(-kY.max, 0) + " to " + fixed(kY.max, 0));
  return Similarity{numbers[0], numbers[1], numbers[2], numbers[3]};
}

/// Whether the properties that people read and change say the same as the pose, to their last decimal.
bool is_written_as(const Similarity& pose, double scale_px, double rotated_deg, double x_px, double y_px) {
  const auto same = [](double a, double b) { return fixed(a, kPixelDecimals) == fixed(b, kPixelDecimals); };
  return same(pose.scale(), scale_px) && same(rotation_deg(pose), rotated_deg) && same(pose.tx, x_px) &&
         same(pose.ty, y_px);
}

GivenPiece piece_of(const json& feature, const Names& names) {
  const json& properties = member(feature, "properties", "an object with shape, scale, rotation_deg, x_px and y_px");
  GivenPiece piece;
  piece.shape = names.id(properties);
  piece.locked = flag(properties, "locked");
  const double scale_px = number(properties, kScale);
  const double rotation_deg = number(properties, kRotation);
  const double x_px = number(properties, kX), y_px = number(properties, kY);
  piece.canvas_from_shape = pose_of(scale_px, rotation_deg, x_px, y_px);
  const std::optional<Similarity> exact = exact_pose(properties);
  if (!exact || !is_written_as(*exact, scale_px, rotation_deg, x_px, y_px)) return piece;
  piece.canvas_from_shape = *exact;
  if (properties.contains(kScore.key)) piece.score = float(number(properties, kScore));
  if (properties.contains(kMatched.key)) piece.matched_px = float(number(properties, kMatched));
  return piece;
}

std::vector<GivenPiece> pieces_in(JsonFile& file, const Names& names) {
  static const std::vector<std::string_view> kRead = {"shape",    kScale.key,   kRotation.key, kX.key,   kY.key,
                                                      kScore.key, kMatched.key, "mirrored",    "locked", kPose};
  std::vector<GivenPiece> pieces;
  read_feature_properties(file, kRead, std::size_t(kMostStartPieces),
                          [&](const json& feature) { pieces.push_back(piece_of(feature, names)); });
  return pieces;
}

/// Marks of the pieces whose indices a list of the job has.
std::vector<bool> marked(const std::vector<int>& indices, std::size_t pieces, const std::string& key) {
  std::vector<bool> marks(pieces, false);
  for (const int index : indices) {
    if (std::size_t(index) >= pieces) {
      throw InputError(key + ": found " + std::to_string(index) + ", allowed: " +
                       (pieces > 0 ? "0 to " + std::to_string(pieces - 1) : "nothing") + ", the pieces of the file");
    }
    marks[std::size_t(index)] = true;
  }
  return marks;
}

/// Moves the pieces to be removed to `start.removed`; the others are locked or free as the job says.
std::vector<GivenPiece> kept(const std::vector<GivenPiece>& pieces, StartSpec& start) {
  const std::vector<bool> removed = marked(start.remove, pieces.size(), "start.remove");
  const std::vector<bool> locked = marked(start.lock, pieces.size(), "start.lock");
  std::vector<GivenPiece> left;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    GivenPiece piece = pieces[i];
    if (removed[i]) {
      if (piece.locked) throw InputError("start.remove: found " + std::to_string(i) + ", which is locked");
      start.removed.push_back(piece);
      continue;
    }
    piece.for_good = piece.locked || locked[i] || start.keep == StartKeep::locked;
    piece.locked = piece.for_good || start.keep == StartKeep::standing;
    left.push_back(piece);
  }
  return left;
}

/// Whether both poses are the same. In the file a pose is rounded to three decimals of px and degrees.
bool same_as_written(const Similarity& given, const Similarity& read, const Period& period) {
  constexpr float kRounding = 0.001f;
  constexpr float kTurn_rad = 2e-5f;
  const auto near = [](float a, float b, float by) { return std::abs(a - b) <= by; };
  const float by = kRounding + kTurn_rad * read.scale();
  const Vec2 at = period.nearest(given.translation(), read.translation());
  return near(given.a, read.a, by) && near(given.b, read.b, by) && near(at.x, read.tx, kRounding) &&
         near(at.y, read.ty, kRounding);
}

/// Removes pieces that the job gives: a result also holds the pieces of its job's [[given]], which would stand twice.
void remove_given_again(const std::vector<GivenPiece>& given, const Period& period, std::vector<GivenPiece>& pieces) {
  std::unordered_multimap<std::uint32_t, const GivenPiece*> by_shape;
  for (const GivenPiece& piece : given) by_shape.emplace(index_of(piece.shape), &piece);
  std::erase_if(pieces, [&](const GivenPiece& piece) {
    const auto [begin, end] = by_shape.equal_range(index_of(piece.shape));
    const auto at = std::find_if(begin, end, [&](const auto& known) {
      return same_as_written(known.second->canvas_from_shape, piece.canvas_from_shape, period);
    });
    if (at == end) return false;
    by_shape.erase(at);
    return true;
  });
}

/// The period of a seamless canvas, which is a rectangle.
Period period_of(const CanvasSpec& canvas) {
  const bool both = canvas.seamless == Seamless::both;
  return {both || canvas.seamless == Seamless::x ? canvas.width_px : 0,
          both || canvas.seamless == Seamless::y ? canvas.height_px : 0};
}

/// Refuses what is no result, with what is allowed.
void check_is_there(const std::string& given, const std::string& file) {
  constexpr const char* kAllowed = "; allowed: the folder of a result, or its pieces.geojson";
  std::error_code error;
  if (!fs::exists(given, error) && !error) throw InputError(given + ": no such file or folder" + kAllowed);
  if (fs::is_directory(given, error) && !fs::exists(file, error) && !error) {
    const std::string holder = holder_of_lock(folder_lock_path(given));
    throw InputError(given + ": found a folder without pieces.geojson" +
                     (holder.empty() ? kAllowed : "; a run is at work here: " + holder + "; wait for its end"));
  }
}

}  // namespace

std::string start_file(const Job& job) {
  std::error_code error;
  if (job.start.pieces.empty() || !fs::is_directory(job.start.pieces, error)) return job.start.pieces;
  return (fs::path(job.start.pieces) / "pieces.geojson").string();
}

void add_start_pieces(const std::vector<NamedShape>& shapes, Job& job) {
  const std::string file = start_file(job);
  if (file.empty()) return;
  const std::string where = job.path + ": start.pieces: ";
  try {
    check_is_there(job.start.pieces, file);
    JsonFile json_file{FileBlocks(file, kMostBytes)};
    const std::vector<GivenPiece> all = pieces_in(json_file, Names(shapes));
    job.start.digest = json_file.digest();
    std::vector<GivenPiece> pieces = kept(all, job.start);
    std::vector<GivenPiece>& given = job.settings.wishes.given;
    remove_given_again(given, period_of(job.canvas), pieces);
    std::stable_partition(pieces.begin(), pieces.end(), [](const GivenPiece& piece) { return piece.locked; });
    given.insert(given.end(), pieces.begin(), pieces.end());
  } catch (const json::exception& error) {
    throw InputError(where + file + ": no JSON: " + printable(error.what(), 200) +
                     "; allowed: entries with commas between them and no comma after the last one");
  } catch (const InputError& error) {
    const std::string what = error.what();
    throw InputError(where + (what.starts_with(job.start.pieces) ? what : file + ": " + what));
  }
}

void check_start_is_elsewhere(const Job& job, const std::string& folder) {
  const std::string file = start_file(job);
  std::error_code error;
  if (file.empty() || !fs::equivalent(fs::path(file).parent_path(), folder, error)) return;
  throw InputError(job.path + ": start.pieces: " + file +
                   " lies in the folder that the run writes; give another --out");
}

}  // namespace tessera
