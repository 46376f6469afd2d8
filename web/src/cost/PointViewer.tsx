import { useMemo } from "preact/hooks";
import { routeText, type Route } from "../route";
import type { ImageEntry } from "../data/source";
import type { Addable, ImageHome } from "../viewer/extra_images";
import { sweepImages } from "../viewer/sweep_images";
import { Viewer } from "../viewer/Viewer";
import { titleOf } from "./CostChart";
import type { CostCurve, CostStudy } from "../data/generated";

interface Props {
  home: ImageHome;
  study: CostStudy;
  route: Route;
  curve: CostCurve;
  index: number;
}

/** What can stand beside the image of a point: the images of the other settings and renderers on the same target. */
function addableOf(images: ImageEntry[], own: string, key: string): Addable {
  return {
    key,
    own,
    names: images.map(({ name }) => name).filter((name) => name !== own),
    load: async (name) => {
      const image = images.find((one) => one.name === name);
      if (!image) throw new Error("the study has no such image of this target");
      return image;
    },
  };
}

/** The image of a point, its reference, and those of any other points, at one place. */
export function PointViewer({ home, study, route, curve, index }: Props) {
  const target = study.targets[curve.target];
  const point = curve.points[index];
  const name = `${study.renderers[curve.renderer]?.name} ${point?.setting}`;
  const key = `${home.run} ${target?.name} ${name}`;
  const images = useMemo(
    () => sweepImages(study, home.run, target?.name ?? ""),
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
