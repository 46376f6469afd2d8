import { show, type Controls } from "./controls";

/** A button and a checkbox for each image. */
export function ImageTabs({ controls: c }: { controls: Controls }) {
  const tick = (name: string): void => {
    const ticked = c.ticked.includes(name)
      ? c.ticked.filter((one) => one !== name)
      : [...c.ticked, name];
    c.setView({ ...c.view, ticked });
  };
  return (
    <div class="tabs" role="group" aria-label="Image">
      {c.images.map((image, i) => (
        <span class="tab" key={image.name}>
          <button
            aria-pressed={c.front?.name === image.name}
            title={`${image.definition ?? image.name} (${i + 1})`}
            onClick={() => {
              c.setBlinking(false);
              show(c, image.name);
            }}
          >
            {i < 9 ? <kbd>{i + 1}</kbd> : null} {image.name}
          </button>
          <input
            type="checkbox"
            checked={c.ticked.includes(image.name)}
            onChange={() => tick(image.name)}
            aria-label={`${image.name} in blink and side by side`}
            title="in blink and side by side"
          />
        </span>
      ))}
    </div>
  );
}
