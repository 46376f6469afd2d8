import { useEffect, useRef } from "preact/hooks";
import { number } from "../common/format";
import type { Statistics } from "./statistics";

const kColours = ["#e5484d", "#30a46c", "#4a8df0", "#9a9a9a"];

/** Counts on a square-root axis, so that rare values are seen; values on an axis that is logarithmic for both signs. */
export function HistogramPlot({ statistics }: { statistics: Statistics }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const { edges, counts } = statistics.histogram;
  useEffect(() => {
    const element = canvas.current;
    const pen = element?.getContext("2d");
    if (!element || !pen) return;
    const { width, height } = element;
    pen.clearRect(0, 0, width, height);
    const most = Math.max(1, ...counts.flat());
    pen.globalCompositeOperation = "source-over";
    counts.slice(0, 4).forEach((bins, c) => {
      pen.fillStyle = counts.length === 1 ? "#9a9a9a" : (kColours[c] ?? "#9a9a9a");
      pen.globalAlpha = counts.length === 1 ? 0.9 : 0.5;
      bins.forEach((count, i) => {
        const h = Math.sqrt(count / most) * height;
        pen.fillRect((i * width) / bins.length, height - h, width / bins.length, h);
      });
    });
  }, [statistics]);
  const first = edges[0] ?? 0;
  const last = edges[edges.length - 1] ?? 0;
  return (
    <figure class="histogram">
      <canvas
        ref={canvas}
        width={320}
        height={90}
        role="img"
        aria-label={`Histogram from ${number(first)} to ${number(last)}`}
      />
      <figcaption>
        <span>{number(first)}</span>
        <span class="quiet">symmetric log</span>
        <span>{number(last)}</span>
      </figcaption>
    </figure>
  );
}

export function StatisticsTable({ statistics }: { statistics: Statistics }) {
  const { channels } = statistics;
  const row = (label: string, value: (i: number) => string, always = true) =>
    always || channels.some((_, i) => value(i) !== "0") ? (
      <tr key={label}>
        <th scope="row">{label}</th>
        {channels.map((one, i) => (
          <td key={one.name} class="number">
            {value(i)}
          </td>
        ))}
      </tr>
    ) : null;
  return (
    <table class="statistics">
      <thead>
        <tr>
          <th />
          <>
            {channels.map((one) => (
              <th scope="col" key={one.name} class="number">
                {one.name}
              </th>
            ))}
          </>
        </tr>
      </thead>
      <tbody>
        {row("min", (i) => number(channels[i]?.min))}
        {row("mean", (i) => number(channels[i]?.mean))}
        {row("max", (i) => number(channels[i]?.max))}
        {row("NaN", (i) => String(channels[i]?.nan), false)}
        {row("Inf", (i) => String(channels[i]?.infinite), false)}
        {row("above 1", (i) => String(channels[i]?.aboveOne), false)}
        {row("below 0", (i) => String(channels[i]?.belowZero), false)}
      </tbody>
    </table>
  );
}
