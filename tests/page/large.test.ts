import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { colourAt, drawn, launch, open, Scratch, serve, type Served } from "./stand";

const scratch = new Scratch();
let browser: Browser;
let served: Served;

before(async () => {
  browser = await launch();
  served = await serve(scratch.run("many"), scratch.run("huge"));
});

after(async () => {
  await browser?.close();
  served?.process.kill("SIGTERM");
  scratch.remove();
});

/** Fills with what the page asks the server for from now on. */
function requestsForData(page: Page): string[] {
  const asked: string[] = [];
  page.on("request", (request) => {
    if (!request.url().endsWith("/icon.svg")) asked.push(request.url());
  });
  return asked;
}

test("the overview of 10 000 cells builds only what is in surface", async () => {
  const { page, errors } = await open(browser, `${served.url}#/?by=target`);
  await page.waitForFunction(
    () => document.querySelector("[role=table]")?.getAttribute("aria-rowcount") === "1001",
  );
  const asked = requestsForData(page);
  const built = () => page.evaluate(() => document.querySelectorAll("*").length);
  // 40 rows of 22 px fill the window; ten cells and a heading each, some elements a cell.
  assert.ok((await page.locator(".row").count()) < 100, "only the rows in surface are there");
  assert.ok((await built()) < 10000, `${await built()} elements`);
  await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
  await page.waitForFunction(() => document.querySelector('[aria-rowindex="1001"]'));
  assert.ok((await page.locator(".row").count()) < 100, "rows out of surface are gone");
  await page.locator(".search input").fill("scene-777");
  await page.waitForFunction(
    () => document.querySelector("[role=table]")?.getAttribute("aria-rowcount") === "2",
  );
  assert.deepEqual(asked, [], "scrolling and searching ask the server nothing");
  assert.deepEqual(errors, []);
  await page.close();
});

test("a pair of 4096 x 4096 pixels can be used", async () => {
  const { page, errors } = await open(browser, "about:blank");
  page.setDefaultTimeout(120000);
  await page.goto(`${served.url}#/case/m1_huge/huge/one?run=huge`);
  await drawn(page, "result");
  await page.getByText("100 pixels differ").waitFor();
  await page.keyboard.press("u");
  await page.waitForFunction(() =>
    document.querySelector(".readout h3")?.textContent?.includes("4000, 4000"),
  );
  await drawn(page, "result");
  const box = await page.locator(".stage").boundingBox();
  const [x, y] = [(box?.width ?? 0) / 2, (box?.height ?? 0) / 2];
  assert.equal((await colourAt(page, x, y))[2], 255);
  // What makes a flip quick: both images are there, none is asked for again.
  const asked = requestsForData(page);
  for (const [key, target] of [
    ["1", "result"],
    ["2", "reference"],
    ["1", "result"],
    ["2", "reference"],
  ] as const) {
    await page.keyboard.press(key);
    await drawn(page, target);
  }
  assert.deepEqual(asked, []);
  assert.ok(((await colourAt(page, x, y))[2] ?? 0) < 200);
  assert.deepEqual(errors, []);
  await page.close();
});
