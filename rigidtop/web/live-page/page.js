/** The page: what is set becomes a motion, which is moved on and drawn frame by frame. */

import { createAddressBar, createAddresses } from "./address.js";
import { createChecks, createChoice, createPick, createPresets } from "./chips.js";
import { createClock } from "./clock.js";
import { createSliders, shown } from "./controls.js";
import { createKeys } from "./keys.js";
import { createMeter } from "./meter.js";
import { createPreview } from "./preview.js";
import { button, createNotice, element, find, messageOf } from "./shell.js";
import { createTake, separated } from "./take.js";
import { preferredTheme, readColours, setTheme, THEMES } from "./theme.js";
import { createTimePlots } from "./time_plots.js";
import { createTour } from "./tour.js";
import { createTransport } from "./transport.js";
import { createVerdict } from "./verdict.js";

/** A single step and the farthest time that an address may ask for, in times of the motion. */
const STEP = 1 / 10;
const FARTHEST = 1e5;
/** While it stands at t = 0 the page shows what is to come in so many seconds of playing. */
const PREVIEW = 12;
/** How often the picture's description is told anew, in ms. */
const DESCRIPTION = 5000;
/** Where there is no room for the map over the picture, as in style.css. */
const narrow = matchMedia("(max-width: 700px), (max-width: 1000px) and (orientation: portrait)");
/** How a sentence on a ghost that there can't be begins. */
const NO_GHOST = "Nothing to compare";
/** What may be chosen of the looks, with words. */
const LOOKS = /** @type {const} */ ({
  view: "seen from", shape: "drawn as", plot: "plot", ghost: "compare with",
});

/**
 * Fill the page.
 *
 * @template {Timed} S
 * @template {Moving<S>} M
 * @param {PageData} data
 * @param {Subject<S, M>} subject
 */
