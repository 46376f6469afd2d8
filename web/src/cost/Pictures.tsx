import { useState } from "preact/hooks";
import { PairList } from "../common/PairList";
import { useRequest } from "../common/request";
import { runQuery } from "../common/session";
import type { Source } from "../data/source";
import { routeText } from "../route";
import { useHeldKey } from "../viewer/held_key";
import { numbersOf } from "./quantities";
import type { CostCurve, CostStudy } from "../data/generated";

interface PictureProps {
  source: Source;
  run: number;
  file: string;
  label: string;
  width: number;
  height: number;
}

function Picture({ source, run, file, label, width, height }: PictureProps) {
  const { value, problem } = useRequest(
    `${run} ${file}`,
    "",
    file ? () => source.picture(run, file) : undefined,
  );
  const [failed, setFailed] = useState("");
  return (
    <figure>
      {value && failed !== value ? (
        <img
          src={value}
          alt={label}
          width={width}
          height={height}
          data-file={file}
          onError={() => setFailed(value)}
        />
      ) : (
        <div class="no-picture quiet" style={{ aspectRatio: `${width} / ${height}` }}>
          {problem ?? (file && !value ? "Reading …" : "There is no such image.")}
        </div>
      )}
      <figcaption>{label}</figcaption>
    </figure>
  );
}

interface Props {
  source: Source;
  run: number;
  study: CostStudy;
  curve: CostCurve;
  index: number;
  onPoint: (index: number) => void;
}

/** The viewer on the image of a point. A study in one file holds no floats for it. */
const viewerLink = (source: Source, run: number, target: string, point: string): string =>
  routeText({ path: ["images"], query: { ...runQuery(source, run), target, point } });

/** The image of a point beside the reference, and all its numbers. */
export function Pictures({ source, run, study, curve, index, onPoint }: Props) {
  const [held, setHeld] = useState(false);
  useHeldKey("shift", setHeld);
  const target = study.targets[curve.target];
  const point = curve.points[index];
  if (!target || !point) return null;
  const name = study.renderers[curve.renderer]?.name ?? "";
  const common = { source, run, width: target.width, height: target.height };
  const step = (by: number, label: string, sign: string) => (
    <button
      aria-label={label}
      title={label}
      disabled={!curve.points[index + by]}
      onClick={() => onPoint(index + by)}
    >
      {sign}
    </button>
  );
  return (
    <section class="pictures" aria-label="Image and reference">
      <h3>
        {step(-1, "Setting before", "‹")} {name}, {point.setting} {step(1, "Next setting", "›")}
      </h3>
      <div class="pair">
        <Picture
          {...common}
          file={held ? target.reference : point.image}
          label={held ? "reference" : `${name}, ${point.setting}`}
        />
        <Picture {...common} file={target.reference} label="reference" />
      </div>
      {source.isServed && point.exr ? (
        <a href={viewerLink(source, run, target.name, `${name}/${index}`)}>
          A × B: this image, its reference and others at one place
        </a>
      ) : null}
      <p class="quiet">
        Hold Shift to see the reference instead of the image.
        {point.below_reference_noise ? " This error is within the noise of the reference." : ""}
      </p>
      <PairList kind="numbers" pairs={numbersOf(study, point)} />
    </section>
  );
}
