// Numbers as people read them. Always in English, as the rest of the page.

const whole = new Intl.NumberFormat("en", { maximumFractionDigits: 0 });

/** 20359 -> "20,359". */
export function count(value: number): string {
  return whole.format(value);
}

/** With thousands separators and exactly that many decimals. */
export function fixed(value: number, decimals: number): string {
  return value.toLocaleString("en", { minimumFractionDigits: decimals, maximumFractionDigits: decimals });
}

/** 0.9019 -> "90.2 %"; small ones keep two decimals. No line ends before the sign. */
export function percent(fraction: number): string {
  const value = 100 * fraction;
  return `${fixed(value, Math.abs(value) < 1 ? 2 : 1)}\u00a0%`;
}

/** "1 piece", "2 pieces". */
export function counted(value: number, noun: string): string {
  return `${count(value)} ${noun}${value === 1 ? "" : "s"}`;
}

/** 196.9 -> "3 min 17 s". */
export function duration(seconds: number): string {
  if (seconds < 60) return `${fixed(seconds, seconds < 10 ? 2 : 1)} s`;
  const rounded = Math.round(seconds);
  const hours = Math.floor(rounded / 3600);
  const minutes = Math.floor((rounded % 3600) / 60);
  return hours > 0 ? `${hours} h ${minutes} min` : `${minutes} min ${rounded % 60} s`;
}
