import { useEffect, useState } from "preact/hooks";
import { useRequest } from "./common/request";
import type { Session } from "./common/session";
import type { Update, Source } from "./data/source";

const kRetry_ms = 3000;

function connectionProblemOf(
  problem: string | undefined,
  update: Update | undefined,
): string | undefined {
  if (problem !== undefined) return problem;
  if (update === "disconnected") return "the server does not answer";
  return update === "closed" ? "the server sends no more updates of this run" : undefined;
}

/** A run, updated while it is live; a message if it cannot be shown, undefined while it loads. */
export function useSession(source: Source, run: number): Session | string | undefined {
  const [last, setLast] = useState<{ run: number; update: Update; count: number }>();
  const [attempt, setAttempt] = useState(0);
  const { value: overview, problem } = useRequest(
    String(run),
    `${last?.count ?? 0} ${attempt}`,
    run < 0 ? undefined : () => source.overview(run),
  );
  const live = overview?.run.live ?? false;
  useEffect(() => {
    if (!live) return undefined;
    return source.follow(run, (update) =>
      setLast((old) => ({
        run,
        update,
        count: (old?.count ?? 0) + (update === "disconnected" ? 0 : 1),
      })),
    );
  }, [source, run, live, attempt]);
  const update = last?.run === run ? last.update : undefined;
  // No event of the server ends these two states: the failed request may follow the last update.
  const isStuck = live && (problem !== undefined || update === "closed");
  useEffect(() => {
    if (!isStuck) return undefined;
    const timer = setTimeout(() => setAttempt((n) => n + 1), kRetry_ms);
    return () => clearTimeout(timer);
  }, [isStuck, attempt]);
  if (!overview) return problem;
  return {
    source,
    run,
    overview,
    progress: typeof update === "object" ? update : undefined,
    connectionProblem: connectionProblemOf(problem, update),
  };
}
