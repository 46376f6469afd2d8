import { number, rawFloat } from "../common/format";
import type { Raster } from "../data/raster";
import type { ChannelErrors } from "./region_metrics";
import { useChannelErrors } from "./use_counted";
import type { Pair } from "./use_front";

const text = (value: number): string => (Number.isFinite(value) ? number(value) : rawFloat(value));

const share = ({ squared, squaredB }: ChannelErrors): string =>
  squaredB > 0 ? `${number(100 * Math.sqrt(squared / squaredB))} %` : "–";

const kRows: { label: string; definition: string; of: (one: ChannelErrors) => string }[] = [
  { label: "mean |Δ|", definition: "mean of |A − B|, linear", of: (one) => text(one.absolute) },
  {
    label: "RMS Δ",
    definition: "root of the mean of (A − B)², linear",
    of: (one) => text(Math.sqrt(one.squared)),
  },
  {
    label: "of RMS B",
    definition: "root of the mean of (A − B)² over root of the mean of B², linear",
    of: share,
  },
  { label: "mean Δ", definition: "mean of A − B, linear: the bias", of: (one) => text(one.signed) },
];

interface Props {
  pair: Pair;
  layer: string;
  a: Raster | undefined;
  b: Raster | undefined;
}

/** The errors of A against B over the whole image, by channel, where no record of the run holds them. */
export function PairErrors({ pair, layer, a, b }: Props) {
  const sameSize = a && b && a.width === b.width && a.height === b.height;
  const channels = useChannelErrors(
    sameSize ? a : undefined,
    sameSize ? b : undefined,
    a ? [0, 0, a.width, a.height] : [0, 0, 0, 0],
  );
  if (!channels) return null;
  return (
    <section class="pair-errors" aria-label="Errors of A against B">
      <h3>
        {pair.a} against {pair.b}
        {layer ? `, layer ${layer}` : ""}
      </h3>
      <table>
        <thead>
          <tr>
            <th />
            {channels.map(({ name }) => (
              <th scope="col" key={name}>
                {name}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {kRows.map(({ label, definition, of }) => (
            <tr key={label} title={definition}>
              <th scope="row">{label}</th>
              {channels.map((one) => (
                <td class="number" key={one.name}>
                  {of(one)}
                </td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}
