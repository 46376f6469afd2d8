// What the tests stand on: runs made once, orbs serving them, a browser.
import { spawn, spawnSync, type ChildProcess } from "node:child_process";
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import type { Socket } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import type { Browser, Page } from "playwright-core";

const source = process.env["ORBS_SOURCE_DIR"] ?? "";
export const build = process.env["ORBS_BINARY_DIR"] ?? "";
const { chromium } = createRequire(join(source, "web/package.json"))(
  "playwright-core",
) as typeof import("playwright-core");

/** Folders that are gone when the tests end. */
export class Scratch {
  readonly folder = mkdtempSync(join(tmpdir(), "orbs-page-"));
  run(kind: string): string {
    const folder = join(this.folder, kind);
    const made = spawnSync(join(build, "orbs-page-fixture"), [kind, folder]);
    if (made.status !== 0) throw new Error(`orbs-page-fixture ${kind}: ${made.stderr}`);
    return folder;
  }
  remove(): void {
    rmSync(this.folder, { recursive: true, force: true });
  }
}

// A test that fails ends before it can end its server: Node must not wait for that, but end it.
const children: ChildProcess[] = [];
process.on("exit", () => children.forEach((child) => child.kill("SIGKILL")));

/** Starts a program of the build and waits for the first line that it writes. */
async function startChild(
  program: string,
  args: string[],
  stdin: "pipe" | "ignore",
): Promise<{ child: ChildProcess; line: string }> {
  const child = spawn(join(build, program), args, { stdio: [stdin, "pipe", "inherit"] });
  children.push(child);
  const line = await firstLine(child);
  child.unref();
  for (const pipe of [child.stdin, child.stdout]) (pipe as Socket | null)?.unref();
  return { child, line };
}

function firstLine(process: ChildProcess): Promise<string> {
  return new Promise((resolve, reject) => {
    let text = "";
    process.stdout?.on("data", (bytes: Buffer) => {
      text += bytes.toString();
      if (text.includes("\n")) resolve(text.slice(0, text.indexOf("\n")));
    });
    process.on("exit", (code) => reject(new Error(`ended with ${code}: ${text}`)));
  });
}

export interface Served {
  url: string;
  process: ChildProcess;
}

export async function serve(...runs: string[]): Promise<Served> {
  const { child, line } = await startChild("orbs", ["serve", ...runs], "ignore");
  return { url: /http:\S+\//.exec(line)?.[0] ?? "", process: child };
}

/** A run that goes on; a line on its stdin ends a render. */
export async function playLive(folder: string): Promise<ChildProcess> {
  return (await startChild("orbs-page-fixture", ["live", folder], "pipe")).child;
}

export function report(run: string, output: string): void {
  const made = spawnSync(join(build, "orbs"), ["report", run, "-o", output, "--exact"]);
  if (made.status !== 0) throw new Error(`orbs report: ${made.stderr}`);
}

export async function launch(): Promise<Browser> {
  const executablePath = [
    "/usr/bin/chromium",
    "/usr/bin/chromium-browser",
    "/usr/bin/google-chrome",
  ].find(existsSync);
  if (!executablePath) throw new Error("there is no Chromium; './bootstrap test' installs it");
  // Drawn in software: the same image on every machine. Chromium's sandbox does not run as root in a container.
  const args = [
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    ...(process.getuid?.() === 0 ? ["--no-sandbox"] : []),
  ];
  return chromium.launch({ executablePath, args });
}

/** A page that makes its test fail on every error in the console, and on every request to elsewhere. */
export async function open(
  browser: Browser,
  url: string,
  options: Parameters<Browser["newPage"]>[0] = {},
): Promise<{ page: Page; errors: string[] }> {
  const page = await browser.newPage({ viewport: { width: 1280, height: 900 }, ...options });
  page.setDefaultTimeout(15000);
  const errors: string[] = [];
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("console", (message) => {
    if (message.type() === "error") errors.push(message.text());
  });
  page.on("request", (request) => {
    const { hostname, protocol } = new URL(request.url());
    if (!["file:", "data:", "blob:"].includes(protocol) && hostname !== "127.0.0.1")
      errors.push(`asked ${request.url()}`);
  });
  await page.goto(url);
  return { page, errors };
}

/** Waits until the stage shows exactly these images. */
export async function drawn(page: Page, names: string): Promise<void> {
  await page.waitForFunction(
    (wanted) =>
      document.querySelector<HTMLCanvasElement>(".stage canvas")?.dataset["drawn"] === wanted,
    names,
  );
  await settled(page);
}

/** Colour of the stage at a point of it, 0 to 255. */
export function colourAt(page: Page, x: number, y: number): Promise<number[]> {
  return page.evaluate(
    ([px, py]) => {
      const canvas = document.querySelector<HTMLCanvasElement>(".stage canvas");
      const copy = document.createElement("canvas");
      copy.width = copy.height = 1;
      const pen = copy.getContext("2d");
      const scale = devicePixelRatio;
      if (!canvas || !pen) return [];
      pen.drawImage(canvas, px * scale, py * scale, 1, 1, 0, 0, 1, 1);
      return [...pen.getImageData(0, 0, 1, 1).data.slice(0, 3)];
    },
    [x, y] as const,
  );
}

/** What the tests change of an overview. */
export interface SomeOverview {
  run: { name: string; live: boolean; finished: boolean };
  states: { name: string }[];
  cells: Record<string, (number | null)[]>;
  measures: Record<string, (number | null)[]>;
  infinite: Record<string, number[]>;
  targets: string[];
  charts?: unknown[];
}

/** Answers for overviews with what `change` makes of the run's own; `run` counts as the server counts. */
export async function changeOverview(
  page: Page,
  change: (overview: SomeOverview, asked: number) => void,
  run: number | "*" = "*",
): Promise<void> {
  let asked = 0;
  await page.route(`**/data/${run}/overview.json`, async (route) => {
    const overview = (await (await route.fetch()).json()) as SomeOverview;
    change(overview, ++asked);
    await route.fulfill({ json: overview });
  });
}

/** Waits until the page has shown what it was told before. */
export async function settled(page: Page): Promise<void> {
  await page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
  );
}

/** An image as the server packs it (src/report/packed_image.h), each channel with its number at (x, y). */
export function packedImage(
  width: number,
  height: number,
  channels: Record<string, (x: number, y: number) => number>,
): Buffer {
  const names = Object.keys(channels);
  const header = JSON.stringify({
    format: "orbs-image/1",
    width,
    height,
    layer: "",
    layers: [""],
    attributes: {},
    channels: names.map((name) => ({ name, type: "float", exact: true })),
  });
  const text = Buffer.from(header.padEnd(Math.ceil((4 + header.length) / 8) * 8 - 4));
  const length = Buffer.alloc(4);
  length.writeUInt32LE(text.length);
  const planes = names.map((name) => {
    const plane = new Float32Array(width * height);
    for (let i = 0; i < plane.length; ++i)
      plane[i] = channels[name]?.(i % width, Math.floor(i / width)) ?? NaN;
    return Buffer.from(plane.buffer);
  });
  return gzipSync(Buffer.concat([length, text, ...planes]));
}

/** Shows these images, by the names of their files, in place of the run's own. */
export async function replaceImages(page: Page, images: Record<string, Buffer>): Promise<void> {
  for (const [file, body] of Object.entries(images))
    await page.route(`**/image/**/${file}*`, (route) => route.fulfill({ body }));
}
