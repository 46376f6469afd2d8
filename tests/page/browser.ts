// The page in a real browser.
import { createRequire } from "node:module";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import type { Browser, Page } from "playwright-core";

const source = process.env["ORBS_SOURCE_DIR"] ?? "";
const { chromium } = createRequire(join(source, "web/package.json"))(
  "playwright-core",
) as typeof import("playwright-core");

export async function launch(): Promise<Browser> {
  const executablePath = process.env["ORBS_CHROMIUM"] ?? "";
  // Software rendering gives the same image on every machine. The sandbox of Chromium does not run
  // as root in a container.
  const args = [
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    ...(process.getuid?.() === 0 ? ["--no-sandbox"] : []),
  ];
  return chromium.launch({ executablePath, args });
}

/** A page; `errors` collects errors in its console and requests to other hosts. */
export async function open(
  browser: Browser,
  url: string,
  options: Parameters<Browser["newPage"]>[0] = {},
): Promise<{ page: Page; errors: string[] }> {
  const page = await browser.newPage({ viewport: { width: 1280, height: 900 }, ...options });
  page.setDefaultTimeout(15000);
  // A page that asks again and again may have a request on its way, whose answer would find the page gone.
  const close = page.close.bind(page);
  page.close = async (): Promise<void> => {
    await page.unrouteAll({ behavior: "ignoreErrors" });
    await close();
  };
  const errors: string[] = [];
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("console", (message) => {
    if (message.type() === "error") errors.push(message.text());
  });
  page.on("request", (request) => {
    const { hostname, protocol } = new URL(request.url());
    if (!["file:", "data:", "blob:"].includes(protocol) && hostname !== "127.0.0.1")
      errors.push(`requested ${request.url()}`);
  });
  await page.goto(url);
  return { page, errors };
}

/** Waits until the stage shows exactly these images, by name. */
export async function drawn(page: Page, names: string): Promise<void> {
  await page.waitForFunction(
    (wanted) =>
      document.querySelector<HTMLCanvasElement>(".stage canvas")?.dataset["drawn"] === wanted,
    names,
  );
  await settled(page);
}

/** Colour of the stage at a point, in CSS pixels; 0 to 255. */
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

/** The members of an overview that tests change. */
export interface SomeOverview {
  run: { name: string; live: boolean; finished: boolean };
  states: { name: string }[];
  cells: Record<string, (number | null)[]>;
  measures: Record<string, (number | null)[]>;
  infinite: Record<string, number[]>;
  targets: string[];
  texts_beside_psnr: string[];
  rule_beside_psnr: string;
}

/** Lets `change` modify the overviews that the server sends; `run` is the index of the run. */
export async function changeOverview(
  page: Page,
  change: (overview: SomeOverview, request: number) => void,
  run: number | "*" = "*",
): Promise<void> {
  let requests = 0;
  await page.route(`**/data/${run}/overview.json`, async (route) => {
    const overview = (await (await route.fetch()).json()) as SomeOverview;
    change(overview, ++requests);
    await route.fulfill({ json: overview });
  });
}

/** Waits until the page has rendered pending changes. */
export async function settled(page: Page): Promise<void> {
  await page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
  );
}

/** An image in the format of src/report/packed_image.h; each channel is a function of (x, y). */
export function packedImage(
  width: number,
  height: number,
  channels: Record<string, (x: number, y: number) => number>,
): Buffer {
  const names = Object.keys(channels);
  const header = JSON.stringify({
    format: "orbs-image/2",
    width,
    height,
    separated: false,
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

/** Replaces images of the run, by the names of their files. */
export async function replaceImages(page: Page, images: Record<string, Buffer>): Promise<void> {
  for (const [file, body] of Object.entries(images))
    await page.route(`**/image/**/${file}*`, (route) => route.fulfill({ body }));
}
