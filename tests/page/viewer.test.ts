// The viewer with images that the renders of the other tests do not contain.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { colourAt, drawn, open, packedImage, replaceImages } from "./browser";
import { startSession } from "./session";

const session = startSession("small");
const values = (): string => `${session.url}#/case/m1_values/values/one?mode=flip`;

/** The viewer with these images in place of result and reference. */
async function viewer(
  query: string,
  images: Record<string, Buffer>,
): Promise<{ page: Page; errors: string[]; middle: { x: number; y: number } }> {
  const { page, errors } = await open(session.browser, "about:blank");
  await replaceImages(page, images);
  await page.goto(`${values()}&${query}`);
  await drawn(page, "result");
  const box = await page.locator(".stage").boundingBox();
  return {
    page,
    errors,
    middle: { x: Math.floor((box?.width ?? 0) / 2), y: Math.floor((box?.height ?? 0) / 2) },
  };
}

const channelSelect = (page: Page) => page.getByRole("combobox", { name: "Channel" });

test("a fourth and a fifth channel show their own values", async () => {
  const five = packedImage(8, 8, {
    R: () => 1,
    G: () => 1,
    B: () => 1,
    A: () => 0.25,
    Z: () => 0.5,
  });
  const { page, errors, middle } = await viewer("curve=linear&ch=A&zoom=40&x=4.5&y=4.5", {
    "result.exr": five,
  });
  const grey = async (): Promise<number> =>
    (await colourAt(page, middle.x, middle.y + 12))[0] ?? -1;
  assert.ok(Math.abs((await grey()) - 63.75) < 1.5, String(await grey()));
  await channelSelect(page).selectOption("Z");
  await page.waitForFunction(() => location.hash.includes("ch=Z"));
  await drawn(page, "result");
  assert.ok(Math.abs((await grey()) - 127.5) < 1.5, String(await grey()));
  const box = await page.locator(".stage").boundingBox();
  await page.mouse.move((box?.x ?? 0) + middle.x, (box?.y ?? 0) + middle.y);
  assert.match(
    await page.locator(".readout tr", { hasText: "result" }).innerText(),
    /1\s+1\s+1\s+0\.5/,
  );
  assert.deepEqual(errors, []);
  await page.close();
});

test("an image of two channels offers these two and shows the chosen one", async () => {
  const two = packedImage(8, 8, { Y: () => 0.25, A: () => 0.75 });
  const { page, errors, middle } = await viewer("curve=linear&zoom=20&x=4.5&y=4.5", {
    "result.exr": two,
  });
  await page.locator(".statistics").first().waitFor();
  assert.deepEqual(await channelSelect(page).locator("option").allInnerTexts(), ["Y", "A"]);
  const grey = async (): Promise<number> => (await colourAt(page, middle.x, middle.y))[0] ?? -1;
  assert.ok(Math.abs((await grey()) - 63.75) < 1.5, String(await grey()));
  await page.keyboard.press("x");
  await page.waitForFunction(() => location.hash.includes("ch=A"));
  await drawn(page, "result");
  assert.ok(Math.abs((await grey()) - 191.25) < 1.5, String(await grey()));
  await page.keyboard.press("x");
  await page.waitForFunction(() => !location.hash.includes("ch="));
  // The reference has no channel A and is shown in colour.
  await page.keyboard.press("x");
  await page.keyboard.press("2");
  await drawn(page, "reference");
  assert.equal(await channelSelect(page).locator("option:checked").innerText(), "RGB");
  assert.deepEqual(errors, []);
  await page.close();
});

test("an address that is followed right after a change of the view is not overwritten by it", async () => {
  const five = packedImage(8, 8, { R: () => 1, G: () => 1, B: () => 1, A: () => 0.25 });
  const { page, errors } = await viewer("ch=R", { "result.exr": five });
  const followed = await channelSelect(page).evaluate(async (select: HTMLSelectElement) => {
    select.value = "A";
    select.dispatchEvent(new Event("change", { bubbles: true }));
    location.hash = location.hash.replace("ch=R", "ch=G");
    // Timers of one delay fire in the order in which they were set: the write of the change comes first.
    await new Promise((resolve) => setTimeout(resolve, 300));
    return location.hash;
  });
  assert.match(followed, /ch=G/);
  assert.equal(await channelSelect(page).inputValue(), "G");
  assert.deepEqual(errors, []);
  await page.close();
});

