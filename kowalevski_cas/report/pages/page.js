// What a link to a formula leads to is shown beside it; formulas and errata can be copied.
const glance = document.body.appendChild(document.createElement("div"));
glance.className = "glance";
glance.hidden = true;
const shownOf = target => {
  const found = document.createDocumentFragment();
  const parts = target.matches(".claim") ? [target.querySelector(".head"),
    ...[...target.querySelectorAll(":scope > .display")].slice(0, 3),
    ...[...target.querySelectorAll(".record")].filter(one => one.textContent.startsWith("What rests"))]
    : [target];
  for (const part of parts.filter(Boolean)) {
    const copy = part.cloneNode(true);
    for (const one of [copy, ...copy.querySelectorAll("[id]")]) one.removeAttribute("id");
    copy.querySelectorAll(".copy").forEach(one => one.remove());
    found.append(copy);
  }
  return found;
};
const show = link => {
  const target = document.getElementById(decodeURIComponent(link.hash.slice(1)));
  const claim = target?.closest(".claim") ?? target;
  if (!claim?.matches(".claim, .display") || claim.contains(link)) return;
  glance.replaceChildren(shownOf(claim));
  glance.hidden = false;
  const at = link.getBoundingClientRect(), size = glance.getBoundingClientRect();
  const left = Math.max(8, Math.min(at.left, document.documentElement.clientWidth - size.width - 8));
  const above = at.bottom + size.height + 12 > innerHeight && at.top > size.height + 12;
  glance.style.left = `${left + scrollX}px`;
  glance.style.top = `${(above ? at.top - size.height - 6 : at.bottom + 6) + scrollY}px`;
};
const hide = () => { glance.hidden = true; };
for (const link of document.querySelectorAll("main a[href^='#']")) {
  link.addEventListener("pointerenter", event => { if (event.pointerType === "mouse") show(link); });
  link.addEventListener("focus", () => { if (link.matches(":focus-visible")) show(link); });
  link.addEventListener("pointerleave", hide);
  link.addEventListener("blur", hide);
}
addEventListener("keydown", event => { if (event.key === "Escape") hide(); });

// The lines of a box in the picture of what rests on what, and the boxes at their other ends.
for (const picture of document.querySelectorAll(".graph svg")) {
  const box = link => decodeURIComponent(link.getAttribute("href").slice("#claim.".length));
  const links = [...picture.querySelectorAll("a")];
  const lines = [...picture.querySelectorAll(".line")].map(line => [line, line.dataset.ends.split(" ")]);
  const mark = own => {
    const near = new Set();
    for (const [line, [from, ...to]] of lines) {
      const joined = from === own || to.includes(own);
      line.classList.toggle("near", joined);
      if (joined) for (const end of from === own ? to : [from]) near.add(end);
    }
    for (const link of links) link.classList.toggle("near", near.has(box(link)));
  };
  for (const link of links) {
    for (const event of ["pointerenter", "focus"]) link.addEventListener(event, () => mark(box(link)));
    for (const event of ["pointerleave", "blur"]) link.addEventListener(event, () => mark());
  }
}

const copied = async text => {
  try { await navigator.clipboard.writeText(text); } catch {  // a page from a file may not
    const field = document.body.appendChild(document.createElement("textarea"));
    field.value = text;
    field.select();
    document.execCommand("copy");
    field.remove();
  }
};
for (const button of document.querySelectorAll(".copy button")) {
  button.parentElement.hidden = false;
  button.addEventListener("click", async () => {
    const words = button.textContent;
    await copied(button.dataset.text);
    button.textContent = "copied";
    setTimeout(() => { button.textContent = words; }, 1500);
  });
}
