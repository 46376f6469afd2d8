// What a file of tests needs: a browser, and a server of runs that are made for the file.
import { after, before } from "node:test";
import type { Browser } from "playwright-core";
import { launch } from "./browser";
import { Scratch, serve, type Served } from "./runs";

/** Its members but `scratch` are there when the first test of the file begins, until its last one has ended. */
export interface Session {
  scratch: Scratch;
  browser: Browser;
  served: Served;
  /** Of the first run. */
  folder: string;
  /** The address of the page; the first run is shown first. */
  url: string;
}

/** Serves a run of each kind that orbs-page-fixture makes. */
export function startSession(...kinds: string[]): Session {
  const session = { scratch: new Scratch() } as Session;
  before(async () => {
    session.browser = await launch();
    const folders = kinds.map((kind) => session.scratch.run(kind));
    session.folder = folders[0] ?? "";
    session.served = await serve(...folders);
    session.url = session.served.url;
  });
  after(async () => {
    await session.browser?.close();
    session.served?.process.kill("SIGTERM");
    session.scratch.remove();
  });
  return session;
}
