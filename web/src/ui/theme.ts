import { Value } from "../util/value.ts";
import { element } from "./dom.ts";

const kThemes = [
  ["auto", "Auto colours"],
  ["light", "Light"],
  ["dark", "Dark"],
] as const;
type Theme = (typeof kThemes)[number][0];

/** Under this name the browser keeps the choice: for pages from the disk all together, or for each page, as the browser has it. */
const kKey = "tessera-theme";

/** Counts changes of the colours, for those who draw with them. */
export const theme_changes = new Value(0);

const told = (): void => theme_changes.set(theme_changes.get() + 1);

const currentTheme = (): string => document.documentElement.dataset["theme"] ?? "auto";

function useTheme(theme: Theme): void {
  if (theme === "auto") delete document.documentElement.dataset["theme"];
  else document.documentElement.dataset["theme"] = theme;
}

/** Gives the page the colours that were chosen when it was open last. */
export function restoreTheme(): void {
  try {
    const kept = localStorage.getItem(kKey);
    for (const [theme] of kThemes) if (theme === kept) useTheme(theme);
  } catch {
    // The browser keeps nothing for this page: the system's colours.
  }
}

function keepTheme(theme: Theme): void {
  try {
    localStorage.setItem(kKey, theme);
  } catch {
    // The choice holds until the page is closed.
  }
}

/** The choice between the system's colours, light and dark ones. */
export function themeSwitch(): HTMLElement {
  const select = element("select", { "aria-label": "Colours of this page", class: "select", "data-testid": "theme" });
  for (const [value, label] of kThemes) select.append(element("option", { value, selected: value === currentTheme() }, label));
  select.addEventListener("change", () => {
    const theme = select.value as Theme;
    useTheme(theme);
    keepTheme(theme);
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
