// core/colour and core/matching/colour_fit.cpp in OpenCL C: CIEDE2000, look-ups in the picture that pieces are to show,
// and how far a piece is from it.

// core/colour/ciede2000.cpp, for one pair of colours and for 16: F is float or float16.
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
DEFINE_CIEDE2000(ciede2000_lanes, float16, portable_exp2_lanes)

// ColourTarget; without one no levels.
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

// Lightness, a and b times the weight, and that.
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

float sum_of_lanes(float16 v) {
  const float8 a = v.lo + v.hi;
  const float4 b = a.lo + a.hi;
  const float2 c = b.lo + b.hi;
  return c.x + c.y;
}

float colour_difference(const Picture* picture, global const float* contour, global const ShapeRecord* shape,
                        PoseRecord s) {
  const uint level = colour_level_for(picture, shape->colour_cell * scale_of(s));
  const Points p = placed_points(s, contour + kColourCellsAt, kLanes, 0);
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
  global const float* cells = contour + kColourCellsAt + 2 * kLanes;
  const float16 covered = vload16(0, weight);
  const int16 wished = covered >= kLeastColourWeight;
  const float16 weights = wished ? vload16(3, cells) * covered : (float16)0;
  const float16 covered_lightness = wished ? vload16(0, lightness) / covered : (float16)0;
  const float16 covered_a = wished ? vload16(0, a) / covered : (float16)0;
  const float16 covered_b = wished ? vload16(0, b) / covered : (float16)0;
  const float16 differences = ciede2000_lanes(vload16(0, cells), vload16(1, cells), vload16(2, cells),
                                              covered_lightness, covered_a, covered_b);
  const float all = sum_of_lanes(weights);
  if (all < kLeastColourWeight) return 0;
  const float of_cells = sum_of_lanes(weights * differences) / all;
  const float of_means = ciede2000(shape->mean_lightness, shape->mean_a, shape->mean_b,
                                   sum_of_lanes(weights * covered_lightness) / all,
                                   sum_of_lanes(weights * covered_a) / all, sum_of_lanes(weights * covered_b) / all);
  return kColourOfMeans * of_means + (1 - kColourOfMeans) * of_cells;
}

float colour_worth(const Picture* picture, float difference) {
  const float halvings = kColourFading * picture->record->weight * difference;
  return portable_exp2(halvings <= kEvenFading ? -halvings : kEvenFading * kEvenFading / halvings - 2 * kEvenFading);
}

// NearColours: the lists of shapes that samples go by.
bool has_near_colour(global const SampleRecord* sample, global const uint* near_bits, uint words, uint library_shape) {
  if (sample->near_list == kAnyColour) return true;
  const uint word = near_bits[(size_t)sample->near_list * words + library_shape / 32];
  return ((word >> (library_shape % 32)) & 1u) != 0;
}
