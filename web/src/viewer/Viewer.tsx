import { useRef, useState } from "preact/hooks";
import { useActions } from "../common/keys";
import type { Raster } from "../data/raster";
import type { ImageEntry } from "../data/source";
import type { Route } from "../route";
import { viewActions } from "./actions";
import { differenceEntry } from "./difference";
import { channelChoices, channelInForce } from "./channels";
import type { Controls } from "./controls";
import { panesOf, type Size } from "./geometry";
import { HistogramPlot, StatisticsTable } from "./Histogram";
import { Legend } from "./Legend";
import { paintSettings } from "./paint_settings";
import { PairErrors } from "./PairErrors";
import { Readout } from "./Readout";
import { RegionPanel } from "./RegionPanel";
import { Stage } from "./Stage";
import type { Shown } from "./stage_content";
import { Toolbar } from "./Toolbar";
import { useExtraImages, type Addable, type ImageHome } from "./extra_images";
import { pairOf, useFront, type Front } from "./use_front";
import { useLoadedImages, type LoadedImages } from "./use_loaded_images";
import { isRaster } from "./use_rasters";
import { useRoom } from "./use_room";
import type { Region } from "./statistics";
import { useView } from "./use_view";
import type { ViewState } from "./view_state";
import type { Worst } from "./worst";

interface Point {
  x: number;
  y: number;
}

/** The state of the viewer that the address does not hold. */
function useLocalState() {
  const [hover, setHover] = useState<Point>();
  const [selecting, setSelecting] = useState(false);
  const [blinking, setBlinking] = useState(false);
  const [full, setFull] = useState(false);
  const [visited, setVisited] = useState<{ of: Worst | undefined; index: number }>();
  return {
    hover,
    setHover,
    selecting,
    setSelecting,
    blinking,
    setBlinking,
    full,
    setFull,
    visited,
    setVisited,
  };
}

type LocalState = ReturnType<typeof useLocalState>;

function controlsOf(
  images: ImageEntry[],
  view: ViewState,
  setView: (view: ViewState) => void,
  local: LocalState,
  { front, visible, ticked, pair }: Front,
  offered: Pick<Controls, "extra" | "addressOf">,
  { raster, size, layers, worst, differing, lackOfNoise, rangeFor }: LoadedImages,
): Controls {
  const { visited, setVisited, setHover } = local;
  const range = front && rangeFor(front);
  return {
    images,
    view,
    setView,
    front,
    settings: front && paintSettings(front, view, raster, range),
    size,
    raster,
    pane: () => paneSize(visible, view, size),
    worst,
    worstIndex: visited?.of === worst ? (visited?.index ?? -1) : -1,
    setWorstIndex: (index) => {
      setVisited({ of: worst, index });
      setHover(undefined); // until the pointer moves again the readout shows the visited pixel
    },
    selecting: local.selecting,
    setSelecting: local.setSelecting,
    blinking: local.blinking,
    setBlinking: local.setBlinking,
    full: local.full,
    setFull: local.setFull,
    channels: channelChoices(raster),
    channel: channelInForce(raster, view.channel),
    // A link may name a layer that these images do not have; another one must still be selectable.
    layers: layers.includes(view.layer) ? layers : [...layers, view.layer],
    differing,
    lackOfNoise,
    ticked,
    pair,
    ...offered,
  };
}

/** The size of a pane of the stage as it is now. */
function paneSize(visible: ImageEntry[], view: ViewState, size: Size): Size {
  const { clientWidth: width, clientHeight: height } = document.querySelector(".stage") ?? {
    clientWidth: 600,
    clientHeight: 400,
  };
  const names = view.mode === "side" ? visible.map(({ name }) => name) : [""];
  return panesOf(names, { width, height }, size)[0] ?? { width, height };
}

interface ViewerProps {
  home: ImageHome;
  images: ImageEntry[];
  addable: Addable;
  route: Route;
  /** Result, reference and difference stand side by side unless the address says otherwise. */
  opensSideBySide?: boolean;
  /** Parts of the images that are outlined. */
  outlined?: Region[];
}

const addressOf = (
  { source, run }: ImageHome,
  { file, run: own }: ImageEntry,
): string | undefined => (file ? source.fileAddress(own ?? run, file) : undefined);

