// The page of `tessera serve`: from a scribble to a new result; and other pages of the same browser, which must not reach the server.

import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import { once } from "node:events";
import { existsSync, readFileSync, rmSync } from "node:fs";
import { createServer } from "node:http";
import { test } from "node:test";
import * as editing from "./editing_fixture.mjs";
import * as fixture from "./page_fixture.mjs";

const limits = { timeout: 180_000 };
fixture.useBrowser();

/** A server for a fresh copy of a result, and its address. */
async function serve(t, folder) {
  for (const end of ["", "-2", "-3", "-4"]) rmSync(`${folder}${end}`, { recursive: true, force: true });
  spawnSync("cp", ["-r", "result", folder]);
  const server = spawn(process.env.TESSERA, ["serve", folder], { stdio: ["ignore", "pipe", "inherit"] });
  t.after(() => server.kill("SIGKILL"));
  // Its output is a pipe, which others might read: so the address stands in a file.
  let text = "";
  for await (const part of server.stdout) {
    text += part;
    if (text.includes("Ctrl-C")) break;
  }
  assert.doesNotMatch(text, /127\.0\.0\.1:\d+\/[0-9a-f]/);
  const address = readFileSync(`${folder}/serve_address.txt`, "utf8").trim();
  const end = async () => {
    server.kill("SIGINT");
    const [code] = server.exitCode === null ? await once(server, "exit") : [server.exitCode];
    assert.equal(code, 0);
  };
  return { address, end };
}

const shownName = (page) => page.getByRole("heading", { level: 1 }).textContent();
const waitForName = (page, name) => page.waitForFunction((wanted) => document.querySelector("h1").textContent === wanted, name, { timeout: 60_000 });

test("scribble, refill, compare; the results stay", limits, async (t) => {
  const { address, end } = await serve(t, "served");
  const { page, faults } = await fixture.open(t, address);
  const pieces = fixture.piecesOf("served");
  const [largest] = [...pieces].sort((a, b) => b.inside?.distance - a.inside?.distance);
  await editing.useTool(page, "scribble");
  await page.getByTestId("brush-size").fill("4");
  const { x, y } = largest.inside;
  await editing.drag(page, [{ x, y }, { x: x + 0.5, y }]);
  const before_it = await fixture.settledShot(page);
  await page.getByTestId("refill").click();
  await waitForName(page, "served-2");
  assert.equal(await page.getByTestId("refill").isDisabled(), true, "nothing is marked on the new result");

  // The preview has no picture of its own yet, or has it already; in the end it has.
  await page.waitForFunction(() => document.querySelector("[data-testid=refill-message]").textContent === "", null, { timeout: 60_000 });
  await page.waitForTimeout(500);
  assert.ok((await fixture.changedFraction(before_it, await fixture.settledShot(page))) > 0.001, "the picture is the old one");
  assert.deepEqual(JSON.parse(readFileSync("served-2/marks.json", "utf8")).pieces, [largest.index]);
  assert.ok(existsSync("served-2/collage.png"));

  await page.getByTestId("tab-variants").click();
  const list = page.getByTestId("variants").getByRole("listitem");
  assert.deepEqual(await list.locator("strong").allTextContents(), ["served", "served-2"]);
  assert.match(await list.nth(1).textContent(), /shown.*from served$/);
  await fixture.expectAccessible(page, "the variants");
  await list.nth(0).getByRole("button", { name: "Side by side" }).click();
  await page.getByTestId("viewer-beside").waitFor();
  const place = await fixture.transform(page);
  const box = await page.getByTestId("viewer").boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.wheel(0, -300);
  await page.waitForFunction((k) => window.tesseraReport.view.transform().k > k * 1.2, place.k);
  await page.getByTestId("compare-close").click();
  assert.equal(await shownName(page), "served-2");

  // A new filling of the new result, by the keyboard, with a seed.
  await page.evaluate(() => window.tesseraReport.view.select(0));
  await page.getByTestId("tab-edit").click();
  await page.getByTestId("viewer").focus();
  await page.keyboard.press("e");
  await page.getByTestId("seed").fill("7");
  await page.getByTestId("refill").press("Enter");
  await waitForName(page, "served-3");
  assert.match(readFileSync("served-3/job.toml", "utf8"), /^seed = 7$/m);
  await page.reload();
  await page.evaluate(() => window.tesseraReport.ready);
  assert.equal(await shownName(page), "served");
  await page.getByTestId("tab-variants").click();
  await list.nth(2).waitFor();
  await end();
  assert.deepEqual(faults, []);
  for (const folder of ["served", "served-2", "served-3"]) assert.ok(existsSync(`${folder}/manifest.json`), folder);

  // The server is gone: the page says so, and still shows what it has.
  await page.getByTestId("tab-edit").click();
  await page.getByTestId("relax").click();
  await page.getByRole("alert").filter({ hasText: /./ }).waitFor();
});

for (const look of [
  { colorScheme: "dark", viewport: { width: 1280, height: 800 } },
  { colorScheme: "light", viewport: { width: 390, height: 780 }, hasTouch: true, deviceScaleFactor: 2 },
]) {
  test(`the tabs of a served page are accessible, ${look.colorScheme}, ${look.viewport.width} px wide`, limits, async (t) => {
    const { address, end } = await serve(t, `served_${look.colorScheme}`);
    const { page, faults } = await fixture.open(t, address, look);
    for (const tab of ["edit", "variants"]) {
      await page.getByTestId(`tab-${tab}`).click();
      await fixture.expectAccessible(page, tab);
      const [content, window_width] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
      assert.ok(content <= window_width, `${tab} is wider than the window`);
    }
    assert.deepEqual(faults, []);
    await end();
  });
}

test("another site in the same browser reaches nothing, even with the address", limits, async (t) => {
  const { address, end } = await serve(t, "served_attacked");
  const other = createServer((_request, answer) => answer.setHeader("Content-Type", "text/html").end("<title>other</title>"));
  await once(other.listen(0, "127.0.0.1"), "listening");
  t.after(() => other.close());
  const page = await fixture.newPage();
  await page.goto(`http://127.0.0.1:${other.address().port}/`);
  const read = await page.evaluate(async (to) => {
    const failed = async (...request) => fetch(...request).then(async (answer) => `read: ${await answer.text()}`, () => "failed");
    const body = JSON.stringify({ result: "served_attacked", action: "erase", pieces: [0], lock: [], seed: null });
    const answers = [
      await failed(`${to}state`),
      await failed(`${to}refine`, { method: "POST", headers: { "X-Tessera": "1", "Content-Type": "application/json" }, body }),
    ];
    await fetch(`${to}refine`, { method: "POST", mode: "no-cors", headers: { "Content-Type": "text/plain" }, body }).catch(() => {});
    return answers;
  }, address);
  assert.deepEqual(read, ["failed", "failed"]);
  await page.goto(address); // typed by the user
  await page.evaluate(() => window.tesseraReport.ready);
  const { results } = await page.evaluate(async () => (await fetch("state")).json());
  assert.deepEqual(results.map(({ name }) => name), ["served_attacked"], "another site has refined");
  await page.close();
  await end();
});
