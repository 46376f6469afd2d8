import { useEffect, useState } from "preact/hooks";
import { messageOf } from "../common/message";
import type { Raster } from "../data/raster";
import { differenceOf, kDifference, type Variances } from "./difference";
import type { Loaded } from "./use_rasters";
import type { Measure } from "./view_state";

// Images do not change, so that each difference is computed once.
const known = new WeakMap<Raster, WeakMap<Raster, Map<Measure, Raster>>>();

function knownOf(a: Raster, b: Raster): Map<Measure, Raster> {
  const byOther = known.get(a) ?? new WeakMap<Raster, Map<Measure, Raster>>();
  known.set(a, byOther);
  const found = byOther.get(b) ?? new Map<Measure, Raster>();
  byOther.set(b, found);
  return found;
}

/**
 * The difference of two images; undefined until both are loaded and it is computed. `variances` are those of
 * the same two images, for the measure "noise" alone.
 */
export function useDifference(
  a: Raster | undefined,
  b: Raster | undefined,
  measure: Measure,
  variances: Variances | { problem: string } | undefined,
): Loaded {
  const [failed, setFailed] = useState<{ a: Raster; b: Raster; problem: string }>();
  const [, setCount] = useState(0);
  const stated = variances && "a" in variances ? variances : undefined;
  const isMissing = measure === "noise" && !stated;
  useEffect(() => {
    if (!a || !b || isMissing || knownOf(a, b).has(measure)) return undefined;
    const abort = new AbortController();
    differenceOf(a, b, measure, stated, abort.signal).then(
      (raster) => {
        knownOf(a, b).set(measure, raster);
        if (!abort.signal.aborted) setCount((count) => count + 1);
      },
      (error: unknown) => {
        if (!abort.signal.aborted)
          setFailed({ a, b, problem: `${kDifference}: ${messageOf(error)}` });
      },
    );
    return () => abort.abort();
  }, [a, b, measure, isMissing]);
  if (!a || !b) return undefined;
  if (measure === "noise" && variances && "problem" in variances) return variances;
  if (failed?.a === a && failed.b === b) return { problem: failed.problem };
  return knownOf(a, b).get(measure);
}
