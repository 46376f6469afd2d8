import type { Raster } from "./raster";

/** The bundled decode_worker.ts as text, which build.mjs inserts: a page in one file has no other. */
declare const kDecodeWorker: string;

export interface Question {
  id: number;
  packed: ArrayBuffer | string;
}

export type Answer = { id: number; raster: Raster } | { id: number; problem: string };

interface Waiting {
  resolve: (raster: Raster) => void;
  reject: (error: Error) => void;
}

const waiting = new Map<number, Waiting>();
let count = 0;
let worker: Worker | undefined;

function settle(answer: Answer): void {
  const one = waiting.get(answer.id);
  waiting.delete(answer.id);
  if ("raster" in answer) one?.resolve(answer.raster);
  else one?.reject(new Error(answer.problem));
}

function startWorker(): Worker {
  const address = URL.createObjectURL(new Blob([kDecodeWorker], { type: "text/javascript" }));
  const started = new Worker(address);
  started.addEventListener("message", ({ data }: MessageEvent<Answer>) => settle(data));
  started.addEventListener("error", () => {
    for (const id of [...waiting.keys()])
      settle({ id, problem: "the browser does not start the worker that unpacks images" });
  });
  return started;
}

/** Unpacks an image in a worker; see decode.ts. The bytes are moved there and cannot be used again. */
export function decoded(packed: ArrayBuffer | string): Promise<Raster> {
  worker ??= startWorker();
  const id = ++count;
  const question: Question = { id, packed };
  const raster = new Promise<Raster>((resolve, reject) => waiting.set(id, { resolve, reject }));
  worker.postMessage(question, typeof packed === "string" ? [] : [packed]);
  return raster;
}
