// The fragment of the address (after '#') holds the whole state of a view: a link reproduces it.
import { useEffect, useState } from "preact/hooks";

export interface Route {
  /** Parts of the path, e.g. ["case", "m1_lambert", "101", "orbs"]; [] is the overview. */
  path: string[];
  query: Record<string, string>;
}

export function parseRoute(hash: string): Route {
  const [path = "", query = ""] = hash.replace(/^#\/?/, "").split("?", 2);
  const decode = (text: string): string => {
    try {
      return decodeURIComponent(text);
    } catch {
      return text; // a malformed %-escape in a link that was typed by hand
    }
  };
  return {
    path: path.split("/").filter(Boolean).map(decode),
    query: Object.fromEntries(new URLSearchParams(query)),
  };
}

export function routeText(route: Route): string {
  const query = new URLSearchParams(
    Object.entries(route.query).filter(([, value]) => value !== ""),
  ).toString();
  return `#/${route.path.map(encodeURIComponent).join("/")}${query ? `?${query}` : ""}`;
}

const listeners = new Set<() => void>();
const notify = (): void => listeners.forEach((listener) => listener());
addEventListener("popstate", notify);
addEventListener("hashchange", notify);

/** Opens another view; the back button returns to this one. */
export function go(route: Route): void {
  history.pushState(null, "", routeText(route));
  notify();
}

/**
 * Records a change within the view in the address. The back button leaves the view instead of
 * undoing the change. Empty values are removed from the address.
 */
export function note(changes: Record<string, string>): void {
  const route = parseRoute(location.hash);
  history.replaceState(
    null,
    "",
    routeText({ path: route.path, query: { ...route.query, ...changes } }),
  );
  notify();
}

export function useRoute(): Route {
  const [route, setRoute] = useState(() => parseRoute(location.hash));
  useEffect(() => {
    const update = (): void => setRoute(parseRoute(location.hash));
    listeners.add(update);
    return () => void listeners.delete(update);
  }, []);
  return route;
}
