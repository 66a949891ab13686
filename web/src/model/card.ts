import { count, duration, fixed, percent } from "../util/format.ts";

/** A key figure in plain words. */
export interface Figure {
  label: string;
  value: string;
  /** What it means. */
  meaning: string;
}

type Section = Record<string, unknown>;

/** The card's section of that name; empty where it is missing. */
export function section(card: Record<string, unknown> | null, name: string): Section {
  const found = card?.[name];
  return typeof found === "object" && found !== null ? (found as Section) : {};
}

type Row = [key: string, label: string, show: (value: number) => string, meaning: string];

const px = (value: number): string => `${fixed(value, 1)} px`;
const ratio = (value: number): string => fixed(value, 2);

const quality_rows: readonly Row[] = [
  ["coverage_fraction", "Covered", percent, "of the canvas lies under at least one piece"],
  ["overlap_fraction", "Overlap", percent, "of the canvas lies under more than one piece"],
  ["outside_fraction", "Outside", percent, "of the canvas' area sticks out beyond the canvas"],
  ["largest_gap_radius_px", "Largest gap", px, "radius of the largest disc that fits between the pieces"],
  ["shared_boundary_fraction", "In contact", percent, "of all boundaries lie within 2 px of another piece or the edge"],
  ["alone_fraction", "Alone", percent, "of the pieces have no other piece within 2 px"],
  ["between_pieces_px", "Closest pieces", px, "between the outlines of the two closest pieces; 0: some touch"],
  ["pieces", "Pieces", count, "placed on the canvas"],
  ["distinct_shapes", "Drawings", count, "different ones are used"],
  ["effective_shapes", "Drawings to the eye", (value) => fixed(value, 0), "with equal shares of the area would look as varied"],
  ["nearest_copy_px", "Nearest copy", px, "from a piece to the nearest one with the same drawing, the median"],
  ["size_balance", "Balance of sizes", ratio, "1: small and large pieces have an equal part in the picture"],
  ["dwarfs_fraction", "Dwarfs", percent, "of the pieces' area are very small pieces"],
  ["style_distance", "Style distance", ratio, "of two pieces on average; 0: all in one style"],
];

/** What the card says about quality, as far as it says it. */
export function qualityFigures(card: Record<string, unknown> | null): Figure[] {
  const quality = section(card, "quality");
  const figures = quality_rows.flatMap(([key, label, show, meaning]): Figure[] => {
    const value = quality[key];
    return typeof value === "number" ? [{ label, value: show(value), meaning }] : [];
  });
  const scale = section(quality, "scale_px");
  if (typeof scale["median"] === "number") {
    const meaning = `median scale of a piece; from ${px(Number(scale["min"]))} to ${px(Number(scale["max"]))}`;
    figures.push({ label: "Size", value: px(scale["median"]), meaning });
  }
  return [...figures, ...afarFigures(card)];
}

/** How a mosaic looks from afar, beside the picture that it shows. */
function afarFigures(card: Record<string, unknown> | null): Figure[] {
  const afar = section(section(card, "from_afar"), "at_100_px");
  const figures: Figure[] = [];
  if (typeof afar["ciede2000"] === "number") {
    figures.push({
      label: "Colour from afar",
      value: fixed(afar["ciede2000"], 1),
      meaning: "mean difference to the image (CIEDE2000); 0: the same",
    });
  }
  if (typeof afar["ssim"] === "number") {
    figures.push({ label: "Structure from afar", value: ratio(afar["ssim"]), meaning: "likeness to the image (SSIM); 1: the same" });
  }
  return figures;
}

const seconds = (value: number): string => duration(value);
const share = (value: number): string => `${fixed(value, 1)} %`;

const cost_rows: readonly [key: string, label: string, show: (value: number) => string][] = [
  ["candidates", "Candidates (drawings and mirror images)", count],
  ["pads_per_shape", "PADs for each shape", (value) => fixed(value, 0)],
  ["iterations", "Iterations", count],
  ["target_samples", "Target samples", count],
  ["docking_choices", "Docking choices", count],
  ["dockings_evaluated", "Dockings evaluated", count],
  ["pruned_percent", "Pruned", (value) => `${fixed(value, 2)} %`],
  ["prune_share_percent", "Time for pruning", share],
  ["dock_share_percent", "Time for docking", share],
  ["objective_share_percent", "Time for the objective", share],
  ["merge_share_percent", "Time for merging", share],
  ["improve_s", "Improving", seconds],
  ["total_s", "Total time", seconds],
];

/** The cost of the run: the columns of the paper's Table 2. */
export function costRows(card: Record<string, unknown> | null): [label: string, value: string][] {
  const run = section(card, "run");
  return cost_rows.flatMap(([key, label, show]): [string, string][] => {
    const value = run[key];
    return typeof value === "number" ? [[label, show(value)]] : [];
  });
}

/** Where the workers spent the time: one row for each stage. */
export function rankRows(card: Record<string, unknown> | null): [stage: string, average: string, share: string, imbalance: string][] {
  const worker = section(section(card, "ranks"), "worker");
  return Object.keys(worker).flatMap((stage): [string, string, string, string][] => {
    const times = section(worker, stage);
    if (typeof times["average_s"] !== "number") return [];
    return [[stage, seconds(times["average_s"]), share(Number(times["share_percent"])), share(Number(times["imbalance_percent"]))]];
  });
}

const endings: Record<string, string> = {
  full: "nothing more fitted",
  used_up: "the library was used up",
  pieces: "it had the wanted number of pieces",
  coverage: "it covered as much as wanted",
  seconds: "its time was over",
  signal: "it was interrupted",
  time_limit: "the time limit was reached",
  lost_rank: "a worker was lost",
};

/** Why the run ended, in words. */
export function ending(card: Record<string, unknown> | null): string {
  const reason = section(card, "run")["stopped_by"];
  return typeof reason === "string" ? (endings[reason] ?? reason) : "";
}
