// The boundary of the free region and its target samples (paper section 4: "cut and paste").
//
// Parts that a placement did not touch keep their samples and PADs. Only new samples, and those whose PAD reaches into
// the change, are computed again. Everything about a sample follows from a walk along its own neighbourhood, so an
// update gives the same bits as a new start.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

#include "core/field/linked_contour.h"
#include "core/field/opened_field.h"
#include "core/field/target_sample.h"
#include "core/geometry/tile_index.h"
#include "core/pad/pad.h"
#include "core/settings/settings.h"

namespace tessera {

class TargetCurve {
 public:
  TargetCurve(const PieceSettings& pieces, const PadParameters& pad);

  struct Change {
    std::vector<SampleId> removed;  // samples that are gone, ascending
    std::vector<SampleId> renewed;  // samples that are new or whose PAD changed much, ascending
  };

  /// Traces the nodes of `windows` again; all others are unchanged. If the opened field repeats, the curve is that of
  /// one period, and its PADs continue beyond it. `origin` is the canvas position of node (0, 0). Uses the rank's threads.
  Change retrace(const OpenedField& opened, Vec2 origin, const std::vector<Window>& windows);

  const TargetSample& sample(SampleId id) const { return samples_.at(id).sample; }
  std::size_t sample_count() const { return samples_.size(); }
  bool has_sample(SampleId id) const { return samples_.contains(id); }
  std::vector<SampleId> samples() const;
  /// Whether holds(position), canvas px, is true for any sample. Stops at the first.
  template <class Holds>
  bool any_position(const Holds& holds) const {
    return std::any_of(samples_.begin(), samples_.end(),
                       [&](const auto& held) { return holds(held.second.sample.position); });
  }

  /// The PADs with which samples were matched, if they have changed a little since, ascending by sample. They are the
  /// only part of a curve that does not follow from the opened field.
  std::vector<MatchedPad> matched_pads() const;
  /// Sets the PADs with which samples were matched. All other samples count as matched with their present PAD.
  void set_matched_pads(const std::vector<MatchedPad>& pads);

 private:
  struct SampleEntry {
    TargetSample sample;
    ArclengthPyramid matched;              // as it was when the sample was last reported as renewed
    std::vector<TileIndex::Tile> support;  // tiles of the nodes that the sample depends on
  };
  /// A place on the curve as it is now.
  struct Place {
    enum class Kind { none, short_loop, sample } kind = Kind::none;
    SampleEntry entry;  // of a short loop: its support alone
  };
  class Walk;

  std::vector<SampleId> reached_by(const std::vector<Window>& windows) const;
  Place look_at(SampleId id, const OpenedField& opened) const;
  void renew(SampleId id, Place place, Change& change);
  bool on_raster(const GridEdge& e) const { return (e.down ? e.x : e.y) % spacing_px_ == 0; }
  /// A smoothed position depends on up to three sigma along the curve.
  int support_nodes() const { return int(3 * sigma_px_) + 3; }
  void visit(int v, TileIndex::Region& support) const;
  bool on_short_loop(int v, TileIndex::Region& support) const;
  SampleEntry make_sample(int v, TileIndex::Region support) const;
  void hold(SampleId id, SampleEntry held);
  void drop(SampleId id);
  void reject(SampleId id, std::vector<TileIndex::Tile> support);

  LinkedContour contour_;
  float sigma_px_;
  float shortest_loop_px_;
  float longest_side_px_;
  int spacing_px_;
  PadParameters pad_;
  std::map<SampleId, SampleEntry> samples_;
  std::map<SampleId, std::vector<TileIndex::Tile>> rejected_;  // places where the loop is too short for a sample
  TileIndex supports_;  // samples and rejected places, by the nodes that they depend on
};

}  // namespace tessera
