import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { changeOverview, colourAt, drawn, open } from "./browser";
import { report } from "./runs";
import { startSession } from "./session";

const session = startSession("small", "before");

const values = "#/case/m1_values/values/one?mode=flip";

test("the overview shows each state as symbol and word, failures first", async () => {
  const { page, errors } = await open(session.browser, `${session.url}#/?by=target`);
  await page.waitForSelector(".grid .row.target");
  const words = await page.locator(".cell a").allInnerTexts();
  for (const word of [
    "pass",
    "fail",
    "crash",
    "timeout",
    "missing reference",
    "unsupported",
    "invalid pixels",
  ])
    assert.ok(
      words.some((text) => text.includes(word)),
      word,
    );
  const first = await page.locator(".row.target").first().innerText();
  assert.match(first, /crash/);
  await page.locator(".declared summary").click();
  assert.match(await page.locator(".renderers").innerText(), /G5\/M8\/L4\/A4\s+G0\/M1\/L0\/A0/);
  assert.deepEqual(errors, []);
  await page.close();
});

test("of targets in the same state the one with the worst metric represents the requirement", async () => {
  const page = await session.browser.newPage();
  await changeOverview(page, (overview) => {
    const { cells, measures } = overview;
    for (const column of ["case", "renderer", "state", "declared"])
      cells[column]!.fill(cells[column]![0]!, 0, 3);
    overview.targets = ["good", "worst", "better", ...overview.targets];
    cells["target"] = cells["target"]!.map((target, i) => (i < 3 ? i : target! + 3));
    measures["psnr_srgb8"]!.splice(0, 3, 50, 36, 42);
  });
  await page.goto(session.url);
  await page.locator(".row.requirement").first().waitFor();
  const rows = await page.locator(".row.requirement").allInnerTexts();
  assert.ok(
    rows.some((text) => text.includes("36 dB")),
    rows.join(" | "),
  );
  assert.ok(!rows.some((text) => /50 dB|42 dB/.test(text)), rows.join(" | "));
  await page.close();
});

test("where an image passes without its noise its own PSNR comes first, and the rule is below", async () => {
  const rule = "Numbers are the PSNR of the images.";
  let target = "";
  const page = await session.browser.newPage();
  await changeOverview(page, (overview) => {
    overview.measures["psnr_srgb8"]![0] = 30.54;
    overview.cells["beside_psnr"]![0] = 1;
    overview.texts_beside_psnr = ["", "37.2 dB without noise"];
    overview.rule_beside_psnr = rule;
    target = overview.targets[overview.cells["target"]![0]!]!;
  });
  await page.goto(`${session.url}#/?by=target`);
  await page.getByText("30.54 dB, 37.2 dB without noise").waitFor();
  await page.getByText(rule).waitFor();
  // The gallery makes the rows that are in view alone.
  await page.goto(`${session.url}#/?as=gallery&by=target&q=${target}`);
  await page.locator(".card .beside", { hasText: "37.2 dB without noise" }).waitFor();
  await page.close();
});

test("filter box, chips and the address agree", async () => {
  const { page } = await open(session.browser, session.url);
  await page.locator(".search").waitFor();
  await page.keyboard.press("/");
  await page.locator(".search:focus, .search :focus").waitFor(); // what is typed before is lost
  await page.keyboard.type("known values");
  await page.waitForFunction(() => document.querySelectorAll(".row.requirement").length === 1);
  assert.match(page.url(), /q=known/);
  await page.goto(`${session.url}#/?suite=beta`);
  await page.waitForFunction(() => document.querySelectorAll(".row.requirement").length === 2);
  await page.getByRole("group", { name: "State" }).getByRole("button", { name: /crash/ }).click();
  await page.waitForFunction(() => document.querySelectorAll(".row.requirement").length === 1);
  assert.match(page.url(), /state=crash/);
  await page.close();
});

