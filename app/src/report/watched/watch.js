// Keeps the page as the files are: the server tells by events that something changed, and pieces of
// the page that are others now take the place of those before.
(() => {
  "use strict";
  const root = document.getElementById("watch");
  const status = document.getElementById("watch-status");
  const troubles = document.getElementById("watch-troubles");
  const contents = document.querySelector("nav ol");
  const script = document.getElementById("live-script").textContent;

  // Pieces by id, as the server wrote them: the machine that runs in the page changes its own.
  let shown = { version: Number(root.dataset.version), pieces: new Map(), known: null };
  let hasBegun = false;

  function say(state, text) {
    root.dataset.state = state;
    status.textContent = text;
  }

  // The element that a piece was written for, with what a reader has unfolded.
  function made(html, old) {
    const template = document.createElement("template");
    template.innerHTML = html;
    const element = template.content.firstElementChild;
    const unfolded = old ? [...old.querySelectorAll("details")].map(({ open }) => open) : [];
    element.querySelectorAll("details").forEach((details, k) => {
      if (k < unfolded.length) details.open = unfolded[k];
    });
    return element;
  }

  function isLive(id) {
    return id === "machine" || id === "run";
  }

  // Replaces pieces that are others now; whether the machine in the page must start anew.
  function replace({ pieces, known, is_complete }) {
    const isOther = ({ id, html }) => shown.pieces.get(id) !== html;
    const isAnew = known !== shown.known || pieces.some((piece) => isLive(piece.id) && isOther(piece));
    const wanted = new Set(pieces.map(({ id }) => id));
    for (const id of shown.pieces.keys()) {
      const old = wanted.has(id) ? null : document.getElementById(id);
      // Some take longer than the run, and come after it.
      if (is_complete) old?.remove();
      else old?.classList.add("stale");
    }
    const replaced = [];
    let above = root;
    for (const piece of pieces) {
      const old = document.getElementById(piece.id);
      if (old && !isOther(piece) && !(isAnew && isLive(piece.id))) {
        old.classList.remove("stale");
        above = old;
        continue;
      }
      const element = made(piece.html, old);
      if (old) old.replaceWith(element);
      else above.after(element);
      replaced.push(element);
      above = element;
    }
    if (replaced.length) document.dispatchEvent(new CustomEvent("machinist:replaced", { detail: replaced }));
    return isAnew;
  }

  // Ends the machine that runs in the page, and starts the one of now.
  function start(known) {
    document.dispatchEvent(new Event("machinist:live-ends"));
    document.getElementById("live-known")?.remove();
    if (known === null) return;
    const add = (properties) => root.parentElement.appendChild(Object.assign(document.createElement("script"), properties));
    add({ type: "application/json", id: "live-known", textContent: known });
    add({ textContent: script }).remove();
  }

  function apply(content) {
    const focused = document.activeElement?.id;
    const isAsWritten = !hasBegun && content.version === shown.version;
    let isAnew = true;
    if (!isAsWritten) isAnew = replace(content);
    const pieces = content.is_complete ? new Map() : shown.pieces;
    for (const { id, html } of content.pieces) pieces.set(id, html);
    shown = { version: content.version, pieces, known: content.known };
    document.title = content.state === "failed" ? `\u2717 ${content.title}` : content.title;
    if (content.is_complete || !contents.children.length) contents.innerHTML = content.navigation;
    if (troubles.innerHTML !== content.troubles) {
      troubles.innerHTML = content.troubles;
      document.dispatchEvent(new CustomEvent("machinist:replaced", { detail: [] }));
    }
    say(content.state, content.status);
    if (isAnew) start(content.known);
    if (focused && document.activeElement === document.body) {
      document.getElementById(focused)?.focus({ preventScroll: true });
    }
    hasBegun = true;
    // How long the page took is seen by who measures it.
    root.dataset.version = content.version;
  }

  // One update at a time; what changes meanwhile is asked for after it.
  let [isBusy, isStale] = [false, false];
  async function update() {
    isStale = true;
    if (isBusy) return;
    isBusy = true;
    try {
      while (isStale) {
        isStale = false;
        const answer = await fetch("/content");
        if (!answer.ok) throw new Error(answer.statusText);
        apply(await answer.json());
      }
    } catch {
      // The stream of events says so too, and begins again once there is a server.
    } finally {
      isBusy = false;
    }
  }

  const events = new EventSource("/events");
  events.onmessage = ({ data }) => {
    const told = JSON.parse(data);
    if (told.state === "working") say("working", told.status);
    else update();
  };
  events.onerror = () => say("lost", "No answer: `machinist watch` has ended, or was started anew at another address.");
})();
