import type { RefineRequest, ResultData, ServerState, Source } from "../data.ts";
import { answerSource } from "../page_source.ts";

/** Talks with `tessera serve`. Paths are relative: the page's own address holds the token. */
async function ask<T>(path: string, body?: unknown): Promise<T> {
  const send = (options: RequestInit): Promise<Response> =>
    fetch(path, options).catch(() => {
      throw new Error("The server does not answer. Start tessera serve again; all results are on the disk.");
    });
  const answer = await send({
    cache: "no-store",
    ...(body === undefined
      ? {}
      : { method: "POST", headers: { "Content-Type": "application/json", "X-Tessera": "1" }, body: JSON.stringify(body) }),
  });
  const text = await answer.text();
  if (!answer.ok) throw new Error(errorText(text) ?? `the server answered with ${answer.status}`);
  return (text === "" ? {} : JSON.parse(text)) as T;
}

function errorText(text: string): string | null {
  try {
    const { error } = JSON.parse(text) as { error?: unknown };
    return typeof error === "string" ? error : null;
  } catch {
    return null;
  }
}

export function fetchState(): Promise<ServerState> {
  return ask<ServerState>("state");
}

export async function fetchResult(name: string): Promise<Source & { data: ResultData }> {
  const { data, blocks } = await ask<{ data: ResultData; blocks: Record<string, string> }>(`data?result=${encodeURIComponent(name)}`);
  return answerSource(data, blocks) as Source & { data: ResultData };
}

/** Begins a refinement; the name of the new result. */
export async function refine(request: RefineRequest): Promise<string> {
  return (await ask<{ name: string }>("refine", request)).name;
}

export function stopRefining(): Promise<unknown> {
  return ask("stop", {});
}
