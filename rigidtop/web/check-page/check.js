/** The page: it hands the text to the worker, keeps the limit of time, and shows the answer. */

const find = (id) => document.getElementById(id);
const [text, numbers, status] = ["text", "numbers", "status"].map(find);
const { base, seconds, fetch: command } = JSON.parse(find("data").textContent);

/** @type {Worker | null} */
let worker = null;
let loaded = false;
let timer = 0;
/** The text that is judged now, and the numbers of its statements that took too long. */
let asked = "";
let left = [];
/** What is judged at the moment, and what was given up before. */
let now = null;
let before = "";

function start() {
  const source = new Blob([find("worker").textContent], { type: "text/javascript" });
  worker = new Worker(URL.createObjectURL(source), { type: "module" });
  worker.onmessage = ({ data }) => heard(data);
  worker.onerror = (event) => absent(event.message);
  const code = Uint8Array.from(atob(find("package").textContent), (sign) => sign.charCodeAt(0));
  worker.postMessage({ base: new URL(base, location.href).href, code });
}

function end() {
  clearTimeout(timer);
  worker?.terminate();
  worker = null;
  loaded = false;
  now = null;
}

function judge() {
  if (!worker) start();
  find("check").disabled = true;
  find("stop").hidden = false;
  worker.postMessage({ text: asked, left });
}

function rest(words) {
  clearTimeout(timer);
  now = null;
  find("check").disabled = false;
  find("stop").hidden = true;
  status.textContent = words;
}

function heard(data) {
  clearTimeout(timer);
  if (data.state) status.textContent = `${before}${data.state} …`;
  else if (data.state === "") loaded = true;
  else if (data.missing !== undefined) absent(data.missing);
  else if (data.failure !== undefined) {
    end();
    rest(`rigidtop itself fails here, please report it: ${data.failure}`);
  } else if (data.answer) show(data.answer);
  else {
    now = data;
    status.textContent = `${before}Line ${data.line} is judged, ${data.nth} of ${data.count} …`;
    timer = setTimeout(late, 1000 * seconds);
  }
}

/** Nothing else can stop Python in a browser: a new worker judges all but that. */
function late() {
  const { line, number } = now;
  end();
  left = [...left, number];
  before = `Line ${line} takes longer than ${seconds} s and is left open; the others are judged again. `;
  judge();
}

/** What to do where there is no Pyodide. */
function absent(why) {
  end();
  rest("");
  const port = location.port || "8000";
  const own = location.pathname.split("/").at(-1) || "check.html";
  const code = (words) => Object.assign(document.createElement("code"), { textContent: words });
  status.append(
    `Pyodide, which runs Python in a browser, is not found at ${base}: save this page `,
    "in a folder, run there ", code(command), " (about 400 MB), then ", code(`python -m http.server ${port}`),
    ", and open ", code(`http://localhost:${port}/${own}`), ".",
  );
  if (why) status.append(` (${why.split("\n")[0]})`);
}

function show(answer) {
  rest(answer.error ?? "");
  find("summary").textContent = answer.summary ?? "";
  find("summary").hidden = !answer.summary;
  for (const name of ["wrong", "lines"]) {
    find(name).querySelector("ol").innerHTML = answer[name] ?? "";
    find(name).hidden = !answer[name];
  }
  const wrong = (answer.outcomes ?? []).filter((each) => each.passed === false);
  if (text.value === asked) count(new Set(wrong.map((each) => each.line)));
  else status.textContent = "The text has changed since it was handed in: check it again.";
  if (!answer.error) find("content").focus();
}

/** The numbers of the lines beside the text, those with something wrong marked. */
function count(wrong = new Set()) {
  const lines = text.value.split("\n").map((_, k) => {
    const number = document.createElement("span");
    number.textContent = String(k + 1);
    number.classList.toggle("amiss", wrong.has(k + 1));
    return number;
  });
  numbers.replaceChildren(...lines);
  numbers.scrollTop = text.scrollTop;
}

/** Select a line of the text. */
function lead(line) {
  const above = text.value.split("\n").slice(0, line);
  const last = above.join("\n").length;
  text.focus();
  text.setSelectionRange(last - above.at(-1).length, last);
  text.scrollTop = (line - 3) * parseFloat(getComputedStyle(text).lineHeight);
}

find("form").addEventListener("submit", (event) => {
  event.preventDefault();
  if (find("check").disabled) return;
  asked = text.value;
  left = [];
  before = "";
  if (!loaded) status.textContent = "Loading …";
  judge();
});
find("stop").addEventListener("click", () => {
  const line = now?.line;
  end();
  rest(line ? `Stopped while line ${line} was judged.` : "Stopped.");
});
text.addEventListener("keydown", (event) => {
  if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) find("form").requestSubmit();
});
text.addEventListener("input", () => count());
text.addEventListener("scroll", () => (numbers.scrollTop = text.scrollTop));
find("content").addEventListener("click", (event) => {
  const place = event.target.closest(".place");
  if (place) lead(Number(place.dataset.line));
});
count();
