// Tools on the picture, and what the tab Edit gives out.

import { readFileSync } from "node:fs";
import * as fixture from "./page_fixture.mjs";

/** Drags the pointer along points of the canvas. */
export async function drag(page, points) {
  const places = [];
  for (const point of points) places.push(await fixture.onPage(page, point));
  await page.mouse.move(...places[0]);
  await page.mouse.down();
  for (const place of places.slice(1)) await page.mouse.move(...place, { steps: 4 });
  await page.mouse.up();
}

export async function useTool(page, tool, kind = "erase") {
  await page.getByTestId("tab-edit").click();
  await fixture.pressLabel(page, `tool-${tool}`);
  await fixture.pressLabel(page, `mark-${kind}`);
}

export const command = (page) => page.getByTestId("command").textContent();

/** Presses a button that saves, and keeps the file under its own name. */
export async function save(page, testid) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId(testid).click()]);
  const name = download.suggestedFilename();
  await download.saveAs(name);
  return { name, text: () => readFileSync(name, "utf8") };
}

/** A lasso around the centres of some pieces and of no other: a rectangle around the first `count` from the left. */
export function lassoFromLeft(pieces, count) {
  const sorted = [...pieces].sort((a, b) => a.x_px - b.x_px);
  const right = (sorted[count - 1].x_px + sorted[count].x_px) / 2;
  const ring = [
    [-4, -4],
    [right, -4],
    [right, 204],
    [-4, 204],
    [-4, -2],
  ];
  const inside = sorted.slice(0, count).map(({ index }) => index);
  return { way: ring.map(([x, y]) => ({ x, y })), inside: inside.sort((a, b) => a - b) };
}
