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
  for (const [each, part] of wide.map((each) => [each, share(each)])) {
    if (part < 1) each.style.fontSize = `${Math.max(0.75, part - 0.02)}em`;
  }
  // Chrome leaves room behind a root for a larger sign than it draws.
  const roots = [...document.querySelectorAll("msqrt")].filter((each) => !each.style.marginRight);
  const ends = roots.map((each) => [each, each.lastElementChild].map((one) => one.getBoundingClientRect().right));
  roots.forEach((each, k) => { each.style.marginRight = `${ends[k][1] - ends[k][0]}px`; });
  for (const each of document.querySelectorAll(".eq, .scroll")) {
    if (share(each) < 1) each.tabIndex = 0;
    else each.removeAttribute("tabindex");
  }
};
