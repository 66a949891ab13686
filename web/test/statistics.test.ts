import assert from "node:assert/strict";
import { test } from "node:test";
import { attemptStarts } from "../src/model/statistics.ts";

test("coverage: a new attempt starts where it falls to nearly nothing, not where a piece goes", () => {
  assert.deepEqual(attemptStarts([0.1, 0.5, 0.49, 0.8, 0.02, 0.7, 0.01]), [0, 4, 6]);
  assert.deepEqual(attemptStarts([0.1, 0.5, 0.499]), [0]);
  assert.deepEqual(attemptStarts([]), []);
});
