// All that the page of a result does, used as people use it.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { test } from "node:test";
import * as editing from "./editing_fixture.mjs";
import * as fixture from "./page_fixture.mjs";

const limits = { timeout: 120_000 };
const pieces = fixture.piecesOf("result");
const by_room = [...pieces].sort((a, b) => b.inside?.distance - a.inside?.distance);
fixture.useBrowser();

test("zoom by wheel, keys and buttons; pan by pointer and keys", limits, async (t) => {
  const { page, finish } = await fixture.open(t);
  const start = await fixture.transform(page);
  const [x, y] = await fixture.onPage(page, { x: 100, y: 60 });
  await page.mouse.move(x, y);
  await page.mouse.wheel(0, -300);
  await page.waitForFunction((k) => window.tesseraReport.view.transform().k > k * 1.2, start.k);
  const [x_after, y_after] = await fixture.onPage(page, { x: 100, y: 60 });
  assert.ok(Math.hypot(x_after - x, y_after - y) < 1, "the point below the pointer moved");

  const zoomed = async (press, expect) => {
    const { k } = await fixture.transform(page);
    await press();
    const ratio = (await fixture.transform(page)).k / k;
    assert.ok(Math.abs(ratio - expect) < 0.01, `zoomed by ${ratio}, not ${expect}`);
  };
  await zoomed(() => page.getByTestId("zoom-in").click(), 1.6);
  await zoomed(() => page.getByTestId("zoom-out").click(), 1 / 1.6);
  await page.getByTestId("viewer").focus();
  await zoomed(() => page.keyboard.press("+"), 1.5);
  await zoomed(() => page.keyboard.press("-"), 1 / 1.5);

  await page.getByTestId("zoom-fit").click();
  assert.deepEqual(await fixture.transform(page), start);
  await page.evaluate(() => window.tesseraReport.view.centre(150, 100, 8));
  const before = await fixture.transform(page);
  await editing.drag(page, [{ x: 150, y: 100 }, { x: 140, y: 95 }]);
  const dragged = await fixture.transform(page);
  assert.ok(Math.abs(dragged.x - before.x + 80) < 1 && Math.abs(dragged.y - before.y + 40) < 1, "dragged elsewhere");
  assert.equal(await fixture.selected(page), null, "a drag is no click");
  await page.getByTestId("viewer").focus();
  await page.keyboard.press("ArrowLeft");
  assert.ok(Math.abs((await fixture.transform(page)).x - dragged.x - 60) < 1);
  await page.keyboard.press("0");
  assert.deepEqual(await fixture.transform(page), start);
  await finish();
});

test("hover, select, next, previous and zoom to a piece", limits, async (t) => {
  const { page, finish } = await fixture.open(t);
  for (const piece of by_room.slice(0, 5)) {
    const [x, y] = await fixture.onPage(page, piece.inside);
    await page.mouse.move(x, y);
    assert.equal(await page.getByTestId("hover-label").textContent(), piece.shape);
    await page.mouse.click(x, y);
    assert.equal(await fixture.selected(page), piece.index);
    const uses = pieces.filter(({ shape }) => shape === piece.shape).length;
    assert.equal(await page.getByTestId("piece-uses").textContent(), String(uses));
  }
  const last = pieces.length - 1;
  await page.evaluate((piece) => window.tesseraReport.view.select(piece), last);
  await page.getByTestId("piece-next").click();
  assert.equal(await fixture.selected(page), 0);
  await page.getByTestId("piece-previous").click();
  assert.equal(await fixture.selected(page), last);
  await page.getByTestId("viewer").focus();
  await page.keyboard.press("p");
  assert.equal(await fixture.selected(page), last - 1);
  await page.keyboard.press("Enter");
  const [x, y] = await fixture.onPage(page, { x: pieces[last - 1].x_px, y: pieces[last - 1].y_px });
  const box = await page.getByTestId("viewer").boundingBox();
  assert.ok(Math.hypot(x - box.x - box.width / 2, y - box.y - box.height / 2) < box.width / 5, "the piece is not in the middle");
  await page.keyboard.press("Escape");
  assert.equal(await fixture.selected(page), null);
  await finish();
});

