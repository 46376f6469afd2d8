import { useEffect, useState } from "preact/hooks";
import { useRequest, type Received } from "../common/request";
import type { Source } from "../data/source";

const kPause_ms = 5000;

/** A study, read again now and then until it is finished; nothing if `run` is -1. */
export function useStudy<Study extends { finished: boolean }>(
  source: Source,
  run: number,
  read: (run: number) => Promise<Study>,
): Received<Study> {
  const [attempt, setAttempt] = useState(0);
  const received = useRequest(`study ${run}`, attempt, run < 0 ? undefined : () => read(run));
  const goesOn = source.isServed && received.value?.finished === false;
  useEffect(() => {
    if (!goesOn) return undefined;
    const timer = setTimeout(() => setAttempt((n) => n + 1), kPause_ms);
    return () => clearTimeout(timer);
  }, [goesOn, attempt]);
  return received;
}
