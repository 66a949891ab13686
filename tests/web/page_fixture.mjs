// The tests of pages share this: the browser, places of pieces, and comparisons of pictures.

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { resolve } from "node:path";
import { after, before } from "node:test";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const axe_path = createRequire(import.meta.url).resolve("axe-core/axe.min.js");

/** A page of this file is ready within this time. How fast pages are on larger results is measured elsewhere. */
export const kReady_ms = 10_000;

/** Chromium that resolves no name: whatever a page asks for outside itself fails, and is noted. */
export function startBrowser() {
  const args = [
    "--no-sandbox",
    "--disable-gpu",
    "--force-color-profile=srgb",
    "--disable-background-networking",
    "--disable-component-update",
    "--no-first-run",
    "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
  ];
  return chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args });
}

let browser;

/** Gives the tests of a file one browser for all. */
export function useBrowser() {
  before(async () => {
    browser = await startBrowser();
  });
  after(() => browser?.close());
}

/** An empty page of the browser, without any checks. */
export const newPage = () => browser.newPage();

/** Opens a page from the disk or of a server until the test `t` ends. `options` are those of a browser's context. The test calls `finish`
 *  at its end: the page must have caused no complaints and no foreign requests (`faults`), and must not have jumped. */
export async function open(t, file = "result.html", options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, reducedMotion: "reduce", ...options });
  t.after(() => context.close());
  const page = await context.newPage();
  page.setDefaultTimeout(kReady_ms);
  const address = file.startsWith("http:") ? file : pathToFileURL(resolve(file)).href;
  const faults = noteFaults(page, address);
  await noteShifts(page);
  const begin_ms = Date.now();
  await page.goto(address);
  await page.waitForFunction(() => window.tesseraReport);
  await page.evaluate(() => window.tesseraReport.ready);
  const ready_ms = Date.now() - begin_ms;
  assert.equal(await page.getByTestId("failure").count(), 0, "the page says that it cannot be shown");
  const finish = async () => {
    assert.deepEqual(faults, []);
    const shift = await page.evaluate(() => window.layout_shift);
    assert.ok(shift < 0.05, `the layout shifted by ${shift}`);
  };
  return { page, faults, ready_ms, finish };
}

/** A list to which the page's complaints and its requests to other addresses are added. */
function noteFaults(page, address) {
  const faults = [];
  page.on("console", (message) => /^(error|warning)$/.test(message.type()) && faults.push(`console: ${message.text()}`));
  page.on("pageerror", (error) => faults.push(`exception: ${error.message}`));
  page.on("dialog", (dialog) => (faults.push(`dialog: ${dialog.message()}`), dialog.dismiss()));
  const own = (url) => /^(data|blob):/.test(url) || url.startsWith(address);
  page.on("request", (request) => own(request.url()) || faults.push(`request: ${request.url()}`));
  return faults;
}

/** Adds up by how much the layout jumps without a user's doing. */
function noteShifts(page) {
  return page.addInitScript(() => {
    window.layout_shift = 0;
    new PerformanceObserver((list) => {
      for (const entry of list.getEntries()) if (!entry.hadRecentInput) window.layout_shift += entry.value;
    }).observe({ type: "layout-shift", buffered: true });
  });
}

