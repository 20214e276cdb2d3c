// The lecture cut into slides of one size: on each what there is room for, its heading said again.
const view = document.documentElement; // not the window: a phone's grows with what is wide in it
const upright = view.clientHeight > view.clientWidth;
const [width, height] = upright ? [640, Math.round((640 * view.clientHeight) / view.clientWidth)] : [1280, 720];
const slides = (() => {
  const main = document.querySelector("main");
  const screen = document.createElement("style");
  screen.textContent =
    `.shown { --width: ${width}px; --height: ${height}px; } @page { size: ${width}px ${height}px; }`;
  document.head.append(screen);
  view.classList.add("shown", ...(upright ? ["upright"] : []));
  for (const each of main.querySelectorAll("figure")) {
    const { width: w, height: h } = each.querySelector("svg").viewBox.baseVal;
    each.classList.toggle("tall", !upright && w < 1.9 * h);
  }
  fitted();

  // What a slide cannot part: a row of a table, an item, a block with its side note.  All is
  // measured before anything is moved.
  const room = height - 92;
  const heads = (node) => node.matches("h2, h3, h4, h5, .head");
  const box = (node) => node.getBoundingClientRect();
  const units = [];
  const told = new Map();
  let count = 0;
  let section = 0;
  let said;
  for (const whole of [...main.children].flatMap((each) => (each.matches(".columns") ? [...each.children] : each))) {
    const last = units.at(-1);
    if (whole.matches("figure")) last.figures.push(whole);
    else if (whole.matches(".side")) {
      last.nodes.push(whole);
      last.end = box(whole).bottom;
    } else {
      const table = whole.querySelector("table");
      const inner = [...(table ? table.tBodies[0].rows : whole.matches("ul") ? whole.children : [whole])];
      const widths = table ? [...table.tHead.rows[0].cells].map((each) => box(each).width) : [];
      const { top, height: tall } = box(whole);
      // The lines that a move rests on, but for those with a number in another section: it is a link.
      section += whole.matches("h2, h3:not(.sub), .exercise");
      const cites = (whole.dataset.cites ?? "").split(" ");
      const needs = cites.flatMap((id) => told.get(id) ?? []).filter((row) => !row.tag || row.section === section);
      if (heads(whole)) said = undefined;
      const goesOn = whole.matches("p:not(.label)") ? said : undefined;
      const at = count;
      for (const [k, each] of inner.entries()) {
        const above = table && k ? box(inner[0]).top - top : 0;
        units.push({ nodes: [each], whole, k, of: inner.length, tall, widths, at, needs, goesOn, figures: [],
          start: k ? box(each).top : top, end: box(each).bottom, again: heads(whole) ? 0 : 56 + above });
      }
      if (whole.matches(".row")) {
        const eq = whole.querySelector(".eq");
        said = { at, section, eq, tag: whole.querySelector(".tag"), tall: 8 + 0.75 * box(eq).height };
        count += 1;
        const { line } = whole.dataset;
        if (line) told.set(line, [...(told.get(line) ?? []), said]);
      }
    }
  }

  // The best breaks: few slides, evenly filled, before a heading, not before what says "it".
  const begun = (k) => {
    const [earlier, before, unit] = [units[k - 2], units[k - 1], units[k]];
    if (heads(before.whole) ? !before.figures.length
      : before.whole.matches(".label") || (before.whole.matches("p") && /:\s*$/.test(before.whole.textContent))) return 100;
    if (before.whole.querySelector(".seal:is(.convention, .false)") && unit.whole.matches("p")) return 4; // what is amiss
    if (unit.k) return unit.tall < room - 100 || Math.min(unit.k, unit.of - unit.k) < 3 ? 4 : 0.5;
    const shown = before.figures.length ? -0.5 : 0; // its figures come next
    const first = unit.whole.matches(".sub") && units[k + 1] ? units[k + 1] : unit; // Exercises
    if (heads(first.whole) && (shown || !first.whole.matches(".sub"))) return -100;
    if (heads(unit.whole)) return -0.2;
    const leads = before.whole.matches("p") && unit.whole.matches(".row"); // to what comes next
    return shown + (leads ? 0.9 : 0) + (earlier && heads(earlier.whole) ? 0.4 + leads : 0);
  };
  // A slide stands by itself: what it speaks of and the last line, where it goes on, are shown again.
  const laid = (first, last, needs) => {
    const bare = last.end - first.start + (first === units[0] ? 0 : first.again) - room;
    const recalled = [...new Set([...needs, first.goesOn])]
      .filter((row) => row?.at < first.at).sort((a, b) => a.at - b.at).slice(-1);
    const over = () => recalled.reduce((sum, { tall }) => sum + tall, bare);
    while (first === last && recalled.length && over() > 0) recalled.shift();
    return { bare, over: over(), recalled };
  };
  const best = [{ cost: 0 }];
  units.forEach((last, k) => {
    const needs = [];
    const after = units[k + 1] ? begun(k + 1) : 0;
    for (let from = k; from >= 0; from -= 1) {
      needs.push(...units[from].needs);
      const { over, bare } = laid(units[from], last, needs);
      if (bare > 0 && from < k) break;
      if (over > 0 && from < k) continue;
      const cost = best[from].cost + 1 + 8 * (over / room) ** 4 + after;
      if (!(best[k + 1]?.cost <= cost)) best[k + 1] = { cost, from };
    }
  });
  const groups = [];
  for (let end = units.length; end; end = best[end].from) groups.unshift(units.slice(best[end].from, end));

  const again = (node) => {
    const made = node.cloneNode(true);
    made.removeAttribute("id");
    return made;
  };
  let title;
  let about;
  let open;
  const page = () => {
    const made = document.createElement("section");
    made.className = "slide";
    if (title) {
      const head = again(title);
      (head.querySelector("h3, h4, h5") ?? head).append(" (continued)");
      made.append(head);
    }
    return made;
  };
  const footed = (slide) => {
    const foot = document.createElement("footer");
    const head = about && (about.querySelector("h3, h4, h5") ?? about);
    foot.append(...(head ? [...again(head).childNodes] : []));
    slide.append(foot);
    return slide;
  };
  const made = groups.flatMap((group) => {
    const first = group.find(({ whole }) => !heads(whole));
    if (group[0] !== first) title = undefined;
    const slide = page();
    const needed = group.flatMap(({ needs }) => needs);
    const recalled = laid(group[0], group.at(-1), needed).recalled.map(({ eq, tag }) => {
      const copy = again(eq);
      if (tag) copy.append(again(tag));
      copy.classList.add("recalled");
      return copy;
    });
    const behind = [];
    for (const { nodes, whole, k, of, widths, figures } of group) {
      if (heads(whole)) title = whole;
      if (heads(whole) && !whole.matches(".sub")) about = whole;
      if (nodes[0] === whole) slide.append(...nodes);
      else {
        if (!k || open.at !== slide) {
          const copy = whole.cloneNode(true);
          for (const each of copy.querySelectorAll("tbody tr, li")) each.remove();
          copy.querySelectorAll("th[scope=col], thead td").forEach((each, n) => { each.style.width = `${widths[n]}px`; });
          if (k) copy.querySelector("caption")?.append(" (continued)");
          open = { at: slide, copy, inside: copy.querySelector("tbody") ?? copy };
          slide.append(copy);
        }
        open.inside.append(...nodes);
        open.copy.classList.toggle("goes-on", k < of - 1);
      }
      for (const figure of figures) {
        const own = first ? page() : slide; // a figure has a slide of its own behind its text
        own.append(figure);
        if (first) behind.push(footed(own));
      }
    }
    [...slide.children].find((each) => !heads(each))?.before(...recalled);
    return [footed(slide), ...behind];
  });
  main.replaceChildren(...made);
  made.forEach((slide, k) => slide.lastChild.append(`\u2003 ${k + 1} / ${made.length}`));
  return made;
})();
