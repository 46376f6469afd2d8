export interface ChannelInfo {
  name: string;
  type: "half" | "float";
  exact: boolean;
}

export interface Raster {
  width: number;
  height: number;
  layer: string;
  layers: string[];
  channels: ChannelInfo[];
  attributes: Record<string, string>;
  /** One plane per channel, rows from top to bottom; half floats as their 16 bits. */
  planes: (Uint16Array | Float32Array)[];
}

function halfTable(): Float32Array {
  const table = new Float32Array(65536);
  for (let bits = 0; bits < 65536; ++bits) {
    const sign = bits & 0x8000 ? -1 : 1;
    const exponent = (bits >> 10) & 31;
    const mantissa = bits & 1023;
    if (exponent === 31) table[bits] = mantissa ? NaN : sign * Infinity;
    else if (exponent === 0) table[bits] = sign * mantissa * 2 ** -24;
    else table[bits] = sign * (1024 + mantissa) * 2 ** (exponent - 25);
  }
  return table;
}

let halves: Float32Array | undefined;

/** The value of one channel of one pixel. */
export function valueAt(raster: Raster, channel: number, index: number): number {
  const plane = raster.planes[channel];
  if (!plane) return NaN;
  const stored = plane[index] ?? NaN;
  if (plane instanceof Float32Array) return stored;
  halves ??= halfTable();
  return halves[stored] ?? NaN;
}

/** The values of one channel of the pixels [begin, end): faster than `valueAt` in loops. */
export function floatsOf(
  raster: Raster,
  channel: number,
  begin: number,
  end: number,
): Float32Array {
  const plane = raster.planes[channel];
  if (!plane) return new Float32Array(0);
  if (plane instanceof Float32Array) return plane.subarray(begin, end);
  halves ??= halfTable();
  const out = new Float32Array(end - begin);
  for (let i = begin; i < end; ++i) out[i - begin] = halves[plane[i] ?? 0] ?? NaN;
  return out;
}
