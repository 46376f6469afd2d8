import { useMemo } from "preact/hooks";
import { Choice } from "../common/Choice";
import type { Session } from "../common/session";
import type { Chart } from "./from_run";
import { cellLink } from "../overview/Grid";
import { go, parseRoute, type Route } from "../route";
import { chartByTarget, chartOfTwo, quantitiesOf, type Quantity } from "./from_run";
import { hasPoints, leftOutText } from "./drawable";
import { Plot } from "./Plot";

interface ChartSectionProps {
  chart: Chart;
  onOpen: (cell: number) => void;
  children?: preact.ComponentChildren;
}

function ChartSection({ chart, onOpen, children }: ChartSectionProps) {
  const leftOut = leftOutText(chart);
  return (
    <section class="chart" aria-label={chart.title}>
      <h2>{chart.title}</h2>
      <div class="chart-choices">{children}</div>
      {hasPoints(chart) ? <Plot chart={chart} onOpen={onOpen} /> : null}
      {leftOut ? <p class="quiet left-out">{leftOut}</p> : null}
      {!hasPoints(chart) && !leftOut ? <p class="quiet">The run has no values for this.</p> : null}
    </section>
  );
}

/** Time, memory and error of all targets. */
export function ChartsPage({ session, route }: { session: Session; route: Route }) {
  const { overview } = session;
  const quantities = useMemo(() => quantitiesOf(overview), [overview]);
  const pick = (param: string, usual: (q: Quantity) => boolean): Quantity | undefined =>
    quantities.find(({ name }) => name === route.query[param]) ??
    quantities.find(usual) ??
    quantities[0];
  const one = pick("of", ({ name }) => name === "wall_seconds");
  const x = pick("cx", ({ name }) => name === "wall_seconds");
  const firstError =
    overview.metrics.find((metric) => metric.lower_is_better)?.name ?? overview.main_metric;
  const y = pick("cy", ({ name }) => name === firstError);
  const byTarget = useMemo(() => one && chartByTarget(overview, one), [overview, one]);
  const ofTwo = useMemo(() => x && y && chartOfTwo(overview, x, y), [overview, x, y]);
  const open = (cell: number): void => go(parseRoute(cellLink(session, cell)));
  if (!one || !x || !y || !byTarget || !ofTwo)
    return <p class="quiet">Nothing was rendered yet, so there is nothing to plot.</p>;
  return (
    <>
      <h1 class="unseen">Time and memory</h1>
      {overview.machines.length > 1 ? (
        <p class="quiet">
          The times were measured on different machines and cannot be compared:{" "}
          {overview.machines.join("; ")}.
        </p>
      ) : null}
      <ChartSection chart={byTarget} onOpen={open}>
        <Choice label="Show" param="of" chosen={one.name} options={quantities} />
      </ChartSection>
      <ChartSection chart={ofTwo} onOpen={open}>
        <Choice label="y axis" param="cy" chosen={y.name} options={quantities} />
        <Choice label="x axis" param="cx" chosen={x.name} options={quantities} />
      </ChartSection>
    </>
  );
}
