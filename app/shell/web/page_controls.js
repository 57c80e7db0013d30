// The words and controls beside the canvas: makes real elements of what the program tells (page_controls.h), and tells
// the program when one is used. An element stays the same as long as its id is there, so that the focus never moves by
// itself.
const stage = document.getElementById("stage");
const panel = document.getElementById("controls");
const shown = new Map();  // by id: what is in the page for a control

function use(id, value) {
  Module.ccall("ghostforce_use_control", null, ["string", "number"], [id, value]);
}

function element(name, attributes, ...parts) {
  const made = Object.assign(document.createElement(name), attributes);
  made.append(...parts);
  return made;
}

// A change of what stays the same would be told again.
function setText(node, text) {
  if (node.textContent !== text) node.textContent = text;
}
function setAttribute(node, name, value) {
  if (value === undefined || value === "") node.removeAttribute(name);
  else if (node.getAttribute(name) !== String(value)) node.setAttribute(name, value);
}

// Of each kind: how its elements are made. `node` stands in the page, `main` is what is used or read, `name` has the
// words, `list` the parts.
const makers = {
  group(control, id) {
    const name = element("h2", { id: id + "-name", tabIndex: -1 });
    const list = element("div");
    const node = element("section", {}, name, list);
    node.setAttribute("aria-labelledby", name.id);
    return { node, main: node, name, list };
  },
  dialog(control, id) {
    const made = makers.group(control, id);
    made.node.setAttribute("role", "dialog");
    return made;
  },
  choices() {
    const name = element("legend");
    const list = element("div");
    const node = element("fieldset", {}, name, list);
    return { node, main: node, name, list };
  },
  // A browser gives the group no name by itself.
  folded(control, id) {
    const name = element("summary", { id: id + "-name" });
    const list = element(isListed(control) ? "ul" : "div");
    const node = element("details", {}, name, list);
    node.setAttribute("aria-labelledby", name.id);
    return { node, main: node, name, list };
  },
  rows(control, id) {
    const name = element("h3", { id: id + "-name", tabIndex: -1 });
    const list = element("ul");
    const node = element("div", {}, name, list);
    node.setAttribute("role", "group");
    node.setAttribute("aria-labelledby", name.id);
    return { node, main: node, name, list };
  },
  text() {
    const node = element("p");
    return { node, main: node, name: node };
  },
  told: () => makers.text(),
  status: () => makers.text(),
  alert: () => makers.text(),
  button(control, id) {
    const main = element("button", { type: "button", onclick: () => use(control.id, 0) });
    const about = element("small", { id: id + "-about" });
    return { node: element("div", {}, main, about), main, name: main, about };
  },
  toggle: (control, id) => makers.button(control, id),
  file(control, id) {
    const made = makers.button(control, id);
    made.main.onclick = () => {
      document.getElementById("file-chooser").click();
      use(control.id, 0);
    };
    return made;
  },
  choice(control, id) {
    const main = element("input", { type: "radio", name: "choice", onchange: () => use(control.id, 0) });
    const name = element("span");
    return { node: element("label", {}, main, " ", name), main, name };
  },
  // What stands above it is for eyes: to ears it is one thing, with a name and a value that has its unit.
  range(control, id) {
    const main = element("input", { type: "range", id, oninput: () => use(control.id, Number(main.value)) });
    const name = element("label", { htmlFor: id, id: id + "-name" });
    const about = element("span");
    const above = element("div", {}, name, about);
    above.setAttribute("aria-hidden", "true");
    main.setAttribute("aria-labelledby", name.id);
    return { node: element("div", {}, above, main), main, name, about };
  },
};

// Whether its parts are items of a list.
function isListed(control) {
  return ["folded", "rows"].includes(control.kind) && !control.parts?.some((part) => part.kind === "rows");
}

// What is new or has changed, and is told.
const toldKinds = ["told", "status", "alert"];
const mostTold = 3;
let news = [];
let hasTold = false;
let noticeCount = 0;  // of notices so far, the same words once more counted again

// An element of its own, so that the same words can be told twice, and after those that may not have been told yet.
function announce(words, region = "polite", language = "") {
  const told = document.getElementById(region);
  const each = element("p", { textContent: words });
  setAttribute(each, "lang", language);
  told.append(each);
  while (told.children.length > mostTold) told.firstElementChild.remove();
}

function tellNews() {
  const isFirst = !hasTold;
  hasTold = true;
  for (const [region, isAlert] of [["alerts", true], ["polite", false]]) {
    // With a pause after each.
    const its = news.filter((each) => (each.kind === "alert") === isAlert);
    const words = its.map((each) => each.words.replace(/[^.:!?…]$/, "$&."));
    // What is there at first is read anyway.
    if (words.length > 0 && (isAlert || !isFirst)) {
      announce(words.join(" "), region, its.every((one) => one.language === its[0].language) ? its[0].language : "");
    }
  }
  news = [];
}

