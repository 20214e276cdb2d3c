// The lecture part by part: arrow keys uncover lines, up and down go from part to part.
"use strict";
(() => {
  const main = document.querySelector("main");
  const begins = (node) => node.matches("header, h2, h3, h4, section.exercise");
  const flat = [...main.children].filter((node) => !node.matches(".tools, footer"));
  const slides = [];
  for (const node of flat) {
    const last = slides.at(-1);
    const headed = last && [...last.children].every((each) => each.matches("h2, h3, h4"));
    if (!last || (begins(node) && !headed)) {
      const slide = document.createElement("section");
      slide.className = "slide";
      main.append(slide);
      slides.push(slide);
    }
    slides.at(-1).append(node);
  }
  const lines = slides.map((slide) =>
    [...slide.querySelectorAll(":scope > p, .row, figure, .scroll, :scope > section > p, li")]);
  const place = document.createElement("div");
  place.className = "place-of";
  place.setAttribute("aria-live", "polite");
  document.body.append(place);
  document.documentElement.classList.add("shown");
  let part = -1;
  let line = 0;
  const show = (to, uncovered) => {
    const before = part;
    part = Math.max(0, Math.min(slides.length - 1, to));
    line = Math.max(0, Math.min(lines[part].length, uncovered));
    slides.forEach((slide, k) => slide.classList.toggle("now", k === part));
    if (part !== before) dispatchEvent(new Event("resize")); // its equations are measured
    lines[part].forEach((each, k) => each.classList.toggle("covered", k >= line));
    place.textContent = `${part + 1} / ${slides.length}`;
    history.replaceState(null, "", `#${part + 1}.${line}`);
    const current = lines[part][line - 1];
    if (current) current.scrollIntoView({ block: "nearest" });
    else slides[part].scrollTop = 0;
  };
  const forth = () => (line < lines[part].length ? show(part, line + 1) : show(part + 1, 1));
  const back = () => (line > 1 ? show(part, line - 1) : show(part - 1, Infinity));
  const keys = {
    ArrowRight: forth, PageDown: forth, " ": forth, Enter: forth,
    ArrowLeft: back, PageUp: back, Backspace: back,
    ArrowDown: () => show(part + 1, 1), ArrowUp: () => show(part - 1, 1),
    Home: () => show(0, 1), End: () => show(slides.length - 1, 1),
    a: () => show(part, Infinity),
    f: () => document.fullscreenElement
      ? document.exitFullscreen() : document.documentElement.requestFullscreen(),
  };
  addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || !keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  });
  addEventListener("click", (event) => { if (!event.target.closest("a, button")) forth(); });
  // #68.6 is a line of a part, #claim-3-57 or #3-57 an equation, which is uncovered.
  const open = () => {
    const name = location.hash.slice(1);
    const at = /^(\d+)\.(\d+)$/.exec(name);
    if (at) return show(at[1] - 1, Number(at[2]));
    const ids = [name, `claim-${name}`].map((id) => document.getElementById(id));
    const target = ids.find((each) => main.contains(each) && each);
    const to = target ? slides.findIndex((slide) => slide.contains(target)) : -1;
    if (to < 0) {
      show(Math.max(part, 0), Math.max(line, 1));
      if (name && target !== main) place.textContent = `no #${name}: ${place.textContent}`;
      return undefined;
    }
    const row = lines[to].findIndex((each) => each.contains(target) || target.contains(each));
    return show(to, Math.max(row, 0) + 1);
  };
  addEventListener("hashchange", open);
  open();
})();
