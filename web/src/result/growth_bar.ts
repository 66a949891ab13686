import { button, element } from "../ui/dom.ts";
import { icon } from "../ui/icons.ts";
import { count } from "../util/format.ts";
import type { Session } from "./session.ts";

/** At the speed 1 the whole collage grows in this time. */
const kWhole_s = 20;

/** The slider below the picture: how the collage grew, piece by piece. */
export function growthBar(session: Session): HTMLElement {
  const { growth, pieces } = session;
  const slider = element("input", {
    type: "range",
    min: 0,
    max: pieces,
    value: pieces,
    step: 1,
    "aria-label": "Pieces shown, in order of placement",
    "data-testid": "growth-slider",
  });
  const text = element("output", { class: "growth-text", "data-testid": "growth-text" });
  const speed = element("select", { class: "select", "aria-label": "Speed of growth", "data-testid": "growth-speed" });
  for (const value of [0.25, 0.5, 1, 2, 4]) speed.append(element("option", { value, selected: value === 1 }, `${value} ×`));
  const player = new Player(session, () => Number(speed.value), showPlaying);
  const play = button({ label: "Play the growth", icon: icon("play"), icon_only: true, testid: "growth-play" }, () => player.toggle());
  slider.addEventListener("input", () => {
    player.stop();
    growth.set(Number(slider.value));
  });
  growth.watch((shown) => {
    slider.value = String(shown);
    slider.setAttribute("aria-valuetext", `${count(shown)} of ${count(pieces)} pieces`);
    text.textContent = `${count(shown)} / ${count(pieces)}`;
  });

  function showPlaying(playing: boolean): void {
    const label = playing ? "Pause the growth" : "Play the growth";
    play.replaceChildren(icon(playing ? "pause" : "play"));
    play.setAttribute("aria-label", label);
    play.title = label;
  }
  return element("div", { class: "growth", role: "group", "aria-label": "Growth of the collage" }, play, slider, text, speed);
}

/** Adds pieces by the clock. It starts only when someone asks for it. */
class Player {
  private playing = false;
  private last_ms = 0;
  private shown = 0;

  constructor(
    private readonly session: Session,
    private readonly speed: () => number,
    private readonly changed: (playing: boolean) => void,
  ) {}

  toggle(): void {
    if (this.playing) return this.stop();
    const { growth, pieces } = this.session;
    if (growth.get() >= pieces) growth.set(0);
    this.shown = growth.get();
    this.playing = true;
    this.last_ms = performance.now();
    this.changed(true);
    requestAnimationFrame((now_ms) => this.tick(now_ms));
  }

  stop(): void {
    if (!this.playing) return;
    this.playing = false;
    this.changed(false);
  }

  private tick(now_ms: number): void {
    if (!this.playing) return;
    const { growth, pieces, viewer } = this.session;
    this.shown += (Math.max(0, now_ms - this.last_ms) / 1000) * (pieces / kWhole_s) * this.speed();
    this.last_ms = now_ms;
    growth.set(Math.min(pieces, Math.floor(this.shown)));
    if (growth.get() >= pieces || !viewer.canvas.isConnected) this.stop();
    else requestAnimationFrame((next_ms) => this.tick(next_ms));
  }
}
