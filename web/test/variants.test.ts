import assert from "node:assert/strict";
import { test } from "node:test";
import type { RefineRequest } from "../src/data.ts";
import type { Result } from "../src/model/result.ts";
import { Variants } from "../src/result/variants.ts";

type State = Partial<Variants["running"]> & { name: string };

/** A server whose results the test sets; the answer to `data` comes when the test lets it come. */
class FakeServer {
  results: State[] = [];
  states_asked = 0;
  refined = 0;
  answerData: () => void = () => {};

  readonly fetch = async (path: string): Promise<Response> => {
    if (path === "state") {
      ++this.states_asked;
      return Response.json({ results: this.results });
    }
    if (path === "refine") return Response.json({ name: `a-${++this.refined + 1}` }, { status: 202 });
    await new Promise<void>((resolve) => {
      this.answerData = resolve;
    });
    return Response.json({ error: "no data" }, { status: 400 });
  };
}

const request = { result: "a" } as RefineRequest;
const first = { data: { name: "a", picture: {} } } as unknown as Result;
const running = (name: string): State => ({ name, state: "running", has_pieces: false, has_picture: false, message: "", from: "a" });
const until = async (condition: () => boolean): Promise<void> => {
  for (let tries = 0; tries < 200 && !condition(); ++tries) await new Promise((resolve) => setTimeout(resolve, 10));
  assert.ok(condition());
};

test("a refinement that begins while the last one's picture loads is followed to its end", async (t) => {
  const server = new FakeServer();
  t.mock.method(globalThis, "fetch", server.fetch);
  const variants = new Variants(first, () => {});
  await until(() => server.states_asked === 1);
  void variants.refine(request);
  await until(() => server.refined === 1);
  server.results = [{ ...running("a-2"), state: "finished", has_pieces: true, has_picture: true }];
  let asked = 0;
  await until(() => variants.list.get().length === 1);
  void variants.refine(request); // the page still waits for the data of a-2
  await until(() => server.refined === 2);
  server.results = [...server.results, running("a-3")];
  server.answerData();
  await until(() => variants.running?.name === "a-3");
  server.results = [server.results[0]!, { ...running("a-3"), state: "failed", message: "no room" }];
  await until(() => variants.trouble.get() === "a-3: no room");
  asked = server.states_asked;
  await new Promise((resolve) => setTimeout(resolve, 250));
  assert.equal(server.states_asked, asked, "nothing runs, and the page still asks");
});

test("the page follows what runs when it is opened, and stops when the server is gone", async (t) => {
  const server = new FakeServer();
  server.results = [running("a-2")];
  let gone = false;
  t.mock.method(globalThis, "fetch", (path: string) => (gone ? Promise.reject(new Error("no connection")) : server.fetch(path)));
  const variants = new Variants(first, () => {});
  await until(() => server.states_asked >= 3);
  gone = true;
  await until(() => variants.trouble.get().startsWith("The server does not answer"));
  await until(() => variants.running === undefined);
  const asked = server.states_asked;
  await new Promise((resolve) => setTimeout(resolve, 250));
  assert.equal(server.states_asked, asked);
});
