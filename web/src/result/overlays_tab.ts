import { checkbox, element } from "../ui/dom.ts";
import { gapClasses } from "../model/gap_classes.ts";
import { kViridis } from "../model/ramp.ts";
import { fixed } from "../util/format.ts";
import { kContactClasses } from "../view/contact_painter.ts";
import type { Layers, OverlayName } from "./layers.ts";
import type { Session } from "./session.ts";

/** The picture's strength beneath overlays that need a calm ground, unless someone has chosen another. */
const kFaded = 0.35;

interface Overlay {
  name: OverlayName;
  label: string;
  explanation: string;
  legend?: HTMLElement;
}

export function overlaysTab(session: Session, layers: Layers): HTMLElement {
  const strength = strengthSlider(session, layers);
  const panel = element("div", { class: "overlays" }, element("h2", {}, "Overlays"), strength.element);
  for (const { name, label, explanation, legend } of overlayList(session)) {
    const line = checkbox(label, explanation, `overlay-${name}`, (on) => {
      layers.overlays[name].visible = on;
      if (legend) legend.hidden = !on;
      strength.fade(Object.entries(layers.overlays).some(([other, layer]) => layer.visible && other !== "outlines"));
      session.viewer.redraw();
    });
    if (legend) {
      legend.hidden = true;
      line.append(legend);
    }
    panel.append(line);
  }
  return panel;
}

function overlayList(session: Session): Overlay[] {
  const { contact, data } = session.result;
  const all: Overlay[] = [
    { name: "outlines", label: "Outlines", explanation: "The exact boundary of each piece." },
    { name: "overlaps", label: "Overlaps", explanation: "Where two pieces lie over each other (red), or three and more (magenta)." },
    { name: "free", label: "Free region", explanation: "What no piece covers, within the region to fill." },
    {
      name: "gaps",
      label: "Gaps by size",
      legend: gapLegend(session),
      explanation:
        data.gaps.radius_px.length > 0
          ? "The largest discs that fit between the pieces; the colour tells their radius."
          : "No discs were found between the pieces.",
    },
    {
      name: "contact",
      label: "Contact",
      legend: contactLegend(),
      explanation: contact
        ? "How far each part of a boundary is from the next piece or the edge."
        : "This page has no distances between the pieces.",
    },
    { name: "order", label: "Order of placement", explanation: "From the first piece to the last one.", legend: orderLegend(session) },
  ];
  return all;
}

/** How strongly the picture shows beneath the overlays. */
function strengthSlider(session: Session, layers: Layers): { element: HTMLElement; fade(on: boolean): void } {
  const input = element("input", { type: "range", id: "strength", min: 0, max: 100, value: 100, "data-testid": "picture-strength" });
  let touched = false;
  const apply = (): void => {
    layers.base.strength = Number(input.value) / 100;
    input.setAttribute("aria-valuetext", `${input.value} %`);
    session.viewer.redraw();
  };
  input.addEventListener("input", () => {
    touched = true;
    apply();
  });
  const fade = (on: boolean): void => {
    if (touched) return;
    input.value = on ? String(100 * kFaded) : "100";
    apply();
  };
  return {
    element: element("div", { class: "slider-row" }, element("label", { for: "strength" }, "Strength of the picture"), input),
    fade,
  };
}

function legendOf(entries: readonly { colour: string; text: string }[]): HTMLElement {
  const list = element("ul", { class: "legend" });
  for (const { colour, text } of entries) {
    const swatch = element("span", { class: "swatch", "aria-hidden": "true" });
    swatch.style.backgroundColor = colour;
    list.append(element("li", {}, swatch, text));
  }
  return list;
}

function gapLegend(session: Session): HTMLElement {
  return legendOf(gapClasses(session.result.data.gaps.radius_px).map(({ from_px, colour }) => ({ colour, text: `from ${fixed(from_px, 1)} px` })));
}

function contactLegend(): HTMLElement {
  const texts = ["up to 0.5 px", "up to 1 px", "up to 2 px: counts as contact", "up to 4 px", "farther"];
  return legendOf(kContactClasses.map(({ colour }, index) => ({ colour, text: texts[index]! })));
}

function orderLegend(session: Session): HTMLElement {
  const bar = element("span", { class: "ramp", "aria-hidden": "true" });
  bar.style.backgroundImage = `linear-gradient(to right, ${kViridis.join(", ")})`;
  return element(
    "div",
    { class: "legend ramp-legend" },
    element("span", {}, "first"),
    bar,
    element("span", {}, `last (${session.pieces - 1})`),
  );
}
