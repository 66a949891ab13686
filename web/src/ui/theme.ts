import { Value } from "../util/value.ts";
import { element } from "./dom.ts";

type Theme = "auto" | "light" | "dark";

/** Counts changes of the colours, for those who draw with them. */
export const theme_changes = new Value(0);

const told = (): void => theme_changes.set(theme_changes.get() + 1);

/** The choice between the system's colours, light and dark ones. */
export function themeSwitch(): HTMLElement {
  const select = element("select", { "aria-label": "Colours of this page", class: "select", "data-testid": "theme" });
  for (const [value, label] of [
    ["auto", "Auto colours"],
    ["light", "Light"],
    ["dark", "Dark"],
  ] as const) {
    select.append(element("option", { value }, label));
  }
  select.addEventListener("change", () => {
    const theme = select.value as Theme;
    if (theme === "auto") delete document.documentElement.dataset["theme"];
    else document.documentElement.dataset["theme"] = theme;
    told();
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", told);
  return select;
}

/** A colour of the style sheet, as canvases take it. */
export function themeColour(name: string): string {
  const probe = element("span", { class: `probe-${name}` });
  document.body.append(probe);
  const { color } = getComputedStyle(probe);
  probe.remove();
  return color;
}
