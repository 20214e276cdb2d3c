// What a reader may do: fold derivations, copy an equation as LaTeX, choose light or dark.
(() => {
  const root = document.documentElement;
  const contents = document.querySelector(".toc details");
  if (contents && matchMedia("(min-width: 78rem)").matches) contents.open = true;
  const tools = document.createElement("div");
  tools.className = "tools";
  tools.setAttribute("role", "group");
  tools.setAttribute("aria-label", "How the lecture is shown");
  const button = (said, act) => {
    const made = document.createElement("button");
    made.type = "button";
    made.textContent = said;
    made.addEventListener("click", () => act(made));
    tools.append(made);
    return made;
  };
  const ways = [["Results only", "results"], ["Steps", "steps"], ["Steps and reasons", "all"]];
  const choices = ways.map(([said, way]) => [button(said, () => {
    show(way);
    fitted(); // what was hidden, or stands elsewhere now
  }), way]);
  const show = (way) => {
    root.dataset.show = way;
    for (const [made, each] of choices) made.setAttribute("aria-pressed", String(each === way));
  };
  show("all");
  button("Light or dark", () => {
    const dark = root.dataset.theme
      ? root.dataset.theme === "dark"
      : matchMedia("(prefers-color-scheme: dark)").matches;
    root.dataset.theme = dark ? "light" : "dark";
  });
  document.querySelector("#figure-opening, main > header:not(:has(+ #figure-opening))").after(tools);
  for (const row of document.querySelectorAll("[data-tex]")) {
    const copy = document.createElement("button");
    copy.type = "button";
    copy.textContent = "Copy LaTeX";
    copy.addEventListener("click", async () => {
      try {
        await navigator.clipboard.writeText(row.dataset.tex);
        copy.textContent = "Copied";
      } catch {
        prompt("LaTeX", row.dataset.tex);
      }
      setTimeout(() => { copy.textContent = "Copy LaTeX"; }, 1500);
    });
    const link = document.createElement("a");
    link.href = `#${row.id}`;
    link.textContent = "Link";
    const take = document.createElement("div");
    take.className = "take";
    take.append(link, copy);
    row.append(take);
  }
})();
