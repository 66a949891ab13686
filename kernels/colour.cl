// core/colour and core/matching/colour_fit.cpp in OpenCL C: CIEDE2000, look-ups in the picture that the pieces shall
// show, and the colour difference of a piece from it.

// core/colour/ciede2000.cpp, for one pair of colours or for one pair in each lane: F is float or LaneFloat.
#define DEFINE_CIEDE2000(NAME, F, EXP2)                                                                              \
  F NAME##_saturation(F chroma) {                                                                                    \
    const F c2 = chroma * chroma;                                                                                    \
    const F c7 = c2 * c2 * c2 * chroma;                                                                              \
    return c7 / (c7 + 6103515625.f);                                                                                 \
  }                                                                                                                  \
  F NAME##_hue_weight(F cosine, F sine) {                                                                            \
    const F cos2 = 2 * cosine * cosine - 1;                                                                          \
    const F sin2 = 2 * cosine * sine;                                                                                \
    const F cos3 = cosine * cos2 - sine * sin2;                                                                      \
    const F sin3 = sine * cos2 + cosine * sin2;                                                                      \
    const F cos4 = 2 * cos2 * cos2 - 1;                                                                              \
    const F sin4 = 2 * cos2 * sin2;                                                                                  \
    return 1 - 0.17f * (cosine * 0.86602540f + sine * 0.5f) + 0.24f * cos2 +                                         \
           0.32f * (cos3 * 0.99452190f - sin3 * 0.10452846f) - 0.2f * (cos4 * 0.45399050f + sin4 * 0.89100652f);     \
  }                                                                                                                  \
  F NAME##_blue_turn(F cosine, F sine) {                                                                             \
    const F along = cosine * 0.08715574f - sine * 0.99619470f;                                                       \
    const F u = 1 - (along > 0 ? along : (F)0);                                                                      \
    F square = 3.8480038e-3f;                                                                                        \
    square = square * u + 1.01587302e-2f;                                                                            \
    square = square * u + 2.85714286e-2f;                                                                            \
    square = square * u + 8.88888889e-2f;                                                                            \
    square = square * u + 3.33333333e-1f;                                                                            \
    square = square * u + 2.f;                                                                                       \
    square = square * u;                                                                                             \
    const F x = 1.04719755f * EXP2(square * -7.5777466f);                                                            \
    const F x2 = x * x;                                                                                              \
    return x * (1 - x2 * (0.16666667f - x2 * (8.3333333e-3f - x2 * 1.9841270e-4f)));                                 \
  }                                                                                                                  \
  F NAME(F lightness_x, F a_x, F bx, F lightness_y, F a_y, F by) {                                                   \
    const F drawn_chroma = (sqrt(a_x * a_x + bx * bx) + sqrt(a_y * a_y + by * by)) * 0.5f;                           \
    const F more_a = 0.5f - 0.5f * sqrt(NAME##_saturation(drawn_chroma));                                            \
    const F ax = a_x + a_x * more_a;                                                                                 \
    const F ay = a_y + a_y * more_a;                                                                                 \
    const F chroma_x = sqrt(ax * ax + bx * bx);                                                                      \
    const F chroma_y = sqrt(ay * ay + by * by);                                                                      \
    const F chroma = (chroma_x + chroma_y) * 0.5f;                                                                   \
    const F along = ax * ay + bx * by;                                                                               \
    const F across = ax * by - bx * ay;                                                                              \
    const F product = chroma_x * chroma_y;                                                                           \
    const F square = along > 0 ? 2 * (across * across) / (product + along) : 2 * (product - along);                  \
    const F size = sqrt(square > 0 ? square : (F)0);                                                                 \
    const F inverse_x = chroma_x > 0 ? 1 / chroma_x : (F)0;                                                          \
    const F inverse_y = chroma_y > 0 ? 1 / chroma_y : (F)0;                                                          \
    const F u = ax * inverse_x + ay * inverse_y;                                                                     \
    const F v = bx * inverse_x + by * inverse_y;                                                                     \
    const F length = sqrt(u * u + v * v);                                                                            \
    const F cosine = length > 1e-6f ? u / length : (F)1;                                                             \
    const F sine = length > 1e-6f ? v / length : (F)0;                                                               \
    const F off_middle = (lightness_x + lightness_y) * 0.5f - 50;                                                    \
    const F off_middle2 = off_middle * off_middle;                                                                   \
    const F by_lightness = (lightness_y - lightness_x) / (1 + 0.015f * off_middle2 / sqrt(20 + off_middle2));        \
    const F by_chroma = (chroma_y - chroma_x) / (1 + 0.045f * chroma);                                               \
    const F by_hue = (across < 0 ? -size : size) / (1 + 0.015f * chroma * NAME##_hue_weight(cosine, sine));          \
    const F turn = -2 * sqrt(NAME##_saturation(chroma)) * NAME##_blue_turn(cosine, sine);                            \
    const F sum =                                                                                                    \
        by_lightness * by_lightness + by_chroma * by_chroma + by_hue * by_hue + turn * (by_chroma * by_hue);         \
    return sqrt(sum > 0 ? sum : (F)0);                                                                               \
  }

DEFINE_CIEDE2000(ciede2000, float, portable_exp2)
DEFINE_CIEDE2000(ciede2000_lanes, LaneFloat, portable_exp2_lanes)

// The ColourTarget; it has no levels where the job has no picture.
typedef struct Picture {
  constant ColourRecord* record;
  global const float* texels;
} Picture;

uint colour_level_for(const Picture* picture, float length_px) {
  constant ColourRecord* record = picture->record;
  uint level = 0;
  while (level + 1 < record->levels && record->level[level + 1].texels_per_px * length_px >= 1) ++level;
  return level;
}

float4 mixed(float4 p, float4 q, float t) { return p * (1 - t) + q * t; }

// (lightness, a and b times the weight; the weight) of the picture at a point.
float4 colour_at(const Picture* picture, uint level, float x, float y) {
  constant ColourLevelRecord* l = picture->record->level + level;
  const CellLookup c = cell_lookup(x, y, l->texels_per_px, l->width, l->height);
  const size_t upper = l->first + (size_t)c.upper * l->width;
  const size_t lower = l->first + (size_t)c.lower * l->width;
  global const float* texels = picture->texels;
  return mixed(mixed(vload4(upper + c.left, texels), vload4(upper + c.right, texels), c.s),
               mixed(vload4(lower + c.left, texels), vload4(lower + c.right, texels), c.s), c.t);
}

float mean_colour_difference(const Picture* picture, global const ShapeRecord* shape, PoseRecord s) {
  const float4 covered = colour_at(picture, colour_level_for(picture, kColourFootprint * scale_of(s)), s.tx, s.ty);
  if (covered.w < kLeastColourWeight) return 0;
  return ciede2000(shape->mean_lightness, shape->mean_a, shape->mean_b, covered.x / covered.w, covered.y / covered.w,
                   covered.z / covered.w);
}

// (Lightness, a and b times the weight; the weight) of the picture at a point of each lane.
typedef struct LaneColours {
  LaneFloat lightness, a, b, weight;
} LaneColours;

#if kLanesAreItems
LaneColours colours_at(const Picture* picture, uint level, Points p) {
  const float4 covered = colour_at(picture, level, p.x, p.y);
  const LaneColours colours = {covered.x, covered.y, covered.z, covered.w};
  return colours;
}
#else
LaneColours colours_at(const Picture* picture, uint level, Points p) {
  float x[kLanes], y[kLanes], lightness[kLanes], a[kLanes], b[kLanes], weight[kLanes];
  vstore16(p.x, 0, x);
  vstore16(p.y, 0, y);
  for (int k = 0; k < kLanes; ++k) {
    const float4 covered = colour_at(picture, level, x[k], y[k]);
    lightness[k] = covered.x;
    a[k] = covered.y;
    b[k] = covered.z;
    weight[k] = covered.w;
  }
  const LaneColours colours = {vload16(0, lightness), vload16(0, a), vload16(0, b), vload16(0, weight)};
  return colours;
}
#endif

// colour_difference of colour_fit.cpp: each lane computes one cell of the piece.
float colour_difference(Lanes lanes, const Picture* picture, global const float* contour,
                        global const ShapeRecord* shape, PoseRecord s) {
  const uint level = colour_level_for(picture, shape->colour_cell * scale_of(s));
  const LaneColours covered = colours_at(picture, level, placed_points(lanes, s, contour + kColourCellsAt, kLanes, 0));
  global const float* cells = contour + kColourCellsAt + 2 * kLanes;
  const LaneInt wished = covered.weight >= kLeastColourWeight;
  const LaneFloat lightness = wished ? covered.lightness / covered.weight : (LaneFloat)0;
  const LaneFloat a = wished ? covered.a / covered.weight : (LaneFloat)0;
  const LaneFloat b = wished ? covered.b / covered.weight : (LaneFloat)0;
  const LaneFloat weights = wished ? load_lanes(lanes, 3, cells) * covered.weight : (LaneFloat)0;
  const LaneFloat differences = ciede2000_lanes(load_lanes(lanes, 0, cells), load_lanes(lanes, 1, cells),
                                                load_lanes(lanes, 2, cells), lightness, a, b);
  const LaneFloat parts[2] = {weights, weights * (differences * differences)};
  float sums[2];
  sums_of_lanes(lanes, 2, parts, sums);
  return sums[0] < kLeastColourWeight ? 0.f : sqrt(sums[1] / sums[0]);
}

float colour_worth(const Picture* picture, float difference) {
  const float halvings = kColourFading * picture->record->weight * difference;
  return portable_exp2(halvings <= kEvenFading ? -halvings : kEvenFading * kEvenFading / halvings - 2 * kEvenFading);
}

// Whether the sample's list of shapes of similar colour (NearColours) contains the shape.
bool has_near_colour(global const SampleRecord* sample, global const uint* near_bits, uint words, uint library_shape) {
  if (sample->near_list == kAnyColour) return true;
  const uint word = near_bits[(size_t)sample->near_list * words + library_shape / 32];
  return ((word >> (library_shape % 32)) & 1u) != 0;
}
