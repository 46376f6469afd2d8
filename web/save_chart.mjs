// Saves the chart "All targets" of a cost study as the page draws it:
//   node save_chart.mjs <build folder> <cost.json> <file.svg>
// Needs Debian's chromium.
import { spawn } from "node:child_process";
import { copyFileSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { chromium } from "playwright-core";

const [build, study, output] = process.argv.slice(2);
if (!output) throw new Error("usage: node save_chart.mjs <build folder> <cost.json> <file.svg>");
const folder = mkdtempSync(join(tmpdir(), "orbs-chart-"));
copyFileSync(study, join(folder, "cost.json"));
const server = spawn(join(build, "orbs"), ["serve", folder]);
const url = await new Promise((resolve) =>
  server.stdout.once("data", (text) => resolve(/http:\S+\//.exec(text)[0])),
);
const args = process.getuid() === 0 ? ["--no-sandbox"] : [];
const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args });
// Wide enough for four charts beside each other.
const page = await browser.newPage({
  colorScheme: "light",
  viewport: { width: 1040, height: 1200 },
});
await page.goto(url);
const panel = page.getByRole("region", { name: "All targets", exact: true });
await panel.locator("a svg").first().waitFor();
const [download] = await Promise.all([
  page.waitForEvent("download"),
  panel.getByRole("button", { name: "SVG", exact: true }).click(),
]);
await download.saveAs(output);
await browser.close();
server.kill("SIGTERM");
rmSync(folder, { recursive: true });
