// Pages with the keyboard alone, with axe-core in all colours and widths, and the comparison of results.

import assert from "node:assert/strict";
import { test } from "node:test";
import * as fixture from "./page_fixture.mjs";

const limits = { timeout: 180_000 };
const tabs = ["piece", "search", "overlays", "edit", "quality", "job"];
const looks = [
  { colorScheme: "light", viewport: { width: 1280, height: 800 } },
  { colorScheme: "dark", viewport: { width: 1280, height: 800 } },
  { colorScheme: "light", viewport: { width: 390, height: 780 }, hasTouch: true, deviceScaleFactor: 2 },
  { colorScheme: "dark", viewport: { width: 390, height: 780 }, hasTouch: true, deviceScaleFactor: 2 },
];
const nameOf = ({ colorScheme, viewport }) => `${colorScheme}, ${viewport.width} px wide`;
fixture.useBrowser();

/** Nothing is wider than the page, so that nobody must scroll it sideways. */
async function expectNarrow(page, what) {
  const [content, window_width] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
  assert.ok(content <= window_width, `${what}: ${content} px of content in ${window_width} px`);
}

for (const look of looks) {
  test(`a result, ${nameOf(look)}: each tab is accessible`, limits, async (t) => {
    const { page, finish } = await fixture.open(t, "result.html", look);
    await page.evaluate(() => window.tesseraReport.view.select(1));
    for (const tab of tabs) {
      await page.getByTestId(`tab-${tab}`).click();
      if (tab === "overlays") for (const name of ["gaps", "contact", "order"]) await page.getByTestId(`overlay-${name}`).check();
      if (tab === "edit") await page.keyboard.press("e");
      await page.waitForTimeout(150); // plots are drawn when they come into sight
      await fixture.expectAccessible(page, `the tab ${tab}, ${nameOf(look)}`);
      await expectNarrow(page, tab);
      await page.screenshot({ path: `shot_${tab}_${look.colorScheme}_${look.viewport.width}.png` });
    }
    // The list of keys is left out where there is hardly a keyboard.
    if (await page.getByTestId("keys").isVisible()) {
      await page.getByTestId("keys").click();
      await fixture.expectAccessible(page, `the keys, ${nameOf(look)}`);
    }
    await finish();
  });

  test(`a campaign, ${nameOf(look)}: sorted, side by side, difference, blinking`, limits, async (t) => {
    const { page, finish } = await fixture.open(t, "both.html", look);
    const order = async () => (await page.getByTestId("ranking").locator("tbody th").allTextContents()).join();
    await page.getByTestId("sort-1").click();
    assert.equal(await order(), "other,result");
    await page.getByTestId("sort-1").click();
    assert.equal(await order(), "result,other");
    assert.equal(await page.getByTestId("ranking").locator("th[aria-sort=descending]").count(), 1);
    await fixture.expectAccessible(page, `a campaign, ${nameOf(look)}`);
    await expectNarrow(page, "a campaign");
    await page.getByTestId("card-0").click();
    await page.getByTestId("card-1").click();
    await fixture.expectAccessible(page, `two chosen results, ${nameOf(look)}`);
    await page.screenshot({ path: `shot_campaign_${look.colorScheme}_${look.viewport.width}.png` });
    await page.getByTestId("compare").click();

    const [one, two] = [await fixture.settledShot(page), await fixture.settledShot(page, "viewer-beside")];
    assert.ok((await fixture.changedFraction(one, two)) > 0.05, "both sides show the same");
    await page.getByTestId("viewer").focus();
    const both = await page.getByTestId("zoom-in").count();
    assert.equal(both, 2);
    await page.getByTestId("zoom-in").first().click();
    await fixture.settledShot(page);
    const beside = await fixture.settledShot(page, "viewer-beside");
    assert.ok((await fixture.changedFraction(two, beside)) > 0.05, "the other side does not follow");
    await fixture.expectAccessible(page, `side by side, ${nameOf(look)}`);
    const zoomed = await fixture.middle(page);
    for (const mode of ["difference", "blink"]) {
      await fixture.pressLabel(page, `mode-${mode}`);
      await page.waitForTimeout(150);
      for (const [key, value] of Object.entries(await fixture.middle(page))) {
        assert.ok(Math.abs(value / zoomed[key] - 1) < 0.01, `${mode} shows another place: ${key} ${value}, not ${zoomed[key]}`);
      }
      if (mode === "difference") assert.ok((await fixture.changedFraction(one, await fixture.settledShot(page))) > 0.05);
      else await page.getByTestId("blink-pause").click();
      await fixture.expectAccessible(page, `${mode}, ${nameOf(look)}`);
      await expectNarrow(page, mode);
      await page.screenshot({ path: `shot_${mode}_${look.colorScheme}_${look.viewport.width}.png` });
    }
    await page.getByTestId("compare-close").click();
    assert.equal(await page.evaluate(() => document.activeElement.dataset.testid), "compare");
    await finish();
  });
}

/** What has the focus: its data-testid, or its text or label. */
const focused = (page) =>
  page.evaluate(() => {
    const now = document.activeElement;
    return now === document.body ? "" : (now.dataset.testid ?? now.getAttribute("aria-label") ?? now.textContent);
  });

