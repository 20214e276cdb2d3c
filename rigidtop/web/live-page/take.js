/** What a reader takes along: the link, a picture, a table of numbers, a film. */

import { button, element } from "./shell.js";

/** How long a film is, in seconds, and its pictures in each of them. */
const FILM = 10;
const PICTURES = 30;
/** Bits in each of them: enough for thin lines. */
const BITS = 8e6;

/** Comma-separated values; what is open, as φ̇ at a pole, stays empty. */
export function separated(
  /** @type {{ names: readonly string[], rows: (string | number)[][] }} */ { names, rows },
) {
  const written = rows.map((row) => row.map((x) => (x === x ? x : "")).join(","));
  return `${[names.join(","), ...written].join("\r\n")}\r\n`;
}

/**
 * The picture with the letters over it, on a sheet of its own.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {HTMLCanvasElement} canvas just drawn
 * @param {HTMLElement} container
 */
function drawWithLetters(ctx, canvas, container) {
  const { width, height } = ctx.canvas;
  ctx.drawImage(canvas, 0, 0, width, height);
  const frame = container.getBoundingClientRect();
  const ratio = width / frame.width;
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  for (const letter of container.querySelectorAll("span")) {
    const box = letter.getBoundingClientRect();
    if (box.width === 0) continue;
    const { font, color, fontWeight, fontStyle, fontSize, fontFamily } = getComputedStyle(letter);
    ctx.font = font || `${fontStyle} ${fontWeight} ${fontSize} ${fontFamily}`;
    ctx.save();
    const [x, y] = [box.x + box.width / 2 - frame.x, box.y + box.height / 2 - frame.y];
    ctx.translate(x * ratio, y * ratio);
    ctx.scale(ratio, ratio);
    ctx.fillStyle = color;
    ctx.fillText(letter.textContent ?? "", 0, 0);
    ctx.restore();
  }
}

/** An empty sheet as large as the picture. */
function sheetLike(/** @type {HTMLCanvasElement} */ { width, height }) {
  const sheet = document.createElement("canvas");
  // A film wants even numbers.
  [sheet.width, sheet.height] = [width - (width % 2), height - (height % 2)];
  return /** @type {CanvasRenderingContext2D} */ (sheet.getContext("2d"));
}

/** Hand a file to the reader. */
function give(/** @type {Blob} */ content, /** @type {string} */ name) {
  const link = element("a", { href: URL.createObjectURL(content), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/**
 * The menu.
 *
 * @param {HTMLElement} container
 * @param {object} page
 * @param {() => string} page.name of the files
 * @param {(finely?: boolean) => HTMLCanvasElement | null} page.picture The scene, drawn just now.
 * @param {HTMLElement} page.scene
 * @param {() => string} page.link Of what is set.
 * @param {() => string} page.table Comma-separated values.
 * @param {(sentence: string) => void} page.say
 */
export function createTake(container, { name, picture, scene, link, table, say }) {
  const menu = element("details", { class: "menu" }, element("summary", {}, "Export"));
  const list = element("div", { class: "menu-list" });
  menu.append(list);
  container.append(menu);
  const add = (/** @type {string} */ words, /** @type {() => void} */ act) => {
    list.append(button(words, () => {
      menu.open = false;
      menu.querySelector("summary")?.focus();
      act();
    }));
  };
  add("Copy link", async () => {
    try {
      await navigator.clipboard.writeText(link());
      say("The link to what is shown is copied");
    } catch {
      say(`This browser copies nothing for a page; the link is ${link()}`);
    }
  });
  add("Picture (PNG)", () => {
    const drawn = picture(true);
    if (!drawn) {
      say("There is no picture here");
      return;
    }
    const ctx = sheetLike(drawn);
    drawWithLetters(ctx, drawn, scene);
    ctx.canvas.toBlob((blob) => blob && give(blob, `${name()}.png`), "image/png");
  });
  add("Table (CSV)", () => {
    give(new Blob([table()], { type: "text/csv" }), `${name()}.csv`);
  });
  add(`Film of ${FILM} s (WebM)`, () => {
    const drawn = picture();
    if (!drawn || !window.MediaRecorder || !drawn.captureStream) {
      say("This browser records no films");
      return;
    }
    /** @type {Blob[]} */
    const parts = [];
    const ctx = sheetLike(drawn);
    const stream = ctx.canvas.captureStream(PICTURES);
    const recorder = new MediaRecorder(stream, {
      mimeType: "video/webm", videoBitsPerSecond: BITS,
    });
    const next = () => {
      const now = picture();
      if (now) drawWithLetters(ctx, now, scene);
      if (recorder.state === "recording") requestAnimationFrame(next);
    };
    recorder.addEventListener("dataavailable", (event) => parts.push(event.data));
    recorder.addEventListener("stop", () => {
      give(new Blob(parts, { type: "video/webm" }), `${name()}.webm`);
      say("The film is there");
    });
    recorder.start();
    next();
    say(`Recording ${FILM} seconds of the picture`);
    setTimeout(() => recorder.stop(), FILM * 1000);
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") menu.open = false;
  });
  return menu;
}
