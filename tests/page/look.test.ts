// Any two images at one place, the layout of the viewer, the gallery, and the diagnosis.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { colourAt, drawn, open, packedImage, replaceImages } from "./browser";
import { report } from "./runs";
import { startSession } from "./session";

const session = startSession("small", "before");

const values = "#/case/m1_values/values/one?mode=flip";

const hashHas = (page: Page, part: string) =>
  page.waitForFunction((wanted) => decodeURIComponent(location.hash).includes(wanted), part);

/** The pixel of the readout in the row of an image. */
const readout = (page: Page, name: string) =>
  page.locator(".readout tr").filter({ has: page.getByRole("rowheader", { name, exact: true }) });

test("another renderer and another run stand beside the image, and the address says so", async () => {
  const { page, errors } = await open(
    session.browser,
    `${session.url}${values}&zoom=20&x=30.5&y=20.5`,
  );
  await drawn(page, "result");
  const add = page.getByRole("combobox", { name: "Add an image" });
  await add.selectOption("two");
  await hashHas(page, "b=two");
  await add.selectOption("one@before");
  await hashHas(page, "more=two|one@before");
  await page.getByRole("combobox", { name: "B", exact: true }).selectOption("two");
  await page.keyboard.press("h");
  await drawn(page, "difference");
  const box = await page.locator(".stage").boundingBox();
  await page.mouse.move(
    (box?.x ?? 0) + (box?.width ?? 0) / 2,
    (box?.y ?? 0) + (box?.height ?? 0) / 2,
  );
  // "two" has 0.25 more in G; the image is that of "one".
  assert.match(await readout(page, "difference").innerText(), /0\s+-0\.2(5|4999\d+)\s+0/);
  await page.keyboard.press("i");
  await hashHas(page, "diff=absolute");
  await drawn(page, "difference");
  assert.match(await readout(page, "difference").innerText(), /0\s+0\.2(5|4999\d+)\s+0/);
  await page.getByRole("button", { name: "Side by side" }).click();
  await drawn(page, "result two difference"); // A, B and A - B
  await page.getByRole("checkbox", { name: "one@before in blink and side by side" }).check();
  await drawn(page, "result two one@before difference");
  assert.deepEqual(errors, []);
  await page.close();
});

test("a link opens the same two images, and the view survives the next renderer", async () => {
  const { page } = await open(
    session.browser,
    `${session.url}${values}&more=two&b=two&img=difference&diff=squared&zoom=8&x=20&y=10&ev=1&region=1%2C2%2C9%2C9`,
  );
  await drawn(page, "difference");
  assert.equal(await page.getByRole("combobox", { name: "B", exact: true }).inputValue(), "two");
  await page.keyboard.press("e"); // the change is not yet in the address when the renderer changes
  await page.keyboard.press("j");
  await page.waitForFunction(() => location.hash.includes("/values/two"));
  await drawn(page, "difference");
  for (const part of ["more=two", "diff=squared", "zoom=8", "x=20", "ev=1.5", "region=1,2,9,9"])
    assert.ok(decodeURIComponent(page.url()).includes(part), `${part}: ${page.url()}`);
  await page.close();
});

test("an image that is not there is named, and the others are shown", async () => {
  const { page } = await open(session.browser, `${session.url}${values}&more=nobody`);
  await page.getByText("nobody: the run has no such target").waitFor();
  await drawn(page, "result");
  await page.getByRole("button", { name: "Remove nobody" }).click();
  await page.waitForFunction(() => !location.hash.includes("nobody"));
  await page.close();
});

test("FLIP is 0 for equal images and 1 for the largest difference of colours", async () => {
  const colour = (g: number, b: number) =>
    packedImage(64, 64, { R: () => 0, G: () => g, B: () => b });
  const of = async (image: Buffer): Promise<string> => {
    const { page } = await open(session.browser, "about:blank");
    await replaceImages(page, { "result.exr": image, "values.exr": colour(1, 0) });
    await page.goto(`${session.url}${values}&img=difference&diff=flip`);
    await drawn(page, "difference");
    await page.locator(".statistics").first().waitFor();
    const text = await page.locator(".statistics").first().innerText();
    await page.close();
    return text;
  };
  assert.match(await of(colour(1, 0)), /max\s+0$/);
  assert.match(await of(colour(0, 1)), /mean\s+1\s+max\s+1$/);
});

