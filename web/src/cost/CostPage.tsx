import { useEffect, useMemo, useRef } from "preact/hooks";
import { Choice } from "../common/Choice";
import { useActions } from "../common/keys";
import type { Source } from "../data/source";
import { note, routeText, type Route } from "../route";
import { About } from "./About";
import { Answer } from "./Answer";
import { chartOf, rangesOf, type Axes } from "./chart_data";
import { completed } from "./older";
import { levelsOf, metricsWithTimes } from "./ranking";
import { CostChart, titleOf } from "./CostChart";
import { pointRows } from "./csv_rows";
import { FitTable } from "./FitTable";
import { Multiples } from "./Multiples";
import { Pictures } from "./Pictures";
import { TimeTable } from "./TimeTable";
import { errorOf, kTimes, metricName, metricOf } from "./quantities";
import { SaveButtons } from "./SaveButtons";
import { Since } from "./Since";
import { PointViewer } from "./PointViewer";
import { sheetOf } from "./save";
import { currentTheme } from "./theme";
import type { CostCurve, CostStudy } from "../data/generated";

interface Props {
  source: Source;
  run: number;
  study: CostStudy;
  route: Route;
}

interface Chosen {
  curve: CostCurve;
  index: number;
}

/** The point whose PSNR is nearest to the quality that the study was made for. */
function usualPoint(study: CostStudy, curve: CostCurve): number {
  const wanted = study.settings.target_db ?? 35;
  const distances = curve.points.map((point) => {
    const value = errorOf(point, "psnr_srgb8")?.value;
    return value == null ? Infinity : Math.abs(value - wanted);
  });
  return Math.max(0, distances.indexOf(Math.min(...distances)));
}

/** The point that the address names as "renderer/index", or a usual one. */
function chosenPoint(
  study: CostStudy,
  target: number,
  text: string | undefined,
): Chosen | undefined {
  const own = study.curves.filter((curve) => curve.target === target && curve.points.length > 0);
  const at = text?.lastIndexOf("/") ?? -1;
  const name = text?.slice(0, at);
  const named = own.find((curve) => study.renderers[curve.renderer]?.name === name);
  const index = Number(text?.slice(at + 1));
  if (named && Number.isInteger(index) && named.points[index]) return { curve: named, index };
  const [usual] = own;
  return usual && { curve: usual, index: usualPoint(study, usual) };
}

/** The chart of one target, and the image of the point that is chosen in it. */
function TargetPanel({
  source,
  run,
  study,
  route,
  axes,
  target,
}: Props & {
  axes: Axes;
  target: number;
}) {
  const panel = useRef<HTMLElement>(null);
  const chart = useMemo(() => chartOf(study, target, axes), [study, target, axes.x, axes.y]);
  const ranges = useMemo(() => rangesOf([chart]), [chart]);
  const chosen = chosenPoint(study, target, route.query["point"]);
  const choose = (curve: CostCurve, index: number): void =>
    note({
      target: study.targets[target]?.name ?? "",
      point: `${study.renderers[curve.renderer]?.name}/${index}`,
    });
  const title = titleOf(study, target);
  const last = useRef(target);
  useEffect(() => {
    if (last.current !== target) panel.current?.scrollIntoView({ block: "start" });
    last.current = target;
  }, [target]);
  const sheet = (): SVGSVGElement | undefined => {
    const drawing = panel.current?.querySelector<SVGSVGElement>(".cost-plot svg");
    return drawing ? sheetOf([drawing], currentTheme(), [title]) : undefined;
  };
  return (
    <section class="cost-panel target" aria-label={title} ref={panel} id="target">
      <div class="panel-head">
        <h2>{title}</h2>
        <SaveButtons name={title} sheet={sheet} rows={() => pointRows(study, [target])} />
      </div>
      <div class="chart-and-images">
        <div>
          {ranges ? (
            <CostChart
              study={study}
              chart={chart}
              ranges={ranges}
              chosen={chosen && { renderer: chosen.curve.renderer, index: chosen.index }}
              onChoose={({ curve, index }) => choose(curve, index)}
            />
          ) : (
            <p class="quiet">The study has no values for these axes on this target.</p>
          )}
          <FitTable study={study} curves={chart.curves.map(({ curve }) => curve)} />
          <RunsOf source={source} target={study.targets[target]?.name ?? ""} />
        </div>
        {chosen ? (
          <Pictures
            {...{ source, run, study, ...chosen }}
            onPoint={(index) => choose(chosen.curve, index)}
          />
        ) : null}
      </div>
    </section>
  );
}

