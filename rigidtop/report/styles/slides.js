// The lecture on slides of one size, which are scaled to the screen: on each what there is room
// for, its heading said again.  The arrow keys uncover it line by line.
"use strict";
(() => {
  const root = document.documentElement;
  const main = document.querySelector("main");
  const upright = innerHeight > innerWidth;
  const [width, height] = upright ? [640, Math.round((640 * innerHeight) / innerWidth)] : [1280, 720];
  const screen = document.createElement("style");
  screen.textContent =
    `.shown { --width: ${width}px; --height: ${height}px; } @page { size: ${width}px ${height}px; }`;
  document.head.append(screen);
  root.classList.add("shown");

  // What is on slides: the children of sections and of displays, one below the other.
  const opened = (node) => {
    if (!node.matches("section, .display, .columns")) return node.matches(".tools, footer") ? [] : [node];
    const inner = [...node.children].flatMap(opened);
    if (node.id) inner[0].id = node.id;
    return inner;
  };
  main.replaceChildren(...[...main.children].flatMap(opened));
  dispatchEvent(new Event("resize")); // equations are measured in this width

  // What a slide cannot part: a row of a table, an item, or a block, with how high it is.
  const heads = (node) => node.matches("h2, h3, h4, h5, .head");
  const held = (node) => heads(node) || node.matches(".label") || /[:：]$/.test(node.textContent.trim());
  const box = (node) => node.getBoundingClientRect();
  const pieces = [];
  for (const node of [...main.children]) {
    if (node.matches(".side")) {
      pieces.at(-1).nodes.push(node);
      pieces.at(-1).end = box(node).bottom;
      continue;
    }
    const table = node.matches(".scroll") && node.firstElementChild;
    for (const each of table ? table.tHead.rows[0].cells : []) each.style.width = `${box(each).width}px`;
    const inner = table ? table.tBodies[0].rows : node.matches("ul") ? node.children : [node];
    for (const [k, each] of [...inner].entries()) {
      const { top, bottom } = box(each);
      const above = k && table ? box(inner[0]).top - box(node).top : 0;
      const nodes = [each];
      pieces.push({ nodes, whole: node, start: k ? top : box(node).top, above, end: bottom });
    }
  }

  // Parts begin with a heading, but where one paragraph introduces it; a figure has its own slide.
  const parts = [];
  for (const piece of pieces) {
    const last = parts.at(-1);
    const figure = piece.whole.matches("figure");
    const rest = last?.filter((each) => !heads(each.whole)) ?? [];
    const intro = rest.length === 1 && rest[0].whole.matches("p") && piece.whole.matches(".sub");
    const begins = heads(piece.whole) || figure || last?.at(-1).whole.matches("figure, header");
    if (last && (!rest.length || intro || !begins)) last.push(piece);
    else parts.push([piece]);
  }

  // So many pieces to a slide that none is longer, and none much shorter than the others.
  const room = height - 112;
  const split = (part, limit) => {
    const title = part.findIndex((each) => !heads(each.whole));
    const head = part[0].start - part[Math.max(title, 0)].start;
    const made = [[]];
    for (const piece of part) {
      const now = made.at(-1);
      const least = made.length > 1 ? 0 : title;
      const top = made.length > 1 ? now[0].start - now[0].above + Math.min(head, -48) : part[0].start;
      if (now.length > least && piece.end - top > limit) {
        let from = now.length;
        while (from > least + 1 && held(now[from - 1].whole)) from -= 1;
        made.push([...now.splice(from), piece]);
      } else now.push(piece);
    }
    return made;
  };
  const balanced = (part) => {
    const least = split(part, room);
    let limit = room;
    while (limit > 0 && split(part, limit - 20).length === least.length) limit -= 20;
    return split(part, limit);
  };

  const words = JSON.parse(root.dataset.words);
  let title;
  const slides = parts.flatMap(balanced).map((group, k) => {
    const slide = document.createElement("section");
    slide.className = "slide";
    if (heads(group[0].nodes[0])) title = group.findLast((each) => heads(each.nodes[0])).nodes[0];
    else if (title && k) {
      const again = title.cloneNode(true);
      again.removeAttribute("id");
      (again.querySelector("h3, h4, h5") ?? again).append(`, ${words.continued}`);
      slide.append(again);
    }
    let shell;
    for (const { nodes, whole } of group) {
      if (nodes[0] === whole) {
        slide.append(...nodes);
        continue;
      }
      if (shell?.whole !== whole) {
        const copy = whole.cloneNode(true);
        for (const each of copy.querySelectorAll("tbody tr, li")) each.remove();
        shell = { whole, copy, inside: copy.querySelector("tbody") ?? copy };
        slide.append(copy);
      }
      shell.inside.append(...nodes);
    }
    return slide;
  });
  main.replaceChildren(...slides);

  const lines = slides.map((slide) =>
    [...slide.children].filter((each) => !heads(each) && !each.matches(".side, .label"))
      .flatMap((each) => (each.matches("ul") ? [...each.children] : [each])));
  const place = document.createElement("div");
  place.className = "place-of";
  place.setAttribute("aria-live", "polite");
  main.append(place);
  let part = -1;
  let line = 0;
  const show = (to, uncovered) => {
    part = Math.max(0, Math.min(slides.length - 1, to));
    line = Math.max(0, Math.min(lines[part].length, uncovered));
    slides.forEach((slide, k) => slide.classList.toggle("now", k === part));
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
    f: () => document.fullscreenElement ? document.exitFullscreen() : root.requestFullscreen(),
  };
  addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || !keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  });
  addEventListener("click", (event) => {
    if (event.target.closest("a, button, input, canvas")) return;
    if (event.clientX < innerWidth / 4) back();
    else forth();
  });
  // #68.6 is a line of a slide, #claim-3-57 or #3-57 an equation, which is uncovered.
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
  const fit = () => {
    if (innerHeight > innerWidth !== upright) location.reload(); // other slides
    root.style.setProperty("--scale", Math.min(innerWidth / width, innerHeight / height));
  };
  addEventListener("resize", fit);
  addEventListener("hashchange", open);
  fit();
  open();
})();
