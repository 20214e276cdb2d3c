/** The shapes of what the modules of the page hand each other: names that all of them know. */

/** Which page: a heavy body with one point held, a body without torque, or any system. */
type Kind = "heavy-top" | "free" | "system";

/**
 * The unit of every time in a setup: all rates are per second, or all are per day.  By the day it
 * is an asteroid, whose moments are known in units of any one of them only.
 */
type Clock = "s" | "d";

/** Numbers by the names that the Python package uses: `lambda1`, `phi_dot`, `omega3` … */
type Values = Readonly<Record<string, number>>;

/**
 * A body and its state at t = 0, in SI units and radians, but for the clock.
 *
 * A heavy body has lambda1, lambda2, lambda3, M, g, R1, R2, R and the Euler angles and rates theta,
 * theta_dot, phi, phi_dot, psi, omega3.  A free one has lambda1, lambda2, lambda3, omega1, omega2,
 * omega3, and theta, phi, psi of its attitude unless it starts with L along ẑ.
 */
interface Setup {
  readonly kind: Kind;
  readonly clock: Clock;
  readonly values: Values;
}

/** Three numbers, or four of a quaternion, scalar first. */
type Numbers = ArrayLike<number>;

/** What is at one time. */
interface Timed {
  readonly t: number;
}

/** A top or a body at one time. */
interface Sample extends Timed {
  /** As the solver has it. */
  readonly state: Float64Array;
  /** Unit quaternion, body components to space components. */
  readonly q: Numbers;
  /** The same as a matrix, row by row; its columns are e₁, e₂, e₃ in space. */
  readonly rotation: Numbers;
  /** ω in body components. */
  readonly omega: Numbers;
  /** ω in space components. */
  readonly omegaSpace: Numbers;
  /** L in space components. */
  readonly momentum: Numbers;
  /** Torque of gravity about the pivot, in space components. */
  readonly torque: Numbers;
  /** The figure axis in space components. */
  readonly e3: Numbers;
  readonly theta: number;
  /** φ and ψ count turns. */
  readonly phi: number;
  readonly psi: number;
  readonly theta_dot: number;
  /** NaN where sin θ = 0 leaves it open, as ψ̇. */
  readonly phi_dot: number;
  readonly psi_dot: number;
  readonly energy: number;
  /** What friction has taken from the energy since t = 0. */
  readonly taken: number;
  readonly p_phi: number;
  readonly p_psi: number;
}

/** What the exact motion keeps, and by how much it has strayed. */
interface Drift {
  readonly name: string;
  /**
   * Relative: the energy to T₀ + MgR without the part of a constant ω₃, a momentum to what no |L|
   * of the body exceeds, √(2λ(T₀ + MgR)) with the largest moment λ.
   */
  readonly now: number;
  /** The largest since t = 0, of all steps. */
  readonly most: number;
  /** Whether the equations hold it constant by their form, so that it says nothing of errors. */
  readonly exact: boolean;
}

/** A motion that can be moved to any time. */
interface Moving<S extends Timed> {
  /** About how long the fastest change takes, one radian of it; in units of the clock. */
  readonly timescale: number;
  /** The motion at t = 0, and where it is now. */
  readonly start: S;
  readonly now: S;
  /** Samples from the earliest that is kept until now, evenly spaced in time, oldest first. */
  readonly trail: readonly S[];
  /**
   * Move to the time t, at most until performance.now() = deadline; whether it was reached.  Throws
   * an Error with one sentence where the motion ends before.
   */
  go(t: number, deadline?: number): boolean;
  /** Begin anew at t = 0; the trail and the drifts are forgotten. */
  reset(): void;
  /**
   * `count` samples, evenly spaced, from t = 0 to `duration`, or to the farthest that can be
   * computed at once; computed apart from the motion itself.
   */
  ahead(duration: number, count: number): S[];
  drift(): readonly Drift[];
}

