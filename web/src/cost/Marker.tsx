import { seriesOf } from "../charts/series";
import type { CostStudy } from "../data/generated";
import { useTheme } from "./theme";

interface MarkerProps {
  /** Index of the renderer: the shape tells renderers apart without colour. */
  shape: number;
  x: number;
  y: number;
  size: number;
  colour: string;
  /** Colour of the inside of a hollow marker. */
  hollow?: string | undefined;
}

/** Corners of each shape around 0; the first shape is a disc. */
const kShapes: ([number, number][] | undefined)[] = [
  undefined,
  [
    [-0.9, -0.9],
    [0.9, -0.9],
    [0.9, 0.9],
    [-0.9, 0.9],
  ],
  [
    [0, -1.15],
    [1.1, 0.85],
    [-1.1, 0.85],
  ],
  [
    [0, -1.25],
    [1.25, 0],
    [0, 1.25],
    [-1.25, 0],
  ],
  [
    [0, 1.15],
    [1.1, -0.85],
    [-1.1, -0.85],
  ],
];

/** The shape as a letter of a text. */
export const markerLetter = (shape: number): string => "●■▲◆▼"[shape % kShapes.length] ?? "●";

export function Marker({ shape, x, y, size, colour, hollow }: MarkerProps) {
  const corners = kShapes[shape % kShapes.length];
  const paint = { fill: hollow ?? colour, stroke: colour, "stroke-width": hollow ? 1.8 : 1 };
  if (!corners) return <circle cx={x} cy={y} r={size} {...paint} />;
  const points = corners.map(([dx, dy]) => `${x + dx * size},${y + dy * size}`).join(" ");
  return <polygon points={points} {...paint} />;
}

/** The marker of a renderer of the study, as a sign beside its name. */
export function RendererMark({ study, renderer }: { study: CostStudy; renderer: number }) {
  const theme = useTheme();
  const series = seriesOf(study, renderer);
  return (
    <svg width={16} height={16} viewBox="0 0 16 16" aria-hidden="true">
      <Marker shape={series} x={8} y={8} size={5} colour={theme.series(series)} />
    </svg>
  );
}
