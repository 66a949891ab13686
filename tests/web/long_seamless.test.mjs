// The page of a result whose canvas repeats: pieces across an edge appear at both sides, and nothing shows beyond the canvas.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { before, test } from "node:test";
import * as editing from "./editing_fixture.mjs";
import { makeResult } from "./made_pages_fixture.mjs";
import * as fixture from "./page_fixture.mjs";
import { changedPixels } from "./pixels_fixture.mjs";

const limits = { timeout: 120_000 };
const kSize = [300, 200];
fixture.useBrowser();
before(() => makeResult("seamless", "canvas.seamless='both'"));

/** A piece that crosses the left or the right edge by some px, and the boxes of its two parts. */
function crossing() {
  const { features } = JSON.parse(readFileSync("seamless/pieces.geojson", "utf8"));
  const [width] = kSize;
  for (const { properties, geometry } of features) {
    const [xs, ys] = [0, 1].map((axis) => geometry.coordinates[0].map((point) => point[axis]));
    const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    const shift = left < -4 && right > 4 ? width : right > width + 4 && left < width - 4 ? -width : 0;
    if (shift === 0 || top < 0 || bottom > kSize[1]) continue;
    const clipped = (by) => [Math.max(0, left + by), top, Math.min(width, right + by), bottom];
    return { index: properties.index, own: clipped(0), other: clipped(shift) };
  }
  throw new Error("no piece crosses the edge");
}

test("a piece across the edge is outlined and marked at both sides, and unmarked at both", limits, async (t) => {
  const { page, finish } = await fixture.open(t, "seamless.html");
  const { index, own, other } = crossing();
  const plain = await fixture.settledShot(page);
  const changed = async (what) => {
    const { within } = await changedPixels(page, plain, await fixture.settledShot(page), kSize, [own, other]);
    assert.ok(within.every((pixels) => pixels > 20), `${what}: ${within} pixels changed in the two parts`);
  };
  const unchanged = async (what) => assert.ok((await fixture.changedFraction(plain, await fixture.settledShot(page))) < 1e-4, what);

  await page.evaluate((piece) => window.tesseraReport.view.select(piece), index);
  await page.getByTestId("tab-edit").click();
  await changed("selected");
  await page.getByTestId("viewer").focus();
  await page.keyboard.press("e");
  await page.keyboard.press("Escape");
  assert.equal(await editing.command(page), `tessera refine seamless --pieces ${index}`);
  await changed("marked");
  await page.getByTestId("marks-undo").click();
  await unchanged("a mark stays after undo");
  await finish();
});

test("nothing shows beyond the canvas: overlays, marks, and the growing picture", limits, async (t) => {
  const { page, finish } = await fixture.open(t, "seamless.html");
  const plain = await fixture.settledShot(page);
  const bounded = async (what) => {
    const now = await fixture.settledShot(page);
    assert.ok((await fixture.changedFraction(plain, now)) > 0.002, `${what} does not show`);
    const { beyond } = await changedPixels(page, plain, now, kSize);
    assert.equal(beyond, 0, `${what} shows beyond the canvas`);
  };
  await page.getByTestId("tab-overlays").click();
  for (const name of ["outlines", "free", "gaps", "contact", "order"]) {
    await page.getByTestId(`overlay-${name}`).check();
    await bounded(name);
    await page.getByTestId(`overlay-${name}`).uncheck();
  }
  await page.getByTestId("highlight-note").evaluate((note) => (note.style.visibility = "hidden")); // it may lie beyond the canvas
  await page.evaluate((piece) => window.tesseraReport.view.select(piece), crossing().index);
  await bounded("the selected piece");
  await page.keyboard.press("Escape");
  await page.getByTestId("growth-slider").fill("10");
  await bounded("the growing picture");
  await finish();
});