/** Fails if axe-core finds anything on the page as it is now. */
export async function expectAccessible(page, what) {
  // The page's policy refuses further script elements; text that the debugger evaluates is no such element.
  await page.evaluate(readFileSync(axe_path, "utf8"));
  const { violations } = await page.evaluate(() => window.axe.run(document));
  const texts = violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => `${node.target} ${node.failureSummary}`).join("; ")}`);
  assert.deepEqual(texts, [], `axe-core about ${what}`);
}

/** The pieces of a result, in order of placement, each with a point well inside it that no later piece covers. */
export function piecesOf(result) {
  const { features } = JSON.parse(readFileSync(`${result}/pieces.geojson`, "utf8"));
  const rings = features.map(({ geometry }) => geometry.coordinates);
  return features.map(({ properties }, index) => ({ ...properties, inside: insidePoint(rings, index) }));
}

/** The drawing that stands in the most places, and their number. */
export function mostUsed(result) {
  const uses = {};
  for (const { shape } of piecesOf(result)) uses[shape] = (uses[shape] ?? 0) + 1;
  const [most] = Object.entries(uses).sort(([, a], [, b]) => b - a);
  assert.ok(most[1] > 1, "no drawing is used twice");
  return most;
}

function contains(polygon, x, y) {
  let inside = false;
  for (const ring of polygon) {
    for (let i = 0, j = ring.length - 1; i < ring.length; j = i++) {
      const [[xi, yi], [xj, yj]] = [ring[i], ring[j]];
      if (yi > y !== yj > y && x < xi + ((y - yi) / (yj - yi)) * (xj - xi)) inside = !inside;
    }
  }
  return inside;
}

/** The place of a grid over the piece that is farthest from its boundary. */
function insidePoint(polygons, index) {
  const outer = polygons[index][0];
  const [xs, ys] = [outer.map(([x]) => x), outer.map(([, y]) => y)];
  const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  let best = null;
  for (let i = 1; i < 24; ++i) {
    for (let j = 1; j < 24; ++j) {
      const [x, y] = [left + ((right - left) * i) / 24, top + ((bottom - top) * j) / 24];
      if (!contains(polygons[index], x, y) || polygons.slice(index + 1).some((other) => contains(other, x, y))) continue;
      const distance = Math.min(...outer.map(([px, py]) => Math.hypot(px - x, py - y)));
      if (!best || distance > best.distance) best = { x, y, distance };
    }
  }
  return best;
}

/** Where a point of the canvas lies on the page. */
export async function onPage(page, { x, y }) {
  const box = await page.getByTestId("viewer").boundingBox();
  const at = await page.evaluate(() => window.tesseraReport.view.transform());
  return [box.x + at.x + x * at.k, box.y + at.y + y * at.k];
}

/** The point of the picture in the middle of the viewer, and the scale. */
export async function middle(page) {
  const box = await page.getByTestId("viewer").boundingBox();
  const { k, x, y } = await transform(page);
  return { x: (box.width / 2 - x) / k, y: (box.height / 2 - y) / k, k };
}

export const transform = (page) => page.evaluate(() => window.tesseraReport.view.transform());
export const selected = (page) => page.evaluate(() => window.tesseraReport.view.selected());

/** A picture of an element, or of the whole page (null), once it no longer changes. */
export async function settledShot(page, testid = "viewer") {
  const seen = testid === null ? page : page.getByTestId(testid);
  let before = null;
  for (let tries = 0; tries < 40; ++tries) {
    const now = await seen.screenshot().catch(() => null); // null: the page was built anew meanwhile
    if (now && before?.equals(now)) return now;
    before = now;
    await page.waitForTimeout(80);
  }
  return before;
}

/** The fraction of pixels of two PNG files that differ clearly; 1 if their sizes differ. */
export const changedFraction = (a, b) => differentSquares(a, b, 1, 12);

/** Divides two PNG files into squares, and gives the fraction of those whose mean colours differ by more than `least`, of 255, in a
 *  channel; 1 if the sizes of the pictures differ. */
export async function differentSquares(a, b, square_px, least) {
  const page = await browser.newPage();
  const urls = [a, b].map((png) => `data:image/png;base64,${png.toString("base64")}`);
  const fraction = await page.evaluate(
    async ([urls, square_px, least]) => {
      const means = async (url) => {
        const picture = new Image();
        picture.src = url;
        await picture.decode();
        const { width, height } = picture;
        const context = new OffscreenCanvas(width, height).getContext("2d");
        context.drawImage(picture, 0, 0);
        const { data } = context.getImageData(0, 0, width, height);
        const across = Math.ceil(width / square_px);
        const sums = new Float64Array(4 * across * Math.ceil(height / square_px));
        for (let y = 0; y < height; ++y) {
          for (let x = 0; x < width; ++x) {
            const square = 4 * (Math.floor(y / square_px) * across + Math.floor(x / square_px));
            for (let channel = 0; channel < 3; ++channel) sums[square + channel] += data[4 * (y * width + x) + channel];
            ++sums[square + 3]; // pixels
          }
        }
        return { width, height, sums };
      };
      const [one, two] = await Promise.all(urls.map(means));
      if (one.width !== two.width || one.height !== two.height) return 1;
      let changed = 0;
      for (let at = 0; at < one.sums.length; at += 4) {
        const far = [0, 1, 2].some((channel) => Math.abs(one.sums[at + channel] - two.sums[at + channel]) > least * one.sums[at + 3]);
        if (far) ++changed;
      }
      return (4 * changed) / one.sums.length;
    },
    [urls, square_px, least],
  );
  await page.close();
  return fraction;
}

/** Radio buttons lie beneath their labels. */
export const pressLabel = (page, testid) => page.locator(`label:has([data-testid=${testid}])`).click();

export function expectNotHacked() {
  assert.equal(existsSync("hacked"), false, "a name was run as a command");
}
