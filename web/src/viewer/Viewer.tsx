import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { useActions } from "../common/keys";
import type { Session } from "../common/session";
import type { Raster } from "../data/raster";
import type { ImageEntry } from "../data/types";
import { note, type Route } from "../route";
import { channelChoices, channelInForce, seenChannels } from "./channels";
import { viewActions, type Controls } from "./controls";
import { HistogramPlot, StatisticsTable } from "./Histogram";
import { Legend } from "./Legend";
import { isMap, paintSettings } from "./paint_settings";
import { Readout } from "./Readout";
import { RegionPanel } from "./RegionPanel";
import { Stage, type Shown } from "./Stage";
import { rangeOf } from "./statistics";
import { Toolbar } from "./Toolbar";
import { knownStatistics, useStatistics, useWorst } from "./use_counted";
import { isRaster, useRasters } from "./use_rasters";
import { parseView, viewQuery, type ViewState } from "./view_state";
import type { Worst } from "./worst";

/** The view, kept in the address: written a moment after it changed, read when somebody else changes it. */
function useView(route: Route): [ViewState, (view: ViewState) => void] {
  const [view, setView] = useState(() => parseView(route.query));
  const written = useRef(JSON.stringify(viewQuery(view)));
  const timer = useRef<ReturnType<typeof setTimeout> | undefined>(undefined);
  const address = JSON.stringify(viewQuery(parseView(route.query)));
  useEffect(() => {
    if (address === written.current || timer.current) return;
    written.current = address;
    setView(parseView(route.query));
  }, [address]);
  useEffect(() => () => clearTimeout(timer.current), []);
  return [
    view,
    (next) => {
      setView(next);
      clearTimeout(timer.current);
      timer.current = setTimeout(() => {
        timer.current = undefined;
        written.current = JSON.stringify(viewQuery(next));
        note(viewQuery(next));
      }, 250); // browsers allow a hundred changes of the address in half a minute
    },
  ];
}

/** True while Shift is down. */
function useShift(): boolean {
  const [held, setHeld] = useState(false);
  useEffect(() => {
    const update = (event: KeyboardEvent): void => {
      if (event.key === "Shift") setHeld(event.type === "keydown");
    };
    const release = (): void => setHeld(false);
    addEventListener("keydown", update);
    addEventListener("keyup", update);
    addEventListener("blur", release);
    return () => {
      removeEventListener("keydown", update);
      removeEventListener("keyup", update);
      removeEventListener("blur", release);
    };
  }, []);
  return held;
}

function useBlink(on: boolean, names: string[]): string | undefined {
  const [turn, setTurn] = useState(0);
  useEffect(() => {
    if (!on) return undefined;
    const timer = setInterval(() => setTurn((n) => n + 1), 1000);
    return () => clearInterval(timer);
  }, [on]);
  return on ? names[turn % names.length] : undefined;
}

const rangeSeen = (raster: Raster, channel: string): Shown["range"] => {
  const statistics = knownStatistics(raster);
  return statistics && rangeOf(statistics, seenChannels(raster, channel));
};

