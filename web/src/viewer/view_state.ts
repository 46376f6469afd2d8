// How the images of a case are looked at: all of it stands in the address.

export type Mode = "flip" | "swipe" | "side";
export type Curve = "srgb" | "gamma" | "linear" | "false";

export interface ViewState {
  image: string; // name of the image in front
  mode: Mode;
  zoom: number; // screen pixels per pixel; 0: the whole image fits
  x: number; // the pixel in the middle
  y: number;
  swipe: number; // where the divider stands, 0 to 1
  exposure: number; // stops
  offset: number;
  curve: Curve;
  gamma: number;
  channel: string; // "" for colour, "luminance", or a channel's name
  layer: string;
  log: boolean;
  zebra: boolean;
  ticked: string[]; // images of blink and side by side
  region: [number, number, number, number] | undefined; // x0, y0, x1, y1; the ends are outside
  ends: Record<string, number>; // end of the colour scale by image, where it is not the image's own
}

export const kDefaultView: ViewState = {
  image: "result",
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
  ticked: [],
  region: undefined,
  ends: {},
};

const finite = (text: string | undefined, fallback: number): number => {
  const value = text === undefined || text === "" ? NaN : Number(text);
  return Number.isFinite(value) ? value : fallback;
};

const oneOf = <T extends string>(text: string | undefined, allowed: readonly T[], fallback: T): T =>
  allowed.find((one) => one === text) ?? fallback;

export const kModes: readonly Mode[] = ["flip", "swipe", "side"];
export const kCurves: readonly Curve[] = ["srgb", "gamma", "linear", "false"];

export function parseView(query: Record<string, string>): ViewState {
  const region = (query["region"] ?? "").split(",").map(Number);
  const ends: Record<string, number> = {};
  for (const part of (query["ends"] ?? "").split("|")) {
    const [name, end] = part.split(":");
    if (name && end && Number.isFinite(Number(end))) ends[name] = Number(end);
  }
  return {
    image: query["img"] || kDefaultView.image,
    mode: oneOf(query["mode"], kModes, "flip"),
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
    ticked: query["tick"] ? query["tick"].split("|") : [],
    region:
      region.length === 4 && region.every(Number.isInteger)
        ? (region as [number, number, number, number])
        : undefined,
    ends,
  };
}

const short = (value: number): string => String(Number(value.toPrecision(7)));

/** The members of a query that say `view`; "" for what is as always. */
export function viewQuery(view: ViewState): Record<string, string> {
  const unless = (value: number, usual: number): string => (value === usual ? "" : short(value));
  return {
    img: view.image === kDefaultView.image ? "" : view.image,
    mode: view.mode === "flip" ? "" : view.mode,
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
    tick: view.ticked.join("|"),
    region: view.region ? view.region.join(",") : "",
    ends: Object.entries(view.ends)
      .map(([name, end]) => `${name}:${short(end)}`)
      .join("|"),
  };
}
