// Formulas, tables and code that are wider than the page scroll: let the keyboard reach them.
(function () {
  "use strict";

  function update() {
    document.querySelectorAll(".formula, .highlight pre, .table-wrapper").forEach(function (part) {
      if (part.scrollWidth > part.clientWidth) {
        part.setAttribute("tabindex", "0");
      } else {
        part.removeAttribute("tabindex");
      }
    });
  }

  window.addEventListener("load", update);
  window.addEventListener("resize", update);
})();
