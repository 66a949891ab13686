#include "job/job_keys.h"

#include <algorithm>
#include <numbers>

#include "core/collage/objective.h"
#include "core/geometry/degrees.h"
#include "job/key_fields.h"
#include "job/palette.h"

namespace tessera {
namespace {

// Defaults are not repeated here: they are the initial values in Job (job_file.h) and CollageSettings (settings.h).
// Their sources stand above each group. "paper" is Kwan et al. 2016. "trial" is the measured single-threaded prototype
// from which this program was designed (120 animal silhouettes, 1000 x 1000 px).

/// A `field` for the functions in key_fields.h.
#define FIELD(member) \
  [](auto& job) -> auto& { return job.member; }

// 2^53 - 1: beyond it a whole number is not exact in every reader of TOML and JSON.
constexpr double kMaxSeed = 9007199254740991;

std::vector<std::string> all_and(std::vector<std::string> words) {
  words.insert(words.begin(), "all");
  return words;
}

// The rows of the table, one for each key: these functions are as long as there are keys.
// clang-format off

/// A canvas of 1000 x 1000 px is the one that docs/measurements/pictures.md measures.
void add_input_keys(std::vector<JobKey>& keys) {
  using enum JobKind;
  keys.push_back(with_number({"", "seed", integer, "", 0, kMaxSeed, {},
                              "start of the random numbers; another seed, another collage"},
                             FIELD(settings.seed)));
  keys.push_back(with_word({"", "quality", word, "", 0, 0, {"", "draft", "good", "best"},
                            "how much the collage is improved; the number of trials follows from the canvas and the "
                            "sizes of the pieces; not used where [improve] gives `trials` or `seconds`; empty = as "
                            "[improve] says"},
                           FIELD(quality)));
  keys.push_back(with_text({"library", "file", file, "", 0, 0, {},
                            "the library of shapes, made by `tessera library build`"},
                           FIELD(library)));
  keys.back().required = true;
  keys.back().or_list = "files";
  keys.push_back(with_texts({"library", "files", files, "", 0, 0, {}, "several libraries as one, instead of `file`"},
                            FIELD(library_files)));
  keys.push_back(with_texts({"library", "include", texts, "", 0, 0, {},
                             "patterns of the names of shapes to use; empty = all"},
                            FIELD(library_include)));
  keys.push_back(with_texts({"library", "exclude", texts, "", 0, 0, {},
                             "patterns of the names of shapes to leave out"},
                            FIELD(library_exclude)));
  keys.push_back(with_texts({"library", "colours", palette, "", 0, 0, all_and(built_in_palettes()),
                             "use only drawings in these colours"},
                            FIELD(library_colours)));
  keys.push_back(with_number({"library", "colours_within", number, "CIEDE2000", 0, 100, {},
                              "largest difference of a drawing from these colours, as the mean of its parts"},
                             FIELD(library_colours_within)));
  keys.push_back(with_text({"library", "wishes", file, "", 0, 0, {},
                            "a table (CSV) of wishes, whose rows come before those of [[shapes]]; empty = none"},
                           FIELD(wishes)));
  keys.push_back(with_pair({"canvas", "size_px", size, "px", 16, 20000, {},
                            "width and height of the rectangle, or of the box that the mask in `file` is scaled into"},
                           FIELD(canvas.width_px), FIELD(canvas.height_px)));
  keys.push_back(with_pair({"canvas", "size_mm", paper_size, "mm", 1, 20000, {},
                            "size of the canvas on paper; lengths may then be given in mm; [0, 0] = none"},
                           FIELD(canvas.width_mm), FIELD(canvas.height_mm)));
  keys.back().decides = false;
  keys.push_back(with_text({"canvas", "file", file, "", 0, 0, {},
                            "SVG or image whose silhouette is filled; empty = rectangle"},
                           FIELD(canvas.file)));
  keys.push_back(with_word({"canvas", "seamless", word, "", 0, 0, {"none", "x", "y", "both"},
                            "edges across which the collage continues, so that copies side by side show no seam: "
                            "left and right (x), top and bottom (y)"},
                           FIELD(canvas.seamless)));
  keys.push_back(with_text({"canvas", "keep_out", file, "", 0, 0, {},
                            "SVG or image, laid over the canvas: pieces keep out of what it shows; empty = nothing"},
                           FIELD(canvas.keep_out)));
}

/// Default as in the paper: an empty canvas, filled from its edge inward.
void add_start_keys(std::vector<JobKey>& keys) {
  using enum JobKind;
  keys.push_back(with_text({"start", "pieces", file, "", 0, 0, {},
                            "`pieces.geojson` of an earlier result, or the result's folder: its pieces stand first; "
                            "empty = none"},
                           FIELD(start.pieces)));
  keys.push_back(with_word({"start", "keep", word, "", 0, 0, {"locked", "free", "standing"},
                            "treatment of these pieces: `locked`: they stay and are locked in the result; `free`: "
                            "[improve] may remove them; `standing`: they stay, and keep their own lock in the result"},
                           FIELD(start.keep)));
  keys.push_back(with_indices({"start", "remove", indices, "", 0, kMostStartPieces - 1, {},
                               "pieces to remove, by `index`; only the room where they lay is filled"},
                              FIELD(start.remove)));
  keys.push_back(with_indices({"start", "lock", indices, "", 0, kMostStartPieces - 1, {},
                               "pieces to lock, by `index`, whatever `keep` says"},
                              FIELD(start.lock)));
  keys.push_back(with_texts({"start", "not_anew", texts, "", 0, 0, {},
                             "names of shapes that are not placed again; empty = none"},
                            FIELD(start.not_anew)));
  keys.push_back(with_word({"start", "grow", word, "", 0, 0, {"inward", "outward"},
                            "`inward`: pieces dock to the canvas' edge, too; `outward`: only to pieces and zones "
                            "that are there, so that the collage grows from them"},
                           FIELD(settings.start.grow_outward)));
}

/// Scales: the range 8:1 of the trial. The paper allows any rotation and any number of uses.
void add_piece_keys(std::vector<JobKey>& keys) {
  using enum JobKind;
  keys.push_back(with_intervals({"pieces", "scale_px", intervals, "px", 2, 5000, {},
                                 "size of the smallest and the largest piece: the square root of its area"},
                                &PoseWish::scale_px, FIELD(settings.pieces.min_scale_px),
                                FIELD(settings.pieces.max_scale_px), 1));
  keys.push_back(with_word({"pieces", "sizes", word, "", 0, 0, {"range", "drawn"},
                            "`range`: those of `scale_px`; `drawn`: each shape as large as its drawing is"},
                           FIELD(drawn_sizes)));
  keys.push_back(with_text({"pieces", "size_map", file, "", 0, 0, {},
                            "a grey picture, laid over the whole canvas: black = only the smallest size, white = all "
                            "sizes up to the largest; empty = white"},
                           FIELD(size_map)));
  keys.push_back(with_intervals({"pieces", "rotation_deg", intervals, "degrees", -360, 360, {},
                                 "allowed rotations of the artwork, clockwise; -180 to 180 = any"},
                                &PoseWish::rotation_rad, FIELD(settings.pieces.min_rotation_rad),
                                FIELD(settings.pieces.max_rotation_rad), kDegreesPerRad));
  keys.push_back(with_word({"pieces", "mirrored", word, "", 0, 0, mirroring_words(),
                            "whether shapes may stand as their mirror images: `also`: as drawn and mirrored"},
                           FIELD(mirrored)));
  keys.push_back(with_pair({"pieces", "uses", uses, "", 0, 1e6, {},
                            "how often one shape may be placed; 0 = unlimited"},
                           FIELD(settings.pieces.least_uses), FIELD(settings.pieces.uses)));
  keys.push_back(with_word({"pieces", "fit", word, "", 0, 0, {"free", "all"},
                            "`all`: every shape is placed at least once; the program multiplies all sizes by one "
                            "factor until they fit"},
                           FIELD(settings.pieces.fit_all)));
  keys.push_back(with_number({"pieces", "least_scale_px", number, "px", 2, 5000, {},
                              "with `fit = \"all\"`: no piece becomes smaller than this, even if some shapes then "
                              "find no place"},
                             FIELD(settings.pieces.least_scale_px)));
  keys.push_back(with_number({"pieces", "balance", number, "", 0, 1, {},
                              "mix of sizes: from 0 = contrast, a few large pieces with very small ones between "
                              "them, to 1 = even, the same area of each size"},
                             FIELD(settings.objective.balance)));
  keys.push_back(with_number({"pieces", "padding_px", number, "px", 0, 500, {},
                              "distance kept between pieces, and between pieces and the canvas' edge"},
                             FIELD(settings.pieces.padding_px)));
  keys.push_back(with_number({"pieces", "apart_px", number, "px", 0, 20000, {},
                              "distance kept between the outlines of two pieces with the same silhouette; 0 = any"},
                             FIELD(settings.pieces.apart_px)));
  keys.push_back(with_number({"pieces", "overlap_px", number, "px", 0, 2.5, {},
                              "without padding: how deep a corner of a piece may lie in another, and beyond the canvas' "
                              "edge; 0 = pieces do not overlap"},
                             FIELD(settings.pieces.overlap_px)));
}

/// levels, delta_tau: paper, section 5. top_percent, beta: trial; the paper's beta = 0.4 lets two thirds of all pairs
/// pass, the best few percent are what prunes. tangent_dockings: trial; 300 to 600 are enough along straight sides,
/// where PAD finds nothing. most_pairs: best hundred to best 2 %, all the same (docs/decisions/2026-11-21-pair-selection-in-bytes.md).
void add_match_keys(std::vector<JobKey>& keys) {
  using enum JobKind;
  keys.push_back(with_number({"match", "levels", integer, "", 2, kMaxPadLevels, {},
                              "n: levels of the arclength pyramid"},
                             FIELD(settings.match.pad.levels)));
  keys.push_back(with_number({"match", "delta_tau", number, "rad", 0.02, 1, {},
                              "Δτ: integral of absolute curvature over each side of level 0"},
                             FIELD(settings.match.pad.delta_tau)));
  keys.push_back(with_number({"match", "top_percent", number, "%", 0.001, 100, {},
                              "K: best pairs kept, of all pairs of a target sample"},
                             FIELD(settings.match.top_percent)));
  keys.push_back(with_number({"match", "most_pairs", integer, "", 0, 1e6, {},
                              "best pairs kept of a target sample, however large the library; 0 = no limit"},
                             FIELD(settings.match.most_pairs)));
  keys.push_back(with_number({"match", "beta", number, "", 0, 4, {}, "β: largest distance of two PADs (Eq. 1)"},
                             FIELD(settings.match.beta)));
  keys.push_back(with_number({"match", "tangent_dockings", integer, "", 0, 100000, {},
                              "random tangent-aligned dockings per target sample"},
                             FIELD(settings.match.tangent_dockings)));
  keys.push_back(with_number({"match", "delta_px", number, "px", 0.1, 50, {},
                              "δ: a boundary point nearer than this is matched"},
                             FIELD(settings.match.delta_px)));
}

std::vector<std::string> objective_names() {
  std::vector<std::string> names;
  for (const ObjectiveKind& kind : objective_kinds()) names.push_back(kind.name);
  return names;
}

/// All from the trial: the paper's Z alone prefers very small pieces (75 % coverage with 600 pieces). Without a cost of
/// repetition one boomerang fills the canvas.
void add_objective_keys(std::vector<JobKey>& keys) {
  using enum JobKind;
  keys.push_back(with_word({"objective", "kind", word, "", 0, 0, objective_names(),
                            "`scale_aware`: long contact, little gap, large pieces; `paper`: the paper's Z"},
                           FIELD(settings.objective.kind)));
  keys.push_back(with_number({"objective", "overlap_weight", number, "", 0, 100, {}, "cost of overlapped area"},
                             FIELD(settings.objective.overlap_weight)));
  keys.push_back(with_number({"objective", "gap_weight", number, "", 0, 100, {},
                              "cost of area that no piece can enter any more"},
                             FIELD(settings.objective.gap_weight)));
  keys.push_back(with_number({"objective", "length_exponent", number, "", 0, 4, {},
                              "exponent of the matched share of the piece's boundary"},
                             FIELD(settings.objective.length_exponent)));
  keys.push_back(with_number({"objective", "scale_exponent", number, "", 0, 4, {},
                              "exponent of the piece's size relative to the largest allowed; more gives larger "
                              "pieces and more contrast"},
                             FIELD(settings.objective.scale_exponent)));
  keys.push_back(with_number({"objective", "repetition_exponent", number, "", 0, 4, {},
                              "the score is multiplied by (1 + uses of the shape)^-exponent"},
                             FIELD(settings.objective.repetition_exponent)));
  keys.push_back(with_number({"objective", "near_twin_factor", number, "", 0, 1, {},
                              "the score is multiplied by this for each copy of the shape nearby; 1 = no effect"},
                             FIELD(settings.objective.near_twin_factor)));
}

/// These numbers apply where `quality` is not used: without a number nothing is improved, as in the paper.
void add_improve_keys(std::vector<JobKey>& keys) {
  using enum JobKind;
  keys.push_back(with_number({"improve", "trials", integer, "", 0, 1e7, {},
                              "number of trials when nothing fits any more: a trial removes a few small pieces "
                              "beside a gap and fills the hole again; it is kept where that is better; 0 = no limit "
                              "if `seconds` is given, else no trials"},
                             FIELD(settings.improve.trials)));
  keys.push_back(with_number({"improve", "seconds", number, "s", 0, 1e7, {},
                              "end improving after this time, which makes the result depend on the machine; 0 = no limit"},
                             FIELD(settings.improve.seconds)));
  keys.push_back(with_flag({"improve", "relax", flag, "", 0, 0, {},
                            "at the beginning all pieces move, turn and grow together; then five of six trials "
                            "exchange single pieces (eight in a trial) while their neighbours make room; only where "
                            "sizes are not fixed, the largest is at most five times the smallest, and neither "
                            "`colour.image` nor `pieces.size_map` is given"},
                           FIELD(settings.improve.relax)));
}

/// The keys of [stop]. Their defaults end a collage when no further piece fits.
void add_stop_keys(std::vector<JobKey>& keys) {
  using enum JobKind;
  keys.push_back(with_number({"stop", "pieces", integer, "", 0, 1e6, {}, "end at this many pieces; 0 = no limit"},
                             FIELD(settings.stop.pieces)));
  keys.push_back(with_number({"stop", "coverage", number, "", 0.01, 1, {},
                              "end at this fraction of the canvas; 1 = when nothing fits any more"},
                             FIELD(settings.stop.coverage)));
  keys.push_back(with_number({"stop", "seconds", number, "s", 0, 1e7, {},
                              "end after this time, which makes the result depend on the machine; 0 = no limit"},
                             FIELD(settings.stop.seconds)));
  keys.back().decides = false;
}

/// The keys of [deform]. By default pieces keep their outlines. Up to the default limits, people did not see that drawings were deformed.
void add_deform_keys(std::vector<JobKey>& keys) {
  using enum JobKind;
  const std::size_t before = keys.size();
  keys.push_back(with_word({"deform", "kind", word, "", 0, 0, {"none", "capped", "voronoi"},
                            "deformation of the finished collage: `capped` moves boundaries, and the drawings with "
                            "them, to the middle of gaps and overlaps, within the limits below; `voronoi` does so "
                            "without these limits, as far as there is something to fill"},
                           FIELD(settings.deform.kind)));
  keys.push_back(with_number({"deform", "most_px", number, "px", 0, 100, {},
                              "largest movement of a boundary, if `capped`"},
                             FIELD(settings.deform.most_px)));
  keys.push_back(with_number({"deform", "most_part", number, "", 0, 0.5, {},
                              "the same limit as a part of the piece's size; the smaller one of both applies"},
                             FIELD(settings.deform.most_part)));
  keys.push_back(with_number({"deform", "most_area", number, "", 0.001, 1, {},
                              "largest change of a piece's area, as a part of that area, if `capped`"},
                             FIELD(settings.deform.most_area)));
  keys.push_back(with_number({"deform", "most_pad", number, "", 0.001, 1, {},
                              "largest change of a piece's outline, if `capped`: the mean distance of PADs along it"},
                             FIELD(settings.deform.most_pad)));
  for (std::size_t i = before; i < keys.size(); ++i) keys[i].decides = false;
}

/// One checkpoint a minute costs at most a thousandth of the time, and at most a minute of work is lost.
void add_checkpoint_keys(std::vector<JobKey>& keys) {
  keys.push_back(with_number({"checkpoint", "every_s", JobKind::number, "s", 0, 1e6, {},
                              "time between two checkpoints; 0 = only at the end, and where the run is interrupted"},
                             FIELD(checkpoint.every_s)));
  keys.back().decides = false;
  keys.back().in_result = false;
}

/// Workers send a heartbeat every 5 s, whatever they compute. A minute allows for nodes that swap and networks that
/// stall.
void add_comm_keys(std::vector<JobKey>& keys) {
  keys.push_back(with_number({"comm", "silence_s", JobKind::number, "s", 1, 1e6, {},
                              "a worker that sends no heartbeat for this time ends the run, with a checkpoint"},
                             FIELD(comm.silence_s)));
  keys.back().decides = false;
  keys.back().in_result = false;
}

/// Silhouettes of one colour, mostly black, would form one black area: colours of a palette tell the pieces apart.
void add_colour_keys(std::vector<JobKey>& keys) {
  using enum JobKind;
  keys.push_back(with_text({"colour", "pieces", word, "", 0, 0, {"auto", "artwork", "palette"},
                            "`artwork`: as drawn; `palette`: silhouettes in colours of the palette; `auto`: `palette` "
                            "for a library of silhouettes in one colour, else `artwork`"},
                           FIELD(colour.pieces)));
  keys.back().decides = false;
  keys.push_back(with_texts({"colour", "palette", palette, "", 0, 0, built_in_palettes(),
                             "the colours of silhouettes: a built-in palette, a palette file, or a list of colours"},
                            FIELD(colour.palette)));
  keys.back().decides = false;
  keys.push_back(with_text({"colour", "image", file, "", 0, 0, {},
                            "a picture, laid over the whole canvas, that the pieces show together; empty = none"},
                           FIELD(colour.image)));
  keys.push_back(with_number({"colour", "weight", number, "", 0, 100, {},
                              "how much colour counts compared with fit, with `image`"},
                             FIELD(settings.colour.weight)));
  keys.push_back(with_number({"colour", "neighbours", number, "", -100, 100, {},
                              "above 0: neighbouring pieces have similar colours; below 0: different ones"},
                             FIELD(settings.colour.neighbours)));
  keys.push_back(with_number({"colour", "shift", number, "CIEDE2000", 0, 100, {},
                              "largest change of a piece's colours towards the colours that it covers, part by part, "
                              "with `image`"},
                             FIELD(colour.shift)));
  keys.back().decides = false;
  keys.push_back(with_number({"colour", "overlay", number, "", 0, 0.5, {},
                              "opacity of `image` itself as a layer over the pieces and the space between them; 0 = "
                              "no layer"},
                             FIELD(colour.overlay)));
  keys.back().decides = false;
  keys.push_back(with_text({"colour", "harmony", word, "", 0, 0, {kNoHarmony, "auto", "i", "V", "L", "I", "T", "Y", "X"},
                            "harmonic template into which the hues of pieces are turned; `auto`: the one that fits "
                            "best; `none`: hues stay"},
                           FIELD(colour.harmony)));
  keys.back().decides = false;
}

/// A library has many styles; collages of the paper ignore them.
void add_style_keys(std::vector<JobKey>& keys) {
  using enum JobKind;
  keys.push_back(with_texts({"style", "like", texts, "", 0, 0, {},
                            "a drawing, or patterns of the names of several, whose style is preferred; `auto`: the "
                             "style that prevails in the library; empty = none"},
                            FIELD(style.like)));
  keys.push_back(with_number({"style", "weight", number, "", 0, 10, {},
                              "strength of this preference: at 1 a drawing is preferred half as much for each unit "
                              "of style distance; 0 = not at all"},
                             FIELD(style.weight)));
}

/// The keys that say how a piece is drawn. Their defaults cut the drawing out along its outline, as in the paper.
void add_piece_drawing_keys(std::vector<JobKey>& keys) {
  using enum JobKind;
  keys.push_back(with_number({"output", "outline_px", number, "px", 0, 100, {},
                              "width of a line along the outline of every piece, in px of the canvas; 0 = none"},
                             FIELD(output.outline_px)));
  keys.push_back(with_text({"output", "outline_colour", colour, "", 0, 0, {}, "its colour"},
                           FIELD(output.outline_colour)));
  keys.push_back(with_number({"output", "shadow_strength", number, "", 0, 1, {},
                              "strength of the pieces' shadow on the background: 0 = none, 1 = black"},
                             FIELD(output.shadow_strength)));
  keys.push_back(with_pair({"output", "shadow_offset_px", point, "px", -200, 200, {},
                            "how far the shadow lies to the right and down, in px of the canvas"},
                           FIELD(output.shadow_offset_px[0]), FIELD(output.shadow_offset_px[1])));
  keys.push_back(with_number({"output", "shadow_blur_px", number, "px", 0.5, 100, {},
                              "softness of the shadow: the standard deviation of its blur, in px of the canvas"},
                             FIELD(output.shadow_blur_px)));
  keys.push_back(with_text({"output", "clip", word, "", 0, 0, {"outline", kNoClip},
                            "`outline`: drawings are cut off beside their outline; `none`: they are drawn whole"},
                           FIELD(output.clip)));
  keys.push_back(with_text({"output", "keep_out", word, "", 0, 0, {kNoKeepOut, "artwork"},
                            "`artwork`: the drawing in `canvas.keep_out` is part of the pictures; `none`: its place is "
                            "left empty"},
                           FIELD(output.keep_out)));
  keys.push_back(with_flag({"output", "labels", flag, "", 0, 0, {},
                            "also write labels.png, whose pixels are the numbers of the pieces"},
                           FIELD(output.labels)));
  keys.push_back(with_flag({"output", "report", flag, "", 0, 0, {},
                            "also write report.html, a page to look at the result (`tessera report`)"},
                           FIELD(output.report)));
  keys.back().in_result = false;  // the page shows what the other files say
}

/// A picture twice as wide as the default canvas shows the artwork's details on a dense screen and in print.
void add_machine_and_output_keys(std::vector<JobKey>& keys) {
  using enum JobKind;
  const std::size_t first = keys.size();
  keys.push_back(with_text({"devices", "use", devices, "", 0, kMaxDeviceIndex, {"all", "cpu", "gpu"},
                            "the OpenCL devices each rank works on, by kind or by index"},
                           FIELD(devices)));
  keys.back().in_result = false;
  keys.push_back(with_number({"devices", "per_worker", integer, "", 0, kMaxDeviceIndex + 1, {},
                              "devices that each worker of a node takes for itself; 0 = all, shared with the others"},
                             FIELD(devices_per_worker)));
  keys.back().in_result = false;
  keys.push_back(with_number({"output", "width_px", integer, "px", 64, 60000, {},
                              "width of collage.png, without `width_mm`; its height follows from the canvas"},
                             FIELD(output.width_px)));
  keys.push_back(with_number({"output", "width_mm", number, "mm", 0, 20000, {},
                              "width of the canvas on paper; 0 = the pictures have no size on paper"},
                             FIELD(output.width_mm)));
  keys.push_back(with_number({"output", "dpi", number, "px per inch", 1, 4800, {},
                              "with `width_mm`: resolution of collage.png"},
                             FIELD(output.dpi)));
  keys.push_back(with_text({"output", "background", colour, "", 0, 0, {kNoColour, kImageBackground, kPhotoBackground},
                            "colour of the canvas, outside it is white; `none`: transparent, the outside too; `image`: "
                            "the picture in `colour.image`; `photo`: what lies round each piece in the photo that it was "
                            "cut out of"},
                           FIELD(output.background)));
  keys.push_back(with_number({"output", "background_light", number, "", 0, 1, {},
                              "with `image`: factor on its colours; below 1 pieces stand out from it; dark places "
                              "become a little lighter"},
                             FIELD(output.background_light)));
  keys.push_back(with_text({"output", "ground", file, "", 0, 0, {},
                            "SVG or image, laid over the background in tiles, below the pieces; empty = none"},
                           FIELD(output.ground)));
  keys.push_back(with_number({"output", "ground_px", number, "px", 0, 20000, {},
                              "width of a tile of `ground`, in px of the canvas; 0 = as wide as it was drawn"},
                             FIELD(output.ground_px)));
  add_piece_drawing_keys(keys);
  for (std::size_t i = first; i < keys.size(); ++i) keys[i].decides = false;
}

#undef FIELD
// clang-format on

}  // namespace

std::vector<Interval> intervals_of(const JobValue& value, double unit_per_member) {
  std::vector<Interval> intervals;
  for (std::size_t i = 0; i + 1 < value.numbers.size(); i += 2) {
    intervals.push_back({float(value.numbers[i] / unit_per_member), float(value.numbers[i + 1] / unit_per_member)});
  }
  return intervals;
}

const std::vector<JobKey>& job_keys() {
  static const std::vector<JobKey> keys = [] {
    std::vector<JobKey> all;
    add_input_keys(all);
    add_piece_keys(all);
    add_start_keys(all);
    add_match_keys(all);
    add_objective_keys(all);
    add_improve_keys(all);
    add_stop_keys(all);
    add_deform_keys(all);
    add_checkpoint_keys(all);
    add_comm_keys(all);
    add_colour_keys(all);
    add_style_keys(all);
    add_machine_and_output_keys(all);
    return all;
  }();
  return keys;
}

const JobKey* find_job_key(const std::string& section, const std::string& name) {
  const auto& keys = job_keys();
  const auto at = std::find_if(keys.begin(), keys.end(),
                               [&](const JobKey& key) { return key.section == section && key.name == name; });
  return at == keys.end() ? nullptr : &*at;
}

}  // namespace tessera
