// The path to a verdict: what each look saw, and how the looks ended. fixture_looks.h says what is known of the run.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import {
  barOf,
  endText,
  gateNumber,
  intervalText,
  pathsOf,
  shownRange,
} from "../../web/src/case/path_to_verdict";
import type { LookRecord, TargetDetail } from "../../web/src/data/generated";
import { open } from "./browser";
import { report } from "./runs";
import { startSession } from "./session";

const session = startSession("looks");

const look = (spp: number, verdict: string, gate: string, ...ends: (number | null)[]) =>
  ({ spp, verdict, gate, value: ends[0], low: ends[1], high: ends[2] }) as LookRecord;

/** A target by one render, which ended so. */
const detailOf = (looks: LookRecord[], end = "decided", outcome = "image", reason = "") =>
  ({
    looks,
    checks: [
      { what: "mean_ratio_g", min: -0.007, max: 0.007 },
      { what: "psnr_srgb8", min: 35 },
    ],
    measures: [{ name: "psnr_srgb8", unit: "dB" }],
    jobs: [
      {
        cost: { started: "2026-01-01T00:00:00", wall_seconds: 12 },
        end: { outcome, reason },
        sampling: { looks: looks.length, most_looks: 9, end },
      },
    ],
  }) as unknown as TargetDetail;

test("the gate of the last look comes first, each with its limits and its own looks", () => {
  const paths = pathsOf(
    detailOf([
      look(16, "inconclusive", "psnr_srgb8", 34, 33, 35),
      look(32, "inconclusive", "mean_ratio_g", 0, -0.01, 0.01),
      look(64, "inconclusive", "psnr_srgb8", 34, 33.5, 34.5),
      look(128, "fail", "mean_ratio_g", 0.02, 0.01, 0.03),
      look(256, "fail", "", undefined as never),
    ]),
  );
  assert.deepEqual(
    paths.map(({ gate, min, max, looks }) => [gate, min, max, looks.map(({ spp }) => spp)]),
    [
      ["mean_ratio_g", -0.007, 0.007, [32, 128]],
      ["psnr_srgb8", 35, undefined, [16, 64]],
    ],
  );
});

test("early intervals leave the limits large enough, and end in arrows", () => {
  const wide = look(16, "inconclusive", "mean_ratio_g", 0.1, -0.4, 0.6);
  const narrow = look(64, "pass", "mean_ratio_g", 0, -0.004, 0.004);
  const [path] = pathsOf(detailOf([wide, narrow]));
  assert.ok(path);
  const range = shownRange(path);
  assert.ok(range.high - range.low < 5 * 0.014, `${range.low} to ${range.high}`);
  assert.ok(range.low < -0.007 && range.high > 0.007);
  const bar = barOf(wide, range);
  assert.deepEqual([bar?.isOpenBelow, bar?.isOpenAbove], [true, true]);
  assert.deepEqual(barOf(narrow, range), {
    low: -0.004,
    high: 0.004,
    isOpenBelow: false,
    isOpenAbove: false,
  });
});

test("an end that is not there is open, and one number alone is a chart", () => {
  const oneEnd = look(16, "fail", "psnr_srgb8", 20, null, 21.5);
  const [path] = pathsOf(detailOf([oneEnd]));
  assert.ok(path);
  const bar = barOf(oneEnd, shownRange(path));
  assert.deepEqual([bar?.isOpenBelow, bar?.isOpenAbove, bar?.high], [true, false, 21.5]);
  const alone = { gate: "l1", looks: [look(16, "fail", "l1", 0.5, null, null)] };
  assert.deepEqual(shownRange(alone), { low: 0.45, high: 0.55 });
  assert.equal(barOf(look(16, "fail", "l1", 0.5, null, null), shownRange(alone)), undefined);
});

test("ratios of means are in per cent, other numbers in the unit of their metric", () => {
  const detail = detailOf([]);
  assert.equal(gateNumber(detail, "mean_ratio_g", 0.00123456), "0.123 %");
  assert.equal(gateNumber(detail, "psnr_srgb8", 34.25), "34.25 dB");
  assert.equal(gateNumber(detail, "edge_blur", 0.25), "0.25");
  assert.equal(gateNumber(detail, "psnr_srgb8", null as never), "–");
  const ends = (...numbers: (number | null)[]) =>
    intervalText(detail, look(1, "pass", "mean_ratio_g", ...numbers));
  assert.equal(ends(0, -0.01, 0.02), "-1 % to 2 %");
  assert.equal(ends(0, null, 0.02), "at most 2 %");
  assert.equal(ends(0, -0.01, null), "at least -1 %");
  assert.equal(ends(0, null, null), "–");
});

