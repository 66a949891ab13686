export interface Histogram {
  /** Lower edge of the first class, and the width of each. */
  from: number;
  step: number;
  counts: number[];
}

/** Counts of values in classes of equal width. Values at the upper end belong to the last class. */
export function histogram(values: readonly number[], from: number, to: number, classes: number): Histogram {
  const step = to > from ? (to - from) / classes : 1;
  const counts = new Array<number>(classes).fill(0);
  for (const value of values) {
    const at = Math.max(0, Math.min(classes - 1, Math.floor((value - from) / step)));
    counts[at]! += 1;
  }
  return { from, step, counts };
}

/** Sum of areas after each piece, percent of the canvas. */
export function cumulativePercent(areas_px2: readonly number[], canvas_px2: number): number[] {
  let sum = 0;
  return areas_px2.map((area) => {
    sum += area;
    return canvas_px2 > 0 ? (100 * sum) / canvas_px2 : 0;
  });
}

/** At most `most` indices, evenly spread over 0 .. length - 1, with both ends: plots need no more points than pixels. */
export function spreadIndices(length: number, most: number): number[] {
  if (length <= most) return Array.from({ length }, (_, index) => index);
  return Array.from({ length: most }, (_, index) => Math.round((index * (length - 1)) / (most - 1)));
}

/** A run may fill the canvas several times. The first index of each attempt: where the coverage falls by more than a tenth. Improving a
 *  collage takes single pieces away, which is no new attempt. */
export function attemptStarts(coverage: readonly number[]): number[] {
  return coverage.flatMap((value, index) => (index === 0 || value < coverage[index - 1]! - 0.1 ? [index] : []));
}
