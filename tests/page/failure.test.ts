// Failures show themselves: how they open, scales of differences, noise, and what is wrong in words.
import assert from "node:assert/strict";
import { test } from "node:test";
import { gunzipSync, gzipSync } from "node:zlib";
import type { Page } from "playwright-core";
import { colourAt, drawn, open, packedImage, replaceImages } from "./browser";
import { output } from "./runs";
import { startSession } from "./session";

const session = startSession("small");
const failing = "#/case/m1_values/values/one";
const passing = "#/case/m1_values/values/two";

const grey = (value: number) => ({ R: () => value, G: () => value, B: () => value });

/** An image that also has a layer of variances, as its header says. */
function withVariance(image: Buffer): Buffer {
  const bytes = gunzipSync(image);
  const length = bytes.readUInt32LE(0);
  const header = JSON.parse(bytes.subarray(4, 4 + length).toString()) as { layers: string[] };
  header.layers = ["", "variance"];
  const text = Buffer.from(JSON.stringify(header));
  const padded = Buffer.alloc(Math.ceil((4 + text.length) / 8) * 8 - 4, " ");
  text.copy(padded);
  const size = Buffer.alloc(4);
  size.writeUInt32LE(padded.length);
  return gzipSync(Buffer.concat([size, padded, bytes.subarray(4 + length)]));
}

/** Result and reference with variances of their own; a colour by a function of the place. */
async function replaceWithNoise(
  page: Page,
  files: Record<string, { colour: Buffer; variance: Buffer }>,
): Promise<void> {
  for (const [file, { colour, variance }] of Object.entries(files))
    await page.route(`**/image/**/${file}*`, (route) =>
      route.fulfill({
        body: route.request().url().includes("variance") ? variance : withVariance(colour),
      }),
    );
}

test("a failure opens with its reference and the difference, a pass as one image", async () => {
  const { page, errors } = await open(session.browser, `${session.url}${failing}`);
  await drawn(page, "result reference difference");
  assert.ok(!page.url().includes("mode="), page.url());
  await page.getByRole("figure", { name: "Colour scale of difference" }).waitFor();
  await page.keyboard.press("2");
  await drawn(page, "reference");
  await page.waitForFunction(() => location.hash.includes("img=reference"));
  await page.getByRole("button", { name: "Side by side" }).click();
  await page.waitForFunction(() => location.hash.includes("mode=side"));
  await page.keyboard.press("1");
  await drawn(page, "result");
  await page.waitForFunction(() => location.hash.includes("mode=flip"));
  const link = page.url();
  await page.goto("about:blank");
  await page.goto(link);
  await drawn(page, "result");
  await page.goto("about:blank");
  await page.goto(`${session.url}${passing}`);
  await drawn(page, "result");
  assert.deepEqual(errors, []);
  await page.close();
});

test("the scale of a difference ends at a percentile, unless a number is chosen", async () => {
  const { page, errors } = await open(session.browser, "about:blank");
  // One pixel in 1000 is wrong by 8, the others by 0.001 to 0.003.
  const result = packedImage(100, 100, {
    ...grey(0),
    R: (x, y) => (x % 10 === 0 && y % 100 === 0 ? 8 : x < 50 ? 0.001 : 0.003),
  });
  await replaceImages(page, { "result.exr": result, "values.exr": packedImage(100, 100, grey(0)) });
  await page.goto(`${session.url}${failing}?img=difference`);
  await drawn(page, "difference");
  const end = page.getByRole("spinbutton", { name: "ends at" });
  const scale = page.getByRole("combobox", { name: "End of the scale" });
  assert.equal(await end.inputValue(), "0.003");
  assert.match(await page.locator(".legend .ticks").innerText(), /0\.003/);
  await scale.selectOption({ label: "largest pixel" });
  await page.waitForFunction(() => location.hash.includes("scale=100"));
  assert.equal(await end.inputValue(), "8");
  await scale.selectOption({ label: "fixed: 0.2" });
  await page.waitForFunction(() => location.hash.includes("scale=fixed"));
  assert.equal(await end.inputValue(), "0.2");
  await end.fill("0.5");
  await end.press("Tab");
  await page.waitForFunction(() => location.hash.includes("ends="));
  assert.equal(await scale.locator("option:checked").innerText(), "as typed");
  await scale.selectOption({ label: "99 % of pixels" });
  await page.waitForFunction(() => !location.hash.includes("ends="));
  assert.equal(await end.inputValue(), "0.003");
  assert.deepEqual(errors, []);
  await page.close();
});

test("a difference over its noise is grey within it, and hatched without any", async () => {
  const { page, errors } = await open(session.browser, "about:blank");
  // From the left: 1 sigma, 10 sigma, -10 sigma, no noise.
  const offset = (x: number): number => [0.1, 1, -1, 0.5][Math.floor(x / 16)] ?? 0;
  const variance = packedImage(64, 64, {
    R: (x) => (x < 48 ? 0.005 : 0),
    G: (x) => (x < 48 ? 0.005 : 0),
    B: (x) => (x < 48 ? 0.005 : 0),
  });
  const colour = (of: (x: number) => number) => packedImage(64, 64, { R: of, G: of, B: of });
  await replaceWithNoise(page, {
    "result.exr": { colour: colour((x) => 1 + offset(x)), variance },
    "values.exr": { colour: colour(() => 1), variance },
  });
  await page.goto(`${session.url}${failing}?img=difference&diff=noise&zoom=8&x=32&y=32`);
  await drawn(page, "difference");
  const box = await page.locator(".stage").boundingBox();
  const at = (x: number, y = 32) =>
    colourAt(page, (box?.width ?? 0) / 2 + 8 * (x - 32), (box?.height ?? 0) / 2 + 8 * (y - 32));
  const [r1 = 0, g1 = 0, b1 = 0] = await at(8);
  assert.ok(Math.max(r1, g1, b1) - Math.min(r1, g1, b1) < 16, `grey: ${r1}, ${g1}, ${b1}`);
  const [r2 = 0, , b2 = 0] = await at(24);
  assert.ok(r2 > b2 + 60, "red where A is larger");
  const [r3 = 0, , b3 = 0] = await at(40);
  assert.ok(b3 > r3 + 60, "blue where A is smaller");
  const hatched = new Set<number>();
  for (let x = 50; x < 62; x += 0.5) hatched.add((await at(x))[0] ?? 0);
  assert.equal(hatched.size, 2);
  const legend = await page.locator(".legend").innerText();
  assert.match(legend, /3: noise alone does this in 1 of 370 pixels/);
  assert.match(legend, /−6 σ\s+−3 σ\s+0 σ\s+3 σ\s+6 σ/);
  await page.mouse.move((box?.x ?? 0) + (box?.width ?? 0) / 2 - 64, (box?.y ?? 0) + 100);
  assert.match(await page.locator(".readout tr").last().innerText(), /\t(10|9\.99\d*)\t/);
  assert.deepEqual(errors, []);
  await page.close();
});

