// The worker that unpacks images, so that the page answers meanwhile: an image of 4096 x 4096 pixels
// takes a second.
import { messageOf } from "../common/message";
import { unpack } from "./decode";
import type { Answer, Question } from "./decoder";

addEventListener("message", ({ data: { id, packed } }: MessageEvent<Question>) => {
  const answer = (message: Answer, transfer: Transferable[]): void =>
    postMessage(message, { transfer });
  unpack(packed).then(
    (raster) => answer({ id, raster }, [...new Set(raster.planes.map((plane) => plane.buffer))]),
    (error: unknown) => answer({ id, problem: messageOf(error) }, []),
  );
});
