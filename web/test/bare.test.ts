import assert from "node:assert/strict";
import { test } from "node:test";
import { barePixels } from "../src/model/bare.ts";

type Pixel = readonly [number, number, number, number];
const clear: Pixel = [0, 0, 0, 0];
const hidden: Pixel = [0, 0, 0, 255];

function picture(width: number, height: number, pixel: (x: number, y: number) => Pixel): Uint8ClampedArray {
  return Uint8ClampedArray.from(Array.from({ length: width * height }, (_, at) => pixel(at % width, Math.floor(at / width))).flat());
}

test("what pieces cover gets the colour around them; what shows stays", () => {
  const covers = (x: number, y: number): boolean => x > 1 && x < 6 && y > 1 && y < 5;
  const pixels = picture(9, 7, (x, y) => (covers(x, y) ? [0, 0, 0, 255] : [200, 100, 50, 255]));
  const bare = barePixels(pixels, picture(9, 7, (x, y) => (covers(x, y) ? hidden : clear)), 9, 7);
  assert.deepEqual(bare, picture(9, 7, () => [200, 100, 50, 255]));
});

test("each part of the canvas keeps its own colour", () => {
  const pixels = picture(64, 16, (x, y) => (y === 8 ? [0, 0, 0, 255] : x < 32 ? [240, 0, 0, 255] : [0, 0, 240, 255]));
  const bare = barePixels(pixels, picture(64, 16, (_x, y) => (y === 8 ? hidden : clear)), 64, 16)!;
  const at = (x: number): number[] => [...bare.subarray(4 * (8 * 64 + x), 4 * (8 * 64 + x) + 4)];
  assert.deepEqual([at(8), at(56)], [[240, 0, 0, 255], [0, 0, 240, 255]]);
});

test("a transparent canvas stays transparent, whatever colour its clear pixels have", () => {
  const pixels = picture(5, 5, (x) => (x === 2 ? [9, 9, 9, 255] : [255, 0, 255, 0]));
  const bare = barePixels(pixels, picture(5, 5, (x) => (x === 2 ? hidden : clear)), 5, 5)!;
  assert.ok(bare.every((value, index) => index % 4 !== 3 || value === 0));
});

test("nothing is known of a canvas that pieces cover wholly", () => {
  assert.equal(barePixels(picture(3, 2, () => [1, 2, 3, 255]), picture(3, 2, () => hidden), 3, 2), null);
});
