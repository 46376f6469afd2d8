import { offer } from "../common/offer";
import type { Theme } from "./theme";

/** A name of a file from any text. */
export const fileName = (text: string, ending: string): string =>
  `${text.replace(/[^A-Za-z0-9._-]+/g, "-").replace(/^[-.]+|[-.]+$/g, "") || "chart"}.${ending}`;

const quoted = (cell: string | number | boolean | null): string => {
  const text = cell === null ? "" : String(cell);
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
};

/** Comma-separated values of RFC 4180; the first row names the columns. */
export function csvText(rows: (string | number | boolean | null)[][]): string {
  return rows.map((row) => `${row.map(quoted).join(",")}\r\n`).join("");
}

export const saveCsv = (name: string, rows: (string | number | boolean | null)[][]): void =>
  offer(fileName(name, "csv"), new Blob([csvText(rows)], { type: "text/csv" }));

const kSvg = "http://www.w3.org/2000/svg";

const set = (element: Element, values: Record<string, string | number>): void =>
  Object.entries(values).forEach(([name, value]) => element.setAttribute(name, String(value)));

function textAt(x: number, y: number, text: string, fill: string): SVGTextElement {
  const element = document.createElementNS(kSvg, "text");
  set(element, { x, y, fill, "font-size": 12, "font-family": "system-ui, sans-serif" });
  element.textContent = text;
  return element;
}

const kTitle_px = 18;
const kLetter_px = 7;

/**
 * A separate drawing with a background: copies of the drawings at their places on the page, each
 * with its title, below a line of `head`.
 */
export function sheetOf(
  drawings: SVGSVGElement[],
  { panel, text }: Pick<Theme, "panel" | "text">,
  titles: string[],
  head: { text: string; colour: string }[] = [],
): SVGSVGElement {
  const boxes = drawings.map((drawing) => drawing.getBoundingClientRect());
  const left = Math.min(...boxes.map((box) => box.left));
  const top = Math.min(...boxes.map((box) => box.top)) - kTitle_px * (head.length > 0 ? 2 : 1);
  const width = Math.ceil(Math.max(...boxes.map((box) => box.right)) - left);
  const height = Math.ceil(Math.max(...boxes.map((box) => box.bottom)) - top);
  const sheet = document.createElementNS(kSvg, "svg");
  set(sheet, { xmlns: kSvg, width, height, viewBox: `0 0 ${width} ${height}` });
  const ground = document.createElementNS(kSvg, "rect");
  set(ground, { width, height, fill: panel });
  sheet.append(ground);
  let x = 4;
  for (const part of head) {
    sheet.append(textAt(x, 13, part.text, part.colour));
    x += kLetter_px * (part.text.length + 2);
  }
  drawings.forEach((drawing, i) => {
    const box = boxes[i];
    if (!box) return;
    const copy = drawing.cloneNode(true) as SVGSVGElement;
    const [dx, dy] = [box.left - left, box.top - top];
    set(copy, { x: dx, y: dy, width: box.width, height: box.height });
    sheet.append(copy, textAt(dx + 4, dy - 5, shortened(titles[i] ?? "", box.width), text));
  });
  return sheet;
}

/** As much of the text as fits into the width. */
const shortened = (text: string, width: number): string =>
  text.length * kLetter_px <= width ? text : `${text.slice(0, width / kLetter_px - 1)}…`;

const svgBlob = (sheet: SVGSVGElement): Blob =>
  new Blob([new XMLSerializer().serializeToString(sheet)], { type: "image/svg+xml" });

export const saveSvg = (name: string, sheet: SVGSVGElement): void =>
  offer(fileName(name, "svg"), svgBlob(sheet));

const kPngScale = 2; // sharp on paper and on dense screens

/** Draws the sheet into a PNG. */
export async function savePng(name: string, sheet: SVGSVGElement): Promise<void> {
  const address = URL.createObjectURL(svgBlob(sheet));
  const image = new Image();
  image.src = address;
  await image.decode();
  const canvas = document.createElement("canvas");
  canvas.width = image.width * kPngScale;
  canvas.height = image.height * kPngScale;
  canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
  URL.revokeObjectURL(address);
  const content = await new Promise<Blob | null>((done) => canvas.toBlob(done));
  if (content) offer(fileName(name, "png"), content);
}
