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
  // A figure has a slide of its own behind that of the text before it.
  const figures = new Map();
  for (const figure of main.querySelectorAll("figure")) {
    const { width: w, height: h } = figure.querySelector("svg").viewBox.baseVal;
    figure.classList.toggle("tall", !upright && w < 1.6 * h);
    const before = figure.previousElementSibling;
    figures.set(before, [...(figures.get(before) ?? []), figure]);
    figure.remove();
  }
  dispatchEvent(new Event("resize")); // equations are measured in this width

  // What a slide cannot part: a row of a table, an item, a block with its side note.  Parts begin
  // with a heading that is no subheading.
  const heads = (node) => node.matches("h2, h3, h4, h5, .head");
  const box = (node) => node.getBoundingClientRect();
  const parts = [];
  for (const whole of [...main.children]) {
    const last = parts.at(-1);
    if (whole.matches(".side")) {
      last.at(-1).nodes.push(whole);
      last.at(-1).end = box(whole).bottom;
      continue;
    }
    const begins = !last || last[0].whole.matches("header") || (heads(whole) && !whole.matches(".sub"));
    const titles = last ? last.findLastIndex((each) => !heads(each.whole) || figures.has(each.whole)) + 1 : 0;
    if (begins && (!last || titles)) parts.push(last?.splice(titles) ?? []); // what only has a title goes on
    const table = whole.matches(".scroll") && whole.firstElementChild;
    for (const each of table ? table.tHead.rows[0].cells : []) each.style.width = `${box(each).width}px`;
    const inner = table ? table.tBodies[0].rows : whole.matches("ul") ? whole.children : [whole];
    const { top, height: tall } = box(whole);
    for (const [k, each] of [...inner].entries()) {
      const start = k ? box(each).top : top;
      const above = k && table ? box(inner[0]).top - top : 0;
      parts.at(-1).push({ nodes: [each], whole, start, above, end: box(each).bottom, tall, k, of: inner.length });
    }
  }

  const room = height - 116;
  // The lines that a sentence means by "it" and "both", where it is the first on a slide.
  const formulas = [...main.querySelectorAll(".row")];
  const meant = ({ whole, start, end }) => {
    if (!whole.matches(".row") || end - start > room - 120) return []; // no place for them
    const words = whole.querySelector(".why")?.textContent;
    const count = /\ball three\b/i.test(words) ? 3 : /\bboth\b/i.test(words) ? 2 : /\bit\b/i.test(words) ? 1 : 0;
    const is = formulas.indexOf(whole);
    return formulas.slice(Math.max(is - count, 0), is).map((row) => row.querySelector(".eq"));
  };

  // The best breaks: few slides, evenly filled, before a subheading, not before what says "it".
  const breaks = (piece, before, earlier) => {
    if (heads(before.whole) || before.whole.matches(".label") || /:$/.test(before.whole.textContent.trim())) return 100;
    if (piece.k) return piece.tall < room - 100 || Math.min(piece.k, piece.of - piece.k) < 3 ? 4 : 0.5;
    if (heads(piece.whole)) return -1.3;
    return meant(piece).length || (earlier && heads(earlier.whole)) ? 0.4 : 0;
  };
  const divided = (part) => {
    const best = [{ cost: 0, groups: [] }];
    for (let to = 1; to <= part.length; to += 1) {
      const after = part[to] ? breaks(part[to], part[to - 1], part[to - 2]) : 0;
      for (let from = to - 1; from >= 0; from -= 1) {
        const first = part[from];
        const again = meant(first).reduce((sum, each) => sum + 0.8 * box(each).height, 0);
        const head = from && !heads(first.whole) ? 56 + first.above + again : 0;
        const over = part[to - 1].end - first.start + head - room;
        if (over > 0 && from < to - 1) break;
        const cost = best[from].cost + 1 + 0.5 * (over / room) ** 2 + after;
        if (!(best[to]?.cost <= cost)) best[to] = { cost, groups: [...best[from].groups, part.slice(from, to)] };
      }
    }
    return best.at(-1).groups;
  };

  const words = JSON.parse(root.dataset.words);
  const text = (title) => [...title.childNodes].map((each) => each.textContent).join(" ");
  const again = (title) => {
    const made = title.cloneNode(true);
    made.removeAttribute("id");
    (made.querySelector("h3, h4, h5") ?? made).append(` (${words.continued})`);
    return made;
  };
  const slides = parts.map(divided).flatMap((groups) => {
    let title;
    let open;
    const about = heads(groups[0][0].whole) ? groups[0].findLast((each) => heads(each.whole) && !each.whole.matches(".sub")) : 0;
    return groups.flatMap((group) => {
      const slide = document.createElement("section");
      slide.className = "slide";
      slide.dataset.about = about ? text(about.whole.querySelector("h3, h4, h5") ?? about.whole) : "";
      if (title && !heads(group[0].whole)) slide.append(again(title));
      const first = group.find((each) => !heads(each.whole));
      for (const each of heads(group[0].whole) ? [] : meant(group[0])) {
        const copy = each.cloneNode(true);
        copy.classList.add("recalled");
        slide.append(copy);
      }
      const behind = [];
      for (const { nodes, whole, k, of } of group) {
        if (heads(whole)) title = whole;
        if (nodes[0] === whole) slide.append(...nodes);
        else {
          if (!k || open.at !== slide) {
            const copy = whole.cloneNode(true);
            for (const each of copy.querySelectorAll("tbody tr, li")) each.remove();
            if (k) copy.querySelector("caption")?.append(` (${words.continued})`);
            open = { at: slide, copy, inside: copy.querySelector("tbody") ?? copy };
            slide.append(copy);
          }
          open.inside.append(...nodes);
          open.copy.classList.toggle("goes-on", k < of - 1);
        }
        for (const node of [whole, ...nodes]) {
          if (k === of - 1 || nodes[0] === whole) behind.push(...(figures.get(node) ?? []).map((figure) => [figure, title]));
          figures.delete(node);
        }
      }
      const shown = behind.map(([figure, above]) => {
        if (!first) return slide.append(figure);
        const own = document.createElement("section");
        Object.assign(own, { className: "slide" }).dataset.about = slide.dataset.about;
        own.append(...(above ? [again(above)] : []), figure);
        return own;
      });
      return [slide, ...shown.filter(Boolean)];
    });
  });
  main.replaceChildren(...slides);

  const lines = slides.map((slide) =>
    [...slide.children].filter((each) => !heads(each) && !each.matches(".side, .label, .recalled"))
      .flatMap((each) => (each.matches("ul") ? [...each.children] : [each])));
  const place = document.createElement("div");
  place.className = "unseen";
  place.setAttribute("aria-live", "polite");
  main.append(place);
  slides.forEach((slide, k) => {
    slide.dataset.place = `${slide.dataset.about} \u2003 ${k + 1} / ${slides.length}`;
  });
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
      if (name && target !== main) slides[part].dataset.place = `no #${name} \u2003 ${place.textContent}`;
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
