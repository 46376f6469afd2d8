import { render } from "preact";
import "uplot/dist/uPlot.min.css";
import { App } from "./App";
import { messageOf } from "./common/message";
import { openSource } from "./data/source";
import "./style/base.css";
import "./style/overview.css";
import "./style/cards.css";
import "./style/case.css";
import "./style/accept.css";
import "./style/viewer.css";
import "./style/charts.css";
import "./style/effects.css";
import "./style/cost.css";
import "./style/cost_chart.css";
import "./style/stability.css";

const root = document.getElementById("page");
if (root)
  openSource().then(
    (source) => {
      root.replaceChildren();
      render(<App source={source} />, root);
    },
    (error: unknown) => {
      root.textContent = `The run cannot be shown: ${messageOf(error)}`;
    },
  );
