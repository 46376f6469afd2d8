// The page of a study of stability. fixture_stability.h says what is known of it.
import assert from "node:assert/strict";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import { launch, open } from "./browser";
import { report, Scratch, serve, type Served } from "./runs";

const scratch = new Scratch();
let browser: Browser;
let served: Served;
let folder = "";

before(async () => {
  browser = await launch();
  folder = scratch.run("stability");
  served = await serve(folder);
});

after(async () => {
  await browser?.close();
  served?.process.kill("SIGTERM");
  scratch.remove();
});

async function looksRight(url: string): Promise<void> {
  const { page, errors } = await open(browser, url);
  const matrix = page.locator("table.matrix");
  await matrix.waitFor();
  const rows = await matrix.locator("tbody tr").allInnerTexts();
  assert.match(rows[0] ?? "", /translate_matrix.*all, to 1e9 m.*to 1000 m; breaks at 1e4 m/s);
  assert.match(rows[1] ?? "", /rotate.*holds, to the bit.*holds/s);
  assert.match(rows[2] ?? "", /ground.*–.*–/s);
  // The first broken cell is chosen; its steps and the images of its first break are shown.
  const steps = page.getByRole("region", { name: "Steps" });
  assert.equal(await steps.locator("tbody tr").count(), 10);
  await steps.getByText("crashed <b>here</b>").waitFor();
  const images = page.locator(".break img");
  await images.nth(2).waitFor();
  assert.equal(await images.count(), 3);
  const width = await images.nth(2).evaluate((image: HTMLImageElement) => image.naturalWidth);
  assert.equal(width, 8);
  await matrix.getByRole("button", { name: "all, to 1e9 m" }).click();
  await page.getByRole("heading", { name: "translate_matrix by orbs" }).waitFor();
  assert.equal(await images.count(), 0);
  assert.deepEqual(errors, []);
  await page.close();
}

test("The matrix leads to the steps and images of each cell", async () => {
  await looksRight(served.url);
});

test("One file holds the page of the study with its images", async () => {
  const file = join(scratch.folder, "stability.html");
  report(folder, file);
  await looksRight(`file://${file}`);
});
