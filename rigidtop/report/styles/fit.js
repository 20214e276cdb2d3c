"use strict";
// An equation that is too wide is broken into more lines, then set smaller; what can still be
// scrolled can be reached by the keys.
const share = (each) => each.clientWidth / each.scrollWidth;
const fitted = () => {
  const equations = [...document.querySelectorAll(".eq")];
  for (const each of equations) {
    each.classList.remove("tight");
    each.style.fontSize = "";
  }
  const wide = equations.filter((each) => share(each) < 1);
  for (const each of wide) each.classList.add("tight");
  const shares = wide.map((each) => [each, share(each)]);
  // Chrome leaves room behind a root for a larger sign than it draws.
  const roots = [...document.querySelectorAll("msqrt")]
    .filter((each) => !each.style.marginRight && each.getClientRects().length)
    .map((each) => [each, ...[each, each.lastElementChild].map((one) => one.getBoundingClientRect().right)]);
  for (const [each, part] of shares) {
    if (part < 1) each.style.fontSize = `${Math.max(0.75, part - 0.02)}em`;
  }
  for (const [each, end, inner] of roots) each.style.marginRight = `${inner - end}px`;
  // A mark stands at the sign of the last line, wherever braces and fractions put that.
  const marks = [...document.querySelectorAll(".row .seal")].flatMap((seal) => {
    const row = seal.closest(".row");
    const sign = [...row.querySelectorAll(".eq mo")].findLast((mo) => /^[=≈<>≤≥≠]$/.test(mo.textContent.trim())
      && mo.getClientRects().length && !mo.closest("munder, msub"));
    if (!sign) return [];
    const { y, height } = sign.getBoundingClientRect();
    return [[seal, y + height / 2 - row.getBoundingClientRect().y - seal.offsetHeight / 2]];
  });
  for (const [seal, down] of marks) seal.style.insetBlock = `${down}px auto`;
  for (const each of document.querySelectorAll(".eq, .scroll")) {
    if (share(each) < 1) each.tabIndex = 0;
    else each.removeAttribute("tabindex");
  }
};
// The letters that a page brings along are there a little later.
document.fonts.ready.then(() => dispatchEvent(new Event("resize")));
