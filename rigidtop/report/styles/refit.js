// Equations fit the screen, whatever becomes of its size.
addEventListener("resize", fitted);
addEventListener("toggle", fitted, true); // a box was opened
fitted();