export function createPage(data, subject) {
  const { presets } = data;
  const { offers } = subject;
  const prefersStill = matchMedia("(prefers-reduced-motion: reduce)");
  const addresses = createAddresses(data, offers);

  let state = addresses.stateOf(data.first);
  let motion = subject.motionOf(state);
  let facts = subject.factsOf(motion);
  /**
   * The same body with one setting changed.
   *
   * @type {M | null}
   */
  let ghost = null;
  /** What is asked for by the sliders and not yet tried, with the name of the one moved last. */
  let asked = /** @type {{ values: Record<string, number>, name: string } | null} */ (null);
  /** Why there is no more of the motion. */
  let ended = "";
  let described = -Infinity;
  let frames = 0;

  setTheme(preferredTheme());
  find("title").textContent = data.title;
  find("version").textContent =
    `rigidtop ${data.version}. This page needs no network and sends nothing.`;

  const tools = find("tools");
  const notice = createNotice();
  const picture = find("scene");
  const scene = sceneIn(picture);
  const plots = createTimePlots(find("plots"), subject.plottedOf);
  const panels = subject.panels(
    (values) => sliders.setAll(values), (arrow) => scene?.light?.(arrow));
  const meter = createMeter(find("meter"));

  const clock = createClock({
    now: () => motion.now.t,
    go,
    rate: () => state.preset.speed * state.speed,
    before: tryAsked,
    draw,
    moved: (rests) => {
      if (rests) described = -Infinity;
      address.changed();
    },
  });
  const preview = createPreview(
    () => {
      const duration = PREVIEW * state.preset.speed;
      const count = Math.round(Math.min(Math.max(300, (4 * duration) / motion.timescale), 3000));
      return [motion, ghost].map((each) => each?.ahead(duration, count) ?? []);
    },
    () => clock.wake(),
  );
  const address = createAddressBar(currentAddress);
  const { blow } = subject;
  /** The motion goes on from where it is, with more θ̇. */
  const push = blow && (() => {
    const struck = blow(motion);
    if (struck) sliders.setAll(struck);
  });
  const transport = createTransport(find("transport"), {
    toStart,
    toggle: clock.toggle,
    step,
    setSpeed: (speed) => {
      state = { ...state, speed };
      clock.wake();
    },
    push,
  });
  const examples = createPresets(find("presets"), presets, choosePreset);
  const verdict = createVerdict(find("verdict"), (rate) => {
    sliders.setAll({ theta_dot: 0, phi_dot: rate });
  });
  const sliders = createSliders(
    { start: find("start"), body: find("body") },
    data.kind,
    data.parameters,
    (values, name) => {
      asked = { values, name };
      clock.wake();
    },
  );
  const switches = find("switches");
  const layers = createChecks(switches, "Drawn", offers.layers, (chosen) => {
    state = { ...state, layers: chosen };
    showLooks();
  });
  const looks = /** @type {(keyof typeof LOOKS)[]} */ (Object.keys(LOOKS))
    .filter((name) => offers[name].length > 1)
    .map((name) => {
      const create = name === "view" ? createChoice : createPick;
      const { show } = create(switches, LOOKS[name], offers[name], (chosen) => {
        state = { ...state, [name]: chosen };
        if (name === "shape") scene?.setMotion(motion, state.shape);
        if (name === "plot") plots.setMotion(motion, ghost, chosen);
        if (name === "ghost") setGhost();
        showLooks();
      });
      return () => show(state[name]);
    });
  const themes = element(
    "select",
    { "aria-label": "Theme" },
    ...THEMES.map(([name, words]) => element("option", { value: name }, words)),
  );
  const tour = data.tour.length === 0 ? null : createTour(find("tour"), data.tour, {
    show: (hash, plays) => readState(state.theme ? `${hash}&theme=${state.theme}` : hash, plays),
    end: () => {
      fit();
      starter.focus();
    },
  });
  const keys = createKeys(picture, /** @type {HTMLDialogElement} */ (find("keys")), {
    play: () => (clock.playing ? clock.pause() : clock.toggle(1)),
    backwards: () => clock.toggle(-1),
    step,
    toStart,
    push,
    zoom: (factor) => scene?.zoom?.(factor),
    turn: (azimuth, elevation) => scene?.turn?.(azimuth, elevation),
    home: () => scene?.home?.(),
    otherView: offers.view.length === 0 ? undefined : () => {
      state = { ...state, view: state.view === "space" ? "body" : "space" };
      showLooks();
    },
    preset: (index) => {
      if (index < presets.length) choosePreset(presets[index]);
    },
    present,
    tour: tour?.start,
  });
  createTake(tools, {
    name: () => `${data.kind}-${state.preset.name}`,
    scene: picture,
    picture: (finely) => scene?.picture(finely) ?? null,
    link: () => `${location.href.split("#")[0]}${currentAddress()}`,
    table: () =>
      separated(subject.table(motion, Math.max(motion.now.t, PREVIEW * state.preset.speed))),
    say: (sentence) => notice.say([sentence]),
  });
  const tool = (/** @type {string} */ words, /** @type {string} */ title, act = () => {}) => {
    const made = button(words, act, { title });
    tools.append(made);
    return made;
  };
  const starter = tool("Tour", "Guided tour (T)", tour?.start);
  starter.hidden = !tour;
  tool("Present", "Show it to a room (P)", present);
  tools.append(themes);
  tool("?", "Keys (?)", keys.help).setAttribute("aria-label", "Keys");

  document.addEventListener("fullscreenchange", () => {
    if (!document.fullscreenElement) document.body.classList.remove("presenting");
    fit();
  });
  themes.addEventListener("change", () => {
    state = { ...state, theme: /** @type {Theme} */ (themes.value) };
    showTheme();
    address.changed();
  });
  for (const query of ["(prefers-color-scheme: dark)", "(prefers-contrast: more)"]) {
    matchMedia(query).addEventListener("change", showTheme);
  }
  narrow.addEventListener("change", placeMap);
  find("corner").addEventListener("toggle", placeMap);
  // The address holds the state, so the link to the controls must not set it.
  document.querySelector(".skip")?.addEventListener("click", (event) => {
    event.preventDefault();
    find("column").focus();
  });
  // As it was then: meanwhile the page may have written the address anew.
  window.addEventListener("hashchange", ({ newURL }) => readState(new URL(newURL).hash));
  new ResizeObserver(fit).observe(picture);

  // For tests and the curious, and for who shows the page in a frame.
  Object.assign(window, {
    rigidtop: {
      get motion() {
        return motion;
      },
      get playing() {
        return clock.playing;
      },
      /** Frames drawn since the page was opened. */
      get frames() {
        return frames;
      },
    },
  });
  readState(location.hash);

  /** The scene, or one sentence in its place. */
  function sceneIn(/** @type {HTMLElement} */ container) {
    try {
      return subject.pictureIn(container, readColours());
    } catch (error) {
      const sentence = `${messageOf(error)} All the rest goes on without it.`;
      container.replaceChildren(element("p", { class: "absent" }, sentence));
      return null;
    }
  }

  /** The picture has another size. */
  function fit() {
    scene?.resize?.();
    clock.wake();
  }

  /** Towards t; where the motion ends it stands. */
  function go(/** @type {number} */ t, /** @type {number} */ deadline) {
    ended = "";
    try {
      const reached = motion.go(t, deadline);
      moveGhost();
      return reached;
    } catch (error) {
      ended = `the motion ends here: ${messageOf(error)}`;
      clock.pause();
      return true;
    }
  }

  /** The ghost to where the motion is, as far as there is one. */
  function moveGhost() {
    try {
      ghost?.go(motion.now.t);
    } catch {
      // It stays where it ended.
    }
  }

  /**
   * Take the state from an address.
   *
   * @param {string} hash
   * @param {boolean} [plays] whatever the address says
   */
  function readState(hash, plays) {
    const { state: said, complaints } = addresses.read(hash);
    let next = said;
    let found;
    try {
      found = subject.motionOf(next);
    } catch (error) {
      complaints.push(
        `there is no motion as the address has it: ${messageOf(error)}; ` +
          `“${next.preset.title}” is shown`,
      );
      next = { ...next, values: { ...next.preset.setup.values }, clock: next.preset.setup.clock };
      found = subject.motionOf(next);
    }
    const farthest = FARTHEST * found.timescale;
    if (next.t > farthest) {
      const most = Number(farthest.toPrecision(3));
      complaints.push(`the address says t=${next.t}, which is more than ${most}; 0 is used`);
      next = { ...next, t: 0 };
    }
    state = next;
    document.body.classList.toggle("embedded", state.embed !== "0");
    document.body.classList.toggle("settable", state.embed === "2");
    placeMap();
    notice.say(complaints);
    start(found, state.play ? state.play === "1" : (plays ?? true) && !prefersStill.matches);
    if (state.t > 0) clock.setGoal(state.t);
  }

  /** The map of starts, over a corner of the picture or, on a phone, below what it sets. */
  function placeMap() {
    const corner = find("corner");
    if (narrow.matches) find("more").prepend(corner);
    else picture.after(corner);
    scene?.setAside?.(corner.offsetWidth > 0 && !narrow.matches && corner.hasAttribute("open"));
  }

  /** What is shown now, as an address. */
  function currentAddress() {
    return addresses.write({ ...state, t: motion.now.t, play: clock.playing ? "1" : "0" });
  }

  /** The picture and one sentence on the whole screen, or all as it was. */
  function present() {
    const shows = document.body.classList.toggle("presenting");
    if (shows) document.documentElement.requestFullscreen?.().catch(() => {});
    else if (document.fullscreenElement) document.exitFullscreen().catch(() => {});
    fit();
  }

  /** Show a motion that begins, with everything that belongs to it. */
  function start(/** @type {M} */ next, /** @type {boolean} */ plays) {
    asked = null;
    clock.start(plays);
    begin(next);
    sliders.show(state.values, state.clock, state.preset);
    showTheme();
    showLooks();
    showFacts();
  }

  function begin(/** @type {M} */ next) {
    motion = next;
    facts = subject.factsOf(motion);
    ended = "";
    described = -Infinity;
    scene?.setMotion(motion, state.shape);
    setGhost();
    for (const panel of panels) panel.setMotion(motion);
    clock.fresh();
  }

  /** The ghost that is asked for, at the time at which the motion is, if there is such a body. */
  function setGhost() {
    ghost = null;
    notice.forget(NO_GHOST);
    if (state.ghost) {
      const words = offers.ghost.find(([name]) => name === state.ghost)?.[1];
      try {
        ghost = subject.motionOf(subject.ghostOf(state.ghost, state, facts), motion);
        moveGhost();
      } catch (error) {
        notice.say([`${NO_GHOST} with ${words}: ${messageOf(error)}`]);
      }
    }
    preview.forget();
    plots.setMotion(motion, ghost, state.plot);
  }

  function choosePreset(/** @type {Preset} */ preset) {
    const { theme, speed, embed, plot, ghost: ghostNow } = state;
    state = { ...addresses.stateOf(preset), theme, speed, embed, plot, ghost: ghostNow };
    start(subject.motionOf(state), clock.playing);
  }

  /** What the sliders ask for, if there is such a body; if not, the slider says why. */
  function tryAsked() {
    if (!asked) return;
    const { values, name } = asked;
    asked = null;
    const wanted = { ...state, values };
    let found;
    try {
      found = subject.motionOf(wanted);
    } catch (error) {
      sliders.refuse(name, messageOf(error), () =>
        sliders.show(state.values, state.clock, state.preset),
      );
      return;
    }
    state = wanted;
    begin(found);
    showFacts();
    address.changed();
  }

  function showFacts() {
    sliders.setMarks(facts);
    verdict.show(facts, sliders.limits("phi_dot"));
    const usual = state.preset.setup.values;
    const changed = data.parameters.some(({ name }) => state.values[name] !== usual[name]);
    examples.show(state.preset, changed);
    if (state.embed === "2") window.parent.postMessage({ caption: changed ? caption() : "" }, "*");
  }

  /** What stands under a figure that is played here, of which something is changed. */
  function caption() {
    const { preset, values, clock: unit } = state;
    const given = data.parameters
      .filter(({ name }) => name !== "lambda2" || values.lambda2 !== values.lambda1)
      .map((each) => `${each.letter} = ${shown(each, values[each.name], unit)}`);
    const said = facts.verdict.replace(/_/g, "");
    return `${preset.title}, changed to ${given.join(", ")}. ${said}`;
  }

  function showLooks() {
    scene?.setLayers?.(state.layers);
    scene?.setView?.(state.view);
    layers.show(state.layers);
    for (const show of looks) show();
    address.changed();
    clock.wake();
  }

  function showTheme() {
    const theme = state.theme || preferredTheme();
    setTheme(theme);
    themes.value = theme;
    const colours = readColours();
    for (const each of [scene, plots, ...panels]) each?.setColours(colours);
    clock.wake();
  }

  /** A little on or back. */
  function step(/** @type {1 | -1} */ way) {
    clock.step(way * STEP * motion.timescale);
  }

  /** Begin anew, from the start itself. */
  function toStart() {
    motion.reset();
    ghost?.reset();
    ended = "";
    described = -Infinity;
    address.changed();
    clock.fresh();
  }

  function draw(/** @type {number} */ now) {
    const sample = motion.now;
    const { ahead: [trail, ghostTrail], mirrored: [past, ghostPast] } = trailsNow();
    scene?.draw(sample, past, ghost && { sample: ghost.now, trail: ghostPast });
    plots.draw({ sample, trail }, ghost && { sample: ghost.now, trail: ghostTrail });
    for (const panel of panels) panel.draw(sample);
    meter.draw(motion.drift());
    const step = STEP * motion.timescale;
    transport.show({
      t: sample.t,
      clock: state.clock,
      digits: Math.min(Math.max(2, Math.ceil(-Math.log10(step))), 15),
      playing: clock.playing,
      direction: clock.direction,
      factor: state.speed,
      rate: state.preset.speed * state.speed,
      note: ended || clock.note(state.clock),
    });
    if (now > described + DESCRIPTION) {
      described = now;
      const plays = clock.playing ? "playing" : "paused";
      picture.setAttribute(
        "aria-label", `${subject.describe(motion, asking() ? null : facts)}; ${plays}.`);
    }
    frames += 1;
  }

  /**
   * The trails of the motion and its ghost until now, for the plots and for the scene; at rest at
   * t = 0 what is to come, as soon as it is computed.
   */
  function trailsNow() {
    const trails = [motion.trail, ghost?.trail ?? []];
    const usual = { ahead: trails, mirrored: trails };
    const rests = !clock.runs && motion.now.t === 0;
    if (!rests) preview.forget();
    return (rests && !asking() && preview.shown()) || usual;
  }

  /** Whether the tour asks what will happen: then nothing on the page tells. */
  function asking() {
    return document.body.classList.contains("asking");
  }
}
