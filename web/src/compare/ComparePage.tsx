import type { Session } from "../common/session";
import type { Route } from "../route";
export function ComparePage(_: { session: Session; route: Route }) { return <p>Compare</p>; }