test("the stage and its colour scale fit the window, and F fills it", async () => {
  for (const [width, height] of [
    [1440, 900],
    [1280, 720],
  ] as const) {
    const { page } = await open(session.browser, `${session.url}${values}&img=l1`, {
      viewport: { width, height },
    });
    await drawn(page, "l1");
    await page.waitForFunction(
      () =>
        (document.querySelector(".legend")?.getBoundingClientRect().bottom ?? 1e9) <= innerHeight,
    );
    const before = (await page.locator(".stage").boundingBox())?.height ?? 0;
    assert.ok(before >= 0.4 * height, `${before} of ${height}`);
    await page.keyboard.press("Shift+F");
    await page.waitForFunction(
      (least) => (document.querySelector(".stage")?.clientHeight ?? 0) > least,
      before + 40,
    );
    const legend = await page.locator(".legend").boundingBox();
    assert.ok((legend?.y ?? 1e9) + (legend?.height ?? 0) <= height);
    await page.keyboard.press("Escape");
    await page.waitForFunction(() => !document.querySelector(".viewer.full"));
    assert.match(page.url(), /case/);
    await page.close();
  }
});

test("on a phone the image comes before its tools", async () => {
  const { page } = await open(session.browser, `${session.url}${values}`, {
    viewport: { width: 390, height: 844 },
  });
  await drawn(page, "result");
  const [stage, toolbar] = [
    await page.locator(".stage").boundingBox(),
    await page.locator(".toolbar").boundingBox(),
  ];
  assert.ok((stage?.y ?? 1e9) < (toolbar?.y ?? 0));
  assert.ok((stage?.y ?? 1e9) + (stage?.height ?? 0) <= 844);
  assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390);
  await page.close();
});

test("Escape ends the drawing of a region and nothing else", async () => {
  const { page } = await open(session.browser, `${session.url}${values}`);
  await drawn(page, "result");
  await page.keyboard.press("a");
  await page.locator(".stage.selecting").waitFor();
  const box = await page.locator(".stage").boundingBox();
  const at = {
    x: (box?.x ?? 0) + (box?.width ?? 0) / 2,
    y: (box?.y ?? 0) + (box?.height ?? 0) / 2,
  };
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x + 50, at.y + 50);
  await page.locator(".region").waitFor();
  await page.keyboard.press("Escape");
  await page.waitForFunction(() => !document.querySelector(".region"));
  await page.mouse.up();
  await page.keyboard.press("Escape");
  await page.waitForFunction(() => !document.querySelector(".stage.selecting"));
  assert.match(page.url(), /case/);
  await page.close();
});

test("Escape leaves the full window and not the target, also when the address has just changed", async () => {
  const { page } = await open(session.browser, `${session.url}${values}`);
  await drawn(page, "result");
  await page.keyboard.press("Shift+F");
  await page.locator(".viewer.full").waitFor();
  await page.evaluate(() => {
    // The page is rendered again by the new address, the viewer is not.
    history.replaceState(
      null,
      "",
      `${location.hash}${location.hash.includes("?") ? "&" : "?"}other=1`,
    );
    dispatchEvent(new Event("hashchange"));
  });
  await page.waitForFunction(() => location.hash.includes("other=1"));
  await page.keyboard.press("Escape");
  await page.waitForFunction(() => !document.querySelector(".viewer.full"));
  assert.match(page.url(), /case/);
  await page.close();
});

test("the worst pixels of a wide edge are one spot each", async () => {
  const { page } = await open(session.browser, "about:blank");
  const flat = (value: (x: number, y: number) => number) =>
    packedImage(64, 48, { R: value, G: () => 0, B: () => 0 });
  await replaceImages(page, {
    "result.exr": flat((x, y) =>
      x > 9 && x < 14 && y > 9 && y < 14 ? 1 : x === 50 && y === 40 ? 0.5 : 0,
    ),
    "values.exr": flat(() => 0),
  });
  await page.goto(`${session.url}${values}`);
  await page.getByText("17 pixels differ").waitFor();
  await page.keyboard.press("u");
  await page.getByRole("button", { name: "1 of 2 spots: 1", exact: true }).waitFor();
  await page.keyboard.press("u");
  await page.getByRole("button", { name: "2 of 2 spots: 0.5" }).waitFor();
  assert.match(await page.locator(".readout h3").innerText(), /50, 40/);
  await page.close();
});

