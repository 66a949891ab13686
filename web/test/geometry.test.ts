import assert from "node:assert/strict";
import { test } from "node:test";
import { pieceContains, polygonContains, segmentsCross, squaredDistanceToSegment, strokeTouchesPiece } from "../src/model/geometry.ts";
import { neighboursOf } from "../src/model/neighbours.ts";
import { decodeOutlines } from "../src/model/outlines.ts";
import { SpatialIndex } from "../src/model/spatial_index.ts";
import { encodeOutlines, square } from "./encode.ts";

const plain = { width_px: 100, height_px: 100, repeats_x: false, repeats_y: false };

test("a point in a hole is outside", () => {
  const outlines = decodeOutlines(encodeOutlines([[square(0, 0, 10), square(4, 4, 2)]]));
  assert.equal(pieceContains(outlines, 0, 2, 2), true);
  assert.equal(pieceContains(outlines, 0, 5, 5), false);
  assert.equal(pieceContains(outlines, 0, 12, 5), false);
});

test("distances to a segment, also to one without length", () => {
  assert.equal(squaredDistanceToSegment(5, 3, 0, 0, 10, 0), 9);
  assert.equal(squaredDistanceToSegment(13, 4, 0, 0, 10, 0), 25);
  assert.equal(squaredDistanceToSegment(3, 4, 0, 0, 0, 0), 25);
});

test("segments cross, or not", () => {
  assert.equal(segmentsCross({ x: 0, y: 0 }, { x: 2, y: 2 }, { x: 0, y: 2 }, { x: 2, y: 0 }), true);
  assert.equal(segmentsCross({ x: 0, y: 0 }, { x: 1, y: 1 }, { x: 5, y: 0 }, { x: 0, y: 9 }), false);
});

test("the brush touches what it passes, and only that", () => {
  const outlines = decodeOutlines(encodeOutlines([[square(40, 40, 10)]]));
  const touches = (x0: number, y0: number, x1: number, y1: number, radius: number): boolean =>
    strokeTouchesPiece(outlines, 0, { x: x0, y: y0 }, { x: x1, y: y1 }, radius);
  assert.equal(touches(0, 45, 100, 45, 0), true); // through it, with both ends outside
  assert.equal(touches(30, 30, 38, 38, 2), false);
  assert.equal(touches(30, 30, 38, 38, 3), true);
  assert.equal(touches(45, 45, 45, 45, 0), true);
});

test("the lasso takes pieces by their centres", () => {
  const triangle = [
    { x: 0, y: 0 },
    { x: 50, y: 0 },
    { x: 0, y: 50 },
  ];
  assert.equal(polygonContains(triangle, 10, 10), true);
  assert.equal(polygonContains(triangle, 40, 40), false);
  const index = new SpatialIndex(decodeOutlines(encodeOutlines([[square(5, 5, 10)], [square(35, 35, 10)]])), plain);
  const centres = [
    { x: 10, y: 10 },
    { x: 40, y: 40 },
  ];
  assert.deepEqual(
    index.inLasso(triangle, (piece) => centres[piece]!),
    [0],
  );
});

test("neighbours lie within the reach, or overlap, or contain each other", () => {
  const pieces = [[square(10, 10, 10)], [square(21.5, 10, 10)], [square(10, 23, 10)], [square(12, 12, 2)]];
  const outlines = decodeOutlines(encodeOutlines(pieces));
  const index = new SpatialIndex(outlines, plain);
  assert.deepEqual(neighboursOf(outlines, index, 0, 2), [1, 3]);
  assert.deepEqual(neighboursOf(outlines, index, 2, 2), []);
  assert.deepEqual(neighboursOf(outlines, index, 3, 1), [0]);
});

test("on a seamless canvas pieces are found and are neighbours across the edge", () => {
  const outlines = decodeOutlines(encodeOutlines([[square(95, 10, 10)], [square(6, 10, 10)]]));
  const seamless = new SpatialIndex(outlines, { ...plain, repeats_x: true });
  assert.equal(seamless.pieceAt(2, 15), 0);
  assert.equal(seamless.pieceAt(98, 15), 0);
  assert.deepEqual(neighboursOf(outlines, seamless, 1, 2), [0]);
  assert.deepEqual(seamless.appearancesOf(0), [
    { piece: 0, dx: 0, dy: 0 },
    { piece: 0, dx: -100, dy: 0 },
  ]);
  assert.equal(seamless.appearancesOf(1).length, 1);
  assert.equal(new SpatialIndex(outlines, plain).pieceAt(2, 15), null);
});

test("the uppermost piece is hit, and no pieces are no trouble", () => {
  const index = new SpatialIndex(decodeOutlines(encodeOutlines([[square(0, 0, 20)], [square(10, 10, 20)]])), plain);
  assert.equal(index.pieceAt(15, 15), 1);
  assert.equal(index.pieceAt(5, 5), 0);
  assert.equal(new SpatialIndex(decodeOutlines(new Uint8Array(0)), plain).pieceAt(5, 5), null);
});
