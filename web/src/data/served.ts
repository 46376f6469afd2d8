import { unpack } from "./raster";
import type { Source } from "./source";
import type { Overview, TargetDetail, Progress } from "./types";

async function get(address: string, signal?: AbortSignal): Promise<Response> {
  const answer = await fetch(address, signal ? { signal } : {}).catch((error: unknown) => {
    if (signal?.aborted) throw error;
    throw new Error("the server does not answer"); // each browser has its own words for that
  });
  if (!answer.ok)
    throw new Error((await answer.text()).trim() || `the server answered ${answer.status}`);
  return answer;
}

const encoded = (path: string): string => path.split("/").map(encodeURIComponent).join("/");

export async function servedSource(): Promise<Source> {
  const { runs } = (await (await get("/data/runs.json")).json()) as { runs: { name: string }[] };
  const fileAddress = (run: number, file: string): string => `/data/${run}/file/${encoded(file)}`;
  return {
    runs: runs.map((run) => run.name),
    overview: async (run) => {
      const overview = (await (await get(`/data/${run}/overview.json`)).json()) as Overview;
      const expected = runs[run]?.name ?? "";
      if (overview.run.name === expected) return overview;
      throw new Error(
        `expected the run '${expected}' and found '${overview.run.name}': the server was started anew; reload the page`,
      );
    },
    target: async (run, index) =>
      (await (await get(`/data/${run}/target/${index}.json`)).json()) as TargetDetail,
    raster: async (run, file, layer, signal) => {
      const query = layer ? `?layer=${encodeURIComponent(layer)}` : "";
      const answer = await get(`/data/${run}/image/${encoded(file)}${query}`, signal);
      if (!answer.body) throw new Error("the server sent nothing");
      return unpack(answer.body);
    },
    thumbnail: async (run, _index, detail) => {
      const result = (await detail()).images.find((image) => image.kind === "result");
      return result ? fileAddress(run, result.file.replace(/[^/]*$/, "result.png")) : undefined;
    },
    fileAddress,
    follow: (run, onNews) => {
      const events = new EventSource(`/data/${run}/events`);
      events.addEventListener("progress", (event) => {
        const progress = JSON.parse((event as MessageEvent<string>).data) as Progress;
        if (!progress.live) events.close();
        onNews(progress);
      });
      events.addEventListener("error", () =>
        onNews(events.readyState === EventSource.CLOSED ? "silent" : "lost"),
      );
      return () => events.close();
    },
  };
}
