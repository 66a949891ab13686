import assert from "node:assert/strict";
import { test } from "node:test";
import { needsFile, refineCommand, shellQuoted } from "../src/model/command.ts";
import { MarkSet } from "../src/model/mark_set.ts";

test("marks are kept, changed and undone a step at a time", () => {
  const marks = new MarkSet();
  marks.beginStep();
  assert.deepEqual(marks.mark([5, 3], "erase"), [5, 3]);
  assert.deepEqual(marks.mark([3, 9], "erase"), [9]); // the same stroke
  marks.beginStep();
  marks.mark([3], "lock");
  assert.deepEqual([marks.pieces("erase"), marks.pieces("lock")], [[5, 9], [3]]);
  assert.deepEqual(marks.undo(), [3]);
  assert.deepEqual(marks.pieces("erase"), [3, 5, 9]);
  assert.deepEqual(marks.undo().sort(), [3, 5, 9]);
  assert.equal(marks.canUndo, false);
  assert.deepEqual(marks.undo(), []);
});

test("what changes nothing is no step; clearing is one", () => {
  const marks = new MarkSet();
  marks.beginStep();
  marks.mark([1], "erase");
  marks.beginStep();
  assert.deepEqual(marks.mark([1], "erase"), []);
  assert.deepEqual(marks.clear(), [1]);
  assert.equal(marks.size, 0);
  marks.undo();
  assert.deepEqual(marks.pieces("erase"), [1]);
});

test("a step can be cancelled, once something was marked in it", () => {
  const marks = new MarkSet();
  marks.mark([1], "erase");
  marks.beginStep();
  assert.deepEqual(marks.cancelStep(), []);
  marks.mark([2], "erase");
  assert.deepEqual(marks.cancelStep(), [2]);
  assert.deepEqual(marks.pieces("erase"), [1]);
});

test("the file of marks", () => {
  const marks = new MarkSet();
  marks.mark([17, 3], "erase");
  marks.mark([4], "lock");
  assert.deepEqual(marks.toFile("abc", "swap"), { format: 1, pieces_digest: "abc", action: "swap", pieces: [3, 17], lock: [4] });
});

test("the command", () => {
  const marks = { format: 1, pieces_digest: "", action: "erase" as const, pieces: [3, 17], lock: [4] };
  assert.equal(refineCommand("out/animals", marks), "tessera refine out/animals --pieces 3,17 --lock 4");
  assert.equal(refineCommand("out/animals", { ...marks, action: "swap", lock: [] }), "tessera refine out/animals --swap 3,17");
  const many = { ...marks, pieces: Array.from({ length: 41 }, (_, index) => index) };
  assert.equal(needsFile(many), true);
  assert.equal(refineCommand("out/animals", many), "tessera refine out/animals --marks marks.json");
  assert.equal(refineCommand("out/animals", { ...marks, lock: [] }, 7), "tessera refine out/animals --pieces 3,17 --set seed=7");
  assert.equal(refineCommand("-rf", marks), "tessera refine ./-rf --pieces 3,17 --lock 4");
});

test("words are quoted for a POSIX shell when they must be", () => {
  assert.equal(shellQuoted("out/a-b_c.1"), "out/a-b_c.1");
  assert.equal(shellQuoted("my drawings"), "'my drawings'");
  assert.equal(shellQuoted("it's; rm $(x)"), "'it'\\''s; rm $(x)'");
  assert.equal(shellQuoted(""), "''");
  assert.equal(shellQuoted("~"), "'~'");
});
