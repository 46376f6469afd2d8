// How the images of a target are shown. The address holds all of it.

export type Mode = "flip" | "swipe" | "side";
export type Curve = "srgb" | "gamma" | "linear" | "false";
export type Measure = (typeof kMeasures)[number];

/** How a difference can be measured; see difference.ts. */
export const kMeasures = [
  "signed",
  "absolute",
  "relative",
  "squared",
  "relmse",
  "smape",
  "srgb8",
  "ssim",
  "flip",
  "noise",
] as const;

/**
 * Where the colour scales of maps end: at a percentile of the magnitudes of their pixels, or at a number that
 * is the same for all images.
 */
export const kScaleEnds = ["99", "95", "99.9", "100", "fixed"] as const;
export type ScaleEnd = (typeof kScaleEnds)[number];

export interface ViewState {
  image: string; // name of the image in front
  a: string; // names of the images that are compared: A is compared with B
  b: string;
  measure: Measure; // of their difference
  more: string[]; // names of images beside those of the target
  mode: Mode;
  zoom: number; // screen pixels per pixel; 0 fits the whole image
  x: number; // position in the image at the centre of a pane
  y: number;
  swipe: number; // position of the divider, 0 to 1
  exposure: number; // stops
  offset: number;
  curve: Curve;
  gamma: number;
  channel: string; // "" for colour, "luminance", or the name of a channel
  layer: string;
  log: boolean;
  zebra: boolean;
  percentile: number; // of what is visible, to which Normalise sets the range; 100: all of it
  ticked: string[]; // names of the images of blink and side by side
  region: [number, number, number, number] | undefined; // x0, y0, x1, y1; the ends are exclusive
  scale: ScaleEnd; // of maps
  ends: Record<string, number>; // by image: end of its colour scale, if it was changed
}

export const kDefaultView: ViewState = {
  image: "result",
  a: "result",
  b: "reference",
  measure: "signed",
  more: [],
  mode: "flip",
  zoom: 0,
  x: 0,
  y: 0,
  swipe: 0.5,
  exposure: 0,
  offset: 0,
  curve: "srgb",
  gamma: 2.2,
  channel: "",
  layer: "",
  log: false,
  zebra: false,
  percentile: 100,
  ticked: [],
  region: undefined,
  scale: "99",
  ends: {},
};

const finite = (text: string | undefined, fallback: number): number => {
  const value = text === undefined || text === "" ? NaN : Number(text);
  return Number.isFinite(value) ? value : fallback;
};

const oneOf = <T extends string>(text: string | undefined, allowed: readonly T[], fallback: T): T =>
  allowed.find((one) => one === text) ?? fallback;

export const kPercentiles: readonly number[] = [100, 99.9, 99, 95, 90];
export const kModes: readonly Mode[] = ["flip", "swipe", "side"];
export const kCurves: readonly Curve[] = ["srgb", "gamma", "linear", "false"];

/** The mode of an address that names none. One that names an image shows that image. */
const modeWithout = (image: string | undefined, usual: Mode): Mode =>
  image && image !== kDefaultView.image ? "flip" : usual;

/** The view of an address; `usual` is the mode in which the target opens. */
export function parseView(query: Record<string, string>, usual: Mode = "flip"): ViewState {
  const region = (query["region"] ?? "").split(",").map(Number);
  const ends: Record<string, number> = {};
  for (const part of (query["ends"] ?? "").split("|")) {
    const [name, end] = part.split(":");
    if (name && end && Number.isFinite(Number(end))) ends[name] = Number(end);
  }
  return {
    image: query["img"] || kDefaultView.image,
    a: query["a"] || kDefaultView.a,
    b: query["b"] || kDefaultView.b,
    measure: oneOf(query["diff"], kMeasures, "signed"),
    more: query["more"] ? query["more"].split("|") : [],
    mode: oneOf(query["mode"], kModes, modeWithout(query["img"], usual)),
    zoom: Math.min(512, Math.max(0, finite(query["zoom"], 0))),
    x: finite(query["x"], 0),
    y: finite(query["y"], 0),
    swipe: Math.min(1, Math.max(0, finite(query["swipe"], 0.5))),
    exposure: finite(query["ev"], 0),
    offset: finite(query["off"], 0),
    curve: oneOf(query["curve"], kCurves, "srgb"),
    gamma: Math.max(0.1, finite(query["gamma"], 2.2)),
    channel: query["ch"] ?? "",
    layer: query["layer"] ?? "",
    log: query["log"] === "1",
    zebra: query["zebra"] === "1",
    percentile: kPercentiles.find((one) => String(one) === query["pct"]) ?? 100,
    ticked: query["tick"] ? query["tick"].split("|") : [],
    region:
      region.length === 4 && region.every(Number.isInteger)
        ? (region as [number, number, number, number])
        : undefined,
    scale: oneOf(query["scale"], kScaleEnds, "99"),
    ends,
  };
}

const short = (value: number): string => String(Number(value.toPrecision(7)));

/** The query that describes `view`; "" for defaults. `usual` is that of parseView. */
export function viewQuery(view: ViewState, usual: Mode = "flip"): Record<string, string> {
  const unless = (value: number, usual: number): string => (value === usual ? "" : short(value));
  return {
    img: view.image === kDefaultView.image ? "" : view.image,
    a: view.a === kDefaultView.a ? "" : view.a,
    b: view.b === kDefaultView.b ? "" : view.b,
    diff: view.measure === "signed" ? "" : view.measure,
    more: view.more.join("|"),
    mode: view.mode === modeWithout(view.image, usual) ? "" : view.mode,
    zoom: unless(view.zoom, 0),
    x: view.zoom ? short(view.x) : "",
    y: view.zoom ? short(view.y) : "",
    swipe: view.mode === "swipe" ? unless(view.swipe, 0.5) : "",
    ev: unless(view.exposure, 0),
    off: unless(view.offset, 0),
    curve: view.curve === "srgb" ? "" : view.curve,
    gamma: unless(view.gamma, 2.2),
    ch: view.channel,
    layer: view.layer,
    log: view.log ? "1" : "",
    zebra: view.zebra ? "1" : "",
    pct: unless(view.percentile, 100),
    tick: view.ticked.join("|"),
    region: view.region ? view.region.join(",") : "",
    scale: view.scale === "99" ? "" : view.scale,
    ends: Object.entries(view.ends)
      .map(([name, end]) => `${name}:${short(end)}`)
      .join("|"),
  };
}
