import type { Axis, Chart, ChartPoint } from "./from_run";

const hasPlace = (value: number, { log }: Axis): boolean =>
  Number.isFinite(value) && (!log || value > 0);

export const isDrawable = (chart: Chart, { x, y }: ChartPoint): boolean =>
  hasPlace(x, chart.x) && hasPlace(y, chart.y);

export const hasPoints = (chart: Chart): boolean =>
  chart.series.some(({ points }) => points.some((point) => isDrawable(chart, point)));

/** How many points the chart cannot show, and why; "" if it shows all. */
export function leftOutText(chart: Chart): string {
  const points = chart.series.flatMap((one) => one.points);
  const left = points.filter((point) => !isDrawable(chart, point));
  if (left.length === 0) return "";
  const isInfinite = ({ x, y }: ChartPoint): boolean => !Number.isFinite(x) || !Number.isFinite(y);
  const isZero = ({ x, y }: ChartPoint): boolean =>
    (chart.x.log && x === 0) || (chart.y.log && y === 0);
  const infinite = left.filter(isInfinite).length;
  const zero = left.filter((point) => !isInfinite(point) && isZero(point)).length;
  const count = (number: number, what: string): string[] =>
    number > 0 ? [`${number} ${number === 1 ? "is" : "are"} ${what}`] : [];
  const reasons = [
    ...count(zero, "0, which a logarithmic axis cannot show"),
    ...count(left.length - zero - infinite, "negative, which a logarithmic axis cannot show"),
    ...count(infinite, "infinite"),
  ];
  const verb = left.length === 1 ? "is" : "are";
  return `${left.length} of ${points.length} points ${verb} not shown: ${reasons.join("; ")}.`;
}
