// The whole state of a view stands in the part of the address behind '#': a link shows what its sender saw.
import { useEffect, useState } from "preact/hooks";

export interface Route {
  /** Parts of the path: ["case", "m1_lambert", "101", "orbs"]; [] for the overview. */
  path: string[];
  query: Record<string, string>;
}

export function parseRoute(hash: string): Route {
  const [path = "", query = ""] = hash.replace(/^#\/?/, "").split("?", 2);
  const decode = (text: string): string => {
    try {
      return decodeURIComponent(text);
    } catch {
      return text; // a broken code in a link that somebody typed
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
const tell = (): void => listeners.forEach((listener) => listener());
addEventListener("popstate", tell);
addEventListener("hashchange", tell);

/** Goes to another view; the back button returns. */
export function go(route: Route): void {
  history.pushState(null, "", routeText(route));
  tell();
}

/** Notes a change within the view: the back button leaves the view, not each step in it. Empty values are dropped. */
export function note(changes: Record<string, string>): void {
  const route = parseRoute(location.hash);
  history.replaceState(
    null,
    "",
    routeText({ path: route.path, query: { ...route.query, ...changes } }),
  );
  tell();
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