test("a scale that ends at the largest value follows the chosen channel", async () => {
  const four = packedImage(8, 8, {
    R: () => 1,
    G: () => 1,
    B: () => 1,
    A: (x) => (x === 0 ? 8 : 4),
  });
  const { page } = await viewer("curve=false&ch=A", { "result.exr": four });
  await page.locator(".statistics").first().waitFor();
  await page.keyboard.press("n");
  await page.waitForFunction(() => location.hash.includes("ends=result"));
  assert.match(decodeURIComponent(page.url()), /ends=result:8/);
  await page.close();
});

test("the readout follows the pointer or the worst pixel, whichever moved last", async () => {
  const { page, middle } = await viewer("zoom=8&x=20.5&y=20.5", {});
  const heading = page.locator(".readout h3");
  const box = await page.locator(".stage").boundingBox();
  const at = { x: (box?.x ?? 0) + middle.x, y: (box?.y ?? 0) + middle.y };
  await page.getByText("pixels differ").waitFor();
  await page.mouse.move(at.x, at.y);
  assert.match(await heading.innerText(), /20, 20/);
  await page.keyboard.press("u");
  await page.waitForFunction(
    () => document.querySelector(".readout h3")?.textContent === "Pixel 5, 7",
  );
  await page.mouse.move(at.x + 36, at.y);
  assert.doesNotMatch(await heading.innerText(), /Pixel 5, 7$/);
  await page.keyboard.press("u"); // NaN at (5, 7) and infinity at (6, 7) are one spot
  await page.waitForFunction(
    () => document.querySelector(".readout h3")?.textContent === "Pixel 40, 20",
  );
  await page.close();
});

for (const region of ["-1000000000,0,5,5", "10,10,2,2", "0,0,1000000000,1000000000"])
  test(`the region ${region} of a link is refused with a reason`, async () => {
    const { page, errors } = await viewer(`region=${encodeURIComponent(region)}`, {});
    await page
      .locator(".region")
      .getByText("The region does not lie within the image, which has 64 × 48 pixels.")
      .waitFor();
    await page.getByRole("button", { name: "Clear" }).click();
    await page.waitForFunction(() => !document.querySelector(".region"));
    assert.deepEqual(errors, []);
    await page.close();
  });

test("the statistics of a region cover only its pixels", async () => {
  const { page } = await viewer("region=32%2C16%2C48%2C24", {});
  // 1 of 16 x 8 x 3 values is too small by 1.
  await page.locator(".region tr", { hasText: "mean Δ" }).last().getByText("-0.002604").waitFor();
  assert.match(
    await page.locator(".region").innerText(),
    /mean \|Δ\|\s+0\.002604\s+mean Δ²\s+0\.002604\s+mean Δ\s+-0\.002604/,
  );
  await page.goto(`${values()}&region=0%2C0%2C32%2C32`);
  await page.locator(".region tr", { hasText: "mean Δ" }).last().getByText("NaN").waitFor();
  await page.close();
});

test("many erroneous pixels are counted, and one of each spot can be visited", async () => {
  const [black, white] = [
    packedImage(64, 48, { R: () => 0, G: () => 0, B: () => 0 }),
    packedImage(64, 48, { R: () => 1, G: () => 0, B: () => 0 }),
  ];
  const { page } = await viewer("", { "result.exr": white, "values.exr": black });
  await page.getByText("3072 pixels differ").waitFor();
  await page.keyboard.press("u");
  await page.getByRole("button", { name: "1 of 48 spots: 1", exact: true }).waitFor();
  await page.close();
});

test("a layer that the images do not have can be deselected", async () => {
  const { page } = await open(session.browser, `${values()}&layer=S3`);
  await page.getByText("result: the image has no layer 'S3'").waitFor();
  await page.getByRole("combobox", { name: "Layer" }).selectOption({ label: "colour" });
  await drawn(page, "result");
  await page.close();
});

test("one NaN among many pixels is visible at any zoom", async () => {
  const large = packedImage(512, 512, { Y: (x, y) => (x === 301 && y === 203 ? NaN : 0.5) });
  const { page, middle } = await viewer("zoom=0.07&x=301&y=203", { "result.exr": large });
  const colours = [];
  for (const dy of [-1, 0, 1])
    for (const dx of [-1, 0, 1])
      colours.push(String(await colourAt(page, middle.x + dx, middle.y + dy)));
  assert.ok(colours.includes("255,0,255"), colours.join(" "));
  await page.close();
});

