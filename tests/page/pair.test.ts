// Any two images at one place: measures of their difference, layers, images of a cost study.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { join } from "node:path";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { drawn, open, packedImage, replaceImages } from "./browser";
import { startSession } from "./session";

const session = startSession("small", "cost");

/** The numbers of `orbs compare` for the same two images, by metric. */
function compared(result: string, reference: string): Record<string, number> {
  const orbs = join(process.env["ORBS_BINARY_DIR"] ?? "", "orbs");
  const made = spawnSync(
    orbs,
    ["compare", join(session.folder, result), join(session.folder, reference), "--all", "--json"],
    { encoding: "utf8" },
  );
  const { metrics } = JSON.parse(made.stdout) as {
    metrics: { name: string; value: number }[];
  };
  return Object.fromEntries(metrics.map(({ name, value }) => [name, value]));
}

/** The mean of the image in front, over its channels. */
async function shownMean(page: Page): Promise<number> {
  await page.locator(".statistics").first().waitFor();
  const row = page.locator(".statistics").first().locator("tr", { hasText: "mean" });
  const means = (await row.locator("td").allInnerTexts()).map(Number);
  return means.reduce((sum, one) => sum + one, 0) / means.length;
}

test("the maps that the browser computes have the means of the metrics", async () => {
  const metrics = compared("two/values/result.exr", "references/values.exr");
  const expected: Record<string, number> = {
    absolute: metrics["l1"] ?? NaN,
    squared: metrics["mse"] ?? NaN,
    relmse: metrics["relmse_eps01"] ?? NaN,
    smape: metrics["smape"] ?? NaN,
    srgb8: 255 ** 2 / 10 ** ((metrics["psnr_srgb8"] ?? NaN) / 10),
    ssim: 1 - (metrics["ssim"] ?? NaN),
    flip: metrics["flip"] ?? NaN,
  };
  for (const [measure, mean] of Object.entries(expected)) {
    const { page } = await open(
      session.browser,
      `${session.url}#/case/m1_values/values/two?run=small&img=difference&diff=${measure}`,
    );
    await drawn(page, "difference");
    const found = await shownMean(page);
    assert.ok(Math.abs(found / mean - 1) < 2e-3, `${measure}: ${found}, expected ${mean}`);
    await page.close();
  }
});

test("a region that is the whole image has the errors of the metrics", async () => {
  const metrics = compared("two/values/result.exr", "references/values.exr");
  const { page } = await open(
    session.browser,
    `${session.url}#/case/m1_values/values/two?run=small&img=result&region=0%2C0%2C64%2C48`,
  );
  await drawn(page, "result");
  const expected: Record<string, number> = {
    "mean |Δ|": metrics["l1"] ?? NaN,
    "mean Δ²": metrics["mse"] ?? NaN,
  };
  for (const [label, value] of Object.entries(expected)) {
    const row = page.locator(".region tr", { hasText: label }).first();
    const found = Number(await row.locator("td").innerText());
    assert.ok(Math.abs(found / value - 1) < 2e-3, `${label}: ${found}, expected ${value}`);
  }
  await page.close();
});

test("d walks through the maps of the run and the measures of the difference", async () => {
  const { page } = await open(
    session.browser,
    `${session.url}#/case/m1_values/values/two?run=small`,
  );
  await drawn(page, "result");
  await page.keyboard.press("d");
  await drawn(page, "difference");
  await page.keyboard.press("d");
  await page.waitForFunction(() => location.hash.includes("diff=absolute"));
  await page.close();
});