test("one sentence says how the looks ended", () => {
  const open = [look(16, "inconclusive", "mean_ratio_g", 0)];
  const decided = [...open, look(32, "fail", "mean_ratio_g", 0.02)];
  const of = (looks: LookRecord[], end: string, isLive = false) =>
    endText(detailOf(looks, end), isLive);
  assert.equal(of(decided, "decided"), "Decided after 32 samples in 2 looks (12.0 s).");
  assert.equal(of(open, "decided", true).startsWith("Stopped after 16 samples"), true);
  assert.match(of(open, "edge"), /^Stopped after 16 samples: the value lies too near to its limit/);
  assert.match(of(open, "budget"), /^Stopped after 16 samples: the budget of samples or time/);
  assert.match(of(open, "looks"), /^Stopped after 16 samples: the error rates allow no further/);
  assert.match(of(open, "reference"), /^Stopped after 16 samples: the reference allows no dec/);
  assert.equal(of(open, "an end of later"), "Stopped after 16 samples: an end of later.");
  assert.equal(of(open, "", true), "Goes on: 16 samples so far, in 1 look (12.0 s).");
  assert.match(of(open, ""), /^Stopped after 16 samples: the run ended before it was decided\.$/);
  const crashed = detailOf(open, "", "crash", "killed by SIGSEGV");
  assert.equal(endText(crashed, true), "Stopped after 16 samples: killed by SIGSEGV.");
  assert.equal(endText(detailOf([]), false), "");
});

async function showsThePath(url: string): Promise<void> {
  const { page, errors } = await open(session.browser, `${url}#/case/m3_lamp/lamp/one`);
  const section = page.locator(".path");
  await section.locator("svg .gate").first().waitFor();
  const gates = section.locator(".gate");
  assert.deepEqual(
    await gates.evaluateAll((all) => all.map((one) => one.getAttribute("data-gate"))),
    ["mean_ratio_g", "edge_blur"],
  );
  const marks = await gates
    .first()
    .locator(".look")
    .evaluateAll((all) => all.map((one) => `${one.getAttribute("data-spp")} ${one.classList[1]}`));
  assert.deepEqual(marks, ["32 tone-unsure", "64 tone-good"]);
  const texts = await gates.first().locator(".limit text").allTextContents();
  assert.deepEqual(texts, ["0.7 %", "-0.7 %"]);
  const ticks = await section.locator(".tick").allTextContents();
  assert.deepEqual(ticks, ["?16", "?32", "✓64"]);
  await section.getByText("Decided after 64 samples in 3 looks (1.20 s).").waitFor();
  await section.getByText("The numbers of each look").click();
  const rows = await section.locator("tbody tr").allInnerTexts();
  assert.equal(rows.length, 3);
  assert.match(rows[0] ?? "", /^16\s+\?\s*inconclusive\s+edge_blur\s+0\.11\s+-0\.02 to 0\.24$/);
  assert.match(rows[2] ?? "", /^64\s+✓\s*pass\s+mean_ratio_g\s+0\.12 %\s+-0\.27 % to 0\.51 %$/);
  assert.match(await page.locator(".cost tbody").innerText(), /^lamp\s+64\s+1\.20 s/);
  assert.deepEqual(errors, []);
  await page.close();
}

test("a target shows the path to its verdict", async () => {
  await showsThePath(session.url);
});

test("the one-file page shows it too", async () => {
  const file = join(session.scratch.folder, "looks.html");
  report(session.folder, file);
  await showsThePath(`file://${file}`);
});

test("a larger value is higher in the chart, and more samples are farther right", async () => {
  const { page } = await open(session.browser, `${session.url}#/case/m3_lamp/lamp/two`);
  await page.locator(".path .look circle").first().waitFor();
  const dots = await page
    .locator(".path .look circle")
    .evaluateAll((all) =>
      all.map(
        (one) => ["cx", "cy"].map((key) => Number(one.getAttribute(key))) as [number, number],
      ),
    );
  assert.equal(dots.length, 9);
  dots.slice(1).forEach(([x], i) => assert.ok(x > (dots[i]?.[0] ?? 0)));
  // The values lie in turn above and below the upper limit, the first above.
  const limit = Number(await page.locator(".path .limit line").first().getAttribute("y1"));
  const sides = dots.map(([, y]) => Math.sign(limit - y));
  assert.equal(sides[0], 1);
  sides.slice(1).forEach((side, i) => assert.equal(side, -(sides[i] ?? 0)));
  await page
    .getByText("Stopped after 4096 samples: the value lies too near to its limit for more")
    .waitFor();
  await page.close();
});

test("three gates have rows, and the fourth is named", async () => {
  const { page } = await open(session.browser, `${session.url}#/case/l2_mirror/mirror/two`);
  await page.locator(".path svg .gate").first().waitFor();
  const gates = await page
    .locator(".path .gate")
    .evaluateAll((all) => all.map((one) => one.getAttribute("data-gate")));
  assert.deepEqual(gates, ["mean_ratio_g", "local_bias", "edge_blur"]);
  await page.getByText("The table also has psnr_srgb8.").waitFor();
  await page.close();
});

test("without a gate there is no chart, and without looks no path", async () => {
  const { page, errors } = await open(
    session.browser,
    `${session.url}#/case/l2_mirror/mirror/three`,
  );
  await page.getByText("Decided after 16 samples in 1 look (3.00 s).").waitFor();
  assert.equal(await page.locator(".path svg").count(), 0);
  await page.goto(`${session.url}#/case/m3_lamp/lamp/three`);
  await page.getByText("What Light of a lamp tests.").waitFor();
  assert.equal(await page.locator(".path").count(), 0);
  assert.deepEqual(errors, []);
  await page.close();
});
