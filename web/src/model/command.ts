import type { Marks } from "../data.ts";

/** With more pieces than this the command takes a file. */
const kMostOnCommandLine = 40;

/** A word for a POSIX shell, quoted only where it must be. */
export function shellQuoted(word: string): string {
  return /^[A-Za-z0-9_@%+=:,./-]+$/.test(word) ? word : `'${word.replaceAll("'", `'\\''`)}'`;
}

/** Whether the command refers to the file of marks. */
export function needsFile(marks: Marks): boolean {
  return marks.pieces.length + marks.lock.length > kMostOnCommandLine;
}

/** The folder of a result as a word of a command. One that begins with a dash would look like an option. */
export function folderWord(folder: string): string {
  return shellQuoted(folder.startsWith("-") ? `./${folder}` : folder);
}

/** The command that fills the result anew as marked; at least one piece is to be erased. `seed`: null for the job's. */
export function refineCommand(folder: string, marks: Marks, seed: number | null = null): string {
  const words = ["tessera", "refine", folderWord(folder)];
  if (needsFile(marks)) {
    words.push("--marks", "marks.json");
  } else {
    words.push(marks.action === "swap" ? "--swap" : "--pieces", marks.pieces.join(","));
    if (marks.lock.length > 0) words.push("--lock", marks.lock.join(","));
  }
  if (seed !== null) words.push("--set", `seed=${seed}`);
  return words.join(" ");
}
