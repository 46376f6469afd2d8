import { seriesOf } from "../charts/series";
import { RendererMark } from "./Marker";
import { ratioRows, ratioScale, type RatioRow, type RatioScale } from "./ratio_bars";
import { ratioText } from "./quantities";
import type { Theme } from "./theme";
import type { CostStudy } from "../data/generated";

const percent = (share: number): string => `${(100 * share).toFixed(2)}%`;

/** The bar from 1 to the ratio, and its 95 % interval. */
function Bar({ row, scale, colour }: { row: RatioRow; scale: RatioScale; colour: string }) {
  if (!row.ratio) return <span class="track" />;
  const { value, low, high } = row.ratio;
  const [from, to] = [Math.min(1, value), Math.max(1, value)].map(scale.at) as [number, number];
  return (
    <span class="track">
      {scale.ticks.map((tick) => (
        <span
          key={tick}
          class={`tick ${tick === 1 ? "one" : ""}`}
          style={{ left: percent(scale.at(tick)) }}
        />
      ))}
      <span
        class="ratio-bar"
        style={{ left: percent(from), width: percent(to - from), background: colour }}
      />
      <span
        class="interval"
        style={{ left: percent(scale.at(low)), width: percent(scale.at(high) - scale.at(low)) }}
      />
    </span>
  );
}

/** What a ratio says, in words. */
function words({ ratio }: RatioRow, isBase: boolean, targets: number): string {
  if (isBase) return "the measure of the others";
  if (!ratio) return "does not reach this quality where the other does";
  const on = ratio.count < targets ? `, on ${ratio.count} of ${targets} targets` : "";
  const open = ratio.low <= 1 && ratio.high >= 1 ? ", no difference shown" : "";
  return `${ratioText(ratio)}${on}${open}`;
}

interface Props {
  study: CostStudy;
  theme: Theme;
  base: number;
  metric: string;
  level: number;
}

/** How many times as long as the base each renderer takes to one quality, as bars, the fastest first. */
export function RatioBars({ study, theme, base, metric, level }: Props) {
  const rows = ratioRows(study, base, metric, level);
  const scale = ratioScale(rows);
  return (
    <table class="ratio-bars">
      <tbody>
        {rows.map((row) => (
          <tr key={row.name}>
            <th scope="row">
              <RendererMark study={study} renderer={row.renderer} /> {row.name}
            </th>
            <td class="bar">
              <Bar row={row} scale={scale} colour={theme.series(seriesOf(study, row.renderer))} />
            </td>
            <td>{words(row, row.renderer === base, study.targets.length)}</td>
          </tr>
        ))}
        <tr class="axis" aria-hidden="true">
          <th />
          <td class="bar">
            <span class="track">
              {scale.ticks.map((tick) => (
                <span key={tick} class="label" style={{ left: percent(scale.at(tick)) }}>
                  × {tick}
                </span>
              ))}
            </span>
          </td>
          <td />
        </tr>
      </tbody>
    </table>
  );
}
