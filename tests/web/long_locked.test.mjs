// Pieces that stood from the start: the program refuses to erase them, and so does the page.

import assert from "node:assert/strict";
import { before, test } from "node:test";
import * as editing from "./editing_fixture.mjs";
import { alterPage } from "./made_pages_fixture.mjs";
import * as fixture from "./page_fixture.mjs";

const limits = { timeout: 120_000 };
const pieces = fixture.piecesOf("result");
const [locked, free] = [...pieces].sort((a, b) => b.inside?.distance - a.inside?.distance);
fixture.useBrowser();

before(() => {
  alterPage("result.html", "some_locked.html", (data) => (data.pieces.locked[locked.index] = 1));
  alterPage("result.html", "all_locked.html", (data) => data.pieces.locked.fill(1));
});

test("a locked piece cannot be marked to be erased", limits, async (t) => {
  const { page, finish } = await fixture.open(t, "some_locked.html");
  const status = page.getByTestId("marks-status");
  await editing.useTool(page, "click");
  assert.match(await page.getByTestId("fixed-note").textContent(), /^1 of \d+ pieces is locked/);
  await page.mouse.click(...(await fixture.onPage(page, locked.inside)));
  assert.match(await status.textContent(), /^Nothing is marked\. .*cannot be erased/);
  await page.mouse.click(...(await fixture.onPage(page, free.inside)));
  assert.equal(await status.textContent(), "1 piece to erase, 0 locked.");
  assert.equal(await editing.command(page), `tessera refine result --pieces ${free.index}`);

  await editing.useTool(page, "scribble");
  await page.getByTestId("brush-size").fill("4");
  const { x, y } = locked.inside;
  await editing.drag(page, [{ x, y }, { x: x + 0.5, y }]);
  assert.match(await status.textContent(), /^1 piece to erase, 0 locked\. .*cannot be erased/);
  await page.getByTestId("marks-undo").click();
  assert.equal(await status.textContent(), "Nothing is marked.");
  await page.evaluate((piece) => window.tesseraReport.view.select(piece), locked.index);
  await page.getByTestId("tab-piece").click();
  assert.equal(await page.getByTestId("piece-erase").isDisabled(), true);
  await finish();
});

test("the tab Edit says where all pieces are locked", limits, async (t) => {
  const { page, finish } = await fixture.open(t, "all_locked.html");
  await page.getByTestId("tab-edit").click();
  assert.match(await page.getByTestId("fixed-note").textContent(), /^All pieces are locked/);
  await finish();
});

test("Undo and Clear stay where they are while marks are made", limits, async (t) => {
  const { page, finish } = await fixture.open(t);
  await editing.useTool(page, "click");
  const place = () => page.getByTestId("marks-undo").boundingBox();
  const before_it = await place();
  for (const { inside } of [locked, free]) await page.mouse.click(...(await fixture.onPage(page, inside)));
  assert.deepEqual(await place(), before_it);
  await finish();
});
