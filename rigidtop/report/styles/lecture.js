// What a reader may do: copy an equation as LaTeX, see what is cited, go there and come back.
(() => {
  document.querySelector(".toc details")?.toggleAttribute("open", matchMedia("(min-width: 78rem)").matches);
  for (const row of document.querySelectorAll("[data-tex]")) {
    row.insertAdjacentHTML("beforeend", `<div class="take"><a href="#${row.id}">Link</a><button type="button">Copy LaTeX</button></div>`);
    const copy = row.lastChild.lastChild;
    copy.addEventListener("click", () => navigator.clipboard.writeText(row.dataset.tex).then(() => {
      copy.textContent = "Copied";
      setTimeout(() => { copy.textContent = "Copy LaTeX"; }, 1500);
    }).catch(() => prompt("LaTeX", row.dataset.tex)));
  }
  // A citation that is pointed at, focused or tapped has a card with its line, whose number leads there.
  const [card, back] = document.querySelectorAll("#card, .back");
  const followed = [];
  let cited = null;
  const linkOf = ({ target }) =>
    card.contains(target) ? cited : target.closest?.("main a[href^='#']:not(.place, .take a)");
  const show = (link) => {
    if (link === cited) return;
    cited?.removeAttribute("aria-describedby");
    const place = link && document.getElementById(link.hash.slice(1));
    card.hidden = !place?.matches(".row, .marked");
    cited = card.hidden ? null : link;
    if (card.hidden) return;
    card.innerHTML = [...(place.matches(".row") ? place.querySelectorAll(".eq, .place") : [place])]
      .map((part) => part.outerHTML.replace(/ (id|tabindex)="[^"]*"/g, "")).join("");
    link.setAttribute("aria-describedby", "card");
    const { left, y, bottom } = link.getClientRects()[0];
    const low = bottom + card.offsetHeight < innerHeight ? bottom : y - card.offsetHeight;
    card.style.insetBlockStart = `${scrollY + low}px`;
    card.style.left = `${Math.max(4, Math.min(left, innerWidth - card.offsetWidth - 20))}px`;
  };
  for (const kind of ["pointerover", "focusin"]) addEventListener(kind, (event) => show(linkOf(event)));
  addEventListener("keydown", ({ key }) => key === "Escape" && show(null));
  addEventListener("click", (event) => {
    const link = event.target.closest?.("a") && linkOf(event);
    if (!link) return;
    show(link);
    if (event.pointerType === "touch" && cited === event.target) return event.preventDefault();
    back.hidden = !followed.push(link);
    show(null);
  });
  back.addEventListener("click", () => {
    const link = followed.pop();
    back.hidden = !followed.length;
    link.scrollIntoView({ block: "center" });
    link.focus({ preventScroll: true });
    show(null);
  });
  // The section that is read is marked in the contents.
  const entries = [...document.querySelectorAll(".toc a")].map((link) => [link, document.getElementById(link.hash.slice(1))]);
  const read = () => {
    const now = entries.findLast(([, place]) => place.getBoundingClientRect().y < innerHeight / 3);
    for (const each of entries) each[0].setAttribute("aria-current", String(each === now));
  };
  addEventListener("scroll", read, { passive: true });
  read();
  // #3.57 leads to its equation.
  const open = () => {
    const name = `claim-${location.hash.slice(1).replace(".", "-")}`;
    if (document.getElementById(name)) location.replace(`#${name}`);
  };
  addEventListener("hashchange", open);
  open();
})();
