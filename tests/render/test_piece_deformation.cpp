// From placements to deformed outlines in pieces.geojson, and back.
#include "render/piece_deformation.h"

#include <gtest/gtest.h>

#include <fstream>

#include "result/geojson_output.h"
#include "support/input_error.h"
#include "support/sample_collage.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_piece_deformation {

/// A disc and a ring with a gap of 8 px between them.
struct Deformable : test::SampleCollage {
  Deformable() {
    job.settings.deform.kind = DeformKind::capped;
    report.placements[1].canvas_from_shape.tx = 50 + 40 / std::sqrt(3.14159f) + 60 / std::sqrt(3.14159f * 0.75f) + 4;
  }
};

float farthest(const Outline& a, const Outline& b) {
  float most = 0;
  for (std::size_t c = 0; c < a.curves.size(); ++c) {
    for (std::size_t i = 0; i < a.curves[c].size(); ++i) most = std::max(most, norm(a.curves[c][i] - b.curves[c][i]));
  }
  return most;
}

TEST(PieceDeformation, GivesEachPieceAShapeOfItsOwn) {
  Deformable sample;
  const Outline disc = sample.report.shapes[0].outline;
  deform_pieces(sample.report, sample.job.settings);
  ASSERT_TRUE(sample.report.deformed);
  EXPECT_EQ(sample.report.deformed->shapes, (std::vector<ShapeId>{ShapeId{7}, ShapeId{3}}));
  EXPECT_GT(farthest(sample.report.shape(sample.report.placements[0].shape).outline, disc), 0.02);
  EXPECT_EQ(sample.report.deformed->originals[0].outline, disc);
  EXPECT_EQ(sample.report.deformed->figures.pieces, 2u);
  EXPECT_GT(sample.report.deformed->figures.coverage_before, 0.2);
}

TEST(PieceDeformation, WhatIsLockedForGoodStays) {
  Deformable sample;
  sample.job.settings.wishes.given.push_back({ShapeId{7}, sample.report.placements[0].canvas_from_shape});
  const Outline disc = sample.report.shapes[0].outline;
  deform_pieces(sample.report, sample.job.settings);
  EXPECT_EQ(sample.report.shapes[0].outline, disc);
  EXPECT_EQ(sample.report.deformed->figures.pieces, 1u);
}

TEST(PieceDeformation, ComesBackFromTheFile) {
  const test::ScratchFolder folder;
  Deformable sample, again;
  deform_pieces(sample.report, sample.job.settings);
  std::ofstream(folder.path("pieces.geojson")) << geojson_text(sample.report);
  restore_deformed_pieces(folder.path(""), again.report);
  for (std::size_t i = 0; i < 2; ++i) {
    const float scale_px = sample.report.placements[i].canvas_from_shape.scale();
    EXPECT_LT(farthest(sample.report.shapes[i].outline, again.report.shapes[i].outline) * scale_px, 0.01) << i;
    EXPECT_LT(farthest(warped_outline(sample.report.deformed->originals[i].outline, again.report.deformed->warps[i]),
                       again.report.shapes[i].outline) *
                  scale_px,
              0.1)
        << i;  // its drawing moves along
    EXPECT_GT(again.report.deformed->warps[i].least_jacobian(), 0.2) << i;
    EXPECT_EQ(sample.report.deformed->shapes[i], again.report.deformed->shapes[i]);
  }
}

TEST(PieceDeformation, RefusesPolygonsOfOtherPieces) {
  const test::ScratchFolder folder;
  Deformable sample;
  deform_pieces(sample.report, sample.job.settings);
  const std::string text = geojson_text(sample.report);
  const auto refused = [&](const std::string& bytes) {
    Deformable again;
    std::ofstream(folder.path("pieces.geojson")) << bytes;
    return test::message_of([&] { restore_deformed_pieces(folder.path(""), again.report); });
  };
  std::string one_less = text;  // removes the first position of the first ring
  const auto at = one_less.find("[[[") + 2;
  one_less.erase(at, one_less.find("],", at) + 2 - at);
  EXPECT_NE(refused(one_less).find("feature 0"), std::string::npos) << refused(one_less);
  std::string far_off = text;
  far_off.insert(far_off.find("[[[") + 3, "9");
  EXPECT_NE(refused(far_off).find("far from"), std::string::npos) << refused(far_off);
  std::string fewer = text.substr(0, text.rfind(",\n{")) + "\n]}\n";
  EXPECT_NE(refused(fewer).find("1 polygon,"), std::string::npos) << refused(fewer);
}

}  // namespace test_piece_deformation
}  // namespace tessera
