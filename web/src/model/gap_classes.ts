import { kInferno } from "./ramp.ts";

/** Gaps from this radius on have this colour. */
export interface GapClass {
  from_px: number;
  colour: string;
}

const kMostClasses = 5;
/** Legends show tenths of a px: narrower classes would look the same there. */
const kNarrowest_px = 0.1;

/** Classes from the smallest to the largest radius, of equal width; none where there are no gaps. */
export function gapClasses(radius_px: readonly number[]): GapClass[] {
  if (radius_px.length === 0) return [];
  const smallest = radius_px.reduce((a, b) => Math.min(a, b));
  const largest = radius_px.reduce((a, b) => Math.max(a, b));
  const classes = Math.max(1, Math.min(kMostClasses, Math.floor((largest - smallest) / kNarrowest_px)));
  return kInferno.slice(0, classes).map((colour, index) => ({ from_px: smallest + ((largest - smallest) * index) / classes, colour }));
}