test("the diagnosis leads the reason of the verdict, and what noise leaves open is not called unmet", async () => {
  const { page } = await open(session.browser, session.url + values);
  await page.getByText("shifted by (2, 1) px: then 60.2 dB").waitFor();
  const items = page.getByRole("list", { name: "Checks" }).getByRole("listitem");
  await items.nth(1).waitFor(); // the reason also stands above the list, which is drawn later
  const checks = await items.allInnerTexts();
  assert.match(checks[0] ?? "", /✗\s+not met:\s+psnr_srgb8/);
  assert.match(checks[1] ?? "", /\?\s+undecided:\s+noise hides the edges/);
  await page.close();
});

for (const kind of ["served", "in one file"])
  test(`the gallery shows result, reference and difference, ${kind}`, async () => {
    const file = join(session.scratch.folder, "gallery.html");
    if (kind !== "served") report(join(session.scratch.folder, "small"), file);
    const start = kind === "served" ? session.url : `file://${file}`;
    const { page, errors } = await open(session.browser, `${start}#/?as=gallery&q=known`);
    const row = page.locator(".gallery .body .gallery-row").first();
    for (const name of ["result", "reference", "|result − reference|"])
      await row.locator(`img[alt="${name}"]`).first().waitFor();
    await row.locator("a.pictures").first().click();
    await drawn(page, "result reference difference");
    assert.deepEqual(errors, []);
    await page.close();
  });

test("pictures are also of requirements, and a group of them can be chosen", async () => {
  const { page } = await open(session.browser, `${session.url}#/?as=gallery&by=requirement`);
  const heads = page.locator(".gallery .body .gallery-head");
  await heads.first().waitFor();
  const codes = async () => (await heads.allInnerTexts()).map((text) => text.slice(0, 2));
  const all = await codes();
  assert.equal(new Set(all).size, all.length, "each requirement has one row");
  await page.getByRole("group", { name: "Group" }).getByText("M materials").click();
  await page.waitForFunction(
    (n) => document.querySelectorAll(".gallery .body .gallery-head").length < n,
    all.length,
  );
  assert.ok((await codes()).every((code) => code.startsWith("M")));
  await page.getByRole("button", { name: "By target" }).click();
  await page.locator(".gallery-head .about").first().waitFor(); // what the case is about
  await page.close();
});

test("the filter knows renderers and verdicts together", async () => {
  const { page } = await open(session.browser, `${session.url}#/?by=target`);
  const rows = () => page.locator(".grid .row.target").count();
  await page.locator(".grid .row.target").first().waitFor();
  const all = await rows();
  await page.locator(".search input").fill("two timeout");
  await page.waitForFunction(() => document.querySelectorAll(".grid .row.target").length === 1);
  await page.locator(".search input").fill("three timeout");
  await page.getByText("Nothing matches the filter.").waitFor();
  await page.locator(".search input").fill("");
  await page.waitForFunction(
    (n) => document.querySelectorAll(".grid .row.target").length === n,
    all,
  );
  await page.close();
});

test("rows sort by the shown number, and titles lead to the worst cell", async () => {
  const { page } = await open(
    session.browser,
    `${session.url}#/?by=target&order=value&show=wall_seconds`,
  );
  const row = page.locator(".grid .row.target").first();
  assert.match(await row.innerText(), /verdict-16/); // 15.5 s
  await row.locator("a.title").click();
  await page.waitForFunction(() => /case\/.*verdict-16\/two/.test(location.hash));
  await page.close();
});

test("compare calls two renderers A and B and leads to both images", async () => {
  const { page } = await open(
    session.browser,
    `${session.url}#/compare?before=small&after=small&ra=two&rb=one`,
  );
  await page.getByRole("heading", { name: /B is worse/ }).waitFor();
  const row = page.locator("section[data-kind=worse] tbody tr", { hasText: "m1_values" });
  await row.getByRole("link", { name: "A × B" }).click();
  await drawn(page, "difference");
  assert.match(decodeURIComponent(page.url()), /more=two/);
  assert.ok((await colourAt(page, 5, 5)).length === 3);
  await page.close();
});

test("compare names the settings that differ before anything else", async () => {
  const { page } = await open(session.browser, `${session.url}#/compare`);
  await page.getByText("samples per pixel × 0.5").waitFor();
  await page.close();
});