test("textures of images that are no longer shown are freed", async () => {
  const { page } = await open(session.browser, "about:blank");
  await page.addInitScript(() => {
    const { createTexture, deleteTexture } = WebGL2RenderingContext.prototype;
    const counts = globalThis as unknown as { textures: number };
    counts.textures = 0;
    WebGL2RenderingContext.prototype.createTexture = function () {
      ++counts.textures;
      return createTexture.call(this);
    };
    WebGL2RenderingContext.prototype.deleteTexture = function (texture) {
      --counts.textures;
      deleteTexture.call(this, texture);
    };
  });
  const textures = () =>
    page.evaluate(() => (globalThis as unknown as { textures: number }).textures);
  await page.goto(`${session.url}#/case/a1_stokes/stokes/one`);
  await drawn(page, "result");
  const first = await textures();
  for (const layer of ["S0", "S1", "S2", "S3"]) {
    await page.getByRole("combobox", { name: "Layer" }).selectOption(layer);
    await page.getByRole("heading", { name: `layer ${layer}` }).waitFor();
    await drawn(page, "result");
  }
  // A layer may still be drawn; textures that are kept would stay more for ever.
  await page.waitForFunction(
    (count) => (globalThis as unknown as { textures: number }).textures === count,
    first,
  );
  await page.close();
});

test("when the graphics driver restarts the images are drawn again", async () => {
  const { page, middle } = await viewer("curve=linear&zoom=20&x=4.5&y=4.5", {
    "result.exr": packedImage(8, 8, { Y: () => 0.25 }),
  });
  const lose = (what: "loseContext" | "restoreContext") =>
    page.evaluate((name) => {
      const own = globalThis as unknown as { lost?: WEBGL_lose_context | null };
      own.lost ??=
        document
          .querySelector<HTMLCanvasElement>(".stage canvas")
          ?.getContext("webgl2")
          ?.getExtension("WEBGL_lose_context") ?? null;
      own.lost?.[name]();
    }, what);
  await lose("loseContext");
  await page.getByText("the graphics driver has stopped").waitFor();
  await lose("restoreContext");
  await page.waitForFunction(() => !document.querySelector(".stage-note"));
  await drawn(page, "result");
  assert.ok(Math.abs(((await colourAt(page, middle.x, middle.y))[0] ?? -1) - 63.75) < 1.5);
  await page.close();
});

test("Space toggles a checkbox that has the focus, and scrolls a log", async () => {
  const { page } = await viewer("", {});
  await page.evaluate(() =>
    addEventListener(
      "keydown",
      (event) => (document.body.dataset["taken"] = String(event.defaultPrevented)),
    ),
  );
  const tick = page.getByRole("checkbox", { name: /^l1 in blink/ });
  await tick.focus();
  await page.keyboard.press(" ");
  assert.ok(await tick.isChecked());
  assert.equal(
    await page.getByRole("button", { name: "Blink" }).getAttribute("aria-pressed"),
    "false",
  );
  await page.locator(".copyable code").first().focus();
  for (const key of [" ", "ArrowRight"]) {
    await page.keyboard.press(key);
    assert.equal(await page.locator("body").getAttribute("data-taken"), "false", key);
  }
  await page.goto(`${session.url}#/case/e1_markup/markup/one`);
  await page.locator(".logs pre").focus();
  for (const key of [" ", "ArrowDown"]) {
    await page.keyboard.press(key);
    assert.equal(await page.locator("body").getAttribute("data-taken"), "false", key);
  }
  await page.close();
});

test("a command is selected if the browser offers no clipboard", async () => {
  const { page, errors } = await open(session.browser, "about:blank");
  // As on a page loaded by plain http from another machine.
  await page.addInitScript(() =>
    Object.defineProperty(navigator, "clipboard", { value: undefined }),
  );
  await page.goto(values());
  const box = page.locator(".copyable").first();
  await box.getByRole("button").click();
  await box.getByText("Selected: press Ctrl+C").waitFor();
  assert.equal(
    await page.evaluate(() => String(getSelection())),
    await box.locator("code").innerText(),
  );
  assert.deepEqual(errors, []);
  await page.close();
});
