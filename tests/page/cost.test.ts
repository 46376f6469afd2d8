// The page of a cost study. fixture_cost.h says what is known of it.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { open, settled } from "./browser";
import { output, report } from "./runs";
import { startSession } from "./session";

const session = startSession("cost", "small");

interface SomeComparison {
  target: number;
  level: number;
  first: number;
  second: number;
  time_ratio: unknown;
  ranking: string;
}

/** The members of cost.json that tests change. */
interface SomeStudy {
  finished: boolean;
  renderers: { name: string }[];
  comparisons: SomeComparison[];
  self_comparison: { passed: boolean; scenes: unknown[]; time_ratio: unknown } | null;
  curves: {
    target: number;
    renderer: number;
    points: { below_reference_noise: boolean }[];
    times_to_error: { level: number; cpu_seconds: unknown }[];
  }[];
}

/** The page of the study, with changes to the cost.json that the server sends. */
async function openStudy(
  hash = "",
  change: (study: SomeStudy) => void = () => undefined,
): Promise<{ page: Page; errors: string[] }> {
  const { page, errors } = await open(session.browser, "about:blank");
  await page.route("**/cost.json", async (route) => {
    try {
      const study = (await (await route.fetch()).json()) as SomeStudy;
      change(study);
      await route.fulfill({ json: study });
    } catch (error) {
      // An unfinished study is read again every 5 s, also while its page is being closed.
      if (!page.isClosed()) throw error;
    }
  });
  await page.goto(`${session.url}#/${hash}`);
  await page.locator(".cost-plot svg").waitFor();
  return { page, errors };
}

const shownImage = (page: Page): Promise<string | null> =>
  page.locator(".pictures img").first().getAttribute("data-file");

/** In pixels, once the browser has decoded them: an element is there before its image is. */
const widthsOfImages = (page: Page): Promise<number[]> =>
  page.locator(".pictures img").evaluateAll(async (elements) => {
    const images = elements as HTMLImageElement[];
    await Promise.all(images.map((image) => image.decode()));
    return images.map((image) => image.naturalWidth);
  });

const rowsOf = (page: Page): Promise<string[]> => page.locator(".times tbody tr").allInnerTexts();

test("a sentence and a bar per level say who is fastest", async () => {
  const { page, errors } = await openStudy();
  // Of six targets two are too noisy for 35 dB, and on 205 orbs and cycles are too alike: the ratios of four
  // targets scatter too much to say anything of others.
  assert.equal(
    await page.locator(".answer").innerText(),
    "At 35 dB orbs is fastest on 3 of the 4 targets on which any renderer reaches it; " +
      "no difference is shown to cycles on average, povray takes 5.7 times as long.",
  );
  const level = page.locator("tr[data-level='40']");
  assert.deepEqual(await level.locator(".win").allInnerTexts(), [
    "2 orbs",
    "1 no difference",
    "3 not reached",
  ]);
  // 12.9 by the model; between two points near the floor the interpolation is 4 % above it, in its interval.
  assert.match(await level.locator(".ratios").innerText(), /povray × 13\.4 .*on 1 target/);
  await page.getByLabel("Time, × that of").selectOption("povray");
  await page.waitForFunction(() => location.hash.includes("base=povray"));
  assert.match(await level.locator(".ratios").innerText(), /orbs × 0\.074\d? .*on 1 target/);
  assert.deepEqual(errors, []);
  await page.close();
});

test("a time before the first point counts as reached, and its bound may decide", async () => {
  // On 101 orbs is said to be faster at 45 dB than its first point: only the ranking says so.
  const { page } = await openStudy("", (study) => {
    for (const time of study.curves[0]?.times_to_error ?? [])
      if (time.level === 45)
        Object.assign(time, { cpu_seconds: null, bound: "at most", bound_seconds: 0.06 });
    for (const one of study.comparisons)
      if (one.target === 0 && one.level === 45 && one.first === 0)
        Object.assign(one, { time_ratio: null, ranking: "slower" });
  });
  const parts = await page.locator("tr[data-level='45'] .win").allInnerTexts();
  assert.deepEqual(parts.slice(0, 1), ["1 orbs"], String(parts));
  await page.close();
});

test("a mean ratio has the same interval on the page and in the terminal", async () => {
  const { page, errors } = await openStudy();
  const terminal = output("cost", "--show", session.folder);
  const ratios = await page.locator("tr[data-level='35'] .ratios li").allInnerTexts();
  assert.equal(ratios.length, 2);
  for (const ratio of ratios) {
    const [, name, numbers] = /^(\w+) × (\S+ \(\S+ to \S+\))/.exec(ratio) ?? [];
    assert.ok(
      terminal.includes(`${name} takes ${numbers} times as long`),
      `${ratio} in ${terminal}`,
    );
  }
  assert.deepEqual(errors, []);
  await page.close();
});

