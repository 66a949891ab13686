export type Direction = "ascending" | "descending";

/** The indices of `values` in order. Missing values stand last either way; equal ones keep their order. */
export function sortedIndices(values: readonly (number | string | null)[], direction: Direction): number[] {
  const sign = direction === "ascending" ? 1 : -1;
  return values
    .map((_value, index) => index)
    .sort((a, b) => {
      const [left, right] = [values[a] ?? null, values[b] ?? null];
      if (left === null || right === null) return Number(left === null) - Number(right === null);
      if (typeof left === "string" || typeof right === "string") return sign * String(left).localeCompare(String(right), "en");
      return sign * (left - right);
    });
}
