import { useAnswer } from "../common/answer";
import { useActions } from "../common/keys";
import { findCell, namesOf, reasonOf, stateOf, type Session } from "../common/session";
import { StateMark } from "../common/StateMark";
import type { Case, TargetDetail } from "../data/types";
import { cellLink } from "../overview/Grid";
import { go, parseRoute, type Route } from "../route";
import { Viewer } from "../viewer/Viewer";
import { Cost } from "./Cost";
import { Effects } from "./Effects";
import { Logs } from "./Logs";
import { Measures } from "./Measures";
import { Provenance } from "./Provenance";
import { RenderRecord } from "./RenderRecord";

/** Cells of the same renderer before and after this one, and the others of the same image. */
function neighbours(session: Session, index: number) {
  const { cells } = session.overview;
  const same = cells.renderer.flatMap((renderer, i) =>
    renderer === cells.renderer[index] ? [i] : [],
  );
  const at = same.indexOf(index);
  const siblings = cells.case.flatMap((one, i) =>
    one === cells.case[index] && cells.target[i] === cells.target[index] ? [i] : [],
  );
  return { previous: same[at - 1], next: same[at + 1], siblings };
}

/** The address of another case that keeps how images are looked at, but not where. */
function keepLook(link: string): void {
  const { query } = parseRoute(location.hash);
  const { x: _x, y: _y, zoom: _zoom, region: _region, ...look } = query;
  const target = parseRoute(link);
  go({ path: target.path, query: { ...look, ...target.query } });
}

export function CasePage({ session, route }: { session: Session; route: Route }) {
  const [, caseName = "", target = "", renderer = ""] = route.path;
  const { overview } = session;
  const index = findCell(overview, caseName, target, renderer);
  // A render that ends changes what there is to know.
  const { value: detail, problem } = useAnswer(
    `${session.run} ${index}`,
    overview.cells.state[index],
    index < 0 ? undefined : () => session.source.target(session.run, index),
  );
  const { previous, next, siblings } = neighbours(session, index);
  const to = (cell: number | undefined): void => {
    if (cell !== undefined) keepLook(cellLink(session, cell));
  };
  const sibling = (step: number) =>
    siblings[(siblings.indexOf(index) + step + siblings.length) % siblings.length];
  useActions([
    { key: "[", label: "previous target", group: "Case", run: () => to(previous) },
    { key: "]", label: "next target", group: "Case", run: () => to(next) },
    { key: "j", label: "next renderer", group: "Case", run: () => to(sibling(1)) },
    { key: "k", label: "previous renderer", group: "Case", run: () => to(sibling(-1)) },
  ]);
  const one = overview.cases[overview.cells.case[index] ?? -1];
  if (index < 0 || !one)
    return (
      <p role="alert">
        This run has no target '{target}' of the case '{caseName}' by '{renderer}'.
      </p>
    );
  return (
    <article class="case">
      <header class="verdict">
        <div class="where">
          <h1>
            <span class="code">{one.requirement}</span> {one.title}{" "}
            <span class="quiet">{target}</span>
          </h1>
          <nav aria-label="Neighbours">
            <button
              disabled={previous === undefined}
              onClick={() => to(previous)}
              title="previous target ([)"
            >
              ◂ Previous
            </button>
            <button disabled={next === undefined} onClick={() => to(next)} title="next target (])">
              Next ▸
            </button>
          </nav>
        </div>
        <div class="renderer-tabs" role="group" aria-label="Renderer">
          {siblings.map((cell) => (
            <button key={cell} aria-pressed={cell === index} onClick={() => to(cell)}>
              {namesOf(overview, cell).renderer}{" "}
              <StateMark state={stateOf(overview, cell)} word={false} />
            </button>
          ))}
        </div>
        <p class="reason">
          <StateMark state={stateOf(overview, index)} /> {reasonOf(overview, index)}
        </p>
        {one.smallest_error_seen ? (
          <p class="quiet">Smallest error that this gate sees: {one.smallest_error_seen}</p>
        ) : null}
      </header>
      {problem !== undefined ? <p role="alert">The target cannot be shown: {problem}</p> : null}
      {detail === undefined && problem === undefined ? <p class="loading">Reading …</p> : null}
      {detail ? <Detail session={session} route={route} one={one} detail={detail} /> : null}
    </article>
  );
}

function Detail({
  session,
  route,
  one,
  detail,
}: {
  session: Session;
  route: Route;
  one: Case;
  detail: TargetDetail;
}) {
  return (
    <>
      <Viewer
        key={`${detail.case}/${detail.target}/${detail.renderer}`}
        session={session}
        images={detail.images}
        route={route}
      />
      <div class="facts">
        <section class="about">
          <h2>What is tested</h2>
          <p>{one.tests || "The case says nothing about it."}</p>
          {one.typical_mistake ? (
            <>
              <h2>A typical mistake</h2>
              <p>{one.typical_mistake}</p>
            </>
          ) : null}
        </section>
        <Effects detail={detail} />
        <Measures detail={detail} />
        <Cost detail={detail} />
        <Provenance session={session} detail={detail} />
        <Logs session={session} detail={detail} />
        <RenderRecord detail={detail} />
      </div>
    </>
  );
}