test("search", limits, async (t) => {
  const { page, finish } = await fixture.open(t);
  await page.getByTestId("tab-search").click();
  const [name, uses] = fixture.mostUsed("result");
  await page.getByTestId("search-input").fill(name.slice(0, 3).toUpperCase());
  assert.match(await page.getByTestId("search-summary").textContent(), new RegExp(`^1 drawing, ${uses} pieces found`));
  const before = await fixture.settledShot(page);
  await page.keyboard.press("Enter");
  assert.match(await page.getByTestId("highlight-note").textContent(), new RegExp(`^${name} · ${uses} ×`));
  assert.ok((await fixture.changedFraction(before, await fixture.settledShot(page))) > 0.002, "nothing is marked");
  await page.getByTestId("tab-search").click();
  await page.getByTestId("search-input").fill("no such name");
  assert.equal(await page.getByTestId("search-summary").textContent(), "Nothing has this name.");
  await finish();
});

test("each overlay changes the picture and goes again; the picture fades", limits, async (t) => {
  const { page, finish } = await fixture.open(t);
  await page.getByTestId("tab-overlays").click();
  const plain = await fixture.settledShot(page);
  const strength = page.getByTestId("picture-strength");
  for (const name of ["outlines", "overlaps", "free", "gaps", "contact", "order"]) {
    const box = page.getByTestId(`overlay-${name}`);
    await box.check();
    const on = await fixture.settledShot(page);
    // The picture fades beneath all but the outlines; an overlay alone must show, too.
    assert.ok((await fixture.changedFraction(plain, on)) > 0.005, `${name} does not show`);
    await box.uncheck();
    assert.ok((await fixture.changedFraction(plain, await fixture.settledShot(page))) < 0.001, `${name} stays`);
  }
  await strength.fill("0");
  const blank = await fixture.settledShot(page);
  assert.ok((await fixture.changedFraction(plain, blank)) > 0.3, "the picture does not fade");
  for (const name of ["outlines", "free", "gaps", "contact", "order"]) {
    const box = page.getByTestId(`overlay-${name}`);
    await box.check();
    assert.ok((await fixture.changedFraction(blank, await fixture.settledShot(page))) > 0.002, `${name} is not drawn`);
    await box.uncheck();
  }
  await finish();
});

test("a dragged picture shows what it shows when it is drawn anew", limits, async (t) => {
  const { page, finish } = await fixture.open(t);
  await page.getByTestId("tab-overlays").click();
  for (const name of ["outlines", "contact"]) await page.getByTestId(`overlay-${name}`).check();
  for (const [x, y] of [[40, 25], [-70, 30], [30, -60]]) {
    await page.evaluate(() => window.tesseraReport.view.centre(150, 100, 7));
    await editing.drag(page, [{ x: 150, y: 100 }, { x: 150 + x / 2, y: 100 }, { x: 150 + x, y: 100 + y }]);
    const dragged = await fixture.settledShot(page);
    await page.getByTestId("picture-strength").dispatchEvent("input");
    const difference = await fixture.changedFraction(dragged, await fixture.settledShot(page));
    assert.ok(difference < 1e-4, `dragged by (${x}, ${y}): ${difference} of the picture differs`);
  }
  await finish();
});

test("growth: the slider shows the first pieces, playing adds the others", limits, async (t) => {
  const { page, finish } = await fixture.open(t);
  const whole = await fixture.settledShot(page);
  const text = page.getByTestId("growth-text");
  assert.equal(await text.textContent(), `${pieces.length} / ${pieces.length}`);
  await page.getByTestId("growth-slider").fill("3");
  assert.equal(await text.textContent(), `3 / ${pieces.length}`);
  assert.ok((await fixture.changedFraction(whole, await fixture.settledShot(page))) > 0.1, "all pieces still show");
  const later = by_room.find(({ index }) => index >= 3);
  await page.mouse.move(...(await fixture.onPage(page, later.inside)));
  assert.equal(await page.getByTestId("hover-label").isVisible(), false, "the name of a piece that is not there yet");
  await page.getByTestId("growth-speed").selectOption("4");
  await page.getByTestId("growth-play").click();
  assert.equal(await page.getByTestId("growth-play").getAttribute("aria-label"), "Pause the growth");
  await page.waitForFunction((all) => document.querySelector("[data-testid=growth-slider]").value === all, String(pieces.length));
  await page.waitForFunction(() => /^Play/.test(document.querySelector("[data-testid=growth-play]").ariaLabel));
  await page.mouse.move(5, 5);
  assert.ok((await fixture.changedFraction(whole, await fixture.settledShot(page))) < 0.001, "another picture at the end");
  await finish();
});

