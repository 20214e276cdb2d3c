// Equations fit the screen, whatever becomes of its size.
addEventListener("resize", fitted);
addEventListener("change", fitted); // what was hidden is shown
addEventListener("toggle", fitted, true); // a box was opened
fitted();
