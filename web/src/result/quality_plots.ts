import { contactFraction, type Result } from "../model/result.ts";
import { attemptStarts, cumulativePercent, histogram, spreadIndices } from "../model/statistics.ts";
import { type Plot, plotFigure } from "../ui/plot.ts";
import { count, duration, fixed } from "../util/format.ts";

const kClasses = 24;
const kMostPoints = 400;

/** The plots that the data allow. */
export function qualityPlots(result: Result): HTMLElement[] {
  if (result.data.pieces.shape.length === 0) return [];
  const plots = [sizes(result), growth(result), ...overTime(result), ...contacts(result)];
  return plots.map(plotFigure);
}

function sizes(result: Result): Plot {
  const { scale_px } = result.data.pieces;
  const from = scale_px.reduce((a, b) => Math.min(a, b));
  const to = scale_px.reduce((a, b) => Math.max(a, b));
  return {
    title: "Sizes of the pieces",
    summary: `Number of pieces by scale, from ${fixed(from, 1)} to ${fixed(to, 1)} px.`,
    x_label: "scale, px",
    ...bars(scale_px, from, to),
    unit: "",
    testid: "plot-sizes",
  };
}

function growth(result: Result): Plot {
  const { canvas, pieces } = result.data;
  const covered = cumulativePercent(pieces.area_px2, canvas.area_px2);
  const indices = spreadIndices(covered.length, kMostPoints);
  const half = covered.findIndex((value) => value >= covered[covered.length - 1]! / 2) + 1;
  return {
    title: "Area over pieces",
    summary:
      "Sum of the pieces' areas, in percent of the canvas. " +
      `The first ${count(half)} of ${count(covered.length)} pieces make up half of it.`,
    x_label: "pieces",
    x: indices.map((index) => index + 1),
    y: indices.map((index) => covered[index]!),
    kind: "line",
    unit: " %",
    testid: "plot-growth",
  };
}

function overTime(result: Result): Plot[] {
  const { s, coverage } = result.data.progress;
  if (s.length < 2) return [];
  const starts = attemptStarts(coverage);
  const attempts = starts.length > 1 ? ` The run filled the canvas in ${starts.length} attempts, a line for each.` : "";
  const points = starts.flatMap((from, attempt): [number, number | null][] => {
    const end = starts[attempt + 1] ?? s.length;
    const indices = spreadIndices(end - from, 1 + Math.ceil(kMostPoints / starts.length)).map((index) => from + index);
    const line = indices.map((index): [number, number] => [s[index]!, 100 * coverage[index]!]);
    return attempt === 0 ? line : [[s[from]!, null], ...line]; // nothing joins the attempts
  });
  return [
    {
      title: "Coverage over time",
      summary: `Covered part of the canvas over ${duration(s[s.length - 1]!)}.${attempts}`,
      x_label: "seconds",
      x: points.map(([time]) => time),
      y: points.map(([, percent]) => percent),
      kind: "line",
      unit: " %",
      testid: "plot-time",
    },
  ];
}

function contacts(result: Result): Plot[] {
  if (!result.contact) return [];
  const fractions = result.data.pieces.shape.map((_shape, piece) => 100 * contactFraction(result, piece)!);
  const middle = [...fractions].sort((a, b) => a - b)[Math.floor(fractions.length / 2)]!;
  return [
    {
      title: "Contact of the pieces",
      summary:
        "Number of pieces by the part of their boundary within 2 px of another piece or the edge; " +
        `the median is ${fixed(middle, 0)} %.`,
      x_label: "% of the boundary",
      ...bars(fractions, 0, 100),
      unit: "",
      testid: "plot-contact",
    },
  ];
}

function bars(values: readonly number[], from: number, to: number): Pick<Plot, "x" | "y" | "kind"> {
  const classes = histogram(values, from, to, kClasses);
  return { x: classes.counts.map((_count, index) => classes.from + (index + 0.5) * classes.step), y: classes.counts, kind: "bars" };
}
