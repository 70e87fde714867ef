// SPDX-License-Identifier: GPL-3.0-or-later
// In the place of the theme's own script, which Debian ships as a module that browsers refuse in files:
// light and dark, and the section in view in the contents beside the page.
(() => {
  const cycle = { auto: "dark", dark: "light", light: "auto" };

  const setTheme = (mode) => {
    document.body.dataset.theme = mode;
    try {
      localStorage.setItem("theme", mode);
    } catch {
      // a browser that keeps nothing
    }
  };

  const markSection = () => {
    const links = [...document.querySelectorAll(".toc-tree li > a[href^='#']")];
    let current = null;
    for (const link of links) {
      const id = decodeURIComponent(link.getAttribute("href").slice(1));
      const section = id && document.getElementById(id);
      if (section && section.getBoundingClientRect().top < 120) {
        current = link;
      }
      link.parentElement.classList.remove("scroll-current");
    }
    current?.parentElement.classList.add("scroll-current");
  };

  document.addEventListener("DOMContentLoaded", () => {
    document.documentElement.classList.remove("no-js");
    for (const button of document.getElementsByClassName("theme-toggle")) {
      button.addEventListener("click", () => setTheme(cycle[document.body.dataset.theme] ?? "auto"));
    }
    let waits = false;
    window.addEventListener("scroll", () => {
      if (!waits) {
        waits = true;
        requestAnimationFrame(() => {
          markSection();
          waits = false;
        });
      }
    });
    markSection();
  });
})();
