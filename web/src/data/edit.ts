// What a page that `orbs serve --edit` serves may write.
import type { FileChange } from "./generated";

export interface KnownFailure {
  run: number;
  target: string;
  renderer: string;
  reason: string;
  /** The last day on which it counts, "2027-06-30", or "". */
  until: string;
  /** Of the file whose difference was seen; without it the server only shows the difference. */
  hash?: string;
}

/** Rejects with an Error that says why nothing can be written. */
export type Edit = (failure: KnownFailure) => Promise<FileChange>;

/** "locked": this tab was not opened by the address with the token. */
export type Editing = Edit | "locked" | "off";

const kStored = "orbs-edit";

/**
 * The token of this tab, "" without one. It is taken out of the address, whose copies would hand it on, and
 * stays in the tab when the page is loaded again.
 */
function takeToken(): string {
  const token = /^#edit=([0-9a-f]+)$/.exec(location.hash)?.[1];
  if (token) history.replaceState(null, "", "#/");
  try {
    if (token) sessionStorage.setItem(kStored, token);
    return token ?? sessionStorage.getItem(kStored) ?? "";
  } catch {
    return token ?? ""; // the browser keeps nothing for pages: good until it is loaded again
  }
}

async function send(token: string, failure: KnownFailure): Promise<FileChange> {
  const response = await fetch("/edit/known-failure", {
    method: "POST",
    headers: { "Content-Type": "application/json", "Orbs-Token": token },
    body: JSON.stringify(failure),
  }).catch(() => {
    throw new Error("the server does not answer");
  });
  if (!response.ok)
    throw new Error((await response.text()).trim() || `the server answered ${response.status}`);
  return (await response.json()) as FileChange;
}

/** `isAllowed`: whether the server writes at all. */
export function editing(isAllowed: boolean): Editing {
  const token = takeToken();
  // The address may be pasted into a tab that shows the page already.
  addEventListener("hashchange", () => {
    if (location.hash.startsWith("#edit=") && takeToken()) location.reload();
  });
  if (!isAllowed) return "off";
  return token ? (failure) => send(token, failure) : "locked";
}
