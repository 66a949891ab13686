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

// Computes the distances of all boundary points; returns the index of the first point in contact, or 0.
int boundary_distances(Lanes lanes, global const float* contour, PoseRecord s, const Field* field,
                       SHARED float* distance) {
  LaneFloat first = kBoundaryPoints;
  for (int block = 0; block < kBoundaryPoints / kLanes; ++block) {
    const Points p = placed_points(lanes, s, contour + kFineAt, kBoundaryPoints, block);
    const LaneFloat d = field_values(field, p.x, p.y);
    store_lanes(lanes, d, block, distance);
    const LaneFloat point = convert_lane_float(numbers_of_block(lanes, block));
    first = min(first, fabs(d) < kContact_px ? point : (LaneFloat)kBoundaryPoints);
  }
  sync_lanes();
  const int first_of_all = (int)smallest_lane(lanes, first);
  return first_of_all < kBoundaryPoints ? first_of_all : 0;
}

int covered_interior_points(Lanes lanes, global const float* contour, int interior_points, PoseRecord s,
                            const Field* field) {
  LaneInt covered = 0;
  for (int block = 0; block * kLanes < interior_points; ++block) {
    const Points p = placed_points(lanes, s, contour + kInteriorAt, kMaxInteriorPoints, block);
    const LaneInt used = numbers_of_block(lanes, block) < interior_points;
    covered += (used & (field_values(field, p.x, p.y) < 0)) ? (LaneInt)1 : (LaneInt)0;
  }
  return int_sum_of_lanes(lanes, covered);
}

// Adds up the runs of overlap and gap along the contour. All lanes compute the same.
void add_runs(TermsRecord* terms, SHARED const float* distance, int first, float step_px, constant MatchRecord* match) {
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

// `distance`: memory for kBoundaryPoints distances.
TermsRecord docking_terms(Lanes lanes, SHARED float* distance, constant MatchRecord* match,
                          global const float* contour, global const ShapeRecord* shape, PoseRecord s,
                          const Field* field, const Picture* picture) {
  TermsRecord terms = {0, 0, 0, 0, 0, 0};
  const int first = boundary_distances(lanes, contour, s, field, distance);
  const float scale = scale_of(s);
  add_runs(&terms, distance, first, shape->perimeter * scale / (float)kBoundaryPoints, match);
  const int covered = covered_interior_points(lanes, contour, shape->interior_points, s, field);
  if (covered > 0) {
    const float seen_px2 = (float)covered / (float)shape->interior_points * (scale * scale);
    if (seen_px2 > terms.overlap_px2) {
      const float more = seen_px2 - terms.overlap_px2;
      terms.overlap_px4 += more * more;
      terms.overlap_px2 = seen_px2;
    }
  }
  if (picture->record->levels > 0) terms.colour_difference = colour_difference(lanes, picture, contour, shape, s);
  return terms;
}