/** The images of the target, those that were added, and the difference of the two compared ones. */
function allImages(own: ImageEntry[], added: ImageEntry[], view: ViewState): ImageEntry[] {
  const images = [...own, ...added];
  const { a, b } = pairOf(images, view);
  return a && b ? [...images, differenceEntry(a, b, view.measure)] : images;
}

/** The images of a target, with the tools to compare them. */
export function Viewer(props: ViewerProps) {
  const { home, images: own, addable, route, opensSideBySide, outlined = [] } = props;
  const [view, setView] = useView(route, opensSideBySide ? "side" : "flip");
  const added = useExtraImages(addable, view.more);
  const images = allImages(own, added.images, view);
  const local = useLocalState();
  const inFront = useFront(images, view, local.blinking);
  const data = useLoadedImages(home, images, view, inFront);
  const controls = controlsOf(
    images,
    view,
    setView,
    local,
    inFront,
    { extra: addable.names, addressOf: (image) => addressOf(home, image) },
    data,
  );
  const actions = viewActions(controls);
  useActions(actions);
  const main = useRef<HTMLDivElement>(null);
  const room = useRoom(main, local.full);
  if (images.length === 0)
    return <p class="quiet no-images">There are no images: nothing was rendered.</p>;
  const marked = data.worst?.pixels[controls.worstIndex];
  const shown: Shown[] = inFront.visible.map((image) => ({
    image,
    loaded: data.rasters.get(image.name),
    preview: data.previews.get(image.name),
    range: data.rangeFor(image),
  }));
  return (
    <section
      class={`viewer ${local.full ? "full" : ""}`}
      aria-label="Images"
      style={{ "--room": `${room}px` }}
    >
      <Toolbar controls={controls} actions={actions} />
      <Problems texts={added.problems} />
      <div class="viewer-body">
        <div class="viewer-main" ref={main}>
          <Stage
            shown={shown}
            loaded={[...data.rasters.values(), ...data.previews.values()].filter(isRaster)}
            view={view}
            size={data.size}
            marked={marked}
            outlined={outlined}
            selecting={local.selecting}
            onView={setView}
            onHover={local.setHover}
            onRegion={(region) => setView({ ...view, region })}
          />
          <Scale controls={controls} shown={shown} />
        </div>
        <Side controls={controls} data={data} at={local.hover ?? marked} />
      </div>
    </section>
  );
}

/** Why images that were asked for are not there. */
const Problems = ({ texts }: { texts: string[] }) => (
  <>
    {texts.map((text) => (
      <p role="alert" key={text}>
        {text}
      </p>
    ))}
  </>
);

interface ScaleProps {
  controls: Controls;
  shown: Shown[];
}

/** The colour scale of the image in front, or else of the last one on the stage in false colour. */
function Scale({ controls: { front, view, setView }, shown }: ScaleProps) {
  const coloured = shown.flatMap(({ image, loaded, range }) => {
    const settings = paintSettings(image, view, isRaster(loaded) ? loaded : undefined, range);
    return settings.falseColour ? [{ image, settings }] : [];
  });
  const one = coloured.find(({ image }) => image === front) ?? coloured.at(-1);
  return one ? <Legend {...one} view={view} onView={setView} /> : null;
}

interface SideProps {
  controls: Controls;
  data: LoadedImages;
  /** The pixel whose values are shown. */
  at: Point | undefined;
}

/** The values and statistics beside the images. */
function Side({ controls, data, at }: SideProps) {
  const { images, view, setView, front, pair } = controls;
  const { rasters, statistics } = data;
  const loaded = (name: string): Raster | undefined => {
    const raster = rasters.get(name);
    return isRaster(raster) ? raster : undefined;
  };
  const kindOf = (name: string) => images.find((image) => image.name === name)?.kind;
  // The verdict's own numbers are those of result and reference in colour.
  const isJudged = !view.layer && kindOf(pair.a) === "result" && kindOf(pair.b) === "reference";
  return (
    <aside class="viewer-side">
      <Readout at={at} images={images} rasters={rasters} channel={view.channel} />
      {isJudged ? null : (
        <PairErrors pair={pair} layer={view.layer} a={loaded(pair.a)} b={loaded(pair.b)} />
      )}
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
          pair={controls.pair}
          onClear={() => setView({ ...view, region: undefined })}
        />
      ) : null}
    </aside>
  );
}
