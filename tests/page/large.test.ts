import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { colourAt, drawn, open } from "./browser";
import { startSession } from "./session";

const session = startSession("many", "huge");

/** The addresses that the page requests from now on. */
function requestsForData(page: Page): string[] {
  const requested: string[] = [];
  page.on("request", (request) => {
    if (!request.url().endsWith("/icon.svg")) requested.push(request.url());
  });
  return requested;
}

test("the overview of 10 000 cells creates only visible rows", async () => {
  const { page, errors } = await open(session.browser, `${session.url}#/?by=target`);
  await page.waitForFunction(
    () => document.querySelector("[role=table]")?.getAttribute("aria-rowcount") === "1001",
  );
  const requested = requestsForData(page);
  const built = () => page.evaluate(() => document.querySelectorAll("*").length);
  // About 40 rows fit into the window; each has ten cells and a heading, of several elements.
  assert.ok((await page.locator(".row").count()) < 100, "only visible rows are in the document");
  assert.ok((await built()) < 10000, `${await built()} elements`);
  await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
  await page.waitForFunction(() => document.querySelector('[aria-rowindex="1001"]'));
  assert.ok((await page.locator(".row").count()) < 100, "rows that left the window are removed");
  await page.locator(".search input").fill("scene-777");
  await page.waitForFunction(
    () => document.querySelector("[role=table]")?.getAttribute("aria-rowcount") === "2",
  );
  assert.deepEqual(requested, [], "scrolling and searching request nothing");
  assert.deepEqual(errors, []);
  await page.close();
});

test("a pair of 4096 x 4096 pixels can be used", async () => {
  const { page, errors } = await open(session.browser, "about:blank");
  page.setDefaultTimeout(120000);
  await page.goto(`${session.url}#/case/m1_huge/huge/one?run=huge&mode=flip`);
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
  // A flip is fast because both images are loaded: none is requested again.
  const requested = requestsForData(page);
  for (const [key, image] of [
    ["1", "result"],
    ["2", "reference"],
    ["1", "result"],
    ["2", "reference"],
  ] as const) {
    await page.keyboard.press(key);
    await drawn(page, image);
  }
  assert.deepEqual(requested, []);
  assert.ok(((await colourAt(page, x, y))[2] ?? 0) < 200);
  assert.deepEqual(errors, []);
  await page.close();
});
