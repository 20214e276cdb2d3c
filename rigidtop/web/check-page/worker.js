/**
 * The judge, away from the page: Python in Pyodide.  It is told where Pyodide is and what rigidtop
 * is, and then texts; it tells of each statement before that is judged, and the answer.
 */

/** @type {Promise<any>} */
let desk;

async function load({ base, code }) {
  self.postMessage({ state: "Loading Pyodide" });
  const { loadPyodide } = await import(`${base}pyodide.mjs`);
  const python = await loadPyodide({ indexURL: base });
  self.postMessage({ state: "Loading NumPy and SymPy" });
  const errors = [];
  const errorCallback = (message) => errors.push(message);
  // SciPy computes the motions by which numbered equations of the lecture are judged, no others.
  for (const name of ["numpy", "sympy", "scipy"])
    await python.loadPackage(name, { messageCallback() {}, errorCallback });
  for (const name of ["numpy", "sympy"])
    if (!(name in python.loadedPackages)) throw new Error(errors.join("; ") || `no ${name}`);
  self.postMessage({ state: "Loading rigidtop" });
  python.unpackArchive(code, "zip", { extractDir: "/rigidtop" });
  python.runPython('import sys; sys.path.insert(0, "/rigidtop")');
  return python.pyimport("rigidtop.commands.browser").Desk();
}

self.onmessage = async ({ data }) => {
  if (data.base) {
    desk = load(data);
    desk.then(
      () => self.postMessage({ state: "" }),
      (error) => self.postMessage({ missing: String(error.message ?? error) }),
    );
    return;
  }
  try {
    const tell = (number, line, nth, count) => self.postMessage({ number, line, nth, count });
    self.postMessage({ answer: JSON.parse((await desk).answer(data.text, data.left, tell)) });
  } catch (error) {
    self.postMessage({ failure: String(error.message ?? error).trim().split("\n").at(-1) });
  }
};
