import type { ViewState } from "./view_state";

interface Props {
  view: ViewState;
  onView: (view: ViewState) => void;
  /** Width of the stage in CSS pixels. */
  width: number;
}

/** The divider of a swipe: it is dragged, or moved by the arrow keys. */
export function Divider({ view, onView, width }: Props) {
  const move = (swipe: number): void => onView({ ...view, swipe: Math.min(1, Math.max(0, swipe)) });
  return (
    <div
      class="divider"
      role="slider"
      tabIndex={0}
      aria-label="Divider"
      aria-valuemin={0}
      aria-valuemax={100}
      aria-valuenow={Math.round(view.swipe * 100)}
      style={{ left: `${view.swipe * 100}%` }}
      onPointerDown={(event) => {
        event.stopPropagation();
        event.currentTarget.setPointerCapture(event.pointerId);
      }}
      onPointerMove={(event) => {
        if (!event.currentTarget.hasPointerCapture(event.pointerId)) return;
        event.stopPropagation();
        const left = event.currentTarget.parentElement?.getBoundingClientRect().left ?? 0;
        move((event.clientX - left) / width);
      }}
      onKeyDown={(event) => {
        const step = event.key === "ArrowLeft" ? -0.01 : event.key === "ArrowRight" ? 0.01 : 0;
        if (!step) return;
        event.preventDefault();
        event.stopPropagation();
        move(view.swipe + step);
      }}
    />
  );
}
