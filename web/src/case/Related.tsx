import { useEffect, useMemo, useState } from "preact/hooks";
import { costOf, stabilityOf } from "../common/said";
import { overviewOf, useRelated, type Found } from "../common/related";
import { findCell, runQuery, stateOf, type Session } from "../common/session";
import { StateMark } from "../common/StateMark";
import { chartOf, rangesOf } from "../cost/chart_data";
import { CostChart } from "../cost/CostChart";
import { completed } from "../cost/older";
import { metricOf } from "../cost/quantities";
import type { CostStudy, Overview, StabilityStudy, TargetDetail } from "../data/generated";
import { go, routeText } from "../route";
import { cellText } from "../stability/texts";

interface Props {
  session: Session;
  detail: TargetDetail;
}

/** The curve of this target with all renderers of the study; a point opens the study there. */
function CostPart({ found, target }: { found: Found<CostStudy>; target: number }) {
  const study = useMemo(() => completed(found.study), [found.study]);
  const y = metricOf(study, undefined);
  const chart = useMemo(
    () => (y ? chartOf(study, target, { x: "cpu_seconds", y }) : undefined),
    [study, target],
  );
  const ranges = useMemo(() => (chart ? rangesOf([chart]) : undefined), [chart]);
  const name = study.targets[target]?.name ?? "";
  const address = { path: [], query: { run: found.name, target: name } };
  return (
    <>
      <h3>
        Error against CPU time{" "}
        <a class="quiet" href={routeText(address)}>
          {found.name}
        </a>
      </h3>
      {chart && ranges ? (
        <CostChart
          study={study}
          chart={chart}
          ranges={ranges}
          chosen={undefined}
          onChoose={({ curve, index }) =>
            go({
              ...address,
              query: {
                ...address.query,
                point: `${study.renderers[curve.renderer]?.name}/${index}`,
              },
            })
          }
        />
      ) : null}
    </>
  );
}

/** The row of the stability matrix: of this scene where the study holds it, and the summary of the renderer. */
function StabilityPart({ found, renderer }: { found: Found<StabilityStudy>; renderer: string }) {
  const { study } = found;
  const cells = study.matrix.filter((cell) => cell.renderer === renderer && cell.scenes > 0);
  const link = (relation: string): string =>
    routeText({ path: [], query: { run: found.name, cell: `${relation}/${renderer}` } });
  return (
    <>
      <h3>
        Does {renderer} stay right?{" "}
        <a class="quiet" href={routeText({ path: [], query: { run: found.name } })}>
          {found.name}
        </a>
      </h3>
      <p>{stabilityOf(study, renderer)}</p>
      <ul class="breaks">
        {cells
          .filter((cell) => cell.first_break)
          .map((cell) => {
            const relation = study.relations.find(({ name }) => name === cell.relation);
            return relation ? (
              <li key={cell.relation}>
                <a href={link(cell.relation)}>{relation.change}</a>: {cellText(cell, relation)}
              </li>
            ) : null;
          })}
      </ul>
    </>
  );
}

interface Earlier {
  run: number;
  overview: Overview;
  cell: number;
}

/** So many other runs are asked for the target, the newest first. */
const kMostRuns = 8;

/** The same target by the same renderer in other runs of this suite and size. */
function useEarlier({ source, run, overview }: Session, detail: TargetDetail): Earlier[] {
  const [found, setFound] = useState<Earlier[]>([]);
  useEffect(() => {
    let isWanted = true;
    const others = source.kinds.flatMap((kind, i) => (kind === "run" && i !== run ? [i] : []));
    const ask = async (): Promise<void> => {
      const all: Earlier[] = [];
      for (const other of others.slice(0, kMostRuns)) {
        const its = await overviewOf(source, other).catch(() => undefined);
        if (!its || !isWanted) continue;
        if (its.run.suite !== overview.run.suite || its.run.size !== overview.run.size) continue;
        const cell = findCell(its, detail.case, detail.target, detail.renderer);
        if (cell >= 0) all.push({ run: other, overview: its, cell });
      }
      if (isWanted) setFound(all);
    };
    void ask();
    return () => void (isWanted = false);
  }, [source, run, detail.case, detail.target, detail.renderer]);
  return found;
}

function HistoryPart({ session, detail }: Props) {
  const earlier = useEarlier(session, detail);
  if (earlier.length === 0) return null;
  const path = ["case", detail.case, detail.target, detail.renderer];
  return (
    <>
      <h3>In other runs</h3>
      <ul class="earlier">
        {earlier.map(({ run, overview, cell }) => (
          <li key={run}>
            <StateMark state={stateOf(overview, cell)} />{" "}
            <a href={routeText({ path, query: runQuery(session.source, run) })}>
              {session.source.runs[run]}
            </a>{" "}
            <span class="quiet">
              {overview.run.started.replace("T", " ")}, orbs {overview.run.orbs_version}
            </span>
          </li>
        ))}
      </ul>
    </>
  );
}

/** What the studies and the other runs of the folder hold of this target and its renderer. */
export function Related({ session, detail }: Props) {
  const { cost, stability } = useRelated(session.source, session.overview.run.suite);
  const indexIn = ({ study }: Found<CostStudy>): number =>
    study.targets.findIndex(({ name }) => name === detail.target);
  const withTarget = cost.find((found) => indexIn(found) >= 0);
  const said = cost.flatMap(({ study }) => costOf(study, detail.renderer) ?? [])[0];
  const stays = stability.find(({ study }) =>
    study.renderers.some(({ name }) => name === detail.renderer),
  );
  const isAlone = session.source.runs.length < 2;
  return (
    <section class="related">
      <h2>What else is known</h2>
      <div class="parts">
        {withTarget ? (
          <div>
            <CostPart found={withTarget} target={indexIn(withTarget)} />
            {said ? (
              <p>
                In the suite, {detail.renderer}: {said}.
              </p>
            ) : null}
          </div>
        ) : null}
        <div>
          {stays ? <StabilityPart found={stays} renderer={detail.renderer} /> : null}
          <HistoryPart session={session} detail={detail} />
        </div>
      </div>
      {isAlone ? (
        <p class="quiet">
          This page holds the run alone. “orbs serve” in the folder of runs and studies also shows
          the error–time curves of “orbs cost”, the breaks of “orbs stability”, and this target in
          earlier runs.
        </p>
      ) : null}
    </section>
  );
}
