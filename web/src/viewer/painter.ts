import { floatsOf, type Raster } from "../data/raster";
import { kColourScales, scaleBytes, scaleOf } from "./colour_scales";
import { kFragmentShader, kVertexShader } from "./shader";

/** x, y, width, height. */
export type Rectangle = [number, number, number, number];

/** How one image is drawn into one pane. */
export interface Paint {
  raster: Raster;
  /** The pane, in pixels of the canvas from its top left corner. */
  pane: Rectangle;
  /** The part of the pane that is drawn. */
  clip: Rectangle;
  /** Position in the image of the top left corner of the pane. */
  origin: [number, number];
  zoom: number;
  gain: number;
  offset: number;
  curve: number;
  gamma: number;
  channels: number[];
  luminance: boolean;
  falseColour: boolean;
  diverging: boolean;
  /** NaN means that a value has no noise, and is hatched. */
  noise: boolean;
  log: boolean;
  scaleEnd: number;
  zebra: boolean;
}

const kScales = 3; // texture unit of the colour scales, after those of three channels

/** Draws images with WebGL2. The values stay as they are; only their display is changed. */
export class Painter {
  private readonly gl: WebGL2RenderingContext;
  private readonly program: WebGLProgram;
  private readonly uniforms = new Map<string, WebGLUniformLocation | null>();
  private readonly textures = new Map<Raster, Map<number, WebGLTexture>>();
  private readonly scales: WebGLTexture;

  /** Throws an Error that says what the browser lacks. */
  constructor(private readonly canvas: HTMLCanvasElement) {
    const gl = canvas.getContext("webgl2", {
      antialias: false,
      alpha: false,
      preserveDrawingBuffer: true,
    });
    if (!gl) throw new Error("this browser has no WebGL2, which the viewer needs");
    this.gl = gl;
    this.program = this.link();
    gl.useProgram(this.program);
    gl.bindVertexArray(gl.createVertexArray());
    this.scales = gl.createTexture();
    gl.activeTexture(gl.TEXTURE0 + kScales);
    gl.bindTexture(gl.TEXTURE_2D, this.scales);
    const rows = new Uint8Array(kColourScales.flatMap((scale) => [...scaleBytes(scale)]));
    const count = kColourScales.length;
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 256, count, 0, gl.RGBA, gl.UNSIGNED_BYTE, rows);
    for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
      gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
    ["first", "second", "third"].forEach((name, unit) => gl.uniform1i(this.uniform(name), unit));
    gl.uniform1i(this.uniform("scaleColours"), kScales);
  }

  private link(): WebGLProgram {
    const { gl } = this;
    const program = gl.createProgram();
    for (const [type, text] of [
      [gl.VERTEX_SHADER, kVertexShader],
      [gl.FRAGMENT_SHADER, kFragmentShader],
    ] as const) {
      const shader = gl.createShader(type);
      if (!shader) throw new Error("the graphics driver has stopped");
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
        throw new Error(
          `the viewer's shader does not compile here: ${gl.getShaderInfoLog(shader) ?? ""}`,
        );
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS))
      throw new Error("the viewer's shader does not link here");
    return program;
  }

  private uniform(name: string): WebGLUniformLocation | null {
    if (!this.uniforms.has(name))
      this.uniforms.set(name, this.gl.getUniformLocation(this.program, name));
    return this.uniforms.get(name) ?? null;
  }

  /** Largest width and height that can be drawn. */
  get mostPixels(): number {
    return this.gl.getParameter(this.gl.MAX_TEXTURE_SIZE) as number;
  }

  /** Binds one channel of an image to the texture unit that is active. */
  private bind(raster: Raster, channel: number): void {
    const { gl } = this;
    const own = this.textures.get(raster) ?? new Map<number, WebGLTexture>();
    this.textures.set(raster, own);
    const known = own.get(channel);
    if (known) return gl.bindTexture(gl.TEXTURE_2D, known);
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
      gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 2);
    const { width, height } = raster;
    const half = isHalf(raster, channel);
    gl.texStorage2D(gl.TEXTURE_2D, 1, half ? gl.R16UI : gl.R32UI, width, height);
    gl.texSubImage2D(
      gl.TEXTURE_2D,
      0,
      0,
      0,
      width,
      height,
      gl.RED_INTEGER,
      half ? gl.UNSIGNED_SHORT : gl.UNSIGNED_INT,
      half ? (raster.planes[channel] as Uint16Array) : floatBits(raster, channel),
    );
    own.set(channel, texture);
  }

  clear(surround: number): void {
    const { gl } = this;
    gl.disable(gl.SCISSOR_TEST);
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(surround, surround, surround, 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
  }

  paint(p: Paint, surround: number): void {
    const { gl } = this;
    // A single channel is bound to all three texture units, because none may be unbound.
    const channels = [0, 1, 2].map((i) => p.channels[i] ?? p.channels[0] ?? 0);
    channels.forEach((channel, unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      this.bind(p.raster, channel);
    });
    const [x, y, width, height] = p.clip.map(Math.round) as Rectangle;
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(x, this.canvas.height - y - height, Math.max(0, width), Math.max(0, height));
    const set = (name: string, value: number): void => gl.uniform1f(this.uniform(name), value);
    const setInt = (name: string, value: number): void => gl.uniform1i(this.uniform(name), value);
    gl.uniform2i(this.uniform("size"), p.raster.width, p.raster.height);
    gl.uniform2f(this.uniform("paneOrigin"), p.pane[0], p.pane[1]);
    gl.uniform2f(this.uniform("origin"), p.origin[0], p.origin[1]);
    gl.uniform3f(this.uniform("surround"), surround, surround, surround);
    set("canvasHeight", this.canvas.height);
    set("zoom", p.zoom);
    set("gain", p.gain);
    set("offset", p.offset);
    set("inverseGamma", 1 / p.gamma);
    set("scaleEnd", p.scaleEnd);
    setInt("curve", p.curve);
    gl.uniform3iv(
      this.uniform("areHalf"),
      channels.map((channel) => (isHalf(p.raster, channel) ? 1 : 0)),
    );
    setInt("isColour", p.channels.length === 3 ? 1 : 0);
    setInt("isLuminance", p.luminance ? 1 : 0);
    setInt("falseColour", p.falseColour ? 1 : 0);
    setInt("isDiverging", p.diverging ? 1 : 0);
    setInt("isNoise", p.noise ? 1 : 0);
    set("scaleRow", (kColourScales.indexOf(scaleOf(p)) + 0.5) / kColourScales.length);
    setInt("isLog", p.log ? 1 : 0);
    setInt("zebra", p.zebra ? 1 : 0);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  /** Frees the textures of all images but these. */
  keepOnly(rasters: Raster[]): void {
    for (const [raster, own] of this.textures) {
      if (rasters.includes(raster)) continue;
      for (const texture of own.values()) this.gl.deleteTexture(texture);
      this.textures.delete(raster);
    }
  }

  dispose(): void {
    this.keepOnly([]);
    this.gl.getExtension("WEBGL_lose_context")?.loseContext();
  }
}

const isHalf = (raster: Raster, channel: number): boolean =>
  raster.planes[channel] instanceof Uint16Array;

function floatBits(raster: Raster, channel: number): Uint32Array {
  const floats = floatsOf(raster, channel, 0, raster.width * raster.height);
  return new Uint32Array(floats.buffer, floats.byteOffset, floats.length);
}
