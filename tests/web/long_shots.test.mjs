// The page of a result looks as it did: shots/*.png. Who changes its looks on purpose renews them (docs/contributing.md).

import { test } from "node:test";
import * as fixture from "./page_fixture.mjs";
import * as shots from "./shots_fixture.mjs";

const kDesktop = { width: 800, height: 500 };
const kPhone = { width: 390, height: 640 };
const pieces = fixture.piecesOf("result");
fixture.useBrowser();

/** Switches overlays on, and leaves their tab open. */
const show = (...overlays) => async (page) => {
  await page.getByTestId("tab-overlays").click();
  for (const name of overlays) await page.getByTestId(`overlay-${name}`).check();
};

/** Two marked pieces, and a selected one. */
async function mark(page) {
  await page.getByTestId("tab-edit").click();
  for (const [piece, key] of [[2, "e"], [5, "l"], [7, ""]]) {
    await page.evaluate((index) => window.tesseraReport.view.select(index), piece);
    if (key) await page.keyboard.press(key);
  }
}

async function growAndZoom(page) {
  await page.getByTestId("growth-slider").fill(String(Math.round(pieces.length / 2)));
  await page.evaluate(() => window.tesseraReport.view.centre(120, 90, 4));
}

const kShots = [
  ["desktop_light", kDesktop, "light", async () => {}],
  ["desktop_dark_contact", kDesktop, "dark", show("outlines", "contact")],
  ["desktop_light_areas", kDesktop, "light", show("overlaps", "free", "gaps")],
  ["desktop_dark_growth", kDesktop, "dark", growAndZoom],
  ["phone_light_marks", kPhone, "light", mark],
  ["phone_dark_order", kPhone, "dark", show("order", "outlines")],
];

for (const [name, viewport, colorScheme, prepare] of kShots) {
  test(`looks: ${name}`, { timeout: 60_000 }, async (t) => {
    const { page, finish } = await fixture.open(t, "result.html", { viewport, colorScheme });
    if (!(await shots.hasFont(page))) return t.skip("the font DejaVu Sans is missing (Debian: fonts-dejavu-core)");
    await shots.plainText(page);
    await prepare(page);
    await shots.expectShot(page, name);
    await finish();
  });
}
