import type { Source } from "../data/source";
import { routeText, type Route } from "../route";

/** Says that the run which the address names in `param` is not here, and which are. */
export function NoSuchRun({
  source,
  route,
  param,
}: {
  source: Source;
  route: Route;
  param: string;
}) {
  return (
    <div role="alert">
      There is no run '{route.query[param]}' here.{" "}
      {source.runs.length > 1 ? "There are:" : "There is:"}
      <ul>
        {source.runs.map((name) => (
          <li key={name}>
            <a href={routeText({ path: route.path, query: { ...route.query, [param]: name } })}>
              {name}
            </a>
          </li>
        ))}
      </ul>
    </div>
  );
}
