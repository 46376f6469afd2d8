import { useEffect, useRef, useState } from "preact/hooks";
import { messageOf } from "./message";

export interface Received<T> {
  value?: T;
  /** Why the last request failed; `value` is then the result of an earlier one. */
  problem?: string;
}

/**
 * The result of `request`; nothing is requested while it is undefined. Results for another `key`
 * are discarded. When `revision` changes the request is repeated, and the last result stays until a
 * newer one arrives.
 */
export function useRequest<T>(
  key: string,
  revision: unknown,
  request: (() => Promise<T>) | undefined,
): Received<T> {
  const [received, setReceived] = useState<Received<T> & { key: string }>();
  const requests = useRef({ key, sent: 0, answered: 0 });
  if (requests.current.key !== key) requests.current = { key, sent: 0, answered: 0 };
  useEffect(() => {
    if (!request) return;
    const own = requests.current;
    const number = ++own.sent;
    const put = (found: Received<T>): void => {
      if (own !== requests.current || number < own.answered) return;
      own.answered = number;
      setReceived((last) => {
        const value = "value" in found ? found.value : last?.key === key ? last.value : undefined;
        return {
          key,
          ...(value === undefined ? {} : { value }),
          ...(found.problem === undefined ? {} : { problem: found.problem }),
        };
      });
    };
    request().then(
      (value) => put({ value }),
      (error: unknown) => put({ problem: messageOf(error) }),
    );
  }, [key, revision]);
  return received?.key === key ? received : {};
}
