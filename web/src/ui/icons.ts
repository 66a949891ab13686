// Drawn on a square of 16, with lines.
const drawings = {
  plus: "M8 3v10M3 8h10",
  minus: "M3 8h10",
  fit: "M2.5 6v-3.5h3.5M10 2.5h3.5v3.5M13.5 10v3.5h-3.5M6 13.5h-3.5v-3.5",
  play: "M5 3l8 5-8 5z",
  pause: "M5.5 3v10M10.5 3v10",
  previous: "M10 3L5 8l5 5",
  next: "M6 3l5 5-5 5",
  undo: "M6 3L3 6l3 3M3 6h6.500a3.5 3.5 0 0 1 0 7H6",
  copy: "M6 6h7v7.500H6zM10 6V2.500H3V10h3",
  clear: "M4 4l8 8M12 4l-8 8",
  hand:
    "M8 2v12M2 8h12M8 2L6.3 3.700M8 2l1.7 1.700M8 14l-1.7-1.700M8 14l1.7-1.7" +
    "M2 8l1.7-1.700M2 8l1.7 1.700M14 8l-1.7-1.700M14 8l-1.7 1.7",
  brush: "M13.5 2.500L7 9M7 9c-2-.5-3.5 1-3.5 4.5 3 0 5-1.5 3.5-4.500z",
  lasso: "M8 2.500c3.3 0 6 1.7 6 3.900s-2.7 3.9-6 3.9-6-1.7-6-3.9 2.7-3.9 6-3.900zM5 10c-.8 1.5.5 2 .5 3.5",
  pointer: "M4 2.500l8.5 5-4 1-1.8 4z",
  panel: "M2.5 3h11v10h-11zM10 3v10",
  swap: "M3 5.500h9.500L10 3M13 10.500H3.500L6 13",
} as const;

export type IconName = keyof typeof drawings;

export function icon(name: IconName): SVGSVGElement {
  const space = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(space, "svg");
  svg.setAttribute("viewBox", "0 0 16 16");
  svg.setAttribute("aria-hidden", "true");
  svg.setAttribute("class", "icon");
  const path = document.createElementNS(space, "path");
  path.setAttribute("d", drawings[name]);
  svg.append(path);
  return svg;
}
