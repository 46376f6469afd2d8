import { useRequest } from "../common/request";
import { useActions } from "../common/keys";
import { findCell, namesOf, stateOf, type Session } from "../common/session";
import { StateMark } from "../common/StateMark";
import type { CaseRecord, TargetDetail } from "../data/generated";
import { cellLink } from "../overview/Grid";
import { go, parseRoute, type Route } from "../route";
import { flushView } from "../viewer/use_view";
import { Viewer } from "../viewer/Viewer";
import { Accept } from "./Accept";
import { Cost } from "./Cost";
import { Effects } from "./Effects";
import { Logs } from "./Logs";
import { Measures } from "./Measures";
import { useOtherImages } from "./other_images";
import { PathToVerdict } from "./PathToVerdict";
import { showsItsError, worstRegion } from "./opening";
import { Provenance } from "./Provenance";
import { Related } from "./Related";
import { RenderRecord } from "./RenderRecord";
import { Verdict } from "./Verdict";

/** The previous and the next cell of the same renderer, and the cells of the same target. */
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

/** Opens another target in the same view: images, place, zoom, region and appearance. */
function openLike(link: string): void {
  flushView();
  const { query } = parseRoute(location.hash);
  const target = parseRoute(link);
  go({ path: target.path, query: { ...query, ...target.query } });
}

export function CasePage({ session, route }: { session: Session; route: Route }) {
  const [, caseName = "", target = "", renderer = ""] = route.path;
  const { overview } = session;
  const index = findCell(overview, caseName, target, renderer);
  // The detail is requested again when the state of the cell changes, or after another look.
  const { value: detail, problem } = useRequest(
    `${session.run} ${index}`,
    `${overview.cells.state[index]} ${overview.cells.spp[index]}`,
    index < 0 ? undefined : () => session.source.target(session.run, index),
  );
  const { previous, next, siblings } = neighbours(session, index);
  const to = (cell: number | undefined): void => {
    if (cell !== undefined) openLike(cellLink(session, cell));
  };
  const sibling = (step: number) =>
    siblings[(siblings.indexOf(index) + step + siblings.length) % siblings.length];
  useActions([
    { key: "[", label: "previous target", group: "Target", run: () => to(previous) },
    { key: "]", label: "next target", group: "Target", run: () => to(next) },
    { key: "j", label: "next renderer", group: "Target", run: () => to(sibling(1)) },
    { key: "k", label: "previous renderer", group: "Target", run: () => to(sibling(-1)) },
  ]);
  const one = overview.cases[overview.cells.case[index] ?? -1];
  if (index < 0 || !one)
    return (
      <p role="alert">
        This run has no target '{target}' of the case '{caseName}' by the renderer '{renderer}'.
      </p>
    );
  return (
    <article class="case">
      <CaseHeader
        session={session}
        index={index}
        one={one}
        target={target}
        diagnosis={detail?.diagnosis ?? ""}
        region={detail?.wrong_regions[0]?.text ?? ""}
        onMove={to}
      />
      {problem !== undefined ? <p role="alert">The target cannot be shown: {problem}</p> : null}
      {detail === undefined && problem === undefined ? <p class="loading">Reading …</p> : null}
      {detail ? (
        <Detail session={session} route={route} index={index} one={one} detail={detail} />
      ) : null}
    </article>
  );
}

interface HeaderProps {
  session: Session;
  /** Index of the cell that is shown. */
  index: number;
  one: CaseRecord;
  target: string;
  diagnosis: string;
  /** What is wrong for certain in the largest part of the image; "" if nothing is known. */
  region: string;
  onMove: (cell: number | undefined) => void;
}

/** The target, its verdict with the reason, and links to its neighbours. */
function CaseHeader(props: HeaderProps) {
  const { session, index, one, target, diagnosis, region, onMove } = props;
  const { overview } = session;
  const { previous, next, siblings } = neighbours(session, index);
  return (
    <header class="verdict">
      <div class="where">
        <h1>
          <span class="code">{one.requirement}</span> {one.title}{" "}
          <span class="quiet">{target}</span>
        </h1>
        <nav aria-label="Neighbours">
          <button
            disabled={previous === undefined}
            onClick={() => onMove(previous)}
            title="previous target ([)"
          >
            ◂ Previous
          </button>
          <button
            disabled={next === undefined}
            onClick={() => onMove(next)}
            title="next target (])"
          >
            Next ▸
          </button>
        </nav>
      </div>
      <div class="renderer-tabs" role="group" aria-label="Renderer">
        {siblings.map((cell) => (
          <button key={cell} aria-pressed={cell === index} onClick={() => onMove(cell)}>
            {namesOf(overview, cell).renderer}{" "}
            <StateMark state={stateOf(overview, cell)} word={false} />
          </button>
        ))}
      </div>
      <Verdict session={session} index={index} diagnosis={diagnosis} region={region} />
    </header>
  );
}

/** More samples make other images, in the same files. */
const samplesOf = ({ jobs }: TargetDetail): string =>
  jobs.map(({ identity }) => identity.spp).join(" ");

interface DetailProps {
  session: Session;
  route: Route;
  index: number;
  one: CaseRecord;
  detail: TargetDetail;
}

function Detail({ session, route, index, one, detail }: DetailProps) {
  const addable = useOtherImages(session, detail);
  return (
    <>
      <Viewer
        key={`${detail.case}/${detail.target}/${detail.renderer}/${samplesOf(detail)}`}
        home={session}
        addable={addable}
        images={detail.images}
        route={route}
        opensSideBySide={showsItsError(stateOf(session.overview, index), detail)}
        outlined={worstRegion(detail)}
      />
      <div class="facts">
        <Related session={session} detail={detail} />
        <Measures detail={detail} />
        <PathToVerdict session={session} detail={detail} />
        <section class="about">
          <h2>What is tested</h2>
          <p>{one.tests || "The case has no description."}</p>
          {one.typical_mistake ? (
            <>
              <h2>Typical mistake</h2>
              <p>{one.typical_mistake}</p>
            </>
          ) : null}
          {one.smallest_error_seen ? (
            <p class="quiet">Smallest error that this gate detects: {one.smallest_error_seen}</p>
          ) : null}
        </section>
        <Accept key={index} session={session} index={index} detail={detail} />
        <Effects detail={detail} />
        <Cost detail={detail} />
        <Provenance session={session} detail={detail} />
        <Logs session={session} detail={detail} />
        <RenderRecord detail={detail} />
      </div>
    </>
  );
}
