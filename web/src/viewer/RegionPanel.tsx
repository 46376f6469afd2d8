import { number } from "../common/format";
import { floatsOf, type Raster } from "../data/raster";
import type { ImageEntry } from "../data/types";
import { StatisticsTable } from "./Histogram";
import type { Region } from "./statistics";
import { useStatistics } from "./use_counted";
import { isRaster, type Loaded } from "./use_rasters";

/** Numbers of the difference of two pictures in a region, in the linear values of the pictures. */
export function regionMetrics(result: Raster, reference: Raster, [x0, y0, x1, y1]: Region) {
  let absolute = 0;
  let squared = 0;
  let signed = 0;
  let count = 0;
  const channels = Math.min(3, result.planes.length, reference.planes.length);
  for (let c = 0; c < channels; ++c)
    for (let y = y0; y < y1; ++y) {
      const a = floatsOf(result, c, y * result.width + x0, y * result.width + x1);
      const b = floatsOf(reference, c, y * reference.width + x0, y * reference.width + x1);
      for (let i = 0; i < a.length; ++i) {
        const error = (a[i] ?? NaN) - (b[i] ?? NaN);
        absolute += Math.abs(error);
        squared += error * error;
        signed += error;
        ++count;
      }
    }
  return { absolute: absolute / count, squared: squared / count, signed: signed / count };
}

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

/** Statistics and metrics of the region that was drawn. */
export function RegionPanel({ region, images, rasters, onClear }: {
  region: Region;
  images: ImageEntry[];
  rasters: Map<string, Loaded>;
  onClear: () => void;
}) {
  const loaded = (kind: string): Raster | undefined => {
    const image = images.find((one) => one.kind === kind);
    const raster = image && rasters.get(image.name);
    return isRaster(raster) ? raster : undefined;
  };
  const result = loaded("result");
  const reference = loaded("reference");
  const fits = (raster: Raster | undefined): raster is Raster =>
    raster !== undefined && region[2] <= raster.width && region[3] <= raster.height;
  const statistics = useStatistics(fits(result) ? result : undefined, region);
  const metrics = fits(result) && fits(reference) ? regionMetrics(result, reference, region) : undefined;
  const [x0, y0, x1, y1] = region;
  return (
    <section class="region" aria-label="Region">
      <h3>
        Region {x0}, {y0} – {x1}, {y1} <span class="quiet">{x1 - x0} × {y1 - y0}</span>{" "}
        <button onClick={onClear}>Clear</button>
      </h3>
      <table>
        <tbody>
          {metrics ? (
            <>
              <tr title="mean of |result − reference| over R, G, B, linear"><th scope="row">mean |Δ|</th><td class="number">{number(metrics.absolute)}</td></tr>
              <tr title="mean of (result − reference)² over R, G, B, linear"><th scope="row">mean Δ²</th><td class="number">{number(metrics.squared)}</td></tr>
              <tr title="mean of result − reference over R, G, B, linear: the bias"><th scope="row">mean Δ</th><td class="number">{number(metrics.signed)}</td></tr>
            </>
          ) : null}
          {images.map((image) => {
            const raster = rasters.get(image.name);
            return image.kind === "map" && isRaster(raster) && fits(raster) ? (
              <MapMean key={image.name} image={image} raster={raster} region={region} />
            ) : null;
          })}
        </tbody>
      </table>
      {statistics ? <><h4>result in the region</h4><StatisticsTable statistics={statistics} /></> : null}
    </section>
  );
}
