import { costRows, ending, qualityFigures, rankRows, section } from "../model/card.ts";
import { element, printable } from "../ui/dom.ts";
import { factList } from "./piece_tab.ts";
import { qualityPlots } from "./quality_plots.ts";
import type { Session } from "./session.ts";

/** The quality card: figures, plots, the cost of the run and what made the result. It is filled when it is opened. */
export function qualityTab(session: Session): { content: HTMLElement; open: () => void } {
  const content = element("div", { class: "quality" });
  const open = (): void => {
    const { card } = session.result.data;
    content.append(element("h2", {}, "Quality"));
    if (!card) content.append(element("p", { class: "note" }, "This result has no quality card yet; the plots come from the pieces."));
    content.append(figureGrid(card), ...qualityPlots(session.result), ...costTable(card), ...ranksTable(card), ...provenance(session));
  };
  return { content, open };
}

function figureGrid(card: Record<string, unknown> | null): HTMLElement {
  const list = element("dl", { class: "figures", "data-testid": "quality-figures" });
  for (const { label, value, meaning } of qualityFigures(card)) {
    list.append(
      element("div", {}, element("dt", {}, label), element("dd", { class: "value" }, value), element("dd", { class: "meaning" }, meaning)),
    );
  }
  return list;
}

function costTable(card: Record<string, unknown> | null): Node[] {
  const rows = costRows(card);
  if (rows.length === 0) return [];
  const body = element("tbody", {});
  for (const [label, value] of rows) body.append(element("tr", {}, element("th", { scope: "row" }, label), element("td", {}, value)));
  const ended = ending(card);
  return [
    element("h3", {}, "Cost of the run"),
    element("p", { class: "note" }, `The columns of the paper's Table 2.${ended ? ` The run ended because ${ended}.` : ""}`),
    element("table", { class: "table", "data-testid": "cost-table" }, element("caption", { class: "spoken" }, "Cost of the run"), body),
  ];
}

function ranksTable(card: Record<string, unknown> | null): Node[] {
  const rows = rankRows(card);
  if (rows.length === 0) return [];
  const head = element("tr", {});
  for (const label of ["Stage", "Average", "Share", "Imbalance"]) head.append(element("th", { scope: "col" }, label));
  const body = element("tbody", {});
  for (const [stage, ...values] of rows) {
    const row = element("tr", {}, element("th", { scope: "row" }, printable(stage)));
    for (const value of values) row.append(element("td", {}, value));
    body.append(row);
  }
  return [
    element("h3", {}, "Workers"),
    element("p", { class: "note" }, `Where ${String(section(card, "ranks")["workers"] ?? "the")} workers spent the time of the loop.`),
    element("table", { class: "table" }, element("caption", { class: "spoken" }, "Time of the workers"), element("thead", {}, head), body),
  ];
}

function provenance(session: Session): Node[] {
  const { program, folder, finished, card } = session.result.data;
  const made = section(card, "provenance");
  const rows: [string, Node | string][] = [
    ["Program", printable(program)],
    ["Folder", printable(folder)],
    ["Finished", finished ? "yes" : "no"],
  ];
  const keys = [
    ["Began", "started_utc"],
    ["Ended", "ended_utc"],
    ["Library", "library_file"],
    ["Library's digest", "library_digest"],
    ["Job file", "job_file"],
    ["Command", "command_line"],
  ] as const;
  for (const [label, key] of keys) {
    if (typeof made[key] === "string" && made[key] !== "") rows.push([label, printable(made[key])]);
  }
  const list = factList([...rows, ...machines(made)], "provenance");
  list.classList.add("stacked");
  return [element("h3", {}, "Provenance"), list, ...warnings(made)];
}

/** One line for each rank: its host and devices. */
function machines(made: Record<string, unknown>): [string, string][] {
  const ranks = Array.isArray(made["ranks"]) ? (made["ranks"] as Record<string, unknown>[]) : [];
  return ranks.slice(0, 32).map((rank, index): [string, string] => {
    const devices = Array.isArray(rank["devices"]) ? (rank["devices"] as Record<string, unknown>[]) : [];
    const names = devices.map((device) => `${String(device["kind"])}: ${String(device["name"])}`);
    return [`Rank ${index}`, printable([String(rank["host"]), ...names].join("; "))];
  });
}

function warnings(made: Record<string, unknown>): Node[] {
  const texts = Array.isArray(made["warnings"]) ? made["warnings"].map(String) : [];
  if (texts.length === 0) return [];
  return [element("h3", {}, "Warnings"), element("ul", { class: "warnings" }, ...texts.map((text) => element("li", {}, printable(text))))];
}
