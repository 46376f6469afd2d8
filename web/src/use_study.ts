import { useEffect, useState } from "preact/hooks";
import { useRequest, type Received } from "./common/request";
import type { Source } from "./data/source";
import type { AnyStudy } from "./studies";

const kPause_ms = 5000;

/** The study at that place, read again now and then until it is finished; nothing if it is a run. */
export function useStudy(source: Source, run: number): Received<AnyStudy> {
  const kind = source.kinds[run];
  const isStudy = kind !== undefined && kind !== "run";
  const [attempt, setAttempt] = useState(0);
  const received = useRequest(
    `study ${run}`,
    attempt,
    isStudy ? () => source.study(kind, run) : undefined,
  );
  const goesOn = source.isServed && received.value?.finished === false;
  useEffect(() => {
    if (!goesOn) return undefined;
    const timer = setTimeout(() => setAttempt((n) => n + 1), kPause_ms);
    return () => clearTimeout(timer);
  }, [goesOn, attempt]);
  return received;
}
