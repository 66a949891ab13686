// Tests where the pointer, taps and the wheel act, and where they must not.

import assert from "node:assert/strict";
import { before, test } from "node:test";
import { alterPage } from "./made_pages_fixture.mjs";
import * as editing from "./editing_fixture.mjs";
import * as fixture from "./page_fixture.mjs";

const limits = { timeout: 120_000 };
const pieces = fixture.piecesOf("result");
const roomiest = [...pieces].sort((a, b) => b.inside?.distance - a.inside?.distance)[0];
fixture.useBrowser();

before(() =>
  alterPage("result.html", "long_names.html", (data) => (data.shapes.name = data.shapes.name.map((name) => `a drawing of a ${name}`))),
);

test("no tab lets the page scroll away", limits, async (t) => {
  const { page, finish } = await fixture.open(t, "result.html", { viewport: { width: 1280, height: 360 } });
  for (const tab of ["piece", "search", "overlays", "edit", "quality", "job"]) {
    await page.getByTestId(`tab-${tab}`).click();
    await page.locator(`#panel-${tab}`).hover();
    await page.mouse.wheel(0, 20_000);
    await page.waitForTimeout(150);
    const { height, top } = await page.evaluate(() => ({ height: document.documentElement.scrollHeight, top: scrollY }));
    assert.deepEqual([height, top], [360, 0], `tab ${tab}`);
  }
  await finish();
});

test("the name beside the pointer is as wide as it needs, wherever the piece is", limits, async (t) => {
  const { page, finish } = await fixture.open(t, "long_names.html");
  const label = page.getByTestId("hover-label");
  const heights = [];
  for (const { inside } of pieces.filter((piece) => piece.inside)) {
    await page.mouse.move(...(await fixture.onPage(page, inside)));
    heights.push((await label.boundingBox()).height);
  }
  assert.ok(Math.max(...heights) < 30, `a label is ${Math.max(...heights)} px high`);
  await finish();
});

test("a double click zooms in with the tool Pan, and marks twice with the tool Click", limits, async (t) => {
  const { page, finish } = await fixture.open(t);
  const start = await fixture.transform(page);
  await page.mouse.dblclick(...(await fixture.onPage(page, roomiest.inside)));
  assert.ok(Math.abs((await fixture.transform(page)).k / start.k - 2) < 0.01);
  assert.equal(await fixture.selected(page), roomiest.index);
  await page.getByTestId("zoom-fit").click();
  await editing.useTool(page, "click");
  await page.mouse.dblclick(...(await fixture.onPage(page, roomiest.inside)));
  assert.deepEqual(await fixture.transform(page), start);
  assert.equal(await page.getByTestId("marks-status").textContent(), "Nothing is marked.");
  await finish();
});

test("two quick taps on a phone both count", limits, async (t) => {
  const { page, finish } = await fixture.open(t, "result.html", { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  const start = await fixture.transform(page);
  await editing.useTool(page, "click");
  const place = await fixture.onPage(page, roomiest.inside);
  await page.touchscreen.tap(...place);
  assert.equal(await editing.command(page), `tessera refine result --pieces ${roomiest.index}`);
  await page.touchscreen.tap(place[0] + 2, place[1]);
  assert.equal(await page.getByTestId("marks-status").textContent(), "Nothing is marked.");
  assert.deepEqual(await fixture.transform(page), start);
  await finish();
});

test("zooming to a piece never shows less than the whole picture fills", limits, async (t) => {
  const { page, finish } = await fixture.open(t);
  const start = await fixture.transform(page);
  for (const { index } of pieces) {
    await page.evaluate((piece) => window.tesseraReport.view.select(piece), index);
    await page.getByTestId("piece-zoom").click();
    assert.ok((await fixture.transform(page)).k >= start.k * 0.999, `piece ${index}: zoomed out`);
  }
  await finish();
});

test("notes over the picture let clicks through", limits, async (t) => {
  const { page, finish } = await fixture.open(t);
  const [name] = fixture.mostUsed("result");
  await page.evaluate((piece) => window.tesseraReport.view.select(piece), pieces.find(({ shape }) => shape === name).index);
  const { x, y, height } = await page.getByTestId("highlight-note").boundingBox();
  const hit = await page.evaluate(([px, py]) => document.elementFromPoint(px, py).dataset.testid, [x + 8, y + height / 2]);
  assert.equal(hit, "viewer");
  await page.getByRole("button", { name: "Show no marks" }).click();
  assert.equal(await fixture.selected(page), null);
  await finish();
});