/** The motion of a top or a body; made by `createMotion`. */
interface Motion extends Moving<Sample> {
  readonly setup: Setup;
  /** Moments, the centre of mass, and Mg times that, in body components. */
  readonly moments: Numbers;
  readonly arm: Numbers;
  readonly weight: Numbers;
  /** λ₁ = λ₂ with the centre of mass on e₃, and no friction: then ω₃ is constant. */
  readonly symmetric: boolean;
}

/** What can be said of a motion before it moves: see `facts.js`. */
interface Facts {
  /** Regime in words: "waves", "cusps", "loops", "steady precession", "sleeping" …; "" if none. */
  readonly regime: string;
  /** Smallest and largest θ, where θ moves between turning points; else null. */
  readonly turningPoints: readonly [number, number] | null;
  /** Of θ between them, in units of the clock; infinite where it comes to no end. */
  readonly nutationPeriod?: number;
  /** Smallest |ω₃| with a steady precession at θ₀ (heavy symmetric top); else null. */
  readonly smallestSpin: number | null;
  /** Smallest |ω₃| at which the upright top is stable; else null. */
  readonly sleepingSpin: number | null;
  /** (Ω₋, Ω₊) at θ₀; null where there are none. */
  readonly steady: readonly [number, number] | null;
  /** One sentence for a reader: "steady precession at θ₀ = 30° needs |ω₃| ≥ 8.3 rad/s …". */
  readonly verdict: string;
}

/** A slider. */
interface Parameter {
  readonly name: string;
  /** λ₁, φ̇₀ … as text, and as MathML. */
  readonly letter: string;
  readonly math: string;
  readonly meaning: string;
  /** "kg m²", "rad/s" …; "" for an angle, which is shown in degrees. */
  readonly unit: string;
  readonly least: number;
  readonly most: number;
  /** Sliders of what may not be zero are logarithmic. */
  readonly logarithmic: boolean;
  readonly angle: boolean;
  /** Of the start, not of the body: these are always in sight. */
  readonly start: boolean;
}

/** A setup with a name and with what to look at. */
interface Preset {
  readonly name: string;
  readonly title: string;
  /** One or two sentences: what happens and why. */
  readonly about: string;
  readonly setup: Setup;
  readonly view: View;
  readonly layers: readonly Layer[];
  readonly shape: Shape;
  /** Units of the clock for each second that passes. */
  readonly speed: number;
}

type View = "space" | "body";
type Shape = "top" | "wheel" | "brick" | "asteroid" | "T-handle";
type Layer =
  | "e1" | "e2" | "e3" | "omega" | "L" | "torque" | "trail" | "cones" | "poinsot";

/** An equation in the notes' form; each term is an element with data-term="0", "1", … in it. */
interface Equation {
  /** "3.54". */
  readonly tag: string;
  readonly title: string;
  readonly mathml: string;
  /** The function of `equations.js` that gives the values of the terms, and what it takes. */
  readonly function: string;
  /** For symmetric bodies alone, for the others alone, or (null) for all. */
  readonly symmetric: boolean | null;
  readonly terms: readonly Term[];
}

interface Term {
  /** The term as text: "MgR sin θ". */
  readonly text: string;
  /** "torque of gravity". */
  readonly name: string;
  readonly unit: string;
  /** What lights up in the picture: the arrow of what the term is a component of; "" for none. */
  readonly arrow: "" | "L" | "torque";
}

/** What Python writes into the page. */
interface PageData {
  readonly kind: Kind;
  readonly version: string;
  readonly title: string;
  /** Coefficients of DOP853, as SciPy has them. */
  readonly tableau: Tableau;
  readonly parameters: readonly Parameter[];
  readonly presets: readonly Preset[];
  readonly equations: readonly Equation[];
  /** What is shown first: a preset, or a motion of one's own. */
  readonly first: Preset;
  readonly tour: readonly TourStep[];
}

