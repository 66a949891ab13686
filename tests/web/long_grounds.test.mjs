// Tests that the same ground lies below and between the pieces while the collage grows, while it fades, and when it is whole.

import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { before, test } from "node:test";
import { alterPage, makeResult } from "./made_pages_fixture.mjs";
import * as fixture from "./page_fixture.mjs";
import { coloursAt } from "./pixels_fixture.mjs";

const limits = { timeout: 120_000 };
const kWhite = [255, 255, 255];
const kCorner = { x: 5, y: 5 };
fixture.useBrowser();

before(() => {
  writeFileSync("oval.svg", "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 300 200'><ellipse cx='150' cy='100' rx='140' ry='90'/></svg>");
  makeResult("oval", "canvas.file='oval.svg'", "output.background='#205080'");
  makeResult("clear", "output.background='none'");
  alterPage("result.html", "no_picture.html", (data) => (data.picture = null));
});

const near = (one, other) => one.every((value, channel) => Math.abs(value - other[channel]) <= 12);

/** Points well inside the largest pieces. */
function inLargest(result) {
  const pieces = fixture.piecesOf(result).filter(({ inside }) => inside);
  return pieces.sort((a, b) => b.inside.distance - a.inside.distance).slice(0, 5).map(({ inside }) => inside);
}

async function showFirst(page, pieces) {
  await page.getByTestId("growth-slider").fill(String(pieces));
}

for (const colorScheme of ["light", "dark"]) {
  test(`a canvas of any shape, ${colorScheme}: bare where pieces do not show, and the same beyond`, limits, async (t) => {
    const { page, finish } = await fixture.open(t, "oval.html", { colorScheme });
    const points = inLargest("oval");
    const [whole] = await coloursAt(page, [kCorner]);
    await showFirst(page, 0);
    const [corner, ...bare] = await coloursAt(page, [kCorner, ...points]);
    assert.ok(near(corner, whole), `beyond the canvas ${corner} instead of ${whole}`);
    for (const colour of bare) assert.ok(near(colour, [0x20, 0x50, 0x80]), `the bare canvas is ${colour}`);
    await finish();
  });

  test(`a transparent picture, ${colorScheme}: on white paper, also while it grows and below overlays`, limits, async (t) => {
    const { page, finish } = await fixture.open(t, "clear.html", { colorScheme });
    const points = inLargest("clear");
    const gap = await page.evaluate(() => {
      const { x_px, y_px } = JSON.parse(document.getElementById("data").textContent).gaps;
      return { x: x_px[0], y: y_px[0] };
    });
    const [ground] = await coloursAt(page, [gap]);
    assert.deepEqual(ground, kWhite, "the paper between the pieces");
    await showFirst(page, 0);
    for (const colour of await coloursAt(page, points)) assert.ok(near(colour, kWhite), `the bare canvas is ${colour}`);
    await showFirst(page, 40);
    const pieces = await coloursAt(page, points);
    assert.ok(pieces.every((colour) => !near(colour, kWhite)), "pieces are white");
    await page.getByTestId("tab-overlays").click();
    await page.getByTestId("picture-strength").fill("0");
    for (const colour of await coloursAt(page, points)) assert.ok(near(colour, kWhite), `faded to ${colour}`);
    await finish();
  });
}

test("a piece that shows looks the same while the collage grows", limits, async (t) => {
  const { page, finish } = await fixture.open(t);
  const points = inLargest("result");
  const whole = await coloursAt(page, points);
  await showFirst(page, 39);
  const grown = await coloursAt(page, points);
  assert.ok(grown.every((colour, index) => near(colour, whole[index])));
  await finish();
});

test("overlays and the lasso know only pieces that show", limits, async (t) => {
  const { page, finish } = await fixture.open(t);
  await page.getByTestId("tab-overlays").click();
  await showFirst(page, 0);
  const bare = await fixture.settledShot(page);
  for (const name of ["outlines", "contact", "order"]) await page.getByTestId(`overlay-${name}`).check();
  await page.getByTestId("picture-strength").fill("100");
  assert.ok((await fixture.changedFraction(bare, await fixture.settledShot(page))) < 1e-4, "overlays show pieces that are not there yet");
  await showFirst(page, 40);
  assert.ok((await fixture.changedFraction(bare, await fixture.settledShot(page))) > 0.1, "overlays stay empty");

  await showFirst(page, 3);
  await page.getByTestId("tab-edit").click();
  await fixture.pressLabel(page, "tool-lasso");
  const corners = [[-3, -3], [303, -3], [303, 203], [-3, 203], [-3, 0]];
  const places = await Promise.all(corners.map(([x, y]) => fixture.onPage(page, { x, y })));
  await page.mouse.move(...places[0]);
  await page.mouse.down();
  for (const place of places) await page.mouse.move(...place);
  await page.mouse.up();
  assert.equal(await page.getByTestId("command").textContent(), "tessera refine result --pieces 0,1,2");
  await finish();
});

test("a page without a picture says so", limits, async (t) => {
  const { page, finish } = await fixture.open(t, "no_picture.html");
  assert.match(await page.getByTestId("no-picture").textContent(), /no picture \(collage\.png\).* tessera draw result/);
  await finish();
  const whole = await fixture.open(t);
  assert.equal(await whole.page.getByTestId("no-picture").count(), 0);
  await whole.finish();
});
