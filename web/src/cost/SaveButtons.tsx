import { saveCsv, savePng, saveSvg } from "./save";

interface Props {
  /** What is saved, for the names of the files. */
  name: string;
  /** The drawing; undefined while there is none. */
  sheet?: () => SVGSVGElement | undefined;
  rows: () => (string | number | boolean | null)[][];
}

/** Buttons that save a chart or a table. */
export function SaveButtons({ name, sheet, rows }: Props) {
  const withSheet = (save: (name: string, sheet: SVGSVGElement) => void): void => {
    const drawn = sheet?.();
    if (drawn) save(name, drawn);
  };
  return (
    <span class="save" role="group" aria-label={`Save: ${name}`}>
      <span class="label">Save</span>
      {sheet ? (
        <>
          <button onClick={() => withSheet(saveSvg)}>SVG</button>
          <button onClick={() => withSheet((file, drawn) => void savePng(file, drawn))}>PNG</button>
        </>
      ) : null}
      <button onClick={() => saveCsv(name, rows())}>CSV</button>
    </span>
  );
}
