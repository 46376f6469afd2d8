import { useEffect } from "preact/hooks";
import { useRequest, type Received } from "../common/request";
import { runNamed, runQuery, type Session } from "../common/session";
import type { Overview } from "../data/generated";
import { note, type Route } from "../route";

/** One side of the comparison, as the address names it. */
export interface ChosenSide {
  /** Index of the run; -1 if there is no run of that name. */
  run: number;
  /** Only this renderer; "" for all. */
  renderer: string;
  received: Received<Overview>;
}

export interface Sides {
  before: ChosenSide;
  after: ChosenSide;
}

function useOverview(session: Session, run: number): Received<Overview> {
  const own = run === session.run;
  const received = useRequest(
    String(run),
    own,
    own || run < 0 ? undefined : () => session.source.overview(run),
  );
  return own ? { value: session.overview } : received;
}

/** The runs of the suite and size of the one that is shown, the newest first: no others can be compared. */
function comparableRuns({ source, run }: Session): number[] {
  return source.runs.flatMap((_, i) =>
    source.kinds[i] === "run" && source.suites[i] === source.suites[run] ? [i] : [],
  );
}

/** The two sides: of several runs the last two of a suite, of a single run its first two renderers. */
export function useSides(session: Session, route: Route): Sides {
  const { source, overview } = session;
  // The newest run is the first, and the run before it the second.
  const runs = comparableRuns(session);
  const before = runNamed(source, route.query["before"], runs[1] ?? runs[0] ?? -1);
  const after = runNamed(source, route.query["after"], runs[0] ?? -1);
  useEffect(() => {
    if (source.runs.length > 1 && (!route.query["before"] || !route.query["after"]))
      note({ ...runQuery(source, before, "before"), ...runQuery(source, after, "after") });
  }, [route]);
  const { renderers } = overview;
  const compareRenderers = runs.length < 2 && renderers.length > 1;
  const usual = (i: number): string => (compareRenderers ? (renderers[i]?.name ?? "") : "");
  return {
    before: {
      run: before,
      renderer: route.query["ra"] ?? usual(1),
      received: useOverview(session, before),
    },
    after: {
      run: after,
      renderer: route.query["rb"] ?? usual(0),
      received: useOverview(session, after),
    },
  };
}
