// Figures of motions, played in place: the live page, unpacked when it is first asked for.
(() => {
  "use strict";
  const read = (id) => document.getElementById(id).textContent;
  /** By the names of the figures: kind of page, name and words of each of its motions. */
  const motions = JSON.parse(read("live-motions"));
  const addresses = new Map();
  let unpacked = null;
  /** The one that plays, and what brings its figure back. */
  let stop = null;

  async function unpack() {
    const packed = Uint8Array.from(atob(read("live-page")), (letter) => letter.charCodeAt(0));
    const plain = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Response(plain).text();
  }

  async function addressOf(kind) {
    unpacked ??= unpack();
    const [before, after] = (await unpacked).split("{{data}}");
    if (!addresses.has(kind)) {
      const html = new Blob([before, read(`live-${kind}`), after], { type: "text/html" });
      addresses.set(kind, URL.createObjectURL(html));
    }
    return addresses.get(kind);
  }

  const element = (name, what) => Object.assign(document.createElement(name), what);
  const button = (words, act) => element("button", { type: "button", textContent: words, onclick: act });

  for (const figure of document.querySelectorAll("figure[data-figure]")) {
    const own = motions[figure.dataset.figure] ?? [];
    if (own.length === 0) continue;
    const still = figure.querySelector("svg");
    const bar = element("p", { className: "live-bar" });
    const frame = element("iframe", { className: "live-frame" });
    // What is printed under the figure gives way to what is true of a motion that was changed.
    const caption = figure.querySelector("figcaption");
    const printed = element("span");
    const changed = element("span", { className: "live-caption", role: "status" });
    const label = caption.querySelector(":scope > strong");
    printed.append(...[...caption.childNodes].filter((part) => part !== label));
    caption.append(printed, changed);
    const say = (words) => {
      changed.textContent = words;
      printed.hidden = words !== "";
    };
    window.addEventListener("message", ({ source, data }) => {
      if (source === frame.contentWindow && typeof data?.caption === "string") say(data.caption);
    });
    const back = button("■ Figure", () => stop?.());
    const open = button("Whole page ↗", async () => {
      window.open(`${await addressOf(own[0][0])}#preset=${frame.dataset.preset}`);
    });
    back.hidden = open.hidden = true;
    const play = async ([kind, preset, words], how) => {
      stop?.();
      frame.title = `The motion of the figure: ${words}`;
      frame.dataset.preset = preset;
      frame.src = `${await addressOf(kind)}#preset=${preset}&embed=${how}`;
      still.classList.add("still");
      still.after(frame);
      back.hidden = open.hidden = false;
      stop = () => {
        frame.remove();
        say("");
        still.classList.remove("still");
        back.hidden = open.hidden = true;
        stop = null;
      };
    };
    for (const each of own) {
      bar.append(button(`▶ ${each[2]}`, async () => {
        await play(each, "2&play=1");
        frame.scrollIntoView({ block: "nearest" });
      }));
    }
    bar.append(back, open);
    caption.before(bar);
    // What a page opens with moves unasked, but for readers who want less motion; a phone has room
    // for the picture alone.
    const opens = figure.id === "figure-opening" && document.createElement("canvas").getContext("webgl");
    const [small, slow] = ["(max-width: 40rem)", "(prefers-reduced-motion: reduce)"].map((each) => matchMedia(each).matches);
    if (opens) play(own[0], `${small ? 1 : 2}&play=${slow ? 0 : 1}`);
  }
})();
