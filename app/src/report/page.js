// Folds the contents away on small screens, and draws each plot of the page when
// it comes into view, in the page's colours.
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

  const figures = [...document.querySelectorAll("figure.plot")];
  const drawn = new Set();

  function colours() {
    const style = getComputedStyle(document.documentElement);
    const colour = (name) => style.getPropertyValue(name).trim();
    return { ink: colour("--ink"), rule: colour("--rule"), raised: colour("--raised") };
  }

  // Layout settings by their paths, as Plotly.relayout takes them.
  function theme(canvas) {
    const { ink, rule, raised } = colours();
    const settings = {
      "font.color": ink,
      "font.family": getComputedStyle(document.body).fontFamily,
      "font.size": 12.5,
      "hoverlabel.bgcolor": raised,
      "hoverlabel.bordercolor": rule,
      "hoverlabel.font.color": ink,
      "modebar.bgcolor": "rgba(0,0,0,0)",
      "modebar.color": rule,
      "modebar.activecolor": ink,
    };
    for (const axis of Object.keys(canvas.layout).filter((key) => /^[xy]axis/.test(key))) {
      settings[axis + ".gridcolor"] = rule;
      settings[axis + ".zerolinecolor"] = rule;
      settings[axis + ".linecolor"] = rule;
      settings[axis + ".automargin"] = true;
    }
    return settings;
  }

  async function draw(figure) {
    if (drawn.has(figure)) return;
    drawn.add(figure);
    const { data, layout, config } = JSON.parse(figure.querySelector("script").textContent);
    const canvas = figure.querySelector(".canvas");
    await Plotly.newPlot(canvas, data, layout, config);
    await Plotly.relayout(canvas, theme(canvas));
  }

  function repaint() {
    for (const figure of drawn) {
      const canvas = figure.querySelector(".canvas");
      Plotly.relayout(canvas, theme(canvas));
    }
  }

  const watcher = new IntersectionObserver(
    (entries) => entries.filter((e) => e.isIntersecting).forEach((e) => draw(e.target)),
    { rootMargin: "600px" },
  );
  figures.forEach((figure) => watcher.observe(figure));

  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", repaint);
  addEventListener("beforeprint", () => {
    document.documentElement.classList.add("printing");
    figures.forEach(draw);
    repaint();
  });
  addEventListener("afterprint", () => {
    document.documentElement.classList.remove("printing");
    repaint();
  });
})();