test("a cell shows a thumbnail, opens its target, and the back button returns", async () => {
  const { page, errors } = await open(session.browser, `${session.url}#/?q=known`);
  const cell = page.locator(".cell a").first();
  await cell.hover();
  await page.waitForFunction(
    () => (document.querySelector<HTMLImageElement>(".preview img")?.naturalWidth ?? 0) === 64,
  );
  await cell.click();
  await page.waitForSelector(".measures");
  await page.locator(".numbers > summary").click();
  await page.locator(".provenance summary").click();
  const text = await page.locator(".facts").innerText();
  for (const part of [
    "What Known values tests.",
    "What goes wrong in Known values.",
    "10 log10(255^2 / MSE)",
    "≥ 35",
    "not met",
    "closer to 0 is better",
    "-0.02 to -0.005, in [8, 16, 24, 32]",
    "it leans to the left",
    "orbs run --suite alpha --case m1_values",
    "--spp-scale 0.5",
    "'with space' 'it'\\''s'",
    "reference <i>tracer</i>",
    "123 MB",
  ])
    assert.ok((text + (await page.locator(".measures").innerHTML())).includes(part), part);
  await page.goBack();
  await page.waitForSelector(".grid");
  assert.match(page.url(), /q=known/);
  assert.deepEqual(errors, []);
  await page.close();
});

test("digits flip between the images, even those of unknown maps", async () => {
  const { page, errors } = await open(session.browser, session.url + values);
  await drawn(page, "result");
  for (const [key, name] of [
    ["2", "reference"],
    ["5", "wobble"],
    ["1", "result"],
  ] as const) {
    await page.keyboard.press(key);
    await drawn(page, name);
  }
  await page.keyboard.down("Shift");
  await drawn(page, "reference");
  await page.keyboard.up("Shift");
  await drawn(page, "result");
  assert.deepEqual(errors, []);
  await page.close();
});

test("swipe shows the result left and the reference right of the divider", async () => {
  // Exposure -1 keeps the extra 1 in R at (40, 20) of the reference below white.
  const { page } = await open(
    session.browser,
    `${session.url}${values}&mode=swipe&zoom=8&x=40.5&y=20.5&swipe=1&curve=linear&ev=-1`,
  );
  await drawn(page, "result reference");
  const box = await page.locator(".stage").boundingBox();
  const [x, y] = [(box?.width ?? 0) / 2, (box?.height ?? 0) / 2];
  const left = await colourAt(page, x, y);
  await page.locator(".divider").focus();
  await page.goto(
    `${session.url}${values}&mode=swipe&zoom=8&x=40.5&y=20.5&swipe=0&curve=linear&ev=-1`,
  );
  await page.waitForFunction(
    () => document.querySelector(".divider")?.getAttribute("aria-valuenow") === "0",
  );
  await drawn(page, "result reference");
  const right = await colourAt(page, x, y);
  // 40/64 / 2 and (40/64 + 1) / 2 of 255.
  assert.ok(Math.abs((left[0] ?? 0) - 79.7) < 1.5, String(left));
  assert.ok(Math.abs((right[0] ?? 0) - 207.2) < 1.5, String(right));
  await page.close();
});

test("the readout has the values of the EXR, even beyond the range of half floats", async () => {
  const { page } = await open(session.browser, `${session.url}${values}&zoom=40&x=8.5&y=9.5`);
  await drawn(page, "result");
  const box = await page.locator(".stage").boundingBox();
  const middle = {
    x: (box?.x ?? 0) + (box?.width ?? 0) / 2,
    y: (box?.y ?? 0) + (box?.height ?? 0) / 2,
  };
  const row = () => page.locator(".readout tr", { hasText: "result" }).innerText();
  await page.mouse.move(middle.x, middle.y);
  assert.match(await row(), /70000\s+0\.1875\s+0\.25/);
  await page.mouse.move(middle.x + 40, middle.y);
  assert.match(await row(), /-0\.5\s+0\.1875\s+0\.25/);
  await page.mouse.move(middle.x - 120, middle.y - 80);
  assert.match(await row(), /NaN/);
  await page.mouse.move(middle.x - 80, middle.y - 80);
  assert.match(await row(), /\+Inf/);
  assert.equal(
    await page.locator(".overlay").getAttribute("data-numbers"),
    "1",
    "values are drawn in the pixels",
  );
  await page.close();
});

