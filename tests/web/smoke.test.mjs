// The page of a result and of a campaign work from the disk, and nothing that the data contain runs.

import assert from "node:assert/strict";
import { test } from "node:test";
import * as fixture from "./page_fixture.mjs";

fixture.useBrowser();

test("a result: pointing, selecting, no complaints, no requests, accessible", { timeout: 60_000 }, async (t) => {
  const { page, finish, ready_ms } = await fixture.open(t);
  assert.ok(ready_ms < fixture.kReady_ms, `ready after ${ready_ms} ms`);
  const pieces = fixture.piecesOf("result");
  assert.match(await page.getByTestId("summary").textContent(), new RegExp(`^${pieces.length} pieces · 300 × 200 px`));

  const largest = pieces.reduce((best, piece) => (piece.inside.distance > best.inside.distance ? piece : best));
  const [x, y] = await fixture.onPage(page, largest.inside);
  await page.mouse.move(x, y);
  assert.equal(await page.getByTestId("hover-label").textContent(), largest.shape);
  await page.mouse.click(x, y);
  assert.equal(await fixture.selected(page), largest.index);
  assert.equal(await page.getByTestId("piece-name").textContent(), largest.shape);
  assert.equal(await page.getByTestId("tab-piece").getAttribute("aria-selected"), "true");

  const policy = await page.locator("meta[http-equiv=Content-Security-Policy]").getAttribute("content");
  assert.match(policy, /default-src 'none'; script-src 'sha256-[A-Za-z0-9+/]+=*'; style-src 'sha256-/);
  assert.doesNotMatch(policy, /unsafe|\*|https?:/);
  await fixture.expectAccessible(page, "the page of a result");
  await finish();
});

test("a campaign: all pictures, no complaints, no requests, accessible", { timeout: 60_000 }, async (t) => {
  const { page, finish } = await fixture.open(t, "both.html");
  assert.equal(await page.getByTestId("contact-sheet").locator("canvas").count(), 2);
  await fixture.expectAccessible(page, "the page of a campaign");
  await finish();
});

test("hostile names are only text", { timeout: 60_000 }, async (t) => {
  const { page, finish } = await fixture.open(t, "hostile.html");
  const scripts = await page.locator("script:not([type])").count();
  assert.equal(scripts, 1, "scripts on the page");
  assert.equal(await page.title(), await page.locator("h1").textContent());
  assert.match(await page.title(), /^it's <img src=x onerror=window\.__hacked=5> & \$\(touch hacked\)/);

  // All names pass through all places that show names: the panel of each piece, its label, the search, the job.
  const pieces = fixture.piecesOf("it's <img src=x onerror=window.__hacked=5> & $(touch hacked)");
  assert.equal(new Set(pieces.map(({ shape }) => shape)).size, 5, "drawings used");
  for (const piece of pieces) {
    await page.evaluate((index) => window.tesseraReport.view.select(index), piece.index);
    const shown = piece.shape.replace(/[\u202a-\u202e\u2066-\u2069]/g, "\ufffd");
    assert.equal(await page.getByTestId("piece-name").textContent(), shown);
  }
  const widest = pieces.reduce((best, piece) => (piece.inside.distance > best.inside.distance ? piece : best));
  await page.mouse.move(...(await fixture.onPage(page, widest.inside)));
  for (const tab of ["search", "overlays", "edit", "quality", "job"]) await page.getByTestId(`tab-${tab}`).click();
  await page.getByTestId("tab-search").click();
  assert.equal(await page.getByTestId("search-results").locator("button").count(), 5);

  await page.getByTestId("tab-edit").click();
  await page.keyboard.press("e");
  const command = await page.getByTestId("command").textContent();
  assert.ok(command.startsWith("tessera refine 'it'\\''s <img src=x onerror=window.__hacked=5> & $(touch hacked)' --pieces "), command);

  assert.equal(await page.evaluate(() => document.querySelectorAll("#page img, #page script, #page b, #page iframe").length), 0);
  assert.equal(await page.evaluate(() => window.__hacked), undefined);
  await fixture.expectAccessible(page, "the page with hostile names");
  await finish();
  fixture.expectNotHacked();
});

test("hostile names in a campaign are only text", { timeout: 60_000 }, async (t) => {
  const { page, finish } = await fixture.open(t, "hostile_both.html");
  await page.getByTestId("choose-0").check();
  await page.getByTestId("choose-1").check();
  assert.match(await page.getByTestId("chosen").textContent(), /<img src=x onerror=window\.__hacked=5>/);
  await page.getByTestId("compare").click();
  for (const mode of ["difference", "blink", "side"]) await fixture.pressLabel(page, `mode-${mode}`);
  assert.equal(await page.evaluate(() => document.querySelectorAll("#page img, #page script").length), 0);
  assert.equal(await page.evaluate(() => window.__hacked), undefined);
  await finish();
});
