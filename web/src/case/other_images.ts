// The images that can stand beside those of a target: of other renderers, other runs (other seeds among
// them), and the images of cost studies on the same scene.
import { useRequest } from "../common/request";
import { findCell, namesOf, type Session } from "../common/session";
import type { CostStudy } from "../data/generated";
import type { Source } from "../data/source";
import type { ImageEntry } from "../data/source";
import type { Addable } from "../viewer/extra_images";
import { sweepImages } from "../viewer/sweep_images";

interface Target {
  case: string;
  target: string;
  renderer: string;
}

interface Study {
  run: number;
  study: CostStudy;
}

const kept = new WeakMap<Source, Promise<Study[]>>();

/** The cost studies that are served beside the runs, each read once. One that cannot be read offers nothing. */
function studiesOf(source: Source): Promise<Study[]> {
  const runs = source.kinds.flatMap((kind, run) => (kind === "cost" ? [run] : []));
  const read = async (run: number): Promise<Study[]> => {
    try {
      return [{ run, study: await source.study("cost", run) }];
    } catch {
      return [];
    }
  };
  const all = kept.get(source) ?? Promise.all(runs.map(read)).then((each) => each.flat());
  kept.set(source, all);
  return all;
}

const sweepImagesOf = async (source: Source, target: string): Promise<ImageEntry[]> =>
  (await studiesOf(source)).flatMap(({ run, study }) =>
    sweepImages(study, run, target).map((image) => ({
      ...image,
      name: `${image.name}@${source.runs[run]}`,
    })),
  );

async function resultOf(session: Session, of: Target, name: string): Promise<ImageEntry> {
  const { source } = session;
  const at = name.lastIndexOf("@");
  const run = at < 0 ? session.run : source.runs.indexOf(name.slice(at + 1));
  if (run < 0) throw new Error("there is no run of this name");
  if (source.kinds[run] === "cost") {
    const image = (await sweepImagesOf(source, of.target)).find((one) => one.name === name);
    if (!image) throw new Error("the study has no such image of this scene");
    return image;
  }
  const overview = run === session.run ? session.overview : await source.overview(run);
  const cell = findCell(overview, of.case, of.target, at < 0 ? name : name.slice(0, at));
  if (cell < 0) throw new Error("the run has no such target");
  const { images } = await source.target(run, cell);
  const result = images.find((image) => image.kind === "result");
  if (!result) throw new Error("there is no image");
  return { ...result, name, kind: "other", run };
}

/** What can stand beside the images of a target: "cycles", "orbs@outputs-2", "orbs 16 spp@cost-1". */
export function useOtherImages(session: Session, of: Target): Addable {
  const { overview, source, run } = session;
  const key = [run, of.case, of.target, of.renderer].join("\n");
  const { value: swept = [] } = useRequest(key, "", () => sweepImagesOf(source, of.target));
  const here = overview.cells.case.flatMap((_, cell) => {
    const names = namesOf(overview, cell);
    const isOther = names.case === of.case && names.target === of.target;
    return isOther && names.renderer !== of.renderer ? [names.renderer] : [];
  });
  const elsewhere = source.runs.flatMap((name, i) =>
    i !== run && source.kinds[i] === "run" ? [`${of.renderer}@${name}`] : [],
  );
  return {
    key,
    own: of.renderer,
    names: [...here, ...elsewhere, ...swept.map(({ name }) => name)],
    load: (name) => resultOf(session, of, name),
  };
}
