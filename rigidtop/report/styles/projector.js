// The slides on the projector: scaled to the screen, uncovered line by line with the arrow keys.
(() => {
  const lines = slides.map((slide) =>
    [...slide.children].filter((each) => !each.matches("h2, h3, h4, h5, .head, .side, .label, .recalled, footer"))
      .flatMap((each) => (each.matches("ul") ? [...each.children] : [each])));
  const place = Object.assign(document.createElement("div"), { className: "unseen", ariaLive: "polite" });
  document.querySelector("main").append(place);
  const help = Object.assign(document.createElement("span"), {
    textContent: "→ ← a line, ↓ ↑ a slide, a all of it, f full screen \u2003 " });
  let part = -1;
  let line = 0;
  const show = (to, uncovered) => {
    slides[part]?.classList.remove("now");
    help.remove();
    part = Math.max(0, Math.min(slides.length - 1, to));
    line = Math.max(0, Math.min(lines[part].length, uncovered));
    slides[part].classList.add("now");
    lines[part].forEach((each, k) => each.classList.toggle("covered", k >= line));
    place.textContent = `${part + 1} / ${slides.length}`;
    history.replaceState(null, "", `#${part + 1}.${line}`);
  };
  const forth = () => (line < lines[part].length ? show(part, line + 1) : show(part + 1, 1));
  const back = () => (line > 1 ? show(part, line - 1) : show(part - 1, Infinity));
  const keys = {
    ArrowRight: forth, PageDown: forth, " ": forth, Enter: forth,
    ArrowLeft: back, PageUp: back, Backspace: back,
    ArrowDown: () => show(part + 1, 1), ArrowUp: () => show(part - 1, 1),
    Home: () => show(0, 1), End: () => show(slides.length - 1, 1),
    a: () => show(part, Infinity),
    "?": () => (help.isConnected ? help.remove() : slides[part].lastChild.prepend(help)),
    f: () => document.fullscreenElement ? document.exitFullscreen() : view.requestFullscreen(),
  };
  addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || !keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  });
  addEventListener("click", (event) => {
    if (event.target.closest("a, button, input, canvas")) return;
    if (event.clientX < view.clientWidth / 4) back();
    else forth();
  });
  // #68.6 is a line of a slide, #3.57 or #3-57 an equation, which is uncovered, #3-5-3 a section.
  const open = () => {
    const name = location.hash.slice(1);
    const number = name.replace(".", "-");
    const at = /^(\d+)\.(\d+)$/.exec(name);
    if (at && !document.getElementById(`claim-${number}`)) return show(at[1] - 1, Number(at[2]));
    const ids = [name, `claim-${number}`, `section-${name}`].map((id) => document.getElementById(id));
    const to = slides.findIndex((slide) => ids.some((each) => each && slide.contains(each)));
    if (to < 0) {
      show(Math.max(part, 0), Math.max(line, 1));
      if (name && name !== "content") slides[part].lastChild.prepend(`no #${name} \u2003 `);
      return undefined;
    }
    const row = lines[to].findIndex((line) => ids.some((each) => each && (line.contains(each) || each.contains(line))));
    return show(to, Math.max(row, 0) + 1);
  };
  const fit = () => {
    if (view.clientHeight > view.clientWidth !== upright) location.reload(); // other slides
    view.style.setProperty("--scale", Math.min(view.clientWidth / width, view.clientHeight / height));
  };
  addEventListener("resize", fit);
  addEventListener("hashchange", open);
  fit();
  open();
})();
