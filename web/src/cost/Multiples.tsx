import { seriesOf } from "../charts/series";
import { useMemo, useRef } from "preact/hooks";
import { routeText, type Route } from "../route";
import { chartOf, rangesOf, type Axes, type ChartOfTarget, type Ranges } from "./chart_data";
import { titleOf } from "./CostChart";
import {
  AxesPart,
  CurvesPart,
  FrontierPart,
  LevelsPart,
  xLabel,
  yLabel,
  PointMark,
  scalesOf,
  type Box,
} from "./Drawing";
import { pointRows } from "./csv_rows";
import { markerLetter, RendererMark } from "./Marker";
import { SaveButtons } from "./SaveButtons";
import { sheetOf } from "./save";
import { useTheme, type Theme } from "./theme";
import type { CostStudy } from "../data/generated";

const kWidth = 232;
const kHeight = 150;
const kBox: Box = { left: 42, right: kWidth - 6, top: 6, bottom: kHeight - 18 };

interface SmallProps {
  chart: ChartOfTarget;
  ranges: Ranges;
  theme: Theme;
}

function SmallChart({ chart, ranges, theme }: SmallProps) {
  const scales = scalesOf(ranges, chart.axes, kBox);
  const parts = { chart, scales, box: kBox, theme, small: true };
  return (
    <svg
      xmlns="http://www.w3.org/2000/svg"
      viewBox={`0 0 ${kWidth} ${kHeight}`}
      font-family="system-ui, sans-serif"
      aria-hidden="true"
    >
      <AxesPart {...parts} />
      <LevelsPart {...parts} />
      <FrontierPart {...parts} />
      <CurvesPart {...parts} />
      {chart.curves.flatMap(({ points }) =>
        points.map((placed) => (
          <PointMark
            key={`${placed.curve.renderer} ${placed.index}`}
            placed={placed}
            scales={scales}
            theme={theme}
            size={2.6}
          />
        )),
      )}
    </svg>
  );
}

/** Which marker is whose. */
export function RendererKey({ study }: { study: CostStudy }) {
  return (
    <ul class="renderer-key">
      {study.renderers.map(({ name, biased }, i) => (
        <li key={name}>
          <RendererMark study={study} renderer={i} />
          {name}
          {biased ? <span class="quiet"> (biased: {biased})</span> : null}
        </li>
      ))}
    </ul>
  );
}

interface Props {
  study: CostStudy;
  axes: Axes;
  /** Indices of the targets to show. */
  targets: number[];
  chosen: number;
  route: Route;
}

/** All targets at a glance, on the same axes. */
export function Multiples({ study, axes, targets, chosen, route }: Props) {
  const theme = useTheme();
  const list = useRef<HTMLUListElement>(null);
  const charts = useMemo(
    () => study.targets.map((_, target) => chartOf(study, target, axes)),
    [study, axes.x, axes.y],
  );
  const ranges = useMemo(() => rangesOf(charts), [charts]);
  // Drawn once: many targets have thousands of marks, and most changes of the page are elsewhere.
  const drawings = useMemo(
    () =>
      charts.map((chart) =>
        ranges ? <SmallChart chart={chart} ranges={ranges} theme={theme} /> : null,
      ),
    [charts, ranges, theme],
  );
  const sheet = (): SVGSVGElement =>
    sheetOf(
      [...(list.current?.querySelectorAll("svg") ?? [])],
      theme,
      targets.map((target) => titleOf(study, target)),
      [
        { text: `${yLabel(axes)}, against ${xLabel(axes)}`, colour: theme.text },
        ...study.renderers.map(({ name }, i) => ({
          text: `${markerLetter(seriesOf(study, i))} ${name}`,
          colour: theme.series(seriesOf(study, i)),
        })),
      ],
    );
  if (!ranges) return null;
  return (
    <section class="cost-panel multiples" aria-label="All targets">
      <div class="panel-head">
        <h2>All targets, on the same axes</h2>
        <RendererKey study={study} />
        <SaveButtons
          name={`${study.suite} all targets`}
          sheet={sheet}
          rows={() => pointRows(study, targets)}
        />
      </div>
      <ul ref={list}>
        {targets.map((target) => {
          const name = study.targets[target]?.name ?? "";
          const link = { path: route.path, query: { ...route.query, target: name, point: "" } };
          return (
            <li key={name}>
              <a href={routeText(link)} aria-current={target === chosen ? "true" : undefined}>
                <span class="multiple-title">{titleOf(study, target)}</span>
                {drawings[target]}
              </a>
            </li>
          );
        })}
      </ul>
    </section>
  );
}
