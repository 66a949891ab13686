// Batches of replacement trials on canvases with pieces side by side.
#pragma once

#include <cstdint>
#include <vector>

#include "asked_replacer.h"
#include "master/replacing.h"
#include "whole_collage.h"

namespace tessera::master::replacing_batches {

using whole_collage::library;

/// Any number of shapes, repeated from the library. Every second one is the mirror image of the one before.
class ManyShapes : public test::VectorShapes {
 public:
  ManyShapes() : VectorShapes(library()) {}
  const Shape& shape(ShapeId id) override { return VectorShapes::shape(kind(id)); }
  const ShapeModel& model(ShapeId id) override { return VectorShapes::model(kind(id)); }
  ShapeId drawing(ShapeId id) const override { return ShapeId(index_of(id) & ~1u); }
  ShapeId silhouette(ShapeId id) const override { return drawing(id); }

 private:
  static ShapeId kind(ShapeId id) { return ShapeId(index_of(id) % std::uint32_t(library().size())); }
};

inline CollageSettings settings_40_to_80() {
  CollageSettings s;
  s.seed = 3;
  s.pieces.min_scale_px = 40;
  s.pieces.max_scale_px = 80;
  return s;
}

/// A canvas with pieces side by side.
class Batches {
 public:
  explicit Batches(const Canvas& canvas, const CollageSettings& s = settings_40_to_80(), std::uint32_t shapes = 12)
      : free(canvas, s.pieces),
        settings_(s),
        area_px2_(canvas.area_px2),
        stances_(s, shapes) {
    for (float y = kPitch_px / 2; y < float(canvas.height_px); y += kPitch_px) {
      for (float x = kPitch_px / 2; x < float(canvas.width_px); x += kPitch_px) {
        const auto i = std::uint32_t(placements.size());
        placements.push_back({ShapeId(i % 12), {45, 0, x, y}, 1.f + float(i), 100.f + float(i)});
      }
    }
  }

  Replacing replacing(Replacer& replacer) {
    return {free,    stances_, settings_, area_px2_, shapes_, [](const Placement&) { return PoseRange{40, 80, {}}; },
            replacer};
  }

  std::vector<Placement> batch(Replacer& replacer, std::size_t given = 0, ReplacementProgress progress = {0, 100'000}) {
    return replacing(replacer).batch(placements, given, progress);
  }

  FreeField free;
  std::vector<Placement> placements;

 private:
  static constexpr float kPitch_px = 56;

  CollageSettings settings_;
  double area_px2_;
  StanceTable stances_;
  ManyShapes shapes_;
};

/// A canvas that is cut into four windows.
inline Canvas large_canvas() { return make_rectangle_canvas(800, 700); }

}  // namespace tessera::master::replacing_batches
