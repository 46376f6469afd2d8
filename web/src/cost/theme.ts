import { useEffect, useState } from "preact/hooks";
import { seriesColour } from "../charts/palette";

/** Colours of a chart, as values: a chart that is saved as a file has no style sheet. */
export interface Theme {
  text: string;
  quiet: string;
  line: string;
  panel: string;
  series: (index: number) => string;
}

const query = (): MediaQueryList => matchMedia("(prefers-color-scheme: dark)");

export function currentTheme(): Theme {
  const style = getComputedStyle(document.documentElement);
  const colour = (name: string): string => style.getPropertyValue(name).trim();
  const dark = query().matches;
  return {
    text: colour("--text"),
    quiet: colour("--quiet"),
    line: colour("--line"),
    panel: colour("--panel"),
    series: (index) => seriesColour(index, dark),
  };
}

export function useTheme(): Theme {
  const [theme, setTheme] = useState(currentTheme);
  useEffect(() => {
    const media = query();
    const update = (): void => setTheme(currentTheme());
    media.addEventListener("change", update);
    return () => media.removeEventListener("change", update);
  }, []);
  return theme;
}
