import type { Result } from "./result.ts";

/** Something that a search can find: a drawing, or a group of drawings. */
export interface Found {
  kind: "drawing" | "group";
  /** Index into the shapes or the groups. */
  index: number;
  name: string;
  /** Number of pieces. */
  pieces: number;
}

/** Letters alone count: "Étoile" is found by "etoile". */
export function foldedName(name: string): string {
  return name.normalize("NFKD").replace(/\p{M}/gu, "").toLowerCase();
}

/** All drawings and groups that have pieces; those with the most pieces first. */
export function searchables(result: Result): Found[] {
  const drawings = result.data.shapes.name.map((name, index) => ({
    kind: "drawing" as const,
    index,
    name,
    pieces: result.uses[index]!.length,
  }));
  const groups = result.data.groups.map((name, index) => ({
    kind: "group" as const,
    index,
    name,
    pieces: result.data.pieces.group.filter((group) => group === index).length,
  }));
  const all: Found[] = [...groups, ...drawings];
  return all.filter((found) => found.pieces > 0).sort((a, b) => b.pieces - a.pieces || a.name.localeCompare(b.name, "en"));
}

/** Those whose name contains every word of the text. */
export function matches(all: readonly Found[], text: string): Found[] {
  const words = foldedName(text).split(/\s+/).filter(Boolean);
  return all.filter((found) => {
    const name = foldedName(found.name);
    return words.every((word) => name.includes(word));
  });
}
