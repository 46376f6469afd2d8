import { useMemo } from "preact/hooks";
import type { Session } from "../common/session";
import type { Chart } from "../data/types";
import { cellLink } from "../overview/Grid";
import { go, note, parseRoute, type Route } from "../route";
import { chartByTarget, chartOfTwo, quantitiesOf, type Quantity } from "./from_run";
import { hasPoints, leftOutText } from "./drawable";
import { Plot } from "./Plot";

function Choice({
  label,
  param,
  chosen,
  quantities,
}: {
  label: string;
  param: string;
  chosen: Quantity;
  quantities: Quantity[];
}) {
  return (
    <label>
      {label}{" "}
      <select
        value={chosen.name}
        onChange={(event) => note({ [param]: event.currentTarget.value })}
      >
        {quantities.map(({ name, label: text }) => (
          <option key={name} value={name}>
            {text}
          </option>
        ))}
      </select>
    </label>
  );
}

function ChartSection({
  chart,
  onOpen,
  children,
}: {
  chart: Chart;
  onOpen: (cell: number) => void;
  children?: preact.ComponentChildren;
}) {
  const leftOut = leftOutText(chart);
  return (
    <section class="chart" aria-label={chart.title}>
      <h2>{chart.title}</h2>
      <div class="chart-choices">{children}</div>
      {hasPoints(chart) ? <Plot chart={chart} onOpen={onOpen} /> : null}
      {leftOut ? <p class="quiet left-out">{leftOut}</p> : null}
      {!hasPoints(chart) && !leftOut ? <p class="quiet">The run has no numbers for this.</p> : null}
    </section>
  );
}

/** Time, memory and error of all images, and the curves that the run holds. */
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
    return <p class="quiet">Nothing was rendered yet, so there is nothing to draw.</p>;
  return (
    <>
      <h1 class="unseen">Time and memory</h1>
      {overview.machines.length > 1 ? (
        <p class="quiet">
          Not all times are of one machine, so they cannot be compared:{" "}
          {overview.machines.join("; ")}.
        </p>
      ) : null}
      <ChartSection chart={byTarget} onOpen={open}>
        <Choice label="Show" param="of" chosen={one} quantities={quantities} />
      </ChartSection>
      <ChartSection chart={ofTwo} onOpen={open}>
        <Choice label="Up" param="cy" chosen={y} quantities={quantities} />
        <Choice label="Right" param="cx" chosen={x} quantities={quantities} />
      </ChartSection>
      {(overview.charts ?? []).map((chart) => (
        <ChartSection key={chart.title} chart={chart} onOpen={open} />
      ))}
    </>
  );
}
