import type { Session } from "../common/session";
import type { Route } from "../route";
export function ChartsPage(_: { session: Session; route: Route }) { return <p>Charts</p>; }
