// The page of several results: pictures of different shapes beside and over each other, and the page on a phone.

import assert from "node:assert/strict";
import { before, test } from "node:test";
import { makeCampaign, makeResult } from "./made_pages_fixture.mjs";
import * as fixture from "./page_fixture.mjs";

const limits = { timeout: 120_000 };
fixture.useBrowser();

before(() => {
  makeResult("tall", "canvas.size_px=[100, 300]", "output.width_px=300", "output.background='#205080'", "stop.pieces=12");
  makeCampaign("shapes.html", "result", "tall");
});

/** The wide and the tall result, the wide one first. */
async function compare(page) {
  const wide_is_first = (await page.getByTestId("card-0").textContent()).includes("result");
  for (const card of wide_is_first ? [0, 1] : [1, 0]) await page.getByTestId(`card-${card}`).click();
  await page.getByTestId("compare").click();
}

/** The columns of a viewer, of 1, that have the blue of the tall picture: the first and the last one. */
async function blueColumns(page, testid) {
  const png = (await fixture.settledShot(page, testid)).toString("base64");
  return page.evaluate(async (base64) => {
    const picture = new Image();
    picture.src = `data:image/png;base64,${base64}`;
    await picture.decode();
    const context = new OffscreenCanvas(picture.width, picture.height).getContext("2d");
    context.drawImage(picture, 0, 0);
    const { data, width } = context.getImageData(0, 0, picture.width, picture.height);
    const columns = [];
    for (let at = 0; at < data.length; at += 4) {
      const blue = Math.abs(data[at] - 0x20) + Math.abs(data[at + 1] - 0x50) + Math.abs(data[at + 2] - 0x80) < 12;
      if (blue) columns.push((at / 4) % width);
    }
    return [columns.reduce((a, b) => Math.min(a, b)) / width, columns.reduce((a, b) => Math.max(a, b)) / width];
  }, png);
}

test("pictures of different shapes: both whole side by side, and neither stretched over the other", limits, async (t) => {
  const { page, finish } = await fixture.open(t, "shapes.html");
  await compare(page);
  await page.getByTestId("zoom-fit").first().click();
  const [left, right] = await blueColumns(page, "viewer-beside");
  const box = await page.getByTestId("viewer-beside").boundingBox();
  const expected = (box.height - 24) / 3 / box.width; // all of its height shows, but a margin
  assert.ok(right - left < 1.05 * expected && right - left > 0.8 * expected, `it is ${right - left} wide, not ${expected}`);

  await fixture.pressLabel(page, "mode-blink");
  await page.getByTestId("blink-pause").click();
  if (!(await page.locator(".pane-name").first().textContent()).startsWith("tall")) {
    await page.getByTestId("blink-pause").click();
    await page.waitForFunction(() => document.querySelector(".pane-name").textContent.startsWith("tall"));
    await page.getByTestId("blink-pause").click();
  }
  const [from, to] = await blueColumns(page, "viewer");
  assert.ok(to - from < 0.3, `the tall picture takes ${to - from} of the width`);
  await finish();
});

test("on a phone the bar of the choice has one line, and units stay with their numbers", limits, async (t) => {
  const { page, finish } = await fixture.open(t, "shapes.html", { viewport: { width: 390, height: 844 } });
  for (const card of [0, 1]) await page.getByTestId(`card-${card}`).click();
  const { width, height } = await page.locator(".compare-bar").boundingBox();
  assert.ok(width > 340 && height < 60, `${width} x ${height} px`);
  assert.doesNotMatch(await page.getByTestId("card-0").textContent(), / %/);
  await finish();
});

test("on a phone the summary of a result shows whole", limits, async (t) => {
  const { page, finish } = await fixture.open(t, "result.html", { viewport: { width: 390, height: 844 } });
  const fits = await page.getByTestId("summary").evaluate(({ scrollWidth, clientWidth }) => scrollWidth <= clientWidth);
  assert.ok(fits);
  assert.ok((await page.getByTestId("theme").boundingBox()).width < 80);
  await finish();
});