/** Presses Tab until something has the focus. */
async function tabTo(page, wanted) {
  const seen = [];
  for (let steps = 0; steps < 80; ++steps) {
    await page.keyboard.press("Tab");
    seen.push(await focused(page));
    if (seen.at(-1) === wanted) return;
  }
  assert.fail(`Tab does not reach ${wanted}: ${seen.join(", ")}`);
}

test("a result with the keyboard alone", limits, async (t) => {
  const { page, finish } = await fixture.open(t);
  for (const wanted of ["keys", "panel-toggle", "theme", "viewer", "zoom-in", "zoom-out", "zoom-fit", "growth-play", "growth-slider"]) {
    await tabTo(page, wanted);
    // The focus must be seen: its outline or its shadow.
    const seen = await page.evaluate(() => {
      const style = getComputedStyle(document.activeElement);
      return style.outlineStyle !== "none" || style.boxShadow !== "none";
    });
    assert.ok(seen, `the focus on ${wanted} does not show`);
  }
  await tabTo(page, "tab-piece");
  await page.keyboard.press("ArrowRight");
  assert.equal(await focused(page), "tab-search");
  await tabTo(page, "search-input");
  const [name, uses] = fixture.mostUsed("result");
  await page.keyboard.type(name);
  await page.keyboard.press("ArrowDown");
  assert.match(await focused(page), new RegExp(`^${name}`));
  await page.keyboard.press("Enter");
  assert.match(await page.getByTestId("highlight-note").textContent(), new RegExp(`^${name} · ${uses} ×`));

  await page.getByTestId("viewer").focus();
  for (const key of ["n", "n", "e", "n", "l"]) await page.keyboard.press(key);
  assert.equal(await fixture.selected(page), 2);
  await tabTo(page, "tab-piece");
  for (let steps = 0; steps < 3; ++steps) await page.keyboard.press("ArrowRight");
  assert.equal(await focused(page), "tab-edit");
  assert.equal(await page.getByTestId("command").textContent(), "tessera refine result --pieces 1 --lock 2");
  for (const wanted of ["edit-swap", "command", "command-copy", "save-marks", "save-mask"]) await tabTo(page, wanted);
  await finish();
});

test("a campaign with the keyboard alone", limits, async (t) => {
  const { page, finish } = await fixture.open(t, "both.html");
  for (const card of ["card-0", "card-1"]) {
    await tabTo(page, card);
    await page.keyboard.press("Enter");
  }
  await tabTo(page, "compare");
  await page.keyboard.press("Enter");
  assert.equal(await focused(page), "viewer");
  await tabTo(page, "compare-close");
  await page.keyboard.press("Enter");
  assert.equal(await focused(page), "compare");
  await finish();
});

const darkness = (page) => page.evaluate(() => getComputedStyle(document.documentElement).colorScheme);
const reload = async (page) => {
  await page.reload();
  await page.evaluate(() => window.tesseraReport.ready);
};

test("the chosen colours stay when the page is opened again", limits, async (t) => {
  const { page, finish } = await fixture.open(t);
  await page.getByTestId("theme").selectOption("dark");
  await reload(page);
  assert.equal(await darkness(page), "dark");
  assert.equal(await page.getByTestId("theme").inputValue(), "dark");
  // If the browser keeps nothing, the choice holds until the page is closed.
  await page.addInitScript(() => Object.defineProperty(window, "localStorage", { get: () => { throw new Error("refused"); } }));
  await reload(page);
  assert.equal(await page.getByTestId("theme").inputValue(), "auto");
  await page.getByTestId("theme").selectOption("light");
  assert.equal(await darkness(page), "light");
  await finish();
});

test("a question mark shows the keys", limits, async (t) => {
  const { page, finish } = await fixture.open(t);
  await page.getByTestId("viewer").focus();
  await page.keyboard.press("?");
  assert.ok(await page.getByRole("dialog", { name: "Keys" }).isVisible());
  await page.keyboard.press("Escape");
  assert.equal(await page.getByRole("dialog").count(), 0);
  await finish();
});

test("forced colours: legends keep their colours, and what is chosen shows", limits, async (t) => {
  const { page, finish } = await fixture.open(t, "result.html", { forcedColors: "active" });
  await page.getByTestId("tab-overlays").click();
  await page.getByTestId("overlay-contact").check();
  const colours = await page.locator(".swatch:visible").evaluateAll((all) => all.map((one) => getComputedStyle(one).backgroundColor));
  assert.equal(new Set(colours).size, 5);
  const lines = await page.locator(".tab").evaluateAll((all) => all.map((one) => getComputedStyle(one).borderBottomColor));
  assert.equal(new Set(lines).size, 2, "the open tab looks like the others");
  await page.getByTestId("tab-edit").click();
  const tools = await page.locator(".segments span").evaluateAll((all) => all.map((one) => getComputedStyle(one).backgroundColor));
  assert.ok(new Set(tools).size > 1, "the chosen tool looks like the others");
  await fixture.expectAccessible(page, "forced colours");
  await finish();
});