test("the page says what other work took, of what times are made, and how equal equals are", async () => {
  const { page, errors } = await openStudy();
  const about = await page.locator(".about").innerText();
  assert.match(about, /1 of 529 renders left out, since others took more than 5 %.*; 2 repeats/);
  assert.match(about, /no difference shown: orbs on 6 targets, time × 1 \(/);
  const rows = await page.locator(".fits tbody tr").allInnerTexts();
  assert.match(rows[0] ?? "", /^orbs\s+50 ms \(.*\)\s+0\.824 s \(.*\)\s+4\.12 s \(/);
  assert.match(rows[2] ?? "", /^povray\s+0\.1\d* s \(.*\)\s+–\s+–/);
  assert.deepEqual(errors, []);
  await page.close();
});

test("a study of an earlier version is shown without what it lacks", async () => {
  const { page, errors } = await openStudy("", (study) => {
    for (const name of ["mean_ratios", "other_load"]) Reflect.deleteProperty(study, name);
    for (const curve of study.curves) Reflect.deleteProperty(curve, "unmeasured");
    for (const point of study.curves.flatMap(({ points }) => points))
      Reflect.deleteProperty(point, "trial_seconds");
    const { time_ratio } = study.self_comparison!;
    const self = { renderer: 0, target: 4, pairs: 4, time_ratio, error_ratio: time_ratio };
    Object.assign(study, { self_comparison: { ...self, known: true, passed: true } });
  });
  assert.match(
    await page.locator(".answer").innerText(),
    /orbs is fastest on 3 of the 4 targets.*it\.$/,
  );
  assert.match(await page.locator(".who").innerText(), /earlier orbs wrote this study/);
  const about = await page.locator(".about").innerText();
  assert.match(about, /Other work on the machine\s+not measured/);
  assert.match(about, /no difference shown: orbs on 301, time/);
  assert.deepEqual(errors, []);
  await page.close();
});

test("a failed comparison of a renderer with itself hides the ranking", async () => {
  const { page } = await openStudy("", (study) => {
    study.comparisons = [];
    study.self_comparison = {
      passed: false,
      scenes: [],
      time_ratio: { value: 1.2, low: 1.1, high: 1.3 },
    };
  });
  const text = await page.locator(".who").innerText();
  assert.match(text, /Nobody is ranked.*time × 1\.2 \(1\.1 to 1\.3\)/s);
  assert.equal(await page.locator(".answer, .wins").count(), 0);
  assert.ok(!(await page.locator(".times tbody").innerText()).includes("★"));
  await page.close();
});

test("the chart has a point per setting, fits, a floor, levels and a frontier", async () => {
  const { page, errors } = await openStudy("?target=101");
  const plot = page.locator(".cost-plot");
  assert.equal(await plot.locator(".point").count(), 3 * 6);
  assert.equal(await plot.locator(".fit").count(), 3);
  assert.equal(await plot.locator(".band").count(), 3);
  assert.equal(await plot.locator(".floor").count(), 1);
  assert.equal(await plot.locator(".level").count(), 3);
  assert.equal(await plot.locator(".frontier").count(), 1);
  assert.equal(await page.locator(".multiples a svg").count(), 6);
  // The fit describes only relMSE over CPU seconds.
  await page.getByLabel("x axis").selectOption("render_seconds");
  await page.waitForFunction(() => !document.querySelector(".cost-plot .fit"));
  assert.equal(await plot.locator(".point").count(), 2 * 6, "povray says no render time");
  await page.getByLabel("y axis").selectOption("psnr_srgb8");
  await page.waitForFunction(() => document.querySelectorAll(".cost-plot .level").length === 4);
  assert.match(page.url(), /x=render_seconds&y=psnr_srgb8|y=psnr_srgb8.*x=render_seconds/);
  assert.deepEqual(errors, []);
  await page.close();
});

test("the reference's noise is a line, and points near it are hollow", async () => {
  const { page } = await openStudy("", (study) => {
    const last = study.curves[0]?.points[5];
    if (last) last.below_reference_noise = true;
    Object.assign((study as unknown as { targets: object[] }).targets[0]!, {
      reference_noise: { relmse: 1e-3 },
    });
  });
  assert.equal(await page.locator(".cost-plot .reference-noise").count(), 1);
  const panel = await page.evaluate(() =>
    getComputedStyle(document.documentElement).getPropertyValue("--panel").trim(),
  );
  const disc = page.locator("[data-point='0/5'] circle").last();
  assert.equal(await disc.getAttribute("fill"), panel);
  await page.close();
});

test("hover and focus say all numbers of a point", async () => {
  const { page } = await openStudy("?target=101");
  const expected = [
    "cycles, 256 spp",
    "1.17 s (1.11 s to 1.23 s)",
    "0.701 s",
    "0.584 s",
    "0.00286 (0.00249 to 0.00324)",
    "2.86e-4",
    "35.4 (34.9 to 36) dB",
    "0.0535",
  ];
  const point = page.locator("[data-point='1/3']");
  const check = async (): Promise<void> => {
    const tip = await page.locator(".point-tip").innerText();
    for (const part of expected) assert.ok(tip.includes(part), `${part} in ${tip}`);
  };
  await point.hover();
  await check();
  await page.mouse.move(0, 0);
  await page.waitForFunction(() => !document.querySelector(".point-tip"));
  await point.focus();
  await check();
  await page.close();
});

test("a click or Enter on a point opens its image beside the reference", async () => {
  const { page, errors } = await openStudy("?target=101");
  await page.locator("[data-point='2/4']").click();
  await page.locator("img[data-file='images/povray/101/4.png']").waitFor();
  await page.locator("img[data-file='images/reference/101.exr']").waitFor();
  assert.deepEqual(await widthsOfImages(page), [64, 64]);
  assert.match(page.url(), /point=povray%2F4/);
  await page.locator("[data-point='0/1']").focus();
  await page.keyboard.press("Enter");
  await page.locator("img[data-file='images/orbs/101/1.png']").waitFor();
  await page.getByRole("button", { name: "Next setting" }).click();
  await page.locator("img[data-file='images/orbs/101/2.png']").waitFor();
  await page.keyboard.down("Shift");
  await page.waitForFunction(
    () => document.querySelectorAll("img[data-file='images/reference/101.exr']").length === 2,
  );
  await page.keyboard.up("Shift");
  assert.deepEqual(errors, []);
  await page.close();
});

test("a small chart opens its target, and text of the study is never markup", async () => {
  const { page } = await openStudy();
  await page.locator(".multiples a", { hasText: "Furnace <b>test</b>" }).click();
  await page.getByRole("region", { name: "M6 g4-lambert: Furnace <b>test</b>" }).waitFor();
  assert.match((await shownImage(page)) ?? "", /g4-lambert/);
  await page.keyboard.press("[");
  await page.getByRole("region", { name: "M5 301: Depth of field" }).waitFor();
  await page.close();
});

test("the table of times sorts by each column, without a time last", async () => {
  const { page } = await openStudy();
  assert.match((await rowsOf(page))[0] ?? "", /^101\s+orbs\s+★ 0\.150 s/);
  const head = page.locator(".times thead th", { hasText: "30 dB" });
  await head.getByRole("button").click();
  assert.equal(await head.getAttribute("aria-sort"), "ascending");
  let rows = await rowsOf(page);
  assert.match(rows[1] ?? "", /^110\s+orbs\s+★ 0\.300 s/);
  assert.match(rows.at(-1) ?? "", /not reached/);
  await head.getByRole("button").click();
  assert.equal(await head.getAttribute("aria-sort"), "descending");
  rows = await rowsOf(page);
  assert.match(rows[0] ?? "", /^248\s+povray\s+10\.7 s/);
  assert.match(rows.at(-1) ?? "", /not reached/);
  await page.locator("input[type=search]").fill("glass");
  await page.waitForFunction(() => document.querySelectorAll(".times tbody tr").length === 3);
  assert.equal(await page.locator(".multiples a svg").count(), 1);
  await page.close();
});

/** Saves by a button of a panel; the name and the text of the file. */
async function saved(page: Page, region: string, button: string) {
  const panel = page.getByRole("region", { name: region, exact: true });
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    panel.getByRole("button", { name: button, exact: true }).click(),
  ]);
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

test("charts are saved as SVG, PNG and CSV", async () => {
  const { page, errors } = await openStudy("?target=101");
  const title = "M1 101: Lambertian reflection";
  const svg = await saved(page, title, "SVG");
  assert.equal(svg.name, "M1-101-Lambertian-reflection.svg");
  assert.match(svg.bytes.toString(), /^<svg xmlns.*Lambertian reflection<\/text>/s);
  assert.ok(
    !/ class="[^"]*"[^>]*style=|var\(--/.test(svg.bytes.toString()),
    "needs no style sheet",
  );
  const png = await saved(page, "All targets", "PNG");
  assert.equal(png.bytes.subarray(1, 4).toString(), "PNG");
  const csv = (await saved(page, title, "CSV")).bytes.toString().trim().split("\r\n");
  assert.equal(csv.length, 1 + 3 * 6);
  assert.match(csv[1] ?? "", /^101,orbs,4 spp,4,4,0\.058,/);
  const times = (await saved(page, "Times to error", "CSV")).bytes.toString().trim().split("\r\n");
  assert.equal(times.length, 1 + 6 * 3 * 7);
  assert.deepEqual(errors, []);
  await page.close();
});

