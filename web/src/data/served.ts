import type { RunComparison } from "../compare/statistics";
import type { Studies } from "../studies";
import { pngAddress } from "./display";
import { decoded } from "./decoder";
import { editing } from "./edit";
import type { Raster } from "./raster";
import {
  kStudyKinds,
  type CostChanges,
  type Overview,
  type Progress,
  type StudyKind,
  type TargetDetail,
} from "./generated";
import type { Kind, Source } from "./source";

async function get(address: string, signal?: AbortSignal): Promise<Response> {
  const response = await fetch(address, signal ? { signal } : {}).catch((error: unknown) => {
    if (signal?.aborted) throw error;
    throw new Error("the server does not answer"); // the message of the error differs by browser
  });
  if (!response.ok)
    throw new Error((await response.text()).trim() || `the server answered ${response.status}`);
  return response;
}

const encoded = (path: string): string => path.split("/").map(encodeURIComponent).join("/");

const costChanges = async (before: number, after: number): Promise<CostChanges> =>
  (await (await get(`/data/${after}/before/${before}.json`)).json()) as CostChanges;

export async function servedSource(): Promise<Source> {
  const { runs, edit } = (await (await get("/data/runs.json")).json()) as {
    runs: { name: string; kind: Kind; suite: string }[];
    edit: boolean;
  };
  const fileAddress = (run: number, file: string): string => `/data/${run}/file/${encoded(file)}`;
  const raster = async (
    run: number,
    file: string,
    layer: string,
    signal?: AbortSignal,
  ): Promise<Raster> => {
    const query = layer ? `?layer=${encodeURIComponent(layer)}` : "";
    const response = await get(`/data/${run}/image/${encoded(file)}${query}`, signal);
    return decoded(await response.arrayBuffer());
  };
  return {
    runs: runs.map((run) => run.name),
    kinds: runs.map((run) => run.kind),
    suites: runs.map((run) => run.suite),
    isServed: true,
    edit: editing(edit),
    overview: async (run) => {
      const overview = (await (await get(`/data/${run}/overview.json`)).json()) as Overview;
      const expected = runs[run]?.name ?? "";
      if (overview.run.name === expected) return overview;
      throw new Error(
        `expected the run '${expected}' and found '${overview.run.name}': ` +
          "the server was restarted; reload the page",
      );
    },
    target: async (run, index) =>
      (await (await get(`/data/${run}/target/${index}.json`)).json()) as TargetDetail,
    comparison: async (before, after, [ra, rb]) => {
      const query = ra && rb ? `?${new URLSearchParams({ ra, rb }).toString()}` : "";
      const response = await get(`/data/${after}/before/${before}.json${query}`);
      return (await response.json()) as RunComparison;
    },
    costChanges,
    raster,
    study: async <K extends StudyKind>(kind: K, run: number) => {
      const file = kStudyKinds.find(({ name }) => name === kind)?.file ?? "";
      return (await (await get(fileAddress(run, file))).json()) as Studies[K];
    },
    picture: async (run, file) =>
      file.endsWith(".exr") ? pngAddress(await raster(run, file, "")) : fileAddress(run, file),
    preview: async (run, file) => `/data/${run}/preview/${encoded(file)}`,
    fileAddress,
    follow: (run, onUpdate) => {
      const events = new EventSource(`/data/${run}/events`);
      events.addEventListener("progress", (event) => {
        const progress = JSON.parse((event as MessageEvent<string>).data) as Progress;
        if (!progress.live) events.close();
        onUpdate(progress);
      });
      events.addEventListener("error", () =>
        onUpdate(events.readyState === EventSource.CLOSED ? "closed" : "disconnected"),
      );
      return () => events.close();
    },
  };
}
