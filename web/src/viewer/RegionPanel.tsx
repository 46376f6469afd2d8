import { number, rawFloat } from "../common/format";
import type { Raster } from "../data/raster";
import type { ImageEntry } from "../data/source";
import { StatisticsTable } from "./Histogram";
import { meanErrors, type Errors } from "./region_metrics";
import { isWithin, type Region } from "./statistics";
import { useChannelErrors, useStatistics } from "./use_counted";
import type { Pair } from "./use_front";
import { isRaster, type Loaded } from "./use_rasters";

// A NaN in the region makes its means NaN, which must not look like a missing value.
const text = (value: number): string => (Number.isFinite(value) ? number(value) : rawFloat(value));

function MapMean({ image, raster, region }: { image: ImageEntry; raster: Raster; region: Region }) {
  const statistics = useStatistics(raster, region);
  const means = statistics?.channels.map((one) => one.mean) ?? [];
  const mean = means.reduce((sum, one) => sum + one, 0) / means.length;
  return (
    <tr title={image.definition}>
      <th scope="row">mean of {image.name}</th>
      <td class="number">{number(mean)}</td>
    </tr>
  );
}

/** Mean differences of A and B. */
function DifferenceRows({ metrics }: { metrics: Errors }) {
  return (
    <>
      <tr title="mean of |A − B| over R, G, B, linear">
        <th scope="row">mean |Δ|</th>
        <td class="number">{text(metrics.absolute)}</td>
      </tr>
      <tr title="mean of (A − B)² over R, G, B, linear">
        <th scope="row">mean Δ²</th>
        <td class="number">{text(metrics.squared)}</td>
      </tr>
      <tr title="mean of A − B over R, G, B, linear: the bias">
        <th scope="row">mean Δ</th>
        <td class="number">{text(metrics.signed)}</td>
      </tr>
    </>
  );
}

interface RegionPanelProps {
  region: Region;
  images: ImageEntry[];
  rasters: Map<string, Loaded>;
  pair: Pair;
  onClear: () => void;
}

/** Statistics and metrics of the selected region. */
export function RegionPanel({ region, images, rasters, pair, onClear }: RegionPanelProps) {
  const loaded = (name: string): Raster | undefined => {
    const raster = rasters.get(name);
    return isRaster(raster) ? raster : undefined;
  };
  const result = loaded(pair.a);
  const reference = loaded(pair.b);
  const fitting = (raster: Raster | undefined): Raster | undefined =>
    raster && isWithin(region, raster) ? raster : undefined;
  const statistics = useStatistics(fitting(result), region);
  const errors = useChannelErrors(fitting(result), fitting(reference), region);
  const image = result ?? reference;
  const [x0, y0, x1, y1] = region;
  return (
    <section class="region" aria-label="Region">
      <h3>
        Region {x0}, {y0} – {x1}, {y1}{" "}
        <span class="quiet">
          {x1 - x0} × {y1 - y0}
        </span>{" "}
        <button onClick={onClear}>Clear</button>
      </h3>
      {image && !fitting(image) ? (
        <p role="alert">
          The region does not lie within the image, which has {image.width} × {image.height} pixels.
        </p>
      ) : null}
      <table>
        <tbody>
          {errors ? <DifferenceRows metrics={meanErrors(errors)} /> : null}
          {images.map((image) => {
            const raster = rasters.get(image.name);
            return image.kind === "map" && isRaster(raster) && fitting(raster) ? (
              <MapMean key={image.name} image={image} raster={raster} region={region} />
            ) : null;
          })}
        </tbody>
      </table>
      {statistics ? (
        <>
          <h4>{pair.a} in the region</h4>
          <StatisticsTable statistics={statistics} />
        </>
      ) : null}
    </section>
  );
}