test("a study stands beside runs, and comparisons of runs do not offer it", async () => {
  const { page, errors } = await openStudy();
  const choice = page.locator("header select");
  assert.deepEqual(await choice.locator("option").allInnerTexts(), ["cost (cost)", "small"]);
  await choice.selectOption("small");
  await page.locator(".grid").waitFor();
  await page.goto(`${session.url}#/compare?run=small`);
  await page.locator(".compare section").first().waitFor();
  assert.equal(await page.getByRole("combobox", { name: "Before: run" }).count(), 0);
  await page.locator("header select").selectOption("cost");
  await page.locator(".cost-plot svg").waitFor();
  assert.deepEqual(errors, []);
  await page.close();
});

test("an unfinished study says so, and ranks nobody before its comparisons", async () => {
  const { page } = await openStudy("", (study) => {
    study.finished = false;
    study.comparisons = [];
    study.self_comparison = null;
  });
  assert.match(await page.locator(".who").innerText(), /Nobody is ranked yet/);
  assert.equal(await page.locator(".wins").count(), 0);
  assert.match(await page.locator("header [role=status]").innerText(), /not finished/);
  await page.close();
});

test("the page fits a narrow screen", async () => {
  const { page } = await openStudy();
  await page.setViewportSize({ width: 390, height: 800 });
  await page.waitForFunction(
    () => (document.querySelector(".cost-plot svg")?.getBoundingClientRect().width ?? 999) < 390,
  );
  const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.ok(over <= 0, `${over} px too wide`);
  await page.close();
});

