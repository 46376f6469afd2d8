import { useEffect, useRef, useState } from "preact/hooks";

export const reasonOf = (error: unknown): string =>
  error instanceof Error ? error.message : String(error);

export interface Answer<T> {
  value?: T;
  /** Why the last question had no answer; `value` is then what an earlier one had. */
  problem?: string;
}

/**
 * What `ask` answers; nothing is asked where there is none. Another `key` is another question: answers to the one
 * before count no more. With another `turn` the same is asked anew, and the last answer stays until there is a later one.
 */
export function useAnswer<T>(
  key: string,
  turn: unknown,
  ask: (() => Promise<T>) | undefined,
): Answer<T> {
  const [answer, setAnswer] = useState<Answer<T> & { key: string }>();
  const question = useRef({ key, asked: 0, answered: 0 });
  if (question.current.key !== key) question.current = { key, asked: 0, answered: 0 };
  useEffect(() => {
    if (!ask) return;
    const own = question.current;
    const number = ++own.asked;
    const put = (found: Answer<T>): void => {
      if (own !== question.current || number < own.answered) return;
      own.answered = number;
      setAnswer((last) => {
        const value = "value" in found ? found.value : last?.key === key ? last.value : undefined;
        return {
          key,
          ...(value === undefined ? {} : { value }),
          ...(found.problem === undefined ? {} : { problem: found.problem }),
        };
      });
    };
    ask().then(
      (value) => put({ value }),
      (error: unknown) => put({ problem: reasonOf(error) }),
    );
  }, [key, turn]);
  return answer?.key === key ? answer : {};
}
