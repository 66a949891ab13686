#include "tessera/matching/descriptor.h"

#include <algorithm>

#include "package/pad_settings.h"
#include "tessera/matching/error.h"

namespace tessera::matching {
namespace {

/// The largest distance of two PADs; PADs that cannot be compared get it, too.
constexpr double kLargestDistance = 2;

/// PADs as rows of numbers: levels on the left, on the right, convexity, lengths on the left, on the right.
class PadDescriptor : public Descriptor {
 public:
  explicit PadDescriptor(const PadSettings& settings) : settings_(settings) {}

  std::string name() const override { return "pad"; }

  Description describe(const Outline& outline) const override {
    Description description;
    for (const Pad& pad : pads_of(outline, settings_)) {
      description.insert(description.end(), {double(pad.left.size()), double(pad.right.size()), double(pad.convexity)});
      description.insert(description.end(), pad.left.begin(), pad.left.end());
      description.insert(description.end(), pad.right.begin(), pad.right.end());
    }
    return description;
  }

  double distance(const Description& query, const Description& known) const override {
    const std::vector<Pad> of_query = pads_in(query);
    const std::vector<Pad> of_known = pads_in(known);
    if (of_query.empty()) return kLargestDistance;
    double sum = 0;
    for (const Pad& pad : of_query) {
      double nearest = kLargestDistance;
      for (const Pad& other : of_known) nearest = std::min(nearest, pad_distance(pad, other));
      sum += nearest;
    }
    return sum / double(of_query.size());
  }

 private:
  /// The PADs of a description. Throws Error where the numbers were not made by describe().
  static std::vector<Pad> pads_in(const Description& description) {
    std::vector<Pad> pads;
    auto at = description.begin();
    const auto take = [&](double count) {
      if (!(count >= 0 && count <= double(description.end() - at))) {
        throw Error("a description of PADs: found " + std::to_string(description.size()) +
                    " numbers that do not make up PADs, allowed: what describe() returned");
      }
      const auto from = at;
      at += std::ptrdiff_t(count);
      return std::vector<double>(from, at);
    };
    while (at != description.end()) {
      const std::vector<double> head = take(3);
      Pad& pad = pads.emplace_back();
      pad.convexity = head[2] > 0 ? 1 : head[2] < 0 ? -1 : 0;
      pad.left = take(head[0]);
      pad.right = take(head[1]);
    }
    return pads;
  }

  PadSettings settings_;
};

std::vector<Description> described(const Descriptor& descriptor, const std::vector<Outline>& outlines,
                                   const char* role) {
  std::vector<Description> descriptions;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    try {
      check(outlines[i]);
    } catch (const Error& error) {
      throw Error(std::string(role) + " " + std::to_string(i) + ": " + error.what());
    }
    descriptions.push_back(descriptor.describe(outlines[i]));
  }
  return descriptions;
}

}  // namespace

Descriptor::~Descriptor() = default;

std::unique_ptr<Descriptor> make_pad_descriptor(const PadSettings& settings) {
  PadSettings without_unit = settings;
  without_unit.smoothing = 0;  // the smoothing of each outline is checked when it is described
  smoothing_of(without_unit, 1);
  return std::make_unique<PadDescriptor>(settings);
}

Matrix distance_matrix(const Descriptor& descriptor, const std::vector<Outline>& queries,
                       const std::vector<Outline>& known) {
  const std::vector<Description> of_queries = described(descriptor, queries, "query");
  const std::vector<Description> of_known = described(descriptor, known, "known outline");
  Matrix matrix{queries.size(), known.size(), {}};
  for (const Description& query : of_queries) {
    for (const Description& one : of_known) matrix.values.push_back(descriptor.distance(query, one));
  }
  return matrix;
}

}  // namespace tessera::matching
