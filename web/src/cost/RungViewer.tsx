import { useMemo } from "preact/hooks";
import { routeText, type Route } from "../route";
import type { ImageEntry } from "../data/types";
import type { Addable, ImageHome } from "../viewer/extra_images";
import { rungImages } from "../viewer/rung_images";
import { Viewer } from "../viewer/Viewer";
import { titleOf } from "./CostChart";
import type { CostStudy, Curve } from "./types";

interface Props {
  home: ImageHome;
  study: CostStudy;
  route: Route;
  curve: Curve;
  rung: number;
}

/** What can stand beside the image of a rung: the other rungs of all renderers on the same target. */
function addableOf(images: ImageEntry[], own: string, key: string): Addable {
  return {
    key,
    own,
    names: images.map(({ name }) => name).filter((name) => name !== own),
    load: async (name) => {
      const image = images.find((one) => one.name === name);
      if (!image) throw new Error("the study has no such rung on this target");
      return image;
    },
  };
}

/** The image of a rung, its reference, and any other rungs, at one place of the images. */
export function RungViewer({ home, study, route, curve, rung }: Props) {
  const target = study.targets[curve.target];
  const point = curve.points[rung];
  const name = `${study.renderers[curve.renderer]?.name} ${point?.rung}`;
  const key = `${home.run} ${target?.name} ${name}`;
  const images = useMemo(
    () => rungImages(study, home.run, target?.name ?? ""),
    [study, home.run, target?.name],
  );
  if (!target || !point) return null;
  const { target: shownTarget = "", point: shownPoint = "", run = "" } = route.query;
  const own: ImageEntry[] = [
    { name: "result", kind: "result", file: point.exr },
    { name: "reference", kind: "reference", file: target.reference },
  ];
  return (
    <article class="case">
      <header class="verdict">
        <h1>
          {titleOf(study, curve.target)} <span class="quiet">{name}</span>
        </h1>
        <a href={routeText({ path: [], query: { run, target: shownTarget, point: shownPoint } })}>
          ◂ Curves
        </a>
      </header>
      <Viewer
        key={key}
        home={home}
        images={own.filter(({ file }) => file)}
        addable={addableOf(images, name, key)}
        route={route}
      />
    </article>
  );
}
