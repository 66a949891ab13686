import type { CampaignData, CampaignResult, Source } from "../data.ts";
import type { TestHooks } from "../test_hooks.ts";
import { announce, announcer } from "../ui/announce.ts";
import { button, element, foreignName, printable, spokenName } from "../ui/dom.ts";
import { header } from "../ui/header.ts";
import { icon } from "../ui/icons.ts";
import { counted } from "../util/format.ts";
import { Value } from "../util/value.ts";
import { type Chosen } from "./chosen.ts";
import { Comparison } from "./comparison.ts";
import { contactSheet } from "./contact_sheet.ts";
import { rankingTable } from "./ranking_table.ts";

/** The page of a campaign: all pictures, a table of the measures, and two results beside each other. */
export function showCampaign(page: HTMLElement, source: Source, data: CampaignData): NonNullable<TestHooks["view"]> {
  if (document.title === "") document.title = data.name;
  const chosen: Chosen = new Value<readonly number[]>([]);
  let comparison: Comparison | null = null;
  const overview = element(
    "main",
    { class: "campaign" },
    element(
      "p",
      { class: "note formula" },
      "Ranked by ",
      element("code", {}, printable(data.formula)),
      ". Choose two results to compare them.",
    ),
    element("h2", {}, "Pictures"),
    contactSheet(data, source, chosen),
    element("h2", {}, "Measures"),
    rankingTable(data, chosen),
    compareBar(data, chosen, () => compare()),
  );
  const root = element("div", { class: "campaign-page" }, header(foreignName(data.name), counted(data.results.length, "result")), overview);
  page.replaceChildren(root, announcer());

  function compare(): void {
    const [a, b] = chosen.get().map((index) => data.results[index]!) as [CampaignResult, CampaignResult];
    const place = scrollY;
    comparison = new Comparison(source, data, a, b, () => {
      comparison?.leave();
      comparison = null;
      root.replaceChild(overview, root.querySelector("main")!);
      scrollTo(0, place);
      overview.querySelector<HTMLElement>("[data-testid=compare]")?.focus();
    });
    root.replaceChild(comparison.element, overview);
    comparison.begin();
    announce(`Comparing ${spokenName(a.name)} with ${spokenName(b.name)}.`);
  }
  return {
    transform: () => {
      const { k, x, y } = comparison?.leading.transform ?? { k: 1, x: 0, y: 0 };
      return { k, x, y };
    },
    fit: () => comparison?.leading.fit(false),
    centre: (x, y, k) => comparison?.leading.centre(x, y, k),
    selected: () => null,
    select: () => {},
  };
}

/** What is chosen, and the button that compares it. It stays in sight. */
function compareBar(data: CampaignData, chosen: Chosen, compare: () => void): HTMLElement {
  const text = element("p", { role: "status", "data-testid": "chosen" });
  const begin = button({ label: "Compare", kind: "primary", testid: "compare" }, compare);
  const clear = button({ label: "Choose none", icon: icon("clear"), icon_only: true, kind: "quiet" }, () => chosen.set([]));
  const bar = element("div", { class: "compare-bar", role: "region", "aria-label": "Comparison" }, text, begin, clear);
  chosen.watch((indices) => {
    bar.hidden = indices.length === 0;
    begin.disabled = indices.length < 2 || indices.some((index) => !data.results[index]!.picture);
    const names = indices.map((index) => foreignName(data.results[index]!.name));
    text.replaceChildren(
      ...names.flatMap((name, index) => (index > 0 ? [" and ", name] : [name])),
      ...(indices.length === 1 ? [" and …"] : []),
    );
  });
  return bar;
}
