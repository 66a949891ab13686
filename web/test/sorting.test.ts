import assert from "node:assert/strict";
import { test } from "node:test";
import { flatColour, rampColour } from "../src/model/ramp.ts";
import { type Found, foldedName, matches } from "../src/model/search.ts";
import { sortedIndices } from "../src/model/sorting.ts";
import { cumulativePercent, histogram, spreadIndices } from "../src/model/statistics.ts";
import { counted, duration, percent } from "../src/util/format.ts";

test("missing values stand last either way, equal ones keep their order", () => {
  const values = [2, null, 3, 2, 1];
  assert.deepEqual(sortedIndices(values, "ascending"), [4, 0, 3, 2, 1]);
  assert.deepEqual(sortedIndices(values, "descending"), [2, 0, 3, 4, 1]);
  assert.deepEqual(sortedIndices(["b", "a", "C"], "ascending"), [1, 0, 2]);
});

test("histograms count the ends", () => {
  assert.deepEqual(histogram([0, 0.5, 9.9, 10], 0, 10, 5), { from: 0, step: 2, counts: [2, 0, 0, 0, 2] });
  assert.deepEqual(histogram([7, 7], 7, 7, 3).counts, [2, 0, 0]);
});

test("areas add up, and plots take evenly spread points", () => {
  assert.deepEqual(cumulativePercent([10, 30], 200), [5, 20]);
  assert.deepEqual(spreadIndices(3, 10), [0, 1, 2]);
  assert.deepEqual(spreadIndices(101, 5), [0, 25, 50, 75, 100]);
});

test("search looks for every word, without accents and case", () => {
  const all: Found[] = ["Étoile du nord", "etoile", "bird"].map((name, index) => ({ kind: "drawing", index, name, pieces: 1 }));
  assert.equal(foldedName("Étoile"), "etoile");
  assert.deepEqual(
    matches(all, " NORD etoile").map((found) => found.index),
    [0],
  );
  assert.equal(matches(all, "").length, 3);
});

test("ramps begin and end with their colours", () => {
  assert.equal(rampColour(["#000000", "#ffffff"], 0), "rgb(0,0,0)");
  assert.equal(rampColour(["#000000", "#ffffff"], 0.5), "rgb(128,128,128)");
  assert.equal(rampColour(["#000000", "#ffffff"], 2), "rgb(255,255,255)");
  assert.notEqual(flatColour(0), flatColour(1));
});

test("numbers in words", () => {
  assert.equal(percent(0.901923), "90.2\u00a0%");
  assert.equal(percent(0.00143), "0.14\u00a0%");
  assert.equal(counted(1, "piece"), "1 piece");
  assert.equal(counted(20359, "piece"), "20,359 pieces");
  assert.equal(duration(196.939), "3 min 17 s");
  assert.equal(duration(3725), "1 h 2 min");
});
