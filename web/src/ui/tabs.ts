import { element } from "./dom.ts";

export interface Tab {
  id: string;
  label: string;
  content: HTMLElement;
  /** Called when the tab shows for the first time. */
  open?: () => void;
}

export interface Tabs {
  list: HTMLElement;
  panels: HTMLElement;
  show(id: string): void;
}

/** Tabs as the ARIA practices describe them: one of them in the order of Tab, arrows go to the others. */
export function makeTabs(label: string, tabs: readonly Tab[], changed: (id: string) => void): Tabs {
  const list = element("div", { class: "tabs", role: "tablist", "aria-label": label });
  const panels = element("div", { class: "tab-panels" });
  const opened = new Set<string>();
  const buttons = tabs.map(({ id, label: text }) =>
    element(
      "button",
      { type: "button", role: "tab", class: "tab", id: `tab-${id}`, "aria-controls": `panel-${id}`, "data-testid": `tab-${id}` },
      text,
    ),
  );
  const sections = tabs.map(({ id, content }) =>
    element("section", { role: "tabpanel", class: "tab-panel", id: `panel-${id}`, "aria-labelledby": `tab-${id}`, tabindex: 0 }, content),
  );
  const show = (id: string): void => {
    tabs.forEach((tab, index) => {
      const chosen = tab.id === id;
      buttons[index]!.setAttribute("aria-selected", String(chosen));
      buttons[index]!.tabIndex = chosen ? 0 : -1;
      sections[index]!.hidden = !chosen;
      if (chosen && !opened.has(id)) {
        opened.add(id);
        tab.open?.();
      }
    });
    changed(id);
  };
  buttons.forEach((tab, index) => {
    tab.addEventListener("click", () => show(tabs[index]!.id));
    tab.addEventListener("keydown", (event) => {
      const next = { ArrowRight: index + 1, ArrowLeft: index - 1, Home: 0, End: tabs.length - 1 }[event.key];
      if (next === undefined) return;
      event.preventDefault();
      const target = (next + tabs.length) % tabs.length;
      show(tabs[target]!.id);
      buttons[target]!.focus();
    });
  });
  list.append(...buttons);
  panels.append(...sections);
  return { list, panels, show };
}
