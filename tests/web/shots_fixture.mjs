// Pictures of pages, compared with pictures in tests/web/shots/.
//
// Fonts differ between machines, and browsers draw text and slanted edges not quite alike. Therefore
// - all text has the metrics of DejaVu Sans (Debian: fonts-dejavu-core) and is transparent: it takes its room, but no letter is compared;
// - not pixels are compared but the mean colours of squares of 8 x 8 px. Soft edges hardly change a mean. A line of another
//   colour, or a picture that moved by 3 px, changes the means of many squares;
// - some squares may differ: a check mark or the thumb of a slider looks different in another version of the browser.
// Measured: with the fonts of a bare Debian 12 alone no square differs; 0.03 % differ if the graphics library draws instead of the
// processor. A picture that moved by 3 px changes 4 % and more, an overlay or mark of another colour 1.5 % and more.

import assert from "node:assert/strict";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import * as fixture from "./page_fixture.mjs";

const kSquare_px = 8;
/** A mean differs clearly from here on, of 255. */
const kClearly = 8;
const kMostChanged = 0.005; // of all squares

const kStyle = `* {
  font-family: "DejaVu Sans" !important;
  text-rendering: geometricPrecision !important;
  -webkit-text-fill-color: transparent !important;
  caret-color: transparent !important;
  transition: none !important;
}`;

/** Whether the browser has the font that gives text its room. */
export function hasFont(page) {
  return page.evaluate(() => {
    const context = new OffscreenCanvas(1, 1).getContext("2d");
    const widths = ["serif", "monospace"].map((other) => {
      context.font = `40px "DejaVu Sans", ${other}`;
      return context.measureText("Mwi1").width;
    });
    return widths[0] === widths[1];
  });
}

/** Makes the page look the same on all machines. */
export async function plainText(page) {
  await page.evaluate((style) => {
    const sheet = new CSSStyleSheet(); // the page's policy allows no further style elements
    sheet.replaceSync(style);
    document.adoptedStyleSheets.push(sheet);
  }, kStyle);
}

/** Compares the page as it is with shots/NAME.png. With RENEW_SHOTS=1 in the environment it writes this file instead. */
export async function expectShot(page, name) {
  const file = join(process.env.SHOTS, `${name}.png`);
  await page.mouse.move(1, 1); // nothing lies below the pointer
  const now = await fixture.settledShot(page, null);
  if (process.env.RENEW_SHOTS === "1") return writeFileSync(file, now);
  assert.ok(existsSync(file), `${file} is missing; RENEW_SHOTS=1 makes it`);
  const changed = await fixture.differentSquares(readFileSync(file), now, kSquare_px, kClearly);
  if (changed > kMostChanged) writeFileSync(`differs_${name}.png`, now);
  const percent = (100 * changed).toFixed(2);
  assert.ok(changed <= kMostChanged, `${percent} % of the page look different from ${file}; it is now as in differs_${name}.png here`);
}
