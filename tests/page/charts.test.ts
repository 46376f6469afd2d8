// Charts: the points that they show, and the notes about those that they cannot show.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { changeOverview, open, type SomeOverview } from "./browser";
import { startSession } from "./session";

const session = startSession("small");

/** The charts of a run whose `metric` has only these values, by the index of the cell. */
async function charts(
  query: string,
  metric: string,
  values: Record<number, number>,
  change: (overview: SomeOverview) => void = () => undefined,
): Promise<{ page: Page; errors: string[] }> {
  const { page, errors } = await open(session.browser, "about:blank");
  await changeOverview(page, (overview) => {
    const column = overview.measures[metric];
    assert.ok(column);
    column.fill(null);
    for (const [cell, value] of Object.entries(values)) column[Number(cell)] = value;
    change(overview);
  });
  await page.goto(`${session.url}#/charts?${query}`);
  await page.locator(".chart").first().waitFor();
  return { page, errors };
}

const first = (page: Page) => page.locator(".chart").first();

test("a click on a point opens its target", async () => {
  // Cells 0, 2 and 3 are of "one"; 0 is halfway between -1 and 1, in the middle of the chart.
  const { page, errors } = await charts("of=lean", "lean", { 0: -1, 2: 0, 3: 1 });
  const over = first(page).locator(".u-over");
  await over.waitFor();
  const box = await over.boundingBox();
  assert.ok(box);
  // The second of three targets on the axis; of its three renderers "one" is the left.
  await page.mouse.click(box.x + (box.width * (1.5 - 1 / 6)) / 3, box.y + box.height / 2);
  await page.waitForSelector(".case");
  assert.match(page.url(), /#\/case\/a1_stokes\/stokes\/one$/);
  assert.deepEqual(errors, []);
  await page.close();
});

test("quantities without positive values are offered, on a linear axis", async () => {
  const { page } = await charts("of=l1&cx=lean", "l1", { 0: -2, 2: -1, 3: 0 });
  assert.match(await first(page).locator("h2").innerText(), /l1/);
  await first(page).locator(".plot canvas").waitFor();
  assert.equal(await first(page).locator(".left-out").count(), 0);
  await page.close();
});

test("points that a chart cannot show are counted below it", async () => {
  const { page } = await charts("of=l1", "l1", { 0: 0, 1: 0, 2: 0.25, 3: 4 });
  assert.equal(
    await first(page).locator(".left-out").innerText(),
    "2 of 4 points are not shown: 2 are 0, which a logarithmic axis cannot show.",
  );
  await page.close();
});

test("infinite values are counted below the chart", async () => {
  const { page } = await charts(
    "of=psnr_srgb8",
    "psnr_srgb8",
    { 2: 30 },
    (overview) => (overview.infinite = { psnr_srgb8: [0] }),
  );
  assert.equal(
    await first(page).locator(".left-out").innerText(),
    "1 of 2 points is not shown: 1 is infinite.",
  );
  await page.close();
});

test("a quantity with only infinite values is offered, with a note", async () => {
  const { page } = await charts(
    "of=psnr_srgb8",
    "psnr_srgb8",
    {},
    (overview) => (overview.infinite = { psnr_srgb8: [0, 2] }),
  );
  assert.match(await first(page).locator("h2").innerText(), /psnr_srgb8/);
  assert.equal(
    await first(page).locator(".left-out").innerText(),
    "2 of 2 points are not shown: 2 are infinite.",
  );
  assert.equal(await first(page).locator(".plot").count(), 0);
  await page.close();
});
