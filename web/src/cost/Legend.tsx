import { seriesOf } from "../charts/series";
import type { ComponentChildren } from "preact";
import type { CostStudy } from "../data/generated";
import { Marker } from "./Marker";
import type { Theme } from "./theme";

export interface LegendItem {
  text: string;
  sign: (x: number, y: number) => ComponentChildren;
}

const kSign_px = 26;
const kLetter_px = 6.6; // of the 12 px font, on average
const kGap_px = 16;
export const kLegendRow_px = 18;

/** Items with their positions, in as many rows as they need. */
export function legendRows(items: LegendItem[], width: number) {
  let [x, row] = [0, 0];
  const placed = items.map((item) => {
    const own = kSign_px + item.text.length * kLetter_px;
    if (x > 0 && x + own > width) [x, row] = [0, row + 1];
    const place = { item, x, row };
    x += own + kGap_px;
    return place;
  });
  return { placed, rows: items.length > 0 ? row + 1 : 0 };
}

interface LegendProps {
  items: LegendItem[];
  x: number;
  y: number;
  width: number;
  theme: Theme;
}

/** A legend within the drawing, so that a saved chart has it. */
export function Legend({ items, x, y, width, theme }: LegendProps) {
  return (
    <g font-size={12} fill={theme.text}>
      {legendRows(items, width).placed.map(({ item, x: dx, row }) => {
        const [left, middle] = [x + dx, y + (row + 0.5) * kLegendRow_px];
        return (
          <g key={item.text}>
            {item.sign(left, middle)}
            <text x={left + kSign_px} y={middle + 4}>
              {item.text}
            </text>
          </g>
        );
      })}
    </g>
  );
}

export const rendererItems = (study: CostStudy, theme: Theme): LegendItem[] =>
  study.renderers.map(({ name, biased }, i) => ({
    text: biased ? `${name} (biased: ${biased})` : name,
    sign: (x, y) => (
      <>
        <line
          x1={x}
          y1={y}
          x2={x + 20}
          y2={y}
          stroke={theme.series(seriesOf(study, i))}
          stroke-width={1.5}
        />
        <Marker
          shape={seriesOf(study, i)}
          x={x + 10}
          y={y}
          size={4.5}
          colour={theme.series(seriesOf(study, i))}
        />
      </>
    ),
  }));

export const lineItem = (
  text: string,
  attributes: Record<string, string | number>,
): LegendItem => ({
  text,
  sign: (x, y) => <line x1={x} y1={y} x2={x + 20} y2={y} {...attributes} />,
});
