// Samples beside times, and renders that go on in looks. fixture_looks.h says what is known of the runs.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import type { Overview } from "../../web/src/data/generated";
import { worstCell, type Row } from "../../web/src/overview/rows";
import { open } from "./browser";
import { playLive, serve } from "./runs";
import { startSession } from "./session";

const session = startSession("looks");

test("the overview shows samples beside times, and sorts by them", async () => {
  const { page } = await open(
    session.browser,
    `${session.url}#/?by=target&show=wall_seconds&order=value`,
  );
  await page.locator(".grid .row.target").first().waitFor();
  const first = await page.locator(".grid .row.target").first().innerText();
  assert.match(first, /64 spp, 1\.20 s[^]*4096 spp, 45\.0 s[^]*64 spp, 2\.00 s/);
  await page.goto(`${session.url}#/?by=target&show=spp&order=value`);
  await page.locator(".cell .value", { hasText: /^4096$/ }).waitFor();
  await page.close();
});

test("a preliminary verdict is no failure in the order of the overview", () => {
  const overview = (preliminary: number) =>
    ({
      states: [
        { name: "inconclusive", failure: true },
        { name: "known", failure: false },
      ],
      cells: { state: [0, 1], declared: [1, 1], preliminary: [preliminary, 0] },
    }) as unknown as Overview;
  const row = { cells: [0, 1] } as Row;
  assert.equal(worstCell(overview(0), row, [0, 1]), 0);
  assert.equal(worstCell(overview(1), row, [0, 1]), 1);
});

test("a render that goes on is shown with its preliminary verdict and its samples", async () => {
  const folder = join(session.scratch.folder, "live-looks");
  const run = await playLive(folder, "live-looks");
  const served = await serve(folder);
  const { page, errors } = await open(session.browser, `${served.url}#/?by=target&order=given`);
  await page.getByText("0 of 2 renders done").waitFor();
  run.stdin?.write("look\n");
  const cell = page.locator(".cell a.preliminary");
  await cell.filter({ hasText: "goes on: 16 samples so far" }).waitFor();
  assert.equal(await cell.locator(".word").innerText(), "inconclusive");
  await page.getByText("one first (16 samples so far)").waitFor();
  await page.goto(`${served.url}#/case/m3_lamp/first/one`);
  await page.locator(".verdict").getByText("goes on: 16 samples so far").waitFor();
  await page.getByText("Goes on: 16 samples so far, in 1 look (").waitFor();
  run.stdin?.write("look\n");
  await page.locator(".verdict").getByText("goes on: 32 samples so far").waitFor();
  await page.getByText("Goes on: 32 samples so far, in 2 looks (").waitFor();
  run.stdin?.write("look\n");
  await page.getByText("Decided after 64 samples in 3 looks (2.40 s).").waitFor();
  assert.equal(await page.locator(".goes-on").count(), 0);
  assert.deepEqual(errors, []);
  await page.close();
  run.stdin?.end();
  served.process.kill("SIGTERM");
});

test("a run that was ended between two looks says so", async () => {
  const folder = join(session.scratch.folder, "ended-looks");
  const run = await playLive(folder, "live-looks");
  const ended = new Promise((resolve) => run.on("exit", resolve));
  run.stdin?.end("look\nlook\n");
  await ended;
  const served = await serve(folder);
  const { page } = await open(session.browser, `${served.url}#/case/m3_lamp/first/one`);
  await page.getByText("Stopped after 32 samples: the run ended before it was decided.").waitFor();
  assert.equal(await page.locator(".goes-on").count(), 0);
  await page.close();
  served.process.kill("SIGTERM");
});
