// Images as src/report/packed_image.h packs them (orbs-image/1).

export interface ChannelInfo {
  name: string;
  type: "half" | "float";
  exact: boolean;
}

interface Header {
  format: string;
  width: number;
  height: number;
  layer: string;
  layers: string[];
  channels: ChannelInfo[];
  attributes: Record<string, string>;
}

export interface Raster {
  width: number;
  height: number;
  layer: string;
  layers: string[];
  channels: ChannelInfo[];
  attributes: Record<string, string>;
  /** One per channel, rows from the top; halves as their 16 bits. */
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

/** The number of one pixel of one channel. */
export function valueAt(raster: Raster, channel: number, index: number): number {
  const plane = raster.planes[channel];
  if (!plane) return NaN;
  const stored = plane[index] ?? NaN;
  if (plane instanceof Float32Array) return stored;
  halves ??= halfTable();
  return halves[stored] ?? NaN;
}

/** Floats of a run of pixels of one channel: for loops over many pixels. */
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

/** Unpacks what the server or the one-file page holds. Throws an Error with the reason when it is torn. */
export async function unpack(gzipped: ReadableStream<Uint8Array<ArrayBuffer>>): Promise<Raster> {
  const stream = gzipped.pipeThrough(new DecompressionStream("gzip"));
  const bytes = await new Response(stream).arrayBuffer();
  if (bytes.byteLength < 4) throw new Error("the image is torn");
  const headerLength = new DataView(bytes).getUint32(0, true);
  const header = JSON.parse(
    new TextDecoder().decode(new Uint8Array(bytes, 4, headerLength)),
  ) as Header;
  if (header.format !== "orbs-image/1")
    throw new Error(`the image has the format '${header.format}'`);
  const count = header.width * header.height;
  let at = 4 + headerLength;
  const planes = header.channels.map((channel) => {
    const size = channel.type === "half" ? 2 : 4;
    const begin = at;
    at += size * count;
    // A plane of floats behind an odd number of halves may start between two multiples of 4.
    const aligned = begin % size === 0 ? bytes : bytes.slice(begin, at);
    const offset = begin % size === 0 ? begin : 0;
    return channel.type === "half"
      ? new Uint16Array(aligned, offset, count)
      : new Float32Array(aligned, offset, count);
  });
  const { width, height, layer, layers, channels, attributes } = header;
  return { width, height, layer, layers, channels, attributes, planes };
}
