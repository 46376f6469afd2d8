/** Offers `content` as a file to save. */
export function offer(name: string, content: Blob): void {
  const address = URL.createObjectURL(content);
  const link = document.createElement("a");
  link.href = address;
  link.download = name;
  link.click();
  // The browser has taken the content when the click returns, but Safari only some time later.
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
