import { useEffect, useRef, useState } from "preact/hooks";
import { note, type Route } from "../route";
import { parseView, viewQuery, type Mode, type ViewState } from "./view_state";

let writePending = (): void => undefined;

/** Writes the last change of the view to the address now, so that a link can take it along. */
export const flushView = (): void => writePending();

const kWriteDelay_ms = 250; // browsers allow about a hundred changes of the address in 30 seconds

/**
 * The view, kept equal to the address: its own changes are written there after a short delay. `usual` is
 * the mode of an address that names none.
 */
export function useView(route: Route, usual: Mode): [ViewState, (view: ViewState) => void] {
  const [view, setView] = useState(() => parseView(route.query, usual));
  const written = useRef(JSON.stringify(viewQuery(view, usual)));
  const timer = useRef<ReturnType<typeof setTimeout> | undefined>(undefined);
  const address = JSON.stringify(viewQuery(parseView(route.query, usual), usual));
  useEffect(() => {
    if (address === written.current) return;
    // A link was followed: a change that is not written yet belongs to the address before it.
    clearTimeout(timer.current);
    timer.current = undefined;
    writePending = () => undefined;
    written.current = address;
    setView(parseView(route.query, usual));
  }, [address]);
  useEffect(
    () => () => {
      clearTimeout(timer.current);
      writePending = () => undefined;
    },
    [],
  );
  return [
    view,
    (next) => {
      setView(next);
      clearTimeout(timer.current);
      writePending = () => {
        clearTimeout(timer.current);
        timer.current = undefined;
        writePending = () => undefined;
        written.current = JSON.stringify(viewQuery(next, usual));
        note(viewQuery(next, usual));
      };
      timer.current = setTimeout(writePending, kWriteDelay_ms);
    },
  ];
}