test("where an image states no variance, the page says so and offers no noise", async () => {
  const { page } = await open(
    session.browser,
    `${session.url}${failing}?img=difference&diff=noise`,
  );
  await page.getByText("difference: no variance is stated by").waitFor();
  const option = page
    .getByRole("combobox", { name: "Measure" })
    .locator("option", { hasText: "(A − B) / σ: no variance is stated by" });
  assert.equal(await option.count(), 1);
  assert.ok(await option.evaluate((one: HTMLOptionElement) => one.disabled));
  await page.close();
});

test("the largest region that is wrong for certain is named and outlined", async () => {
  const { page } = await open(session.browser, "about:blank");
  await page.route("**/data/*/target/*", async (route) => {
    const detail = (await (await route.fetch()).json()) as Record<string, unknown>;
    const regions = [
      { where: [8, 8, 24, 24], seen: "left wall", text: "the left wall, 4 % too dark" },
      { where: [0, 0, 8, 8], seen: "", text: "the upper left, 9 % too dark" },
    ];
    await route.fulfill({ json: { ...detail, wrong_regions: regions } });
  });
  await page.goto(`${session.url}${failing}`);
  await drawn(page, "result reference difference");
  assert.match(await page.locator(".verdict .reason").innerText(), /the left wall, 4 % too dark/);
  assert.equal(
    await page.locator(".stage .overlay").evaluate((one: HTMLElement) => one.dataset["outlined"]),
    "8,8,24,24",
  );
  await page.close();
});

test("a fault that is named comes before the region that it makes wrong", async () => {
  const { page } = await open(session.browser, "about:blank");
  const fault = "multiplied by pi: then 38.9 dB";
  await page.route("**/overview.json", async (route) => {
    const overview = (await (await route.fetch()).json()) as { reasons: string[] };
    overview.reasons = overview.reasons.map((reason) => (reason ? `${fault}; ${reason}` : ""));
    await route.fulfill({ json: overview });
  });
  await page.route("**/data/*/target/*", async (route) => {
    const detail = (await (await route.fetch()).json()) as Record<string, unknown>;
    const regions = [{ where: [8, 8, 24, 24], seen: "", text: "the left, 214 % too bright" }];
    await route.fulfill({ json: { ...detail, diagnosis: fault, wrong_regions: regions } });
  });
  await page.goto(`${session.url}${failing}`);
  await page.locator(".wrong-region").waitFor();
  assert.match(
    (await page.locator(".verdict .reason").innerText()).replaceAll("\n", " "),
    /multiplied by pi: then 38\.9 dB *the left, 214 % too bright/,
  );
  await page.close();
});

test("the number of differing pixels is that of a page in one file, which rounds to halves", async () => {
  const count = async (a: (x: number, y: number) => number, b: typeof a): Promise<string> => {
    const { page } = await open(session.browser, "about:blank");
    const image = (of: typeof a) => packedImage(64, 64, { R: of, G: () => 0.5, B: () => 0 });
    await replaceImages(page, { "result.exr": image(a), "values.exr": image(b) });
    await page.goto(`${session.url}${failing}`);
    await drawn(page, "result reference difference");
    await page.locator(".worst-count", { hasText: "differ" }).waitFor();
    const text = await page.locator(".worst-count").innerText();
    await page.close();
    return text;
  };
  // From 1 to 2 halves are 1/1024 apart. A quarter of that is a difference in one of four pixels.
  const exact = (x: number, y: number): number => 1 + (64 * y + x + 0.25) / 4096 / 1.1;
  const other = (x: number, y: number): number => exact(x, y) + 1 / 4096;
  const rounded = (of: typeof exact) => (x: number, y: number) =>
    Math.round(1024 * Math.fround(of(x, y))) / 1024;
  const served = await count(exact, other);
  assert.equal(served, await count(rounded(exact), rounded(other)));
  const differing = Number(/^\d+/.exec(served)?.[0]);
  assert.ok(differing > 900 && differing < 1150, served);
});

test("the number of differing pixels is the same served and in one file", async () => {
  const count = async (address: string): Promise<string> => {
    const { page } = await open(session.browser, address);
    await drawn(page, "result reference difference");
    await page.locator(".worst-count", { hasText: "differ" }).waitFor();
    const text = await page.locator(".worst-count").innerText();
    await page.close();
    return text;
  };
  const file = `${session.scratch.folder}/report.html`;
  output("report", session.folder, "-o", file); // rounded to halves
  const served = await count(`${session.url}${failing}`);
  assert.equal(await count(`file://${file}${failing}`), served);
});
