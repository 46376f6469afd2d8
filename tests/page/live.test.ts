// Live runs, and responses that are late or missing.
import assert from "node:assert/strict";
import type { ChildProcess } from "node:child_process";
import { join } from "node:path";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { changeOverview, open, settled } from "./browser";
import { playLive, serve, type Served } from "./runs";
import { startSession } from "./session";

const session = startSession("small", "before");

/** A live run of three renders, and a page that has not opened it yet. */
async function live(name: string): Promise<{
  run: ChildProcess;
  served: Served;
  page: Page;
  errors: string[];
  end: () => Promise<void>;
}> {
  const folder = join(session.scratch.folder, name);
  const run = await playLive(folder);
  const served = await serve(folder);
  const { page, errors } = await open(session.browser, "about:blank");
  const end = async (): Promise<void> => {
    await page.close();
    run.stdin?.end();
    served.process.kill("SIGTERM");
  };
  return { run, served, page, errors, end };
}

const overview = "#/?by=target&order=given";
const passed = (page: Page, count: number) =>
  page.waitForFunction(
    (wanted) => document.querySelectorAll(".cell a.tone-good").length === wanted,
    count,
  );

test("a live run fills its cells as renders end", async () => {
  const { run, served, page, errors, end } = await live("fills");
  await page.goto(served.url + overview);
  await page.getByText("0 of 3 renders done").waitFor();
  run.stdin?.write("one\n");
  await page.getByText("1 of 3 renders done, 1 running, 1 left, about 20.0 s to go").waitFor();
  const cells = page.locator(".cell a .word");
  await passed(page, 1);
  assert.deepEqual(await cells.allInnerTexts(), ["pass", "running", "waiting"]);
  run.stdin?.write("two\nthree\n");
  run.stdin?.end();
  await page.waitForFunction(() => !document.querySelector(".live"));
  assert.deepEqual(await cells.allInnerTexts(), ["pass", "fail", "fail"]);
  assert.deepEqual(errors, []);
  await end();
});

test("a live run stays visible if one request fails, and is requested again", async () => {
  const { run, served, page, end } = await live("breaks");
  let isBroken = false;
  await page.route("**/overview.json", (route) =>
    isBroken ? route.fulfill({ status: 500, body: "the disk is gone" }) : route.continue(),
  );
  await page.goto(served.url + overview);
  await page.getByText("0 of 3 renders done").waitFor();
  isBroken = true;
  run.stdin?.write("one\n");
  await page.getByText("the disk is gone").waitFor();
  assert.equal(await page.locator(".cell a .word").count(), 3);
  isBroken = false;
  await passed(page, 1);
  await page.getByText("1 of 3 renders done").waitFor();
  await end();
});

test("of two responses the page shows the one that was requested later", async () => {
  const { run, served, page, end } = await live("overlaps");
  let release = (): void => undefined;
  const released = new Promise<void>((resolve) => (release = resolve));
  let requests = 0;
  let oldGiven: Promise<void> | undefined;
  await page.route("**/overview.json", async (route) => {
    const number = ++requests;
    const response = await route.fetch();
    if (number === 2) await released; // requested after the first update of the run
    const given = route.fulfill({ response });
    if (number === 2) oldGiven = given;
    await given;
  });
  await page.goto(served.url + overview);
  await page.getByText("0 of 3 renders done").waitFor();
  run.stdin?.write("one\n");
  await passed(page, 1);
  const finished = page.waitForEvent("requestfinished");
  release();
  await finished;
  await oldGiven;
  await settled(page);
  assert.equal(await page.locator(".cell a.tone-good").count(), 1);
  await end();
});

test("without the server the page says so and keeps its data", async () => {
  const { served, page, end } = await live("ends");
  await page.goto(served.url + overview);
  await page.getByText("0 of 3 renders done").waitFor();
  served.process.kill("SIGKILL");
  await page.getByText("the server does not answer").waitFor();
  assert.equal(await page.locator(".cell a .word").count(), 3);
  await end();
});

test("a run that ends before the page follows it is shown as finished", async () => {
  const { page, errors } = await open(session.browser, "about:blank");
  // The server responds with 204 to a request to follow a finished run.
  await changeOverview(page, ({ run }, request) => (run.live = request === 1));
  await page.goto(`${session.url}#/`);
  await page.locator(".grid .row").first().waitFor();
  await page.waitForFunction(() => !document.querySelector(".live"));
  assert.deepEqual(errors, []);
  await page.close();
});

test("a late response about a run that is no longer shown is ignored", async () => {
  const { page, errors } = await open(session.browser, "about:blank");
  let release = (): void => undefined;
  const released = new Promise<void>((resolve) => (release = resolve));
  await page.route("**/data/0/overview.json", async (route) => {
    await released;
    await route.continue();
  });
  await page.goto(session.url);
  await page.getByText("Reading the run").waitFor();
  await page.getByRole("combobox", { name: "Run" }).selectOption("before");
  await page.locator(".grid .row").first().waitFor();
  const finished = page.waitForEvent("requestfinished", (request) =>
    request.url().endsWith("/data/0/overview.json"),
  );
  release();
  await finished;
  await settled(page);
  assert.equal(await page.getByText("Reading the run").count(), 0);
  assert.ok((await page.locator(".grid .row").count()) > 1);
  assert.deepEqual(errors, []);
  await page.close();
});

test("a server that was restarted with other runs is detected", async () => {
  const { page } = await open(session.browser, "about:blank");
  await changeOverview(page, ({ run }) => (run.name = "another"));
  await page.goto(`${session.url}#/`);
  await page.getByText("expected the run 'small' and found 'another'").waitFor();
  await page.close();
});
