// node measure_panning.mjs PAGE...: prints how long a page of tessera report takes to open, and the main-thread work of each frame while
// it is dragged, in headless Chromium. It runs where browser_test.sh installed its packages: build/release/tests/web/browser_smoke.

import { pathToFileURL } from "node:url";
import { startBrowser } from "./page_fixture.mjs";

const kCategories = ["toplevel", "devtools.timeline", "disabled-by-default-devtools.timeline"];
const kSteps = 240; // moves of the pointer in one drag
const kDrawn_ms = 2500; // until all tiles in sight are drawn
const kSameFrame_us = 4000; // callbacks closer than this belong to one frame
const kBefore_us = 3000; // input events run this long before the callbacks of their frame

/** The value below which the part `part` of the numbers lies. */
function quantile(numbers, part) {
  const sorted = [...numbers].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))] ?? NaN;
}

async function drag(page) {
  const box = await page.getByTestId("viewer").boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let step = 1; step <= kSteps; ++step) {
    const angle = (step / kSteps) * 4 * Math.PI;
    await page.mouse.move(x + 260 * Math.sin(angle), y + 180 * Math.sin(1.5 * angle));
    await page.waitForTimeout(8);
  }
  await page.mouse.up();
}

/** The events of a trace while the page is dragged. */
async function traceOfDrag(page) {
  const session = await page.context().newCDPSession(page);
  const events = [];
  session.on("Tracing.dataCollected", ({ value }) => events.push(...value));
  await session.send("Tracing.start", { transferMode: "ReportEvents", traceConfig: { includedCategories: kCategories } });
  await drag(page);
  const complete = new Promise((resolve) => session.once("Tracing.tracingComplete", resolve));
  await session.send("Tracing.end");
  await complete;
  await session.detach();
  return events;
}

/** For each frame the work of the page's main thread, ms: by the clock, and of processor time. */
function workOfFrames(events) {
  const callbacks = events.filter(({ name, ph }) => name === "FireAnimationFrame" && ph === "X");
  const thread = ({ pid, tid }) => `${pid}/${tid}`;
  const own = (event) => thread(event) === thread(callbacks[0]);
  const tasks = events.filter((event) => event.name === "RunTask" && event.ph === "X" && own(event));
  const times = callbacks.filter(own).map(({ ts }) => ts).sort((a, b) => a - b);
  const starts = times.filter((time, i) => i === 0 || time - times[i - 1] > kSameFrame_us);
  return starts.slice(0, -1).map((start, i) => {
    const inside = tasks.filter(({ ts }) => ts >= start - kBefore_us && ts < starts[i + 1] - kBefore_us);
    const sum = (key) => inside.reduce((total, task) => total + (task[key] ?? 0), 0) / 1000;
    return { clock: sum("dur"), processor: sum("tdur") };
  });
}

/** The picture 1.5 and 4 times enlarged, with the overlays that are switched on. */
async function measure(page, what) {
  for (const enlarged of [1.5, 4]) {
    await page.evaluate((factor) => {
      const { width_px, height_px } = JSON.parse(document.getElementById("data").textContent).canvas;
      const { view } = window.tesseraReport;
      view.fit();
      view.centre(width_px / 2, height_px / 2, view.transform().k * factor);
    }, enlarged);
    await page.waitForTimeout(kDrawn_ms);
    const frames = workOfFrames(await traceOfDrag(page));
    const figures = (key) => [0.5, 0.95].map((part) => quantile(frames.map((frame) => frame[key]), part).toFixed(1)).join(" and ");
    console.log(`  ${what}, ${enlarged} times: ${frames.length} frames, median and 95 %: ${figures("clock")} ms by the clock, ` +
      `${figures("processor")} ms of processor time`);
  }
}

const kAll = ["outlines", "overlaps", "free", "gaps", "contact", "order"];
const kOverlays = [[], ["outlines", "contact"], ["overlaps"], ["free"], ["gaps"], ["order"], kAll];

const browser = await startBrowser();
for (const file of process.argv.slice(2)) {
  const page = await (await browser.newContext({ viewport: { width: 1280, height: 800 } })).newPage();
  const begun_ms = Date.now();
  await page.goto(pathToFileURL(file).href, { timeout: 120_000 });
  await page.waitForFunction(() => window.tesseraReport);
  await page.evaluate(() => window.tesseraReport.ready);
  console.log(`${file}: ready after ${Date.now() - begun_ms} ms`);
  await page.getByTestId("tab-overlays").click();
  for (const overlays of kOverlays) {
    for (const overlay of overlays) await page.getByTestId(`overlay-${overlay}`).check();
    await measure(page, overlays.join(", ") || "picture");
    for (const overlay of overlays) await page.getByTestId(`overlay-${overlay}`).uncheck();
  }
  await page.context().close();
}
await browser.close();