test("the one-file page of a study works from file:// and requests nothing", async () => {
  const file = join(session.scratch.folder, "cost.html");
  report(join(session.scratch.folder, "cost"), file);
  const { page, errors } = await open(session.browser, `file://${file}#/?target=110`);
  await page.locator("[data-point='1/2']").click();
  await page.locator("img[data-file='images/cycles/110/2.png']").waitFor();
  await page.locator("img[data-file='images/reference/110.exr']").waitFor();
  assert.deepEqual(await widthsOfImages(page), [64, 64]);
  assert.match(await page.locator(".answer").innerText(), /At 35 dB orbs is fastest/);
  assert.equal((await saved(page, "M2 110: Glass", "PNG")).bytes.subarray(1, 4).toString(), "PNG");
  assert.deepEqual(errors, []);
  await page.close();
});

test("of many renderers the ratios to one of them are bars, the fastest first", async () => {
  const { page, errors } = await openStudy("", (study) => {
    const more = ["four", "five"].map((name) => ({ ...study.renderers[0]!, name }));
    study.renderers.push(...more);
  });
  const rows = page.locator(".ratio-bars tr:not(.axis)");
  const names = async (): Promise<string[]> =>
    (await rows.locator("th").allInnerTexts()).map((name) => name.trim());
  await rows.first().waitFor();
  assert.equal((await names())[0], "orbs");
  assert.match(await rows.nth(0).innerText(), /the measure of the others/);
  assert.match(await rows.nth(1).innerText(), /cycles\s+× [\d.]+ \([\d.]+ to [\d.]+\)/);
  assert.match(await rows.last().innerText(), /does not reach this quality/);
  // The sentence names no ratio of five renderers.
  assert.doesNotMatch(await page.locator(".answer").innerText(), /times as long/);
  const bars = await rows
    .locator(".ratio-bar")
    .evaluateAll((all) => all.map((bar) => bar.getBoundingClientRect().width));
  assert.ok(bars[1]! > 10 && bars[0]! < 5, bars.join(" "));
  await page.getByLabel("as a multiple of those of").selectOption("cycles");
  await page.waitForFunction(() => location.hash.includes("base=cycles"));
  assert.match(await rows.nth(0).innerText(), /orbs\s+× 0\.\d/);
  await page.getByLabel("CPU seconds to").selectOption("30");
  await page.waitForFunction(() => location.hash.includes("at=30"));
  await page.setViewportSize({ width: 390, height: 844 });
  await settled(page); // charts follow the width of the window
  const widest = (): Promise<string[]> =>
    page.evaluate(() =>
      [...document.querySelectorAll(".ratio-bars, .ratio-bars *")]
        .filter((element) => element.getBoundingClientRect().right > innerWidth)
        .map((element) => element.className),
    );
  assert.deepEqual(await widest(), []);
  assert.deepEqual(errors, []);
  await page.close();
});
