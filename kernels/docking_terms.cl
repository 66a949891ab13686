// core/matching/docking_terms.cpp in OpenCL C (paper section 4: L, O_i, G_i), estimated along the piece's contour.

enum Run { NO_RUN, OVERLAP_RUN, GAP_RUN };

void finish_run(TermsRecord* terms, int run, float area_px2) {
  if (run == OVERLAP_RUN) {
    terms->overlap_px2 += area_px2;
    terms->overlap_px4 += area_px2 * area_px2;
  } else if (run == GAP_RUN) {
    terms->gap_px2 += area_px2;
    terms->gap_px4 += area_px2 * area_px2;
  }
}

// Distances of all boundary points; gives the first one in contact, or 0.
int boundary_distances(global const float* contour, PoseRecord s, const Field* field, float* distance) {
  for (int block = 0; block < kBoundaryPoints / kLanes; ++block) {
    const Points p = placed_points(s, contour + kFineAt, kBoundaryPoints, block);
    vstore16(field_values(field, p.x, p.y), block, distance);
  }
  for (int i = 0; i < kBoundaryPoints; ++i) {
    if (fabs(distance[i]) < kContact_px) return i;
  }
  return 0;
}

int covered_interior_points(global const float* contour, int interior_points, PoseRecord s, const Field* field) {
  int covered = 0;
  for (int block = 0; block * kLanes < interior_points; ++block) {
    const Points p = placed_points(s, contour + kInteriorAt, kMaxInteriorPoints, block);
    const int16 used = lane_index() + block * kLanes < interior_points;
    covered += count_lanes(used & (field_values(field, p.x, p.y) < 0));
  }
  return covered;
}

void add_runs(TermsRecord* terms, const float* distance, int first, float step_px, constant MatchRecord* match) {
  int run = NO_RUN;
  float area_px2 = 0;
  for (int k = 0; k < kBoundaryPoints; ++k) {
    const float d = distance[first + k < kBoundaryPoints ? first + k : first + k - kBoundaryPoints];
    if (fabs(d) < match->delta_px) terms->matched_px += step_px;
    const int here = d < -kNoise_px ? OVERLAP_RUN : d > kNoise_px && d < match->gap_px ? GAP_RUN : NO_RUN;
    if (here != run) {
      finish_run(terms, run, area_px2);
      run = here;
      area_px2 = 0;
    }
    area_px2 += fabs(d) * step_px;
  }
  finish_run(terms, run, area_px2);
}

TermsRecord docking_terms(constant MatchRecord* match, global const float* contour, global const ShapeRecord* shape,
                          PoseRecord s, const Field* field, const Picture* picture) {
  TermsRecord terms = {0, 0, 0, 0, 0, 0};
  float distance[kBoundaryPoints];
  const int first = boundary_distances(contour, s, field, distance);
  const float scale = scale_of(s);
  add_runs(&terms, distance, first, shape->perimeter * scale / (float)kBoundaryPoints, match);
  const int covered = covered_interior_points(contour, shape->interior_points, s, field);
  if (covered > 0) {
    const float seen_px2 = (float)covered / (float)shape->interior_points * (scale * scale);
    if (seen_px2 > terms.overlap_px2) {
      const float more = seen_px2 - terms.overlap_px2;
      terms.overlap_px4 += more * more;
      terms.overlap_px2 = seen_px2;
    }
  }
  if (picture->record->levels > 0) terms.colour_difference = colour_difference(picture, contour, shape, s);
  return terms;
}
