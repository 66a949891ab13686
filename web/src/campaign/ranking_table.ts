import type { CampaignData, CampaignResult, Measure } from "../data.ts";
import { type Direction, sortedIndices } from "../model/sorting.ts";
import { element, foreignName, spokenName } from "../ui/dom.ts";
import { fixed } from "../util/format.ts";
import { type Chosen, toggleChosen } from "./chosen.ts";

/** A value as people read it; no line ends before its unit. */
export function shownValue(measure: Measure, value: number | null): string {
  if (value === null) return "–";
  return `${fixed(value, measure.decimals)}${measure.unit ? `\u00a0${measure.unit}` : ""}`;
}

interface Column {
  label: string;
  /** Which way is sorted first. */
  first: Direction;
  value(result: CampaignResult): number | string | null;
}

/** The measures of all results; a click on a heading sorts. */
export function rankingTable(data: CampaignData, chosen: Chosen): HTMLElement {
  const columns = columnsOf(data);
  const rows = data.results.map((result, index) => tableRow(data, result, index, chosen));
  const body = element("tbody", {}, ...rows);
  let sorted: { column: number; direction: Direction } = { column: 0, direction: "ascending" };
  const headings = columns.map((column, index) => {
    const press = element("button", { type: "button", class: "sort", "data-testid": `sort-${index}` }, column.label);
    press.addEventListener("click", () => {
      const again = sorted.column === index;
      sorted = { column: index, direction: again ? opposite(sorted.direction) : column.first };
      show();
    });
    return element("th", { scope: "col" }, press);
  });
  function show(): void {
    headings.forEach((heading, index) => heading.setAttribute("aria-sort", index === sorted.column ? sorted.direction : "none"));
    const values = data.results.map((result) => columns[sorted.column]!.value(result));
    body.append(...sortedIndices(values, sorted.direction).map((index) => rows[index]!));
  }
  show();
  const head = element(
    "thead",
    {},
    element("tr", {}, element("th", { scope: "col" }, element("span", { class: "spoken" }, "Choose")), ...headings),
  );
  const table = element(
    "table",
    { class: "table ranking", "data-testid": "ranking" },
    element("caption", { class: "spoken" }, "Measures of the results"),
    head,
    body,
  );
  return element("div", { class: "table-scroll", tabindex: 0, role: "region", "aria-label": "Measures of the results" }, table);
}

function opposite(direction: Direction): Direction {
  return direction === "ascending" ? "descending" : "ascending";
}

function columnsOf(data: CampaignData): Column[] {
  const measures = data.measures.map((measure, at): Column => ({
    label: measure.unit ? `${measure.label}, ${measure.unit}` : measure.label,
    first: measure.better === "less" ? "ascending" : "descending",
    value: (result) => result.values[at] ?? null,
  }));
  return [
    { label: "Rank", first: "ascending", value: (result) => result.rank },
    { label: "Result", first: "ascending", value: (result) => result.name },
    ...measures,
  ];
}

function tableRow(data: CampaignData, result: CampaignResult, index: number, chosen: Chosen): HTMLTableRowElement {
  const box = element("input", { type: "checkbox", "aria-label": `Choose ${spokenName(result.name)}`, "data-testid": `choose-${index}` });
  box.addEventListener("change", () => toggleChosen(chosen, index));
  chosen.watch((indices) => {
    box.checked = indices.includes(index);
  });
  const row = element("tr", {}, element("td", {}, box), element("td", {}, String(result.rank)));
  row.append(element("th", { scope: "row" }, foreignName(result.name)));
  data.measures.forEach((measure, at) => {
    const value = result.values[at] ?? null;
    const cell = element("td", {}, value === null ? "–" : fixed(value, measure.decimals));
    if (isBest(data, at, value)) cell.classList.add("best");
    row.append(cell);
  });
  return row;
}

/** Whether no other result has a better value. */
function isBest(data: CampaignData, at: number, value: number | null): boolean {
  const { better } = data.measures[at]!;
  if (better === null || value === null || data.results.length < 2) return false;
  const values = data.results.flatMap((result) => result.values[at] ?? []);
  return value === (better === "more" ? Math.max(...values) : Math.min(...values));
}
