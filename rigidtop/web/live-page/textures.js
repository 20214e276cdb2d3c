/** What is painted on bodies and on the table: wood with a spiral, and a soft shadow. */

const SIZE = 512;
const WOOD = { light: "#d9ad75", grain: "#a8733f", paint: "#6d2b18" };
/** Turns of the spiral from the hub to the rim. */
const TURNS = 1.5;

/** A texture and the sheet it is drawn on. */
function painted(
  /** @type {number} */ size, /** @type {(ctx: CanvasRenderingContext2D) => void} */ paint,
) {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = size;
  const ctx = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  const texture = new THREE.CanvasTexture(canvas);
  paint(ctx);
  return { texture, ctx };
}

/**
 * A turned wheel seen along its axis: grain, and a spiral that shows how it spins; in high contrast
 * the spiral on one colour.
 */
export function createWheelFace() {
  const { texture, ctx } = painted(SIZE, () => {});
  return {
    texture,
    paint(/** @type {Colours} */ { body, paper, highContrast }) {
      ctx.fillStyle = highContrast ? body : WOOD.light;
      ctx.fillRect(0, 0, SIZE, SIZE);
      if (!highContrast) drawGrain(ctx);
      drawSpiral(ctx, highContrast ? paper : WOOD.paint);
      texture.needsUpdate = true;
    },
  };
}

/** Lines along the wood, the same every time. */
function drawGrain(/** @type {CanvasRenderingContext2D} */ ctx) {
  ctx.strokeStyle = WOOD.grain;
  for (let n = 0; n < 56; n++) {
    const y = (n + 0.5 * Math.sin(7.3 * n)) * (SIZE / 56);
    ctx.globalAlpha = 0.16 + 0.14 * Math.sin(3.7 * n + 1);
    ctx.lineWidth = 1.6 + 1.2 * Math.sin(5.1 * n);
    ctx.beginPath();
    for (let x = 0; x <= SIZE; x += 16) {
      ctx.lineTo(x, y + 6 * Math.sin(x / 90 + n / 9) + 2 * Math.sin(x / 31 + 2.3 * n));
    }
    ctx.stroke();
  }
  ctx.globalAlpha = 1;
}

/** A band that winds outwards and grows wider. */
function drawSpiral(
  /** @type {CanvasRenderingContext2D} */ ctx, /** @type {string} */ colour,
) {
  const STEPS = 240;
  const edge = (/** @type {number} */ n, /** @type {number} */ wide) => {
    const part = n / STEPS;
    const angle = 2 * Math.PI * TURNS * part + wide * (0.25 + 0.3 * part);
    const radius = (0.16 + 0.86 * part) * (SIZE / 2);
    ctx.lineTo(SIZE / 2 + radius * Math.cos(angle), SIZE / 2 + radius * Math.sin(angle));
  };
  ctx.fillStyle = colour;
  ctx.beginPath();
  for (let n = 0; n <= STEPS; n++) edge(n, 1);
  for (let n = STEPS; n >= 0; n--) edge(n, -1);
  ctx.fill();
}

/** Dark in the middle, nothing at the rim. */
export function shadowTexture() {
  return painted(128, (ctx) => {
    const fade = ctx.createRadialGradient(64, 64, 0, 64, 64, 64);
    fade.addColorStop(0, "rgb(0 0 0 / 100%)");
    fade.addColorStop(0.55, "rgb(0 0 0 / 75%)");
    fade.addColorStop(1, "rgb(0 0 0 / 0%)");
    ctx.fillStyle = fade;
    ctx.fillRect(0, 0, 128, 128);
  }).texture;
}