test("NaN and infinite pixels are magenta at any zoom and counted", async () => {
  const { page } = await open(session.browser, `${session.url}${values}&zoom=20&x=5.5&y=7.5`);
  await drawn(page, "result");
  const box = await page.locator(".stage").boundingBox();
  const [x, y] = [Math.floor((box?.width ?? 0) / 2), Math.floor((box?.height ?? 0) / 2)];
  for (const dx of [0, 20]) assert.deepEqual(await colourAt(page, x + dx, y), [255, 0, 255]);
  assert.notDeepEqual(await colourAt(page, x - 20, y), [255, 0, 255]);
  assert.match(await page.locator(".statistics").first().innerText(), /NaN\s+1\s+0\s+0/);
  assert.match(await page.locator(".statistics").first().innerText(), /Inf\s+1\s+0\s+0/);
  await page.goto("about:blank");
  await page.goto(`${session.url}${values}&zoom=0.25&x=32&y=24`);
  await drawn(page, "result");
  const small = await page.evaluate(() => {
    const canvas = document.querySelector<HTMLCanvasElement>(".stage canvas");
    const copy = document.createElement("canvas");
    Object.assign(copy, { width: canvas?.width, height: canvas?.height });
    const pen = copy.getContext("2d");
    if (canvas) pen?.drawImage(canvas, 0, 0);
    const data = pen?.getImageData(0, 0, copy.width, copy.height).data ?? [];
    let magenta = 0;
    for (let i = 0; i < data.length; i += 4)
      if (data[i] === 255 && data[i + 1] === 0 && data[i + 2] === 255) ++magenta;
    return magenta;
  });
  assert.ok(small >= 1, "visible although 16 pixels share one screen pixel");
  await page.close();
});

test("the worst pixels are visited in order, with their positions", async () => {
  const { page } = await open(session.browser, `${session.url}${values}&img=l1`);
  await drawn(page, "l1");
  await page.getByText("6 pixels differ").waitFor(); // of result and reference, also behind a map
  await page.keyboard.press("u");
  await page.getByRole("button", { name: "1 of 2 spots: 1", exact: true }).waitFor();
  assert.match(await page.locator(".readout h3").innerText(), /40, 20/);
  await page.keyboard.press("u");
  await page.getByRole("button", { name: "2 of 2 spots: 0.5" }).waitFor();
  assert.match(await page.locator(".readout h3").innerText(), /10, 30/);
  await page.keyboard.press("w"); // its button is folded away
  await page.locator(".region").waitFor();
  assert.match(await page.locator(".region").innerText(), /Region 32, 0 – 64, 32/);
  await page.close();
});

test("a link restores the view, and changes of the view change the link", async () => {
  const { page } = await open(
    session.browser,
    `${session.url}${values}&img=reference&zoom=4&x=20&y=10&ev=1.5&ch=G&region=1%2C2%2C11%2C12&zebra=1`,
  );
  await drawn(page, "reference");
  assert.equal(
    await page.locator(".field", { hasText: "EV" }).locator("input").inputValue(),
    "1.5",
  );
  assert.match(await page.locator(".region").innerText(), /10 × 10/);
  await page.keyboard.press("e");
  await page.waitForFunction(() => location.hash.includes("ev=2"));
  for (const part of ["img=reference", "zoom=4", "x=20", "ch=G", "zebra=1"])
    assert.ok(page.url().includes(part), part);
  await page.close();
});

test("Stokes layers have values of both signs and get a diverging scale", async () => {
  const { page, errors } = await open(
    session.browser,
    `${session.url}#/case/a1_stokes/stokes/one?layer=S3&zoom=8&x=16&y=16`,
  );
  await drawn(page, "result");
  await page.locator(".statistics").first().waitFor();
  await page.waitForFunction(() => document.querySelector(".ticks")?.textContent?.includes("−1"));
  const box = await page.locator(".stage").boundingBox();
  const [x, y] = [(box?.width ?? 0) / 2, (box?.height ?? 0) / 2];
  const [negative, positive] = [await colourAt(page, x - 80, y), await colourAt(page, x + 80, y)];
  assert.ok((negative[2] ?? 0) > (negative[0] ?? 0), `blue ${negative}`);
  assert.ok((positive[0] ?? 0) > (positive[2] ?? 0), `orange ${positive}`);
  assert.deepEqual(errors, []);
  await page.close();
});

test("layers of result and reference share one scale", async () => {
  const { page, errors } = await open(
    session.browser,
    `${session.url}#/case/a1_stokes/stokes/one?layer=S3&mode=swipe&swipe=1&zoom=8&x=16&y=16`,
  );
  await drawn(page, "result reference");
  await page.waitForFunction(() => document.querySelector(".ticks")?.textContent?.includes("−1"));
  const box = await page.locator(".stage").boundingBox();
  const [x, y] = [(box?.width ?? 0) / 2, (box?.height ?? 0) / 2];
  const left = await colourAt(page, x - 80, y);
  await page.evaluate(() => {
    location.hash = location.hash.replace("swipe=1", "swipe=0");
  });
  await page.waitForFunction(
    () => document.querySelector(".divider")?.getAttribute("aria-valuenow") === "0",
  );
  await drawn(page, "result reference");
  assert.deepEqual(await colourAt(page, x - 80, y), left);
  assert.deepEqual(errors, []);
  await page.close();
});

