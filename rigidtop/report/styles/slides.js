// The lecture cut into slides of one size: on each what there is room for, its heading said again.
const upright = innerHeight > innerWidth;
const [width, height] = upright ? [640, Math.round((640 * innerHeight) / innerWidth)] : [1280, 720];
const slides = (() => {
  const root = document.documentElement;
  const main = document.querySelector("main");
  const { continued } = JSON.parse(root.dataset.words);
  const screen = document.createElement("style");
  screen.textContent =
    `.shown { --width: ${width}px; --height: ${height}px; } @page { size: ${width}px ${height}px; }`;
  document.head.append(screen);
  root.classList.add("shown");
  for (const each of main.querySelectorAll("figure")) {
    const { width: w, height: h } = each.querySelector("svg").viewBox.baseVal;
    each.classList.toggle("tall", !upright && w < 1.6 * h);
  }
  fitted();

  // What a slide cannot part: a row of a table, an item, a block with its side note.  All is
  // measured before anything is moved.
  const room = height - 116;
  const heads = (node) => node.matches("h2, h3, h4, h5, .head");
  const box = (node) => node.getBoundingClientRect();
  const units = [];
  const rows = [];
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
      // The lines that its sentence means by "it" and "both" are said again above it.
      const words = whole.matches(".row") ? whole.querySelector(".why")?.textContent : "";
      const meant = /\ball three\b/i.test(words) ? 3 : /\bboth\b/i.test(words) ? 2 : /\bit\b/i.test(words) ? 1 : 0;
      const recalled = meant ? rows.slice(-meant).map((row) => row.querySelector(".eq")) : [];
      const grey = recalled.reduce((sum, eq) => sum + 0.8 * box(eq).height, 0);
      if (56 + grey + tall > room) recalled.length = 0; // no place for them
      if (whole.matches(".row")) rows.push(whole);
      for (const [k, each] of inner.entries()) {
        const above = table && k ? box(inner[0]).top - top : recalled.length && grey;
        units.push({ nodes: [each], whole, k, of: inner.length, tall, widths, recalled, figures: [],
          start: k ? box(each).top : top, end: box(each).bottom, again: heads(whole) ? 0 : 56 + above });
      }
    }
  }

  // The best breaks: few slides, evenly filled, before a heading, not before what says "it".
  const begun = (k) => {
    const [earlier, before, unit] = [units[k - 2], units[k - 1], units[k]];
    if (heads(before.whole) ? !before.figures.length
      : before.whole.matches(".label") || (before.whole.matches("p") && /:\s*$/.test(before.whole.textContent))) return 100;
    if (unit.k) return unit.tall < room - 100 || Math.min(unit.k, unit.of - unit.k) < 3 ? 4 : 0.5;
    const shown = before.figures.length ? -0.5 : 0; // its figures come next
    const first = unit.whole.matches(".sub") && units[k + 1] ? units[k + 1] : unit; // Exercises
    if (heads(first.whole) && !first.whole.matches(".sub")) return -100;
    if (heads(unit.whole)) return shown - 1.1;
    return shown + (unit.recalled.length || (earlier && heads(earlier.whole)) ? 0.4 : 0);
  };
  const best = [{ cost: 0 }];
  units.forEach((last, k) => {
    const after = units[k + 1] ? begun(k + 1) : 0;
    for (let from = k; from >= 0; from -= 1) {
      const over = last.end - units[from].start + (from && units[from].again) - room;
      if (over > 0 && from < k) break;
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
      (head.querySelector("h3, h4, h5") ?? head).append(` (${continued})`);
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
    for (const each of group[0].recalled) {
      const copy = again(each);
      copy.classList.add("recalled");
      slide.append(copy);
    }
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
          if (k) copy.querySelector("caption")?.append(` (${continued})`);
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
    return [footed(slide), ...behind];
  });
  main.replaceChildren(...made);
  made.forEach((slide, k) => slide.lastChild.append(`\u2003 ${k + 1} / ${made.length}`));
  return made;
})();
