// Folded sections: a link to one unfolds it, a button unfolds all, and printing does so while it lasts.

const folds = [...document.querySelectorAll(".folded > details")];

function unfoldTarget() {
  const target = document.querySelector(":target");
  const fold = target?.closest(".folded")?.querySelector("details");
  if (!fold) return;
  fold.open = true;
  target.scrollIntoView();
}

const foldButton = document.createElement("button");
foldButton.type = "button";
foldButton.className = "unfold";

function updateButtonText() {
  foldButton.textContent = folds.every((fold) => fold.open) ? "Fold all" : "Unfold all";
}

foldButton.addEventListener("click", () => {
  const open = !folds.every((fold) => fold.open);
  for (const fold of folds) fold.open = open;
});
for (const fold of folds) fold.addEventListener("toggle", updateButtonText);
updateButtonText();
const listItem = document.createElement("li");
listItem.append(foldButton);
document.querySelector(".contents ol").append(listItem);

// A click on a link to the address that is already shown causes no hashchange event.
for (const link of document.querySelectorAll('a[href^="#"]')) {
  link.addEventListener("click", () => { if (link.hash === location.hash) unfoldTarget(); });
}
addEventListener("hashchange", unfoldTarget);
unfoldTarget();

let openedForPrint = [];
addEventListener("beforeprint", () => {
  openedForPrint = folds.filter((fold) => !fold.open);
  for (const fold of openedForPrint) fold.open = true;
});
addEventListener("afterprint", () => { for (const fold of openedForPrint) fold.open = false; });
