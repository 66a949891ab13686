// Colour ramps that keep their order for colour-blind eyes and in grey: viridis, inferno and cividis of matplotlib, a few of their colours.

export const kViridis = ["#440154", "#414487", "#2a788e", "#22a884", "#7ad151", "#fde725"];
export const kInferno = ["#fcffa4", "#fbb61a", "#ed6925", "#bc3754", "#781c6d", "#320a5e"];
export const kCividis = ["#fee838", "#bcaf6f", "#7c7b78", "#3b496c", "#00224e"];

/** "#rrggbb" -> [r, g, b]. */
export function channels(colour: string): [number, number, number] {
  const value = Number.parseInt(colour.slice(1), 16);
  return [(value >> 16) & 255, (value >> 8) & 255, value & 255];
}

/** The colour of a ramp at t of 0 to 1. */
export function rampColour(ramp: readonly string[], t: number): string {
  const at = Math.max(0, Math.min(1, t)) * (ramp.length - 1);
  const index = Math.min(ramp.length - 2, Math.floor(at));
  const [from, to] = [channels(ramp[index]!), channels(ramp[index + 1]!)];
  const mixed = from.map((value, channel) => Math.round(value + (to[channel]! - value) * (at - index)));
  return `rgb(${mixed.join(",")})`;
}

/** Colours for drawings where there is no picture: calm, and different for neighbouring numbers. */
export function flatColour(number: number): string {
  const hue = (number * 137.508) % 360;
  return `hsl(${hue.toFixed(0)} ${28 + (number % 3) * 8}% ${52 + (number % 4) * 6}%)`;
}
