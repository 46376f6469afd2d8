import { unpack } from "./raster";
import type { Source } from "./source";
import type { Overview, TargetDetail } from "./types";

function textOf(id: string): string {
  const element = document.getElementById(id);
  if (!element) throw new Error("it is not in this file, which was written without");
  return element.textContent ?? "";
}

function bytesOf(id: string): Uint8Array<ArrayBuffer> {
  const text = atob(textOf(id));
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

/** The page written by `orbs report`: all data stands in script elements of the file. */
export function embeddedSource(): Source {
  const written = JSON.parse(textOf("orbs-overview")) as Overview;
  // In a file no run goes on.
  const overview = { ...written, run: { ...written.run, live: false } };
  const elements = JSON.parse(textOf("orbs-images")) as Record<string, string>;
  let targets: TargetDetail[] | undefined;
  return {
    runs: [overview.run.name],
    overview: async () => overview,
    target: async (_run, index) => {
      targets ??= JSON.parse(textOf("orbs-targets")) as TargetDetail[];
      const target = targets[index];
      if (!target) throw new Error("this run has no such target");
      return target;
    },
    raster: async (_run, file, layer) => {
      const element = elements[file];
      if (!element)
        throw new Error(
          "it is not in this file, which was kept small; 'orbs serve' shows it from the run's folder",
        );
      if (layer)
        throw new Error("this file holds only the main layer; 'orbs serve' shows the others");
      return unpack(new Blob([bytesOf(element)]).stream());
    },
    thumbnail: async (_run, index) => {
      const element = document.getElementById(`thumbnail-${index}`);
      return element ? `data:image/png;base64,${element.textContent ?? ""}` : undefined;
    },
    fileAddress: () => undefined,
    follow: () => () => undefined,
  };
}
