// Images in the format of src/report/packed_image.h (orbs-image/2). Runs in the worker.
import type { ChannelInfo, Raster } from "./raster";

interface Header {
  format: string;
  width: number;
  height: number;
  separated: boolean;
  layer: string;
  layers: string[];
  channels: ChannelInfo[];
  attributes: Record<string, string>;
}

function bytesOfBase64(text: string): Uint8Array<ArrayBuffer> {
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < characters.length; ++i) bytes[i] = characters.charCodeAt(i);
  return bytes;
}

/** Undoes `separated` of src/report/packed_image.cpp; all machines with a browser are little-endian. */
function joined(bytes: Uint8Array, size: number): ArrayBuffer {
  const out = new Uint8Array(bytes.length);
  let byte = 0;
  let from = 0;
  for (let place = size - 1; place >= 0; --place)
    for (let at = place; at < out.length; at += size) {
      byte = (byte + bytes[from++]!) & 255;
      out[at] = byte;
    }
  return out.buffer;
}

/**
 * Unpacks an image: the bytes of a server, or base64 of a page in one file. Throws an Error with a
 * message if it is truncated or of another format.
 */
export async function unpack(packed: ArrayBuffer | string): Promise<Raster> {
  const gzipped = typeof packed === "string" ? bytesOfBase64(packed) : packed;
  const stream = new Blob([gzipped]).stream().pipeThrough(new DecompressionStream("gzip"));
  const bytes = await new Response(stream).arrayBuffer();
  if (bytes.byteLength < 4) throw new Error("the image is truncated");
  const headerLength = new DataView(bytes).getUint32(0, true);
  const header = JSON.parse(
    new TextDecoder().decode(new Uint8Array(bytes, 4, headerLength)),
  ) as Header;
  if (header.format !== "orbs-image/2")
    throw new Error(`expected an image in the format 'orbs-image/2' and found '${header.format}'`);
  const count = header.width * header.height;
  let at = 4 + headerLength;
  const planes = header.channels.map((channel) => {
    const size = channel.type === "half" ? 2 : 4;
    const begin = at;
    at += size * count;
    // Typed arrays must start at a multiple of their element size; a plane may not.
    const [values, offset] = header.separated
      ? [joined(new Uint8Array(bytes, begin, size * count), size), 0]
      : begin % size === 0
        ? [bytes, begin]
        : [bytes.slice(begin, at), 0];
    return channel.type === "half"
      ? new Uint16Array(values, offset, count)
      : new Float32Array(values, offset, count);
  });
  const { width, height, layer, layers, channels, attributes } = header;
  return { width, height, layer, layers, channels, attributes, planes };
}