test("a target lists the effects that its scene calls for, and their cost", async () => {
  const { page, errors } = await open(session.browser, `${session.url}#/case/a1_stokes/stokes/one`);
  const effects = page.locator(".effects");
  await effects.waitFor();
  assert.match(await effects.innerText(), /stokes calls for polarised light paths/);
  assert.match(
    await effects.innerText(),
    /polarisation: material 'filter' is a polariser and 1 more/,
  );
  assert.match(await effects.innerText(), /spectral: material 'grey' is constant <b>/);
  assert.deepEqual(await effects.locator("tbody tr").allInnerTexts(), [
    "spectral\t× 0.80\t× 0.50\tmean -15 +- 0.1 %",
    "rgb\t× 0.60\t–\tmean -15 +- 0.2 %",
    "polarised-bispectral\t× 1.04\t× 1.04\tsame to the bit",
  ]);
  assert.deepEqual(errors, []);
  await page.close();
});

test("text of cases and logs is never markup", async () => {
  const { page, errors } = await open(session.browser, `${session.url}#/case/e1_markup/markup/one`);
  await page.locator(".logs pre").waitFor();
  assert.ok(
    (await page.locator(".logs pre").innerText()).includes(
      "</script><script>document.title='owned'",
    ),
  );
  assert.ok(!(await page.title()).includes("owned"));
  assert.equal(await page.locator("img[src=x]").count(), 0);
  assert.deepEqual(errors, []);
  await page.close();
});

test("the one-file page works from file:// and requests nothing", async () => {
  const file = join(session.scratch.folder, "page.html");
  report(join(session.scratch.folder, "small"), file);
  const { page, errors } = await open(session.browser, `file://${file}${values}&img=wobble`);
  await drawn(page, "wobble");
  await page.keyboard.press("1");
  await drawn(page, "result");
  await page.goto(`file://${file}#/case/e1_markup/markup/one`);
  await page.locator(".logs pre").waitFor();
  assert.ok(!(await page.title()).includes("owned"));
  await page.goto(`file://${file}#/charts`);
  await page.locator(".plot canvas").first().waitFor();
  assert.deepEqual(errors, []);
  await page.close();
});

test("two runs: better, worse, new and removed", async () => {
  const { page } = await open(session.browser, `${session.url}#/compare`);
  const rows = (kind: string) => page.locator(`section[data-kind=${kind}] tbody tr`);
  await rows("gone").waitFor();
  assert.match(await rows("better").innerText(), /m1_values\s+values\s+two/);
  assert.match(await rows("worse").innerText(), /e1_markup\s+markup\s+one/);
  assert.match(await rows("new").innerText(), /m9_new/);
  assert.match(await rows("gone").innerText(), /g9_gone/);
  // "two" took twice as long before; "three" was rendered on another machine.
  assert.match(await rows("better").innerText(), /× 0\.5\tA × B$/);
  const line = await page.locator(".compare-time").innerText();
  assert.match(
    line,
    /^Wall clock × 0\.\d+, geometric mean over \d+ targets; load at the start 0\.25 before, 0\.25 after\./,
  );
  assert.match(
    line,
    /measured on different machines \(another processor, 2 cores before, a processor, 2 cores after\)/,
  );
  await page.locator("section[data-kind=same] summary").click();
  assert.match(
    await rows("same").filter({ hasText: "three" }).first().innerText(),
    /measured on different machines\t$/,
  );
  await page.goto(`${session.url}#/compare?before=small&after=small&ra=one&rb=two`);
  await page.waitForFunction(() =>
    document.querySelector("section[data-kind=better]")?.textContent?.includes("one → two"),
  );
  await page.close();
});

test("the help lists the keys, and Escape closes it", async () => {
  const { page } = await open(session.browser, session.url + values);
  await drawn(page, "result");
  await page.keyboard.press("?");
  assert.match(await page.getByRole("dialog").innerText(), /exposure \+½ stop/);
  await page.keyboard.press("Escape");
  await page.waitForFunction(() => !document.querySelector("dialog"));
  assert.match(page.url(), /case/, "Escape only closed the help");
  await page.close();
});