/** What Python writes into the page of a system besides. */
interface SystemData extends PageData {
  /** q, then q̇. */
  readonly state: readonly Letter[];
  /** q, q̇, and the time where the equations have it, and the values of all parameters. */
  readonly start: readonly number[];
  readonly given: readonly number[];
  /** Coordinates that must keep a sign, with it. */
  readonly sides: readonly (readonly [number, number])[];
  /** How many points there are, which of them are bodies, and whether all lie in a plane. */
  readonly points: number;
  readonly bodies: readonly number[];
  readonly planar: boolean;
  /** The point that the picture goes along with, or null. */
  readonly follow: number | null;
  readonly kept: readonly string[];
  /** L and the equations of motion. */
  readonly written: string;
  /** By the names of the presets: of motions that Python has computed. */
  readonly recordings: Readonly<Record<string, Recording>>;
}

/** States at even steps of time, each of `width` numbers of four bytes, and why no more. */
interface Recording {
  readonly step: number;
  readonly width: number;
  readonly rows: string;
  readonly ended: string;
}

type Letter = Pick<Parameter, "letter" | "math" | "meaning" | "unit" | "angle">;

/** Words that may be chosen, each with what a reader sees. */
type Choices = readonly (readonly [string, string])[];

type Theme = "light" | "dark" | "contrast";

/** Everything that the address can say; "" where the reader's system decides, or for none. */
interface State {
  readonly preset: Preset;
  readonly values: Record<string, number>;
  readonly clock: Clock;
  readonly t: number;
  readonly play: "" | "0" | "1";
  readonly view: View;
  readonly layers: readonly Layer[];
  readonly shape: Shape;
  /** Times the speed of the preset. */
  readonly speed: number;
  readonly theme: Theme | "";
  readonly plot: string;
  /** The change that the ghost has. */
  readonly ghost: string;
  /**
   * For a frame: the picture and time alone ("1"), or with the sliders, the verdict and the
   * equations ("2").
   */
  readonly embed: "0" | "1" | "2";
}

/** What the address and the switches of a page offer, with the usual one first; [] for none. */
interface Offers {
  readonly clock: Choices;
  readonly view: Choices;
  readonly shape: Choices;
  readonly plot: Choices;
  readonly ghost: Choices;
  readonly layers: readonly (readonly [Layer, string])[];
}

/** The motion until now, as it is drawn. */
interface Past<S extends Timed> {
  readonly sample: S;
  readonly trail: readonly S[];
}

/** The picture of a motion; what is optional is for pictures in three dimensions. */
interface Picture<S extends Timed, M extends Moving<S>> {
  setMotion(motion: M, shape: Shape): void;
  draw(sample: S, trail: readonly S[], ghost: Past<S> | null): void;
  setColours(colours: Colours): void;
  /** The canvas with the picture in it, just drawn, with smooth edges where asked. */
  picture(finely?: boolean): HTMLCanvasElement | null;
  turn?(azimuth: number, elevation: number): void;
  zoom?(factor: number): void;
  home?(): void;
  resize?(): void;
  setLayers?(layers: readonly Layer[]): void;
  setView?(view: View): void;
  setAside?(aside: boolean): void;
  light?(arrow: Term["arrow"]): void;
}

/** Whatever else follows the motion. */
interface Panel<S extends Timed, M extends Moving<S>> {
  setMotion(motion: M): void;
  draw(sample: S): void;
  setColours(colours: Colours): void;
}

/** What is particular to a page: that of tops and bodies, or that of systems. */
interface Subject<S extends Timed, M extends Moving<S>> {
  readonly offers: Offers;
  /** Throws an Error with one sentence where there is none; `beside` is what it is a ghost of. */
  motionOf(state: State, beside?: M): M;
  factsOf(motion: M): Facts;
  /** The state with one thing changed; throws an Error where it cannot be. */
  ghostOf(ghost: string, state: State, facts: Facts): State;
  plottedOf(motion: M, plot: string): Plotted<S>;
  pictureIn(container: HTMLElement, colours: Colours): Picture<S, M>;
  panels(
    set: (values: Record<string, number>) => void, light: (arrow: Term["arrow"]) => void,
  ): Panel<S, M>[];
  /** The motion in words; without `facts` what is not to be told. */
  describe(motion: M, facts: Facts | null): string;
  /** Names of columns, and rows of the motion as far as `duration`. */
  table(motion: M, duration: number): { names: readonly string[]; rows: (string | number)[][] };
  /** What the sliders are to be after a blow on the axis; null where there is none. */
  blow?(motion: M): Record<string, number> | null;
}

