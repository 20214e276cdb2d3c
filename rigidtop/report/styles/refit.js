// Equations fit the screen, whatever becomes of its size.
addEventListener("resize", fitted);
fitted();