export function Viewer({
  session,
  images,
  route,
}: {
  session: Session;
  images: ImageEntry[];
  route: Route;
}) {
  const [view, setView] = useView(route);
  const [hover, setHover] = useState<{ x: number; y: number }>();
  const [selecting, setSelecting] = useState(false);
  const [blinking, setBlinking] = useState(false);
  const [visited, setVisited] = useState<{ of: Worst | undefined; index: number }>();
  const held = useShift();

  const reference = images.find((image) => image.kind === "reference");
  const chosen = images.find((image) => image.name === view.image) ?? images[0];
  const names = view.ticked.filter((name) => images.some((image) => image.name === name));
  const ticked = names.length > 0 ? names : images.slice(0, 2).map((image) => image.name);
  const blink = useBlink(blinking, ticked);
  const front = (held && reference) || images.find((image) => image.name === blink) || chosen;
  const other = front?.kind === "reference" ? images[0] : reference;
  const panes = useMemo((): ImageEntry[] => {
    if (!front) return [];
    if (view.mode === "side") return images.filter((image) => ticked.includes(image.name));
    return view.mode === "swipe" && other && other !== front ? [front, other] : [front];
  }, [images, view.mode, front, other, ticked.join()]);

  const wanted = [
    ...new Set(
      ["result", "reference"]
        .flatMap((kind) => images.filter((i) => i.kind === kind))
        .concat(panes)
        .map((i) => i.name),
    ),
  ];
  const rasters = useRasters(session, images, wanted, view.layer);
  const rasterOf = (image: ImageEntry | undefined): Raster | undefined => {
    const loaded = image && rasters.get(image.name);
    return isRaster(loaded) ? loaded : undefined;
  };
  const raster = rasterOf(front);
  const referenceRaster = rasterOf(reference);
  const result = images.find((image) => image.kind === "result");
  const errors = front?.kind === "map" ? raster : rasterOf(result);
  const sameSize =
    errors &&
    referenceRaster &&
    errors.width === referenceRaster.width &&
    errors.height === referenceRaster.height;
  const worst = useWorst(
    front?.kind === "map" || sameSize ? errors : undefined,
    front?.kind === "map" ? undefined : referenceRaster,
  );
  const statistics = useStatistics(raster, undefined);
  const resultRaster = rasterOf(result);
  const layered = view.layer !== "";
  useStatistics(layered ? resultRaster : undefined, undefined);
  useStatistics(layered ? referenceRaster : undefined, undefined);
  // Result and reference of numbers have one scale: beside each other a colour must be the same number in both.
  const rangeFor = (image: ImageEntry, own: Raster): Shown["range"] => {
    const alike = layered && !isMap(image) ? [own, resultRaster, referenceRaster] : [own];
    const ranges = alike.flatMap((one) => (one && rangeSeen(one, view.channel)) ?? []);
    return ranges.length === 0
      ? undefined
      : {
          min: Math.min(...ranges.map((one) => one.min)),
          max: Math.max(...ranges.map((one) => one.max)),
        };
  };
  const size = raster ?? referenceRaster ?? rasterOf(result) ?? { width: 512, height: 512 };
  const range = front && raster && rangeFor(front, raster);
  const settings = front && paintSettings(front, view, raster, range);
  const layers = (rasterOf(result) ?? referenceRaster)?.layers ?? [""];

  const worstIndex = visited?.of === worst ? (visited?.index ?? -1) : -1;
  const setWorstIndex = (index: number): void => {
    setVisited({ of: worst, index });
    setHover(undefined); // until it moves again the pointer is where it was, and looked at is another pixel
  };
  const controls: Controls = {
    images,
    view,
    setView,
    front,
    size,
    range,
    worst,
    worstIndex,
    setWorstIndex,
    selecting,
    setSelecting,
    blinking,
    setBlinking,
    held,
    channels: channelChoices(raster),
    channel: channelInForce(raster, view.channel),
    // A link may ask for a layer that these images do not have; it must be possible to choose another.
    layers: layers.includes(view.layer) ? layers : [...layers, view.layer],
    ticked,
    falseColour: settings?.falseColour ?? false,
    scaleEnd: settings?.scaleEnd ?? 1,
  };
  const actions = viewActions(controls);
  useActions(actions);
  if (images.length === 0)
    return <p class="quiet no-images">There is no image of this: nothing was rendered.</p>;
  const shown: Shown[] = panes.map((image) => {
    const own = rasterOf(image);
    return { image, loaded: rasters.get(image.name), range: own && rangeFor(image, own) };
  });
  const marked = worst?.pixels[worstIndex];
  return (
    <section class="viewer" aria-label="Images">
      <Toolbar controls={controls} actions={actions} />
      <div class="viewer-body">
        <div class="viewer-main">
          <Stage
            shown={shown}
            loaded={[...rasters.values()].filter(isRaster)}
            view={view}
            size={size}
            marked={marked}
            selecting={selecting}
            onView={setView}
            onHover={setHover}
            onRegion={(region) => setView({ ...view, region })}
          />
          {settings?.falseColour && front ? (
            <Legend
              image={front}
              settings={settings}
              onLog={() => setView({ ...view, log: !view.log })}
              onEnd={(end) => {
                const { [front.name]: _, ...ends } = view.ends;
                setView({ ...view, ends: end && end > 0 ? { ...ends, [front.name]: end } : ends });
              }}
            />
          ) : null}
        </div>
        <aside class="viewer-side">
          <Readout at={hover ?? marked} images={images} rasters={rasters} channel={view.channel} />
          {front ? (
            <h3>
              {front.name}
              {view.region ? ", whole image" : ""}
            </h3>
          ) : null}
          {statistics ? (
            <>
              <HistogramPlot statistics={statistics} />
              <StatisticsTable statistics={statistics} />
            </>
          ) : null}
          {view.region ? (
            <RegionPanel
              region={view.region}
              images={images}
              rasters={rasters}
              onClear={() => setView({ ...view, region: undefined })}
            />
          ) : null}
        </aside>
      </div>
    </section>
  );
}