/** A question on a motion, and what is to be seen. */
interface TourStep {
  /** An address of the page. */
  readonly show: string;
  readonly ask: string;
  readonly choices: readonly string[];
  /** The number of the choice that is right. */
  readonly answer: number;
  readonly told: string;
}

/** An explicit Runge-Kutta method with dense output: names as in `scipy.integrate.DOP853`. */
interface Tableau {
  readonly A: readonly (readonly number[])[];
  readonly B: readonly number[];
  readonly E3: readonly number[];
  readonly E5: readonly number[];
  readonly D: readonly (readonly number[])[];
  readonly A_EXTRA: readonly (readonly number[])[];
}

/** Colours of the page's theme, for what is drawn: read from the style sheet by `theme.js`. */
interface Colours {
  readonly paper: string;
  readonly ink: string;
  readonly muted: string;
  readonly rule: string;
  readonly body: string;
  readonly e1: string;
  readonly e2: string;
  readonly e3: string;
  readonly omega: string;
  readonly L: string;
  readonly torque: string;
  readonly trail: string;
  readonly bodyCone: string;
  readonly spaceCone: string;
  readonly polhode: string;
  /** Lines are thicker, and nothing is translucent. */
  readonly highContrast: boolean;
}

type Colour = Exclude<keyof Colours, "highContrast">;

/** Where something is drawn on a sheet, and from where to where an axis goes. */
type Box = Record<"left" | "right" | "top" | "bottom", number>;
type Span = Record<"low" | "high", number>;

/** A sheet to draw on, with the size of its letters. */
interface Paper {
  readonly ctx: CanvasRenderingContext2D;
  readonly width: number;
  readonly height: number;
  readonly em: number;
  readonly colours: Colours;
}

/** Curves of one quantity or more, where their axis goes, and what stands above it. */
interface Graph<S> {
  readonly title: string;
  readonly curves: readonly (readonly [(sample: S) => number, Colour])[];
  follow(old: Span, seen: Span): Span;
  /** Dashed lines. */
  readonly guides: readonly number[];
  now(sample: S): string;
  range: Span;
  /** What is seen of it in the first window of time. */
  expected: Span | null;
}

/** What is plotted of a motion: against time, or the first of two across the other, up or down. */
interface Plotted<S extends Timed> {
  readonly panels: Graph<S>[];
  readonly across: "" | "up" | "down";
  readonly clock: string;
  /** The window of time. */
  readonly duration: number;
  /** How far, in radians, a ghost is. */
  readonly apart: ((one: S, other: S) => number) | null;
}

type Quantity = (sample: Sample) => number;

/** A solver at the end of its last step, which went from `before` to `t`. */
interface Solver {
  readonly t: number;
  readonly before: number;
  /** The next step, with its sign. */
  readonly h: number;
  step(): void;
  /** The state between `before` and `t`. */
  at(t: number, state: Float64Array): void;
}

/** A system at one time: its state, its points (and attitudes), and E. */
interface Moment extends Timed {
  readonly state: Float64Array;
  readonly points: Float64Array;
  readonly energy: number;
}

/** The motion of a system. */
interface Flow extends Moving<Moment> {
  /** The largest |q| and |q̇| of a first look. */
  readonly sizes: readonly number[];
}

/** What decides what a symmetric top does. */
type Top = Record<"M" | "R" | "g" | "lambda1" | "lambda3", number>;

/** A material for ribbons, and how many of their pieces grow old, or 0. */
interface Line {
  readonly material: THREE.ShaderMaterial;
  readonly count: { value: number };
}

type Palette = ReturnType<typeof import("./palette.js").createPalette>;
type Pieces = ReturnType<typeof import("./lines.js").createPieces>;
type Arrow = ReturnType<ReturnType<typeof import("./arrows.js").createArrows>["add"]>;
