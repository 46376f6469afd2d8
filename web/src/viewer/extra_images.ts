// Images that are added beside those of the viewer.
import { useEffect, useState } from "preact/hooks";
import { messageOf } from "../common/message";
import type { Source } from "../data/source";
import type { ImageEntry } from "../data/source";

/** Where the files of images are: the index of a run or study of the source. */
export interface ImageHome {
  source: Source;
  run: number;
}

/** The images that can be added. */
export interface Addable {
  /** What they are of: the names of two addables with the same key mean the same images. */
  key: string;
  names: string[];
  /** The name that the result itself has for other viewers; it is not added a second time. "" for none. */
  own: string;
  /** The image of a name, which a link may have made up; rejects with an Error that says why not. */
  load(name: string): Promise<ImageEntry>;
}

export interface ExtraImages {
  images: ImageEntry[];
  problems: string[];
}

const kNone: ExtraImages = { images: [], problems: [] };

/** The images of these names, once their records are read. */
export function useExtraImages(addable: Addable, wanted: string[]): ExtraImages {
  const [found, setFound] = useState({ key: "", extra: kNone });
  const names = wanted.filter((name) => name !== addable.own);
  const key = [addable.key, ...names].join("\n");
  useEffect(() => {
    let isWanted = true;
    const each = names.map((name) =>
      addable.load(name).catch((error: unknown) => `${name}: ${messageOf(error)}`),
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
