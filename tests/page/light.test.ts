// What the page loads, in which order, and where it is unpacked.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { colourAt, drawn, open, packedImage, replaceImages } from "./browser";
import { report } from "./runs";
import { startSession } from "./session";

const session = startSession("small");
const values = "#/case/m1_values/values/one?mode=flip";

const previewed = (page: Page, name: string) =>
  page.waitForFunction(
    (wanted) =>
      document.querySelector<HTMLCanvasElement>(".stage canvas")?.dataset["preview"] === wanted,
    name,
  );

test("the small PNG is shown until the floats are there, and is then replaced", async () => {
  const { page, errors } = await open(session.browser, "about:blank");
  let release = (): void => undefined;
  const held = new Promise<void>((resolve) => (release = resolve));
  const asked: string[] = [];
  page.on("request", (request) => asked.push(new URL(request.url()).pathname));
  await page.route("**/image/**/result.exr*", async (route) => {
    await held;
    await route.fulfill({
      body: packedImage(64, 48, { R: () => 0, G: () => 1, B: () => 0 }),
    });
  });
  await page.goto(`${session.url}${values}`);
  await previewed(page, "result");
  await page.getByText("Preview: the values of result are loading").waitFor();
  const box = await page.locator(".stage").boundingBox();
  const middle = [(box?.width ?? 0) / 2, (box?.height ?? 0) / 2] as const;
  // The ramp of the fixture has R = x / 64 there: 0.5, which is 188 on the screen.
  assert.ok(Math.abs(((await colourAt(page, ...middle))[0] ?? 0) - 188) < 4);
  // What depends on the values waits for them.
  assert.equal(await page.locator(".statistics").count(), 0);
  release();
  await drawn(page, "result");
  assert.deepEqual(await colourAt(page, ...middle), [0, 255, 0]);
  const places = ["/preview/", "/image/"].map((part) =>
    asked.findIndex((path) => path.includes(part)),
  );
  assert.ok(places[0]! >= 0 && places[0]! < places[1]!, asked.join(" "));
  assert.deepEqual(errors, []);
  await page.close();
});

test("an image without a preview is loaded all the same", async () => {
  const { page } = await open(session.browser, "about:blank");
  await page.route("**/preview/**", (route) => route.fulfill({ status: 422, body: "none" }));
  await page.goto(`${session.url}${values}`);
  await drawn(page, "result");
  await page.close();
});

for (const kind of ["served", "in one file"])
  test(`images are unpacked in a worker, ${kind}`, async () => {
    const file = join(session.scratch.folder, "light.html");
    if (kind !== "served") report(join(session.scratch.folder, "small"), file);
    const start = kind === "served" ? session.url : `file://${file}`;
    const { page, errors } = await open(session.browser, `${start}${values}`);
    await drawn(page, "result");
    assert.equal(page.workers().length, 1);
    // Nothing is left of the unpacking in the page itself.
    assert.equal(
      await page.evaluate(() => performance.getEntriesByType("resource").length > 0),
      kind === "served",
    );
    assert.deepEqual(errors, []);
    await page.close();
  });

test("a broken image is named and does not stop the others", async () => {
  const { page } = await open(session.browser, "about:blank");
  await replaceImages(page, { "result.exr": packedImage(8, 8, { R: () => 1 }).subarray(0, 40) });
  await page.goto(`${session.url}${values}`);
  await page.locator(".stage-note[role=alert]", { hasText: "result:" }).waitFor();
  await page.keyboard.press("2");
  await drawn(page, "reference");
  await page.close();
});

test("what a target needs for its first paint is below 200 kB", async () => {
  const { page } = await open(session.browser, "about:blank");
  const network = await page.context().newCDPSession(page);
  await network.send("Network.enable");
  let bytes = 0;
  network.on("Network.loadingFinished", (event) => (bytes += event.encodedDataLength));
  // Floats come after the preview; they would count what comes after the first paint.
  await page.route("**/image/**", () => undefined);
  await page.goto(`${session.url}${values}`);
  await previewed(page, "result");
  // 1.6 Mbit/s are 200 kB/s: a second, which leaves another one for six round trips of 150 ms.
  assert.ok(bytes > 50_000 && bytes < 200_000, `${bytes} bytes`);
  await page.close();
});
