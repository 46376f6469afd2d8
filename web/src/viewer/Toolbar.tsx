import { number } from "../common/format";
import { AppearanceTools, RarerTools } from "./AppearanceTools";
import { toWorst, zoomTo } from "./controls";
import { ImageTabs } from "./ImageTabs";
import { PairTools } from "./PairTools";
import { ActionButton, type ToolsProps } from "./tools";
import type { ViewState } from "./view_state";
import type { Worst } from "./worst";

function ArrangementTools({ controls: c, actions }: ToolsProps) {
  const { view } = c;
  const set = (change: Partial<ViewState>): void => c.setView({ ...view, ...change });
  return (
    <span class="group" role="group" aria-label="Arrangement">
      <button
        aria-pressed={view.mode === "flip"}
        onClick={() => set({ mode: "flip" })}
        title="one image at a time (m)"
      >
        Flip
      </button>
      <ActionButton actions={actions} action="s" text="Swipe" pressed={view.mode === "swipe"} />
      <button
        aria-pressed={view.mode === "side"}
        onClick={() => set({ mode: "side" })}
        title="the ticked images side by side (m)"
      >
        Side by side
      </button>
      <ActionButton actions={actions} action=" " text="Blink" pressed={c.blinking} />
    </span>
  );
}

function ZoomTools({ controls: c, actions }: ToolsProps) {
  return (
    <span class="group" role="group" aria-label="Zoom">
      <ActionButton actions={actions} action="f" text="Fit" pressed={c.view.zoom === 0} />
      <button
        aria-pressed={c.view.zoom === 1}
        onClick={() => zoomTo(c, 1)}
        title="one screen pixel per pixel (0)"
      >
        1:1
      </button>
      <ActionButton actions={actions} action="-" text="−" />
      <ActionButton actions={actions} action="+" text="+" />
      <ActionButton actions={actions} action="Shift+F" text="Full" pressed={c.full} />
    </span>
  );
}

/** The rank and the error of the worst pixel of a spot. */
function worstText({ pixels }: Worst, index: number, error: number): string {
  const spots = pixels.length === 1 ? "spot" : "spots";
  return `${index + 1} of ${pixels.length} ${spots}: ${number(error, error === Infinity)}`;
}

function ErrorTools({ controls: c, actions }: ToolsProps) {
  const worst = c.worst?.pixels[c.worstIndex];
  const { differing } = c;
  const counted =
    differing === undefined
      ? ""
      : `${differing} ${differing === 1 ? "pixel differs" : "pixels differ"}`;
  return (
    <span class="group" role="group" aria-label="Errors">
      <ActionButton actions={actions} action="y" text="◂" />
      <button
        onClick={() => toWorst(c, 1)}
        title="next worst pixel (u)"
        disabled={!c.worst?.pixels.length}
      >
        {c.worst && worst ? worstText(c.worst, c.worstIndex, worst.error) : "Worst pixel"}
      </button>
      <ActionButton actions={actions} action="u" text="▸" />
      <ActionButton actions={actions} action="a" text="Region" pressed={c.selecting} />
      <span
        class="quiet worst-count"
        role="status"
        title="pixels of A and B that differ in their first 11 significant bits"
      >
        {counted}
      </span>
    </span>
  );
}

/** A button for every key of the viewer. */
export function Toolbar({ controls, actions }: ToolsProps) {
  return (
    <div class="toolbar">
      <div class="images">
        <ImageTabs controls={controls} />
        <ErrorTools controls={controls} actions={actions} />
      </div>
      <div class="tools">
        <ArrangementTools controls={controls} actions={actions} />
        <PairTools controls={controls} actions={actions} />
        <ZoomTools controls={controls} actions={actions} />
        <AppearanceTools controls={controls} />
        <details class="rarer">
          <summary>More</summary>
          <RarerTools controls={controls} actions={actions} />
        </details>
      </div>
    </div>
  );
}
