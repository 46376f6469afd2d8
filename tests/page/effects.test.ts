// The view of the suite: which scenes need which effects, and what each costs.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { open } from "./browser";
import { report } from "./runs";
import { startSession } from "./session";

const session = startSession("small");

test("each scene says what its effects cost, and links to its target", async () => {
  const { page, errors } = await open(session.browser, `${session.url}#/effects`);
  const row = page.locator(".effect-matrix tbody tr");
  await row.waitFor();
  const cells = (await row.locator("td").allInnerTexts()).map((text) => text.split("\n"));
  // The cost of polarisation is the inverse of the time ratio without it, and so is its range.
  assert.deepEqual(cells[1], ["× 1.25", "1.18 to 1.33", "mean -15 +- 0.1 %"]);
  assert.deepEqual(cells[2], ["× 1.04", "1.02 to 1.06"]);
  const notes = (await page.locator(".effect-notes").allInnerTexts()).join(" ");
  assert.match(notes, /1 of 1 measurements with a richer transport .* same image to the\s+bit/);
  assert.match(notes, /in 0 of 16 renders, after 1 repeats/);
  assert.match(notes, /\(A\/A\): × 1\.001 \(95 %: 0\.980 to 1\.020\), so no difference was found/);
  await row.locator("td a").first().click();
  await page.waitForSelector(".case");
  assert.match(page.url(), /#\/case\/a1_stokes\/stokes\/one$/);
  assert.deepEqual(errors, []);
  await page.close();
});

test("the page of a phone is no wider than the phone", async () => {
  const viewport = { width: 390, height: 844 };
  const { page } = await open(session.browser, `${session.url}#/effects`, { viewport });
  await page.locator(".effect-matrix").waitFor();
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  await page.close();
});

test("the one-file page shows the same", async () => {
  const file = join(session.scratch.folder, "effects.html");
  report(join(session.scratch.folder, "small"), file);
  const { page, errors } = await open(session.browser, `file://${file}#/effects`);
  await page.getByText("× 1.25").first().waitFor();
  assert.deepEqual(errors, []);
  await page.close();
});
