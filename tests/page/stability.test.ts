// The page of a study of stability. fixture_stability.h says what is known of it.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { open } from "./browser";
import { report } from "./runs";
import { startSession } from "./session";

const session = startSession("stability");

async function looksRight(url: string): Promise<void> {
  const { page, errors } = await open(session.browser, url);
  const matrix = page.locator("table.matrix");
  await matrix.waitFor();
  const rows = await matrix.locator("tbody tr").allInnerTexts();
  assert.match(
    rows[0] ?? "",
    /the world moved, by its matrices.*all, to 1e9 m.*to 1000 m; breaks at 1e4 m/s,
  );
  assert.match(rows[1] ?? "", /world and camera turned.*holds, to the bit.*holds/s);
  assert.match(rows[2] ?? "", /a larger ground.*not applicable.*not applicable/s);
  await page.getByText("cycles: 1 of 2 changes leave the image right.").waitFor();
  // The first broken cell is chosen; its steps and the images of its first break are shown.
  const steps = page.getByRole("region", { name: "Steps" });
  assert.equal(await steps.locator("tbody tr").count(), 10);
  await steps.getByText("crashed <b>here</b>").waitFor();
  // One mark for each step of both scenes; that without an image says so.
  const chart = steps.locator(".sweep-chart > svg");
  assert.equal(await chart.locator("title").count(), 10);
  await chart.getByText("no image", { exact: true }).waitFor();
  const images = page.locator(".break img");
  await images.nth(2).waitFor();
  assert.equal(await images.count(), 3);
  const width = await images.nth(2).evaluate((image: HTMLImageElement) => image.naturalWidth);
  assert.equal(width, 8);
  await matrix.getByRole("button", { name: "all, to 1e9 m" }).click();
  await page.getByRole("heading", { name: "The world moved, by its matrices: orbs" }).waitFor();
  assert.equal(await images.count(), 0);
  assert.deepEqual(errors, []);
  await page.close();
}

test("The matrix leads to the steps and images of each cell", async () => {
  await looksRight(session.url);
});

test("One file holds the page of the study with its images", async () => {
  const file = join(session.scratch.folder, "stability.html");
  report(session.folder, file);
  await looksRight(`file://${file}`);
});
