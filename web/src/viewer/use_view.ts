import { useEffect, useRef, useState } from "preact/hooks";
import { note, type Route } from "../route";
import { parseView, viewQuery, type ViewState } from "./view_state";

const kWriteDelay_ms = 250; // browsers allow about a hundred changes of the address in 30 seconds

/** The view, kept equal to the address: its own changes are written there after a short delay. */
export function useView(route: Route): [ViewState, (view: ViewState) => void] {
  const [view, setView] = useState(() => parseView(route.query));
  const written = useRef(JSON.stringify(viewQuery(view)));
  const timer = useRef<ReturnType<typeof setTimeout> | undefined>(undefined);
  const address = JSON.stringify(viewQuery(parseView(route.query)));
  useEffect(() => {
    if (address === written.current || timer.current) return;
    written.current = address;
    setView(parseView(route.query));
  }, [address]);
  useEffect(() => () => clearTimeout(timer.current), []);
  return [
    view,
    (next) => {
      setView(next);
      clearTimeout(timer.current);
      timer.current = setTimeout(() => {
        timer.current = undefined;
        written.current = JSON.stringify(viewQuery(next));
        note(viewQuery(next));
      }, kWriteDelay_ms);
    },
  ];
}
