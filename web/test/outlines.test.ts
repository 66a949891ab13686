import assert from "node:assert/strict";
import { test } from "node:test";
import { boxOf, decodeOutlines, pieceCount, pointRange } from "../src/model/outlines.ts";
import { decodeBase64 } from "../src/util/base64.ts";
import { encodeOutlines, square } from "./encode.ts";

test("outlines are decoded with holes, negative places and eighths of a px", () => {
  const outlines = decodeOutlines(encodeOutlines([[square(-3.125, 5, 100), square(10, 20, 7.5)], [square(30000, 2, 1)]]));
  assert.equal(pieceCount(outlines), 2);
  assert.deepEqual([...outlines.points.slice(0, 4)], [-3.125, 5, 96.875, 5]);
  assert.deepEqual([...outlines.points.slice(8, 12)], [10, 20, 17.5, 20]);
  assert.deepEqual(pointRange(outlines, 1), [8, 12]);
  assert.deepEqual(boxOf(outlines, 0), { left: -3.125, top: 5, right: 96.875, bottom: 105 });
  assert.deepEqual(boxOf(outlines, 1), { left: 30000, top: 2, right: 30001, bottom: 3 });
});

test("no bytes are no pieces", () => {
  assert.equal(pieceCount(decodeOutlines(new Uint8Array(0))), 0);
});

test("a block that ends early is refused", () => {
  const bytes = encodeOutlines([[square(1, 2, 300)]]);
  assert.throws(() => decodeOutlines(bytes.subarray(0, bytes.length - 1)), /damaged/);
  assert.throws(() => decodeOutlines(Uint8Array.of(255, 255, 255, 255, 255, 255)), /damaged/);
});

test("base64 of any length", () => {
  for (let length = 0; length < 40; ++length) {
    const bytes = Uint8Array.from({ length }, (_, index) => (index * 89 + 250) & 255);
    assert.deepEqual(decodeBase64(`\n${Buffer.from(bytes).toString("base64")}\n`), bytes);
  }
  assert.throws(() => decodeBase64("ab*d"), /damaged/);
});
