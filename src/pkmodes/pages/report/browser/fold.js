// Sections that fold: going to one unfolds it, a button unfolds all, and so does printing.

const folds = [...document.querySelectorAll(".folded > details")];

function unfoldTarget() {
  const target = document.querySelector(":target");
  const fold = target?.closest(".folded")?.querySelector("details");
  if (!fold) return;
  fold.open = true;
  target.scrollIntoView();
}

const every = document.createElement("button");
every.type = "button";
every.className = "unfold";

function name() {
  every.textContent = folds.every((fold) => fold.open) ? "Fold all" : "Unfold all";
}

every.addEventListener("click", () => {
  const open = !folds.every((fold) => fold.open);
  for (const fold of folds) fold.open = open;
});
for (const fold of folds) fold.addEventListener("toggle", name);
name();
const entry = document.createElement("li");
entry.append(every);
document.querySelector(".contents ol").append(entry);

// A link to a section that was already the last one gone to makes no event of the address.
for (const link of document.querySelectorAll('a[href^="#"]')) {
  link.addEventListener("click", () => { if (link.hash === location.hash) unfoldTarget(); });
}
addEventListener("hashchange", unfoldTarget);
unfoldTarget();

let unfolded = [];
addEventListener("beforeprint", () => {
  unfolded = folds.filter((fold) => !fold.open);
  for (const fold of unfolded) fold.open = true;
});
addEventListener("afterprint", () => { for (const fold of unfolded) fold.open = false; });
