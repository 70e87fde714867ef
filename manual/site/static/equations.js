// SPDX-License-Identifier: GPL-3.0-or-later
// Sets every formula of the page; what KaTeX does not understand stays as it is written and is told.
document.addEventListener("DOMContentLoaded", () => {
  for (const place of document.querySelectorAll(".tex")) {
    const formula = place.textContent;
    try {
      katex.render(formula, place, { displayMode: place.classList.contains("display"), throwOnError: true });
    } catch (error) {
      place.textContent = formula;
      console.error(error.message);
    }
  }
  document.documentElement.classList.add("formulas-set");
});
