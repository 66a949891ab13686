import uPlot from "uplot";
import { element } from "./dom.ts";
import { theme_changes, themeColour } from "./theme.ts";

export interface Plot {
  title: string;
  /** What the plot says, for those who do not see it. */
  summary: string;
  x_label: string;
  x: number[];
  /** Null: the line ends, and begins anew at the next value. */
  y: (number | null)[];
  kind: "bars" | "line";
  /** Of the values down the side: "%" or "". */
  unit: string;
  testid: string;
}

const kHeight_px = 150;

/** A plot with its heading. It is drawn anew when the colours of the page change. */
export function plotFigure(plot: Plot): HTMLElement {
  const area = element("div", { class: "plot", role: "img", "aria-label": `${plot.title}. ${plot.summary}`, "data-testid": plot.testid });
  const figure = element("figure", {}, element("figcaption", {}, plot.title), area, element("p", { class: "note" }, plot.summary));
  let drawn: uPlot | null = null;
  const draw = (): void => {
    drawn?.destroy();
    drawn = new uPlot(options(plot, area.clientWidth), [plot.x, plot.y], area);
  };
  new ResizeObserver(() => {
    if (area.clientWidth === 0) return;
    if (drawn) drawn.setSize({ width: area.clientWidth, height: kHeight_px });
    else draw();
  }).observe(area);
  theme_changes.watch(() => drawn && area.isConnected && draw());
  return figure;
}

function options(plot: Plot, width: number): uPlot.Options {
  const [ink, line, accent, tint] = ["ink-soft", "line", "accent", "tint"].map(themeColour) as [string, string, string, string];
  const axis: uPlot.Axis = {
    stroke: ink,
    font: "11px system-ui, sans-serif",
    grid: { stroke: line, width: 1 },
    ticks: { show: false },
  };
  const bars = plot.kind === "bars";
  const step = bars && plot.x.length > 1 ? plot.x[1]! - plot.x[0]! : 0;
  return {
    width,
    height: kHeight_px,
    legend: { show: false },
    cursor: { show: false },
    padding: [8, 18, 0, 0],
    scales: {
      x: { time: false, range: (_self, from, to) => [from - step / 2, to + step / 2] },
      y: { range: (_self, _from, to) => [0, to > 0 ? to * 1.06 : 1] },
    },
    axes: [
      {
        ...axis,
        size: 24,
        space: 44,
        grid: { show: false },
        label: plot.x_label,
        labelSize: 14,
        labelGap: 0,
        labelFont: "11px system-ui, sans-serif",
      },
      { ...axis, size: 44, space: 22, values: (_self, values) => values.map((value) => `${value.toLocaleString("en")}${plot.unit}`) },
    ],
    series: [
      {},
      {
        stroke: accent,
        fill: bars ? accent : tint,
        width: bars ? 0 : 1.5,
        points: { show: false },
        ...(bars ? { paths: uPlot.paths.bars!({ size: [0.86], align: 0 }) } : {}),
      },
    ],
  };
}
