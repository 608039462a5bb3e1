// Folds the contents away on small screens, and tells values of curves where one points
// at them; figures of one scene point at the same time.
(() => {
  "use strict";
  const contents = document.querySelector("nav details");
  const small = matchMedia("(max-width: 64rem)");
  const fold = () => { contents.open = !small.matches; };
  small.addEventListener("change", fold);
  contents.addEventListener("click", (event) => {
    if (event.target.closest("a")) fold();
  });
  fold();

  // Printed, a page is light.
  const root = document.documentElement.classList;
  addEventListener("beforeprint", () => root.add("printing"));
  addEventListener("afterprint", () => root.remove("printing"));

  // What scrolls sideways is scrolled by keys too.
  const scrolling = new ResizeObserver((entries) => {
    for (const { target } of entries) {
      if (target.scrollWidth > target.clientWidth) target.tabIndex = 0;
      else target.removeAttribute("tabindex");
    }
  });
  function watchScrolling() {
    scrolling.disconnect();
    for (const region of document.querySelectorAll(".scroll")) scrolling.observe(region);
  }
  watchScrolling();

  const svg = "http://www.w3.org/2000/svg";
  const values = Object.assign(document.createElement("div"), { id: "values", hidden: true });
  document.body.append(values);

  // Ends on the plot and of the axis, and whether the axis is of logarithms.
  function axes(panel) {
    const n = panel.dataset.axes.split(" ").map(Number);
    const axis = (k) => ({ from: n[k], to: n[k + 1], low: n[k + 2], high: n[k + 3], log: n[k + 4] });
    return [axis(0), axis(5)];
  }
  function valueAt({ from, to, low, high, log }, at) {
    const place = low + ((at - from) / (to - from)) * (high - low);
    return log ? 10 ** place : place;
  }
  function placeOf({ from, to, low, high, log }, value) {
    const place = log ? Math.log10(value) : value;
    return from + ((place - low) / (high - low)) * (to - from);
  }
  const shown = (value) => Number(value.toPrecision(3)).toString().replace("-", "\u2212");

  // Points of a curve, from its path, once.
  const known = new WeakMap();
  function points(curve) {
    if (!known.has(curve)) {
      // In tenths; each point but the first of a piece by its distance from the one before.
      const found = [];
      let pen = [0, 0];
      for (const [, command, x, y] of curve.getAttribute("d").matchAll(/([Ml])(-?\d+) (-?\d+)/g)) {
        const from = command === "M" ? [0, 0] : pen;
        pen = [from[0] + Number(x), from[1] + Number(y)];
        found.push([pen[0] / 10, pen[1] / 10]);
      }
      known.set(curve, found);
    }
    return known.get(curve);
  }
  function nearest(curve, x) {
    let best = null;
    for (const point of points(curve)) {
      if (!best || Math.abs(point[0] - x) < Math.abs(best[0] - x)) best = point;
    }
    return best;
  }

  function line(panel, x, [, up]) {
    let pointer = panel.querySelector(".pointer");
    if (!pointer) {
      pointer = panel.appendChild(document.createElementNS(svg, "line"));
      pointer.setAttribute("class", "pointer");
    }
    const ends = { x1: x, x2: x, y1: up.from, y2: up.to };
    for (const [name, value] of Object.entries(ends)) pointer.setAttribute(name, value);
  }
  function clear() {
    values.hidden = true;
    document.querySelectorAll(".pointer").forEach((pointer) => pointer.remove());
  }

  function point(chart, event) {
    clear();
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(chart.getScreenCTM().inverse());
    for (const panel of chart.querySelectorAll(".panel")) {
      const [across, up] = axes(panel);
      const curves = [...panel.querySelectorAll(".curve")];
      if (at.x < across.from || at.x > across.to || curves.length === 0) continue;
      line(panel, at.x, [across, up]);
      const rows = curves.map((curve) => [curve, nearest(curve, at.x)]).filter(([, near]) => near);
      values.replaceChildren(shown(valueAt(across, at.x)));
      for (const [curve, near] of rows) {
        const row = document.createElement("div");
        row.style.color = curve.getAttribute("stroke");
        row.textContent = `${curve.dataset.name} ${shown(valueAt(up, near[1]))}`;
        values.append(row);
      }
      values.hidden = false;
      const room = innerWidth - values.offsetWidth - 16;
      values.style.left = `${Math.min(event.clientX + 14, room)}px`;
      values.style.top = `${Math.min(event.clientY + 14, innerHeight - values.offsetHeight - 8)}px`;
      const time = valueAt(across, at.x);
      if (!chart.dataset.link) continue;
      for (const other of document.querySelectorAll(`.chart[data-link="${chart.dataset.link}"]`)) {
        const linked = other.querySelector(".panel");
        const ends = axes(linked);
        const x = placeOf(ends[0], time);
        if (other !== chart && x >= ends[0].from && x <= ends[0].to) line(linked, x, ends);
      }
    }
  }
  function listen(root) {
    for (const chart of root.querySelectorAll(".chart")) {
      chart.addEventListener("pointermove", (event) => point(chart, event));
      chart.addEventListener("pointerleave", clear);
    }
  }
  listen(document);

  // A page that is served replaces its pieces.
  document.addEventListener("machinist:replaced", ({ detail }) => {
    clear();
    watchScrolling();
    detail.forEach(listen);
  });
})();