/** The target in the runs that are served beside the study. */
function RunsOf({ source, target }: { source: Source; target: string }) {
  const runs = source.runs.filter((_, i) => source.kinds[i] === "run");
  if (runs.length === 0) return null;
  return (
    <p>
      Its images and verdicts:{" "}
      {runs.map((name, i) => (
        <>
          {i > 0 ? ", " : ""}
          <a href={routeText({ path: [], query: { run: name, by: "target", q: target } })}>
            {name}
          </a>
        </>
      ))}
    </p>
  );
}

/** What all charts and tables of the page share. */
function Choices({
  study,
  axes,
  metric,
  target,
  route,
}: {
  study: CostStudy;
  axes: Axes;
  metric: string;
  target: number;
  route: Route;
}) {
  const filter = useRef<HTMLInputElement>(null);
  const step = (by: number) => () => {
    const next = study.targets[target + by];
    if (next) note({ target: next.name, point: "" });
  };
  useActions([
    { key: "/", label: "filter", group: "Cost", run: () => filter.current?.focus() },
    { key: "[", label: "previous target", group: "Cost", run: step(-1) },
    { key: "]", label: "next target", group: "Cost", run: step(1) },
  ]);
  const metrics = study.metrics.map(({ name }) => ({ name, label: metricName(name) }));
  return (
    <section class="cost-choices" aria-label="Choices">
      <Choice label="x axis" param="x" chosen={axes.x} options={kTimes} />
      <Choice label="y axis" param="y" chosen={axes.y.name} options={metrics} />
      <Choice
        label="Times by"
        param="by"
        chosen={metric}
        options={metricsWithTimes(study).map((name) => ({ name, label: metricName(name) }))}
      />
      <input
        ref={filter}
        type="search"
        aria-label="Filter targets"
        placeholder="Filter targets  ( / )"
        value={route.query["q"] ?? ""}
        onInput={(event) => note({ q: event.currentTarget.value })}
      />
    </section>
  );
}

/** What accuracy costs: who is fastest, the curves of each target, and the times to error. */
export function CostPage(read: Props) {
  const study = useMemo(() => completed(read.study), [read.study]);
  const props = { ...read, study };
  const { route } = read;
  const { query } = route;
  const y = metricOf(study, query["y"]);
  const x = kTimes.find(({ name }) => name === query["x"]) ?? kTimes[0];
  const metrics = metricsWithTimes(study);
  const metric = metrics.find((name) => name === query["by"]) ?? metrics[0] ?? "";
  const wanted = (query["q"] ?? "").toLowerCase();
  const targets = study.targets.flatMap((_, i) =>
    titleOf(study, i).toLowerCase().includes(wanted) ? [i] : [],
  );
  const named = study.targets.findIndex(({ name }) => name === query["target"]);
  const target = named >= 0 ? named : 0;
  if (!x || !y || study.targets.length === 0) return <p class="quiet">Nothing was measured yet.</p>;
  const axes = { x: x.name, y };
  const viewed =
    route.path[0] === "images" ? chosenPoint(study, target, query["point"]) : undefined;
  if (viewed) return <PointViewer home={props} study={study} route={route} {...viewed} />;
  return (
    <>
      <section class="cost-panel who" aria-label="Who is fastest">
        <h1>Who is fastest?</h1>
        <Answer study={study} metric={metric} base={query["base"]} level={query["at"]} />
      </section>
      <Since
        {...props}
        metric={metric}
        level={levelsOf(study, metric).find((one) => String(one) === query["at"])}
      />
      <Choices study={study} axes={axes} metric={metric} target={target} route={route} />
      <TargetPanel {...props} axes={axes} target={target} />
      <Multiples study={study} axes={axes} targets={targets} chosen={target} route={route} />
      <TimeTable study={study} metric={metric} targets={targets} route={route} />
      <About study={study} />
    </>
  );
}