test("Normalise takes a percentile of what is visible", async () => {
  const { page } = await open(session.browser, "about:blank");
  const image = packedImage(100, 100, {
    R: (x, y) => (x === 50 && y === 50 ? 1000 : x < 50 ? 0 : 4),
    G: () => 0,
    B: () => 0,
  });
  await replaceImages(page, { "result.exr": image });
  const at = (query: string) =>
    page.goto(`${session.url}#/case/m1_values/values/one?mode=flip&${query}`);
  const exposure = async (): Promise<number> => {
    await drawn(page, "result");
    await page.locator(".statistics").first().waitFor();
    await page.keyboard.press("n");
    await page.waitForFunction(() => location.hash.includes("ev="));
    return Number(/ev=([-\d.]+)/.exec(page.url())?.[1]);
  };
  await at("run=small&ch=R");
  assert.ok(Math.abs((await exposure()) + Math.log2(1000)) < 1e-3, "the whole range");
  await at("run=small&ch=R&pct=99");
  assert.equal(await exposure(), -2, "0 to 4 without the one bright pixel");
  // Far from the bright pixel it is not visible.
  await at("run=small&ch=R&zoom=256&x=60&y=20&curve=gamma");
  await page.keyboard.press("n");
  await drawn(page, "result");
  assert.ok(!page.url().includes("ev="), "one value is no range");
  await page.close();
});

test("a layer has its difference and its errors by channel beside it", async () => {
  const { page } = await open(session.browser, "about:blank");
  const layer = (red: number) =>
    packedImage(16, 16, { R: () => red, G: () => 0.5, B: (x) => (x < 8 ? 0.5 : -0.5) });
  await replaceImages(page, { "result.exr": layer(0.25), "stokes.exr": layer(0.5) });
  await page.goto(`${session.url}#/case/a1_stokes/stokes/one?run=small&layer=S1&mode=side`);
  await drawn(page, "result reference difference");
  const errors = page.getByRole("region", { name: "Errors of A against B" });
  assert.deepEqual(
    (await errors.locator("tbody tr").allInnerTexts()).map((row) => row.split("\t")),
    [
      ["mean |Δ|", "0.25", "0", "0"],
      ["RMS Δ", "0.25", "0", "0"],
      ["of RMS B", "50 %", "0 %", "0 %"],
      ["mean Δ", "-0.25", "0", "0"],
    ],
  );
  assert.match(await errors.innerText(), /result against reference, layer S1/);
  await page.close();
});

test("the images of a cost study stand at one place with their reference", async () => {
  const { page, errors } = await open(
    session.browser,
    `${session.url}#/?run=cost&target=110&point=${encodeURIComponent("orbs/1")}`,
  );
  await page.getByRole("link", { name: /A × B/ }).click();
  await drawn(page, "result");
  await page.getByRole("combobox", { name: "Add an image" }).selectOption("cycles 64 spp");
  await page.keyboard.press("h");
  await drawn(page, "difference");
  // The address follows a change of the view after a pause.
  const address = /images\?.*target=110&point=orbs\/1.*b=cycles.64.spp.*more=cycles.64.spp/;
  await page.waitForURL((url) => address.test(decodeURIComponent(url.href)));
  const link = page.url();
  await page.goto("about:blank");
  await page.goto(link);
  await drawn(page, "difference");
  await page.getByRole("link", { name: /Curves/ }).click();
  await page.locator(".cost-plot svg").waitFor();
  assert.match(page.url(), /target=110/);
  assert.deepEqual(errors, []);
  await page.close();
});

test("a run offers the images of a study that is served beside it", async () => {
  const { page, errors } = await open(session.browser, "about:blank");
  await page.route("**/cost.json", async (route) => {
    const study = (await (await route.fetch()).json()) as { targets: { name: string }[] };
    study.targets[0]!.name = "values";
    await route.fulfill({ json: study });
  });
  await page.goto(`${session.url}#/case/m1_values/values/two?run=small`);
  await drawn(page, "result");
  const add = page.getByRole("combobox", { name: "Add an image" });
  await add.locator("option", { hasText: "povray 16 spp@cost" }).waitFor({ state: "attached" });
  await add.selectOption("povray 16 spp@cost");
  await page.keyboard.press("h");
  await drawn(page, "difference");
  await page.goto(
    `${session.url}#/case/m1_values/values/two?run=small&more=${encodeURIComponent("orbs 3 spp@cost")}`,
  );
  await page.getByText("orbs 3 spp@cost: the study has no such image of this scene").waitFor();
  assert.deepEqual(errors, []);
  await page.close();
});
