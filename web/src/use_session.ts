import { useEffect, useState } from "preact/hooks";
import { useAnswer } from "./common/answer";
import type { Session } from "./common/session";
import type { News, Source } from "./data/source";

const kRetry_ms = 3000;

function troubleOf(problem: string | undefined, news: News | undefined): string | undefined {
  if (problem !== undefined) return problem;
  if (news === "lost") return "the server does not answer";
  return news === "silent" ? "the server tells nothing more about this run" : undefined;
}

/** A run, kept up to date while it goes on; a text when it cannot be shown, undefined while it is read. */
export function useSession(source: Source, run: number): Session | string | undefined {
  const [heard, setHeard] = useState<{ run: number; news: News; count: number }>();
  const [attempt, setAttempt] = useState(0);
  const { value: overview, problem } = useAnswer(
    String(run),
    `${heard?.count ?? 0} ${attempt}`,
    run < 0 ? undefined : () => source.overview(run),
  );
  const live = overview?.run.live ?? false;
  useEffect(() => {
    if (!live) return undefined;
    return source.follow(run, (news) =>
      setHeard((last) => ({ run, news, count: (last?.count ?? 0) + (news === "lost" ? 0 : 1) })),
    );
  }, [source, run, live, attempt]);
  const news = heard?.run === run ? heard.news : undefined;
  // Nothing that comes by itself ends these two: the last news may be what could not be read.
  const isStuck = live && (problem !== undefined || news === "silent");
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
    progress: typeof news === "object" ? news : undefined,
    trouble: troubleOf(problem, news),
  };
}
