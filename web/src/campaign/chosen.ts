import type { Value } from "../util/value.ts";

/** Indices of the results to compare: none, one or two, the one chosen first in front. */
export type Chosen = Value<readonly number[]>;

/** Takes a result into the choice or out of it. A third one takes the place of the first. */
export function toggleChosen(chosen: Chosen, result: number): void {
  const now = chosen.get();
  chosen.set(now.includes(result) ? now.filter((index) => index !== result) : [...now, result].slice(-2));
}