test("scribble and lasso mark pieces; command, undo and files", limits, async (t) => {
  const { page, finish } = await fixture.open(t);
  await page.getByTestId("tab-edit").click();
  assert.equal(await editing.command(page), "# mark pieces to erase first");

  // Locks alone are no command.
  const [locked, scribbled] = by_room;
  await editing.useTool(page, "click", "lock");
  await page.mouse.click(...(await fixture.onPage(page, locked.inside)));
  assert.equal(await editing.command(page), "# mark pieces to erase first");
  assert.equal(await page.getByTestId("save-marks").isDisabled(), true);

  await editing.useTool(page, "scribble");
  await page.getByTestId("brush-size").fill("4");
  const { x, y } = scribbled.inside;
  await editing.drag(page, [{ x, y }, { x: x + 0.5, y }]);
  const one = `tessera refine result --pieces ${scribbled.index} --lock ${locked.index}`;
  assert.equal(await editing.command(page), one);
  assert.equal(await page.getByTestId("marks-status").textContent(), "1 piece to erase, 1 locked.");

  await editing.useTool(page, "lasso");
  const { way, inside } = editing.lassoFromLeft(pieces, 6);
  await editing.drag(page, way);
  const erased = [...new Set([...inside, scribbled.index])].sort((a, b) => a - b);
  const lock = inside.includes(locked.index) ? [] : [locked.index];
  const rest = lock.length > 0 ? ` --lock ${lock}` : "";
  assert.equal(await editing.command(page), `tessera refine result --pieces ${erased}${rest}`);
  await page.getByTestId("edit-swap").check();
  assert.equal(await editing.command(page), `tessera refine result --swap ${erased}${rest}`);
  const swap = JSON.parse((await editing.save(page, "save-marks")).text());
  const pieces_digest = JSON.parse(readFileSync("result/manifest.json", "utf8")).pieces.digest;
  assert.deepEqual(swap, { format: 1, pieces_digest, action: "swap", pieces: erased, lock });
  await page.getByTestId("edit-swap").uncheck();

  await page.getByTestId("marks-undo").click();
  assert.equal(await editing.command(page), one, "undo takes the lasso back, and only it");
  await page.getByTestId("marks-clear").click();
  assert.equal(await page.getByTestId("marks-status").textContent(), "Nothing is marked.");
  await page.getByTestId("marks-undo").click();
  assert.equal(await editing.command(page), one);
  await finish();
});

test("what the page gives out is what the program takes", limits, async (t) => {
  const { page, finish } = await fixture.open(t);
  await editing.useTool(page, "click");
  const chosen = by_room.slice(0, 2);
  for (const { inside } of chosen) await page.mouse.click(...(await fixture.onPage(page, inside)));
  const expected = chosen.map(({ index }) => index).sort((a, b) => a - b);
  const shown = await editing.command(page);
  assert.equal(shown, `tessera refine result --pieces ${expected}`);
  assert.equal((await editing.save(page, "save-marks")).name, "marks.json");
  assert.equal((await editing.save(page, "save-mask")).name, "mask.png");

  const kept = (folder) => new Set(fixture.piecesOf(folder).map(({ canvas_from_shape, shape }) => `${shape} ${canvas_from_shape}`));
  const went = (folder) => {
    const after_it = kept(folder);
    return pieces.filter((piece) => !after_it.has(`${piece.shape} ${piece.canvas_from_shape}`)).map(({ index }) => index);
  };
  const ways = { by_command: shown.split(" ").slice(3), by_marks: ["--marks", "marks.json"], by_mask: ["--erase", "mask.png"] };
  for (const [out, words] of Object.entries(ways)) {
    const done = spawnSync(process.env.TESSERA, ["refine", "result", ...words, "--out", out], { encoding: "utf8", timeout: 60_000 });
    assert.equal(done.status, 0, done.stderr);
    assert.ok(existsSync(`${out}/collage.png`));
    assert.match(done.stdout, new RegExp(`^${expected.length} of ${pieces.length} pieces go`), out);
    assert.ok(went(out).every((piece) => expected.includes(piece)), `${out}: ${went(out)} went, not ${expected}`);
  }
  assert.deepEqual(readFileSync("by_marks/pieces.geojson"), readFileSync("by_command/pieces.geojson"));
  await finish();
});
