#include "job/pieces/feature_properties.h"

#include <algorithm>
#include <string>

#include "core/base/error.h"
#include "job/job_entry.h"

namespace tessera {
namespace {

using nlohmann::json;

constexpr int kDeepest = 32;              // most levels of nesting
constexpr std::size_t kMostInLists = 16;  // values in lists of one feature's properties

/// Tells nlohmann's parser what to keep: the wanted properties of the present feature, and no feature that was passed
/// on.
class Filter {
 public:
  Filter(const std::vector<std::string_view>& keys, std::size_t most, const std::function<void(const json&)>& take)
      : keys_(keys),
        most_(most),
        take_(take) {}

  bool operator()(int depth, json::parse_event_t event, const json& parsed) {
    if (depth == kFeature && in_features_ &&
        (event == json::parse_event_t::object_end || event == json::parse_event_t::value)) {
      hand_out(parsed);
      return false;
    }
    const bool opens = event == json::parse_event_t::object_start || event == json::parse_event_t::array_start;
    if (opens && depth > kDeepest) throw InputError("more than " + std::to_string(kDeepest) + " levels deep");
    if (opens) return depth <= kProperty;
    if (event == json::parse_event_t::value && depth > kProperty && in_read_property_) count_in_lists();
    return event != json::parse_event_t::key || enter(depth, parsed);
  }

 private:
  static constexpr int kCollection = 1, kFeature = 2, kProperties = 3, kProperty = 4;

  void hand_out(const json& feature) {
    const std::string number = std::to_string(features_);
    if (++features_ > most_) throw InputError("more than " + std::to_string(most_) + " features");
    in_lists_ = 0;
    try {
      take_(feature);
    } catch (const InputError& error) {
      throw InputError("feature " + number + ": " + error.what());
    }
  }

  void count_in_lists() {
    if (++in_lists_ <= kMostInLists) return;
    throw InputError("feature " + std::to_string(features_) + ": properties: found more than " +
                     std::to_string(kMostInLists) + " values in lists, allowed: " + std::to_string(kMostInLists) +
                     " or fewer");
  }

  /// Whether the parser keeps the member with this key.
  bool enter(int depth, const json& key) {
    if (depth == kCollection) return in_features_ = key == "features";
    if (depth == kProperties) {
      in_read_property_ = false;
      return in_properties_ = key == "properties";
    }
    if (depth == kProperty) in_read_property_ = in_properties_ && is_wanted(key);
    return depth == kProperty && in_read_property_;
  }

  bool is_wanted(const json& key) const {
    return std::any_of(keys_.begin(), keys_.end(), [&](std::string_view wanted) { return key == wanted; });
  }

  const std::vector<std::string_view>& keys_;
  std::size_t most_;
  const std::function<void(const json&)>& take_;
  bool in_features_ = false;
  bool in_properties_ = false;
  bool in_read_property_ = false;
  std::size_t features_ = 0;
  std::size_t in_lists_ = 0;  // of the present feature
};

}  // namespace

void read_feature_properties(JsonFile& file, const std::vector<std::string_view>& keys, std::size_t most,
                             const std::function<void(const json& feature)>& take) {
  constexpr const char* kAllowed = "a list of features, as in pieces.geojson";
  const json collection = json::parse(file.stream(), Filter(keys, most, take));
  const auto features = collection.is_object() ? collection.find("features") : collection.end();
  if (!collection.is_object() || features == collection.end())
    throw InputError(std::string("features: found nothing, allowed: ") + kAllowed);
  if (!features->is_array()) {
    throw InputError("features: found " + printable(features->dump(-1, ' ', false, json::error_handler_t::replace)) +
                     ", allowed: " + kAllowed);
  }
}

}  // namespace tessera