function showOne(control, isItem) {
  const id = "control-" + control.id;
  let made = shown.get(control.id);
  if (made === undefined || made.kind !== control.kind || made.isItem !== isItem) {
    made = { kind: control.kind, isItem, ...makers[control.kind](control, id) };
    made.main.id ||= id;
    made.outer = isItem ? element("li", {}, made.node) : made.node;
    made.isNew = true;
    shown.set(control.id, made);
  }
  // In the place of one dialog there may be another one, as of a lesson's steps.
  const changing =
    control.id === "lesson" ? control.words + control.parts[0].words : control.kind === "dialog" && control.words;
  const language = document.documentElement.lang;
  made.isNew ||= changing !== made.changing && made.language === language;
  Object.assign(made, { changing, language });
  if (made.list) made.whenGone = control.about;
  setAttribute(made.main, "lang", control.language);
  if (toldKinds.includes(control.kind) && made.name.textContent !== control.words) news.push(control);
  setText(made.name, control.words);
  const remark = [control.about, control.refusal].filter(Boolean).join(" ");
  if (made.about) {
    setText(made.about, control.kind === "range" ? control.about ?? "" : remark);
    if (control.kind !== "range") setAttribute(made.main, "aria-describedby", remark && made.about.id);
    else setAttribute(made.main, "aria-description", control.refusal);
  }
  if (control.kind === "toggle") setAttribute(made.main, "aria-pressed", control.is_on ? "true" : "false");
  if (control.kind === "choice") made.main.checked = control.is_on === true;
  if (["button", "toggle", "choice", "range"].includes(control.kind)) {
    setAttribute(made.main, "aria-disabled", control.refusal && "true");
  }
  if (control.kind === "range") {
    for (const [name, value] of [["min", control.least], ["max", control.greatest], ["step", control.step]]) {
      setAttribute(made.main, name, value);
    }
    if (document.activeElement !== made.main || Math.abs(made.main.value - control.value) >= control.step / 2) {
      made.main.value = control.value;
    }
    setAttribute(made.main, "aria-valuetext", control.about);
  }
  if (made.list) fill(made.list, control.parts ?? [], isListed(control));
  return made.outer;
}

// Within one parent, elements that stay are never moved. A dialog takes over the groups of its folded list.
function fill(parent, controls, areItems) {
  const wanted = controls.map((control) => showOne(control, areItems));
  for (const node of [...parent.children]) if (!wanted.includes(node)) node.remove();
  wanted.forEach((node, i) => {
    if (parent.children[i] !== node) parent.insertBefore(node, parent.children[i] ?? null);
  });
}

let opener = stage;  // what had the focus when the dialog was opened

// Where the focus goes when its element has gone: from a dialog to what has opened it, else to the heading of what
// stood round it. What is folded takes no focus.
function keepFocus(focused, round) {
  if (!focused || panel.contains(document.activeElement)) return;
  if (round.some((each) => each.id === "control-dialog" && !each.isConnected)) {
    opener.focus();
    if (document.activeElement === opener) return;
  }
  for (const each of round) {
    if (each.isConnected) each.querySelector("h1, h2, h3")?.focus();
    if (panel.contains(document.activeElement)) return;
  }
}

function showControls(told) {
  document.documentElement.lang = told.language;
  setAttribute(stage, "aria-label", told.picture);
  for (const [name, value] of Object.entries(told.colours)) {
    document.documentElement.style.setProperty("--" + name, value);
  }
  const about = document.getElementById("about");
  if (about.textContent !== told.about.join("")) {
    about.replaceChildren(...told.about.map((textContent) => element("p", { textContent })));
  }
  setText(document.getElementById("how-to"), told.how_to);
  const focused = panel.contains(document.activeElement) ? document.activeElement : null;
  const round = [];
  for (let each = focused; each && each !== document.body; each = each.parentElement) round.push(each);
  fill(document.getElementById("control-list"), told.controls, false);
  for (const [id, made] of shown) {
    // Who has begun a lesson, gone on in it or opened a dialog is where it is.
    if (["lesson", "dialog"].includes(id) && made.isNew) {
      if (id === "dialog" && !round.includes(made.node)) opener = focused ?? stage;
      if (focused) made.name.focus();
    }
    made.isNew = false;
    if (!made.outer.isConnected) {
      shown.delete(id);
      if (made.whenGone) announce(made.whenGone);
    }
  }
  keepFocus(focused, round);
  const notice = told.controls.find((each) => each.id === "notice");
  if (notice && told.notice_count !== noticeCount && !news.includes(notice)) news.push(notice);
  noticeCount = told.notice_count ?? noticeCount;
  tellNews();
}

// A ring shows that the canvas has the focus where it has come by the keyboard.
let usesKeyboard = false;
addEventListener("keydown", (event) => usesKeyboard = ["Tab", "Escape"].includes(event.key), true);
addEventListener("pointerdown", () => {
  usesKeyboard = false;
  stage.classList.remove("ringed");
}, true);
stage.addEventListener("focus", () => stage.classList.toggle("ringed", usesKeyboard));
stage.addEventListener("keyup", (event) => { if (event.key === "Tab") stage.classList.add("ringed"); });
stage.addEventListener("blur", () => stage.classList.remove("ringed"));
// In a window of another size what has the focus is still in sight.
addEventListener("resize", () => {
  if (panel.contains(document.activeElement)) document.activeElement.scrollIntoView({ block: "nearest" });
});
panel.addEventListener("keydown", (event) => {
  if (event.key !== "Escape") return;
  const isDialogOpen = shown.has("dialog");
  use("motors-stop", 0);
  if (isDialogOpen) use("dialog-close", 0);
  else stage.focus();
});
