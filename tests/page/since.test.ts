// Two studies of cost of the same scenes: what changed between them.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { join } from "node:path";
import { test } from "node:test";
import { seriesOfNames } from "../../web/src/charts/series";
import { open } from "./browser";
import { output } from "./runs";
import { startSession } from "./session";

const session = startSession("cost-later", "cost", "small");

test("a later study says by what factor each renderer changed, as the terminal does", async () => {
  const { page, errors } = await open(session.browser, session.url);
  const panel = page.getByRole("region", { name: "Since the earlier study" });
  assert.equal(
    await panel.locator(".since-answer").innerText(),
    "At 35 dB: orbs takes 1.5 times the time; no change of cycles is shown; no change of povray is shown.",
  );
  const [orbs, cycles] = await panel.locator("tbody tr").allInnerTexts();
  const factor = /× (1\.5 \(\S+ to \S+\))\s/.exec(orbs ?? "")?.[1] ?? "none";
  const earlier = join(session.scratch.folder, "cost");
  const terminal = spawnSync(
    join(process.env["ORBS_BINARY_DIR"] ?? "", "orbs"),
    ["compare-runs", earlier, session.folder],
    { encoding: "utf8" },
  );
  assert.equal(terminal.status, 1, "a time is longer");
  assert.ok(terminal.stdout.includes(factor), `${factor} in ${terminal.stdout}`);
  assert.match(orbs ?? "", /orbs 1\.0 → orbs 1\.1/);
  assert.match(cycles ?? "", /no change shown.*cycles 1\.0 in both/s);
  assert.deepEqual(errors, []);
  await page.close();
});

test("an earlier study names what it is compared with, and the level is that of the answer", async () => {
  const { page } = await open(session.browser, `${session.url}#/?run=cost&at=40`);
  const panel = page.getByRole("region", { name: "Since the earlier study" });
  assert.equal(await panel.getByLabel("Earlier study").inputValue(), "cost-later");
  assert.match(
    await panel.locator(".since-answer").innerText(),
    /^At 40 dB: orbs takes 0\.667 times/,
  );
  await page.close();
});

test("a run is no study to compare with", () => {
  const run = join(session.scratch.folder, "small");
  assert.throws(() => output("compare-runs", run, session.folder), /results\.json/);
});

test("a renderer keeps its place in the palette where others are missing", () => {
  assert.deepEqual(seriesOfNames(["orbs", "cycles", "povray"]), [0, 1, 2]);
  assert.deepEqual(seriesOfNames(["pbrt", "mine", "orbs"]), [4, 6, 0]);
  assert.deepEqual(seriesOfNames(["hydra-mispt", "hydra-shadowpt", "a"]), [5, 6, 7]);
});
