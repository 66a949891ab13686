#include "core/matching/docking_terms.h"

#include <cmath>

#include "core/matching/colour_fit.h"
#include "core/settings/tuning.h"

namespace tessera {
namespace {

enum class ContactRun { none, overlap, gap };

void finish_run(DockingTerms& terms, ContactRun run, float area_px2) {
  if (run == ContactRun::overlap) {
    terms.overlap_px2 += area_px2;
    terms.overlap_px4 += area_px2 * area_px2;
  } else if (run == ContactRun::gap) {
    terms.gap_px2 += area_px2;
    terms.gap_px4 += area_px2 * area_px2;
  }
}

}  // namespace

DockingTerms docking_terms(const Similarity& canvas_from_shape, const ShapeModel& shape, const FieldView& field,
                           const MatchingContext& context) {
  float distance[kBoundaryPoints];
  int first = kBoundaryPoints;
  for (int i = 0; i < kBoundaryPoints; ++i) {
    distance[i] = field_value(field, canvas_from_shape.apply(shape.boundary[i]));
    if (first == kBoundaryPoints && std::abs(distance[i]) < kContact_px) first = i;
  }
  if (first == kBoundaryPoints) first = 0;

  const float scale = canvas_from_shape.scale();
  const float step_px = shape.perimeter * scale / float(kBoundaryPoints);
  DockingTerms terms;
  ContactRun run = ContactRun::none;
  float area_px2 = 0;
  for (int k = 0; k < kBoundaryPoints; ++k) {
    const int i = first + k < kBoundaryPoints ? first + k : first + k - kBoundaryPoints;
    const float d = distance[i];
    if (std::abs(d) < context.delta_px) terms.matched_px += step_px;
    const ContactRun here = d < -kNoise_px                        ? ContactRun::overlap
                            : d > kNoise_px && d < context.gap_px ? ContactRun::gap
                                                                  : ContactRun::none;
    if (here != run) {
      finish_run(terms, run, area_px2);
      run = here;
      area_px2 = 0;
    }
    area_px2 += std::abs(d) * step_px;
  }
  finish_run(terms, run, area_px2);

  int covered = 0;
  for (const Vec2& p : shape.interior) covered += field_value(field, canvas_from_shape.apply(p)) < 0;
  if (covered > 0) {
    const float seen_px2 = float(covered) / float(shape.interior.size()) * (scale * scale);
    if (seen_px2 > terms.overlap_px2) {
      const float more = seen_px2 - terms.overlap_px2;
      terms.overlap_px4 += more * more;
      terms.overlap_px2 = seen_px2;
    }
  }
  if (context.colour)
    terms.colour_difference = colour_difference(shape.colour, canvas_from_shape, *context.colour.target);
  return terms;
}

}  // namespace tessera
