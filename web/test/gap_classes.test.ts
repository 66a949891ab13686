import assert from "node:assert/strict";
import { test } from "node:test";
import { gapClasses } from "../src/model/gap_classes.ts";

const starts = (radius_px: number[]): number[] => gapClasses(radius_px).map(({ from_px }) => from_px);

test("gaps: five classes from the smallest to the largest radius", () => {
  assert.deepEqual(starts([11.5, 3, 1.5]), [1.5, 3.5, 5.5, 7.5, 9.5]);
});

test("gaps of nearly the same size have one class, no gaps have none", () => {
  assert.deepEqual(starts([2, 1.95]), [1.95]);
  assert.deepEqual(starts([]), []);
});
