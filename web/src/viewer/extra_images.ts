// Images of the same target by other renderers and of other runs, beside those of the target.
import { useEffect, useState } from "preact/hooks";
import { messageOf } from "../common/request";
import { findCell, namesOf, type Session } from "../common/session";
import type { ImageEntry } from "../data/types";

/** The target whose images the viewer shows. */
export interface ViewedTarget {
  case: string;
  target: string;
  renderer: string;
}

/** Names of images that can be added: "cycles", or "orbs@outputs-1" of another run. */
export function extraChoices(session: Session, { renderer, ...of }: ViewedTarget): string[] {
  const { overview, source, run } = session;
  const here = overview.cells.case.flatMap((_, cell) => {
    const names = namesOf(overview, cell);
    const isOther = names.case === of.case && names.target === of.target;
    return isOther && names.renderer !== renderer ? [names.renderer] : [];
  });
  const elsewhere = source.runs.flatMap((name, i) =>
    i !== run && source.kinds[i] === "run" ? [`${renderer}@${name}`] : [],
  );
  return [...here, ...elsewhere];
}

/** The image of that name, or why there is none. */
async function load(
  session: Session,
  of: ViewedTarget,
  name: string,
): Promise<ImageEntry | string> {
  const { source } = session;
  const at = name.indexOf("@");
  const run = at < 0 ? session.run : source.runs.indexOf(name.slice(at + 1));
  if (run < 0) return `${name}: there is no run of this name`;
  const overview = run === session.run ? session.overview : await source.overview(run);
  const renderer = at < 0 ? name : name.slice(0, at);
  const cell = findCell(overview, of.case, of.target, renderer);
  if (cell < 0) return `${name}: the run has no such target`;
  const detail = await source.target(run, cell);
  const result = detail.images.find((image) => image.kind === "result");
  return result ? { ...result, name, kind: "other", run } : `${name}: there is no image`;
}

export interface ExtraImages {
  images: ImageEntry[];
  problems: string[];
}

const kNone: ExtraImages = { images: [], problems: [] };

/** The images of these names, once their records are read. */
export function useExtraImages(session: Session, of: ViewedTarget, names: string[]): ExtraImages {
  const [found, setFound] = useState({ key: "", extra: kNone });
  const wanted = names.filter((name) => name !== of.renderer);
  const key = [session.run, of.case, of.target, ...wanted].join("\n");
  useEffect(() => {
    let isWanted = true;
    const each = wanted.map((name) =>
      load(session, of, name).catch((error: unknown) => `${name}: ${messageOf(error)}`),
    );
    void Promise.all(each).then((all) => {
      if (!isWanted) return;
      const images = all.filter((one) => typeof one !== "string");
      const problems = all.filter((one) => typeof one === "string");
      setFound({ key, extra: { images, problems } });
    });
    return () => void (isWanted = false);
  }, [key]);
  return found.key === key ? found.extra : kNone;
}
