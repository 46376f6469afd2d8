import type { Source } from "../data/source";
import { routeText, type Route } from "../route";

interface NoSuchRunProps {
  source: Source;
  route: Route;
  param: string;
}

/** Message that the run named by `param` of the address does not exist, with those that do. */
export function NoSuchRun({ source, route, param }: NoSuchRunProps) {
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
