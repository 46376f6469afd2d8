import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
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

test("the overview of 10 000 cells can be used within a second", async () => {
  const { page, errors } = await open(browser, "about:blank");
  let milliseconds = Infinity;
  // The best of ten: what else the machine does is not the page's doing.
  for (let i = 0; i < 10 && milliseconds >= 1000; ++i) {
    await page.goto("about:blank");
    const begin = Date.now();
    await page.goto(served.url);
    await page.locator(".cell a").first().waitFor();
    // Interactive: a filter typed now has its effect.
    await page.locator(".search input").fill("scene-777");
    await page.waitForFunction(() => document.querySelectorAll(".row.requirement").length === 1);
    milliseconds = Math.min(milliseconds, Date.now() - begin);
  }
  await page.goto(`${served.url}#/?by=picture`);
  await page.waitForFunction(() => document.querySelector("[role=table]")?.getAttribute("aria-rowcount") === "1001");
  assert.ok((await page.locator(".row").count()) < 100, "only the rows in sight are there");
  await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
  await page.waitForFunction(() => document.querySelector('[aria-rowindex="1001"]'));
  assert.ok(milliseconds < 1000, `${milliseconds} ms`);
  assert.deepEqual(errors, []);
  await page.close();
});

test("a pair of 4096 x 4096 pixels can be used", async () => {
  const { page, errors } = await open(browser, "about:blank");
  page.setDefaultTimeout(30000);
  await page.goto(`${served.url}#/case/m1_huge/huge/one?run=huge`);
  await drawn(page, "result");
  await page.getByText("100 pixels differ").waitFor();
  await page.keyboard.press("u");
  await page.waitForFunction(() => document.querySelector(".readout h3")?.textContent?.includes("4000, 4000"));
  await drawn(page, "result");
  const box = await page.locator(".stage").boundingBox();
  const [x, y] = [(box?.width ?? 0) / 2, (box?.height ?? 0) / 2];
  assert.equal((await colourAt(page, x, y))[2], 255);
  let milliseconds = Infinity;
  for (let i = 0; i < 10 && milliseconds >= 1000; ++i) {
    await page.keyboard.press("1");
    await drawn(page, "result");
    const begin = Date.now();
    await page.keyboard.press("2");
    await drawn(page, "reference");
    milliseconds = Math.min(milliseconds, Date.now() - begin);
  }
  assert.ok(milliseconds < 1000, `a flip took ${milliseconds} ms at best`);
  assert.ok(((await colourAt(page, x, y))[2] ?? 0) < 200);
  assert.deepEqual(errors, []);
  await page.close();
});
