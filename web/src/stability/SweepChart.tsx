import { Marker } from "../cost/Marker";
import { scaleOf, tickText, type Scale } from "../cost/scale";
import { useTheme, type Theme } from "../cost/theme";
import type { StabilityRelationRecord, StabilityStep, StabilityStudy } from "../data/generated";
import { excessOf, magnitudeText, stepText } from "./texts";

const kWidth = 560;
const kHeight = 240;
const kBox = { left: 54, right: kWidth - 10, top: 12, bottom: kHeight - 40 };
const kLeast = 1e-4; // of what is allowed: below it, and where the images are equal, lies the floor

interface Line {
  scene: string;
  steps: StabilityStep[];
}

function linesOf(study: StabilityStudy, steps: StabilityStep[]): Line[] {
  return study.scenes
    .map(({ name }, scene) => ({
      scene: name,
      steps: steps.filter((step) => step.scene === scene && step.outcome !== "not applicable"),
    }))
    .filter((line) => line.steps.length > 0);
}

interface Scales {
  x: Scale;
  y: Scale;
}

function Axes({ scales, unit, theme }: { scales: Scales; unit: string; theme: Theme }) {
  const { left, right, top, bottom } = kBox;
  return (
    <g font-size={11} fill={theme.quiet} stroke-width={1}>
      {scales.x.ticks.map((tick) => (
        <g key={tick}>
          <line
            x1={scales.x.at(tick)}
            x2={scales.x.at(tick)}
            y1={top}
            y2={bottom}
            stroke={theme.line}
          />
          <text x={scales.x.at(tick)} y={bottom + 16} text-anchor="middle">
            {tickText(tick, 0.1)}
          </text>
        </g>
      ))}
      {scales.y.ticks.map((tick) => (
        <g key={tick}>
          <line
            x1={left}
            x2={right}
            y1={scales.y.at(tick)}
            y2={scales.y.at(tick)}
            stroke={theme.line}
          />
          <text x={left - 5} y={scales.y.at(tick) + 4} text-anchor="end">
            {tickText(tick, 0.01)}
          </text>
        </g>
      ))}
      <line
        x1={left}
        x2={right}
        y1={scales.y.at(1)}
        y2={scales.y.at(1)}
        stroke={theme.text}
        stroke-dasharray="5 4"
      />
      <text x={(left + right) / 2} y={kHeight - 6} text-anchor="middle" font-size={12}>
        magnitude{unit ? ` (${unit})` : ""}
      </text>
    </g>
  );
}

interface SweepProps {
  line: Line;
  index: number;
  scales: Scales;
  excess: (step: StabilityStep) => number;
}

function Sweep({ line, index, scales, excess }: SweepProps) {
  const theme = useTheme();
  const colour = theme.series(index);
  const placed = line.steps.map((step) => ({
    step,
    x: scales.x.at(step.magnitude),
    y:
      step.outcome === "no image"
        ? kBox.top
        : scales.y.at(Math.min(Math.max(excess(step), kLeast), scales.y.max)),
  }));
  return (
    <g>
      <polyline
        points={placed.map(({ x, y }) => `${x},${y}`).join(" ")}
        fill="none"
        stroke={colour}
        stroke-width={1.5}
      />
      {placed.map(({ step, x, y }) => (
        <g key={step.magnitude}>
          <title>
            {`${line.scene}, ${magnitudeText(step.magnitude, "")}: ${stepText(step)}`}
            {step.outcome === "no image" ? "" : `, ${tickText(excess(step), 0.001)} of the bound`}
          </title>
          <Marker
            shape={index}
            x={x}
            y={y}
            size={4.5}
            colour={colour}
            hollow={step.outcome === "inconclusive" ? theme.panel : undefined}
          />
          {step.outcome === "no image" ? (
            <text x={x - 8} y={y + 4} font-size={11} fill={theme.text} text-anchor="end">
              no image
            </text>
          ) : null}
        </g>
      ))}
    </g>
  );
}

interface Props {
  study: StabilityStudy;
  relation: StabilityRelationRecord;
  steps: StabilityStep[];
}

/** Error against magnitude, as a multiple of what is allowed; one line for each scene. */
export function SweepChart({ study, relation, steps }: Props) {
  const theme = useTheme();
  const lines = linesOf(study, steps);
  const magnitudes = lines.flatMap((line) => line.steps.map((step) => step.magnitude));
  if (new Set(magnitudes).size < 2) return null;
  const excess = (step: StabilityStep): number => excessOf(step, study.settings);
  const most = Math.max(10, ...steps.map(excess).filter(Number.isFinite));
  const scales = {
    x: scaleOf([Math.min(...magnitudes) / 1.5, Math.max(...magnitudes) * 1.5], true, [
      kBox.left,
      kBox.right,
    ]),
    y: scaleOf([kLeast, most * 2], true, [kBox.bottom, kBox.top]),
  };
  return (
    <figure class="sweep-chart">
      <figcaption>
        Error over what is allowed, against the magnitude. Above the dashed line the relation breaks
        if noise is ruled out; on the lowest line the images are equal or nearly so.
      </figcaption>
      <svg
        viewBox={`0 0 ${kWidth} ${kHeight}`}
        role="img"
        aria-label="Error over what is allowed, against the magnitude; the table below has the numbers"
        font-family="system-ui, sans-serif"
      >
        <Axes scales={scales} unit={relation.unit} theme={theme} />
        {lines.map((line, i) => (
          <Sweep key={line.scene} line={line} index={i} scales={scales} excess={excess} />
        ))}
      </svg>
      <ul class="renderer-key">
        {lines.map((line, i) => (
          <li key={line.scene}>
            <svg width={16} height={16} viewBox="0 0 16 16" aria-hidden="true">
              <Marker shape={i} x={8} y={8} size={5} colour={theme.series(i)} />
            </svg>
            {line.scene}
          </li>
        ))}
      </ul>
    </figure>
  );
}
