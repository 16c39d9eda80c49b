"use strict";

/* ---- numbers, events, places ---- */

function showLate(found, planned) {
  const late = finite(found) && finite(planned) ? found - planned : null;
  say("late", late === null ? "" : `(${rounded(Math.abs(late), 2)} s ${late < 0 ? "early" : "late"})`);
}

/* How it came out, each number once it has happened: the totals are those of the whole run, so they come at its end. */
function showOutcome(model, now) {
  const isOver = now >= model.duration - EPSILON, result = model.result ?? {}, totals = isOver ? result : {};
  const past = (t) => (finite(t) && t <= now + EPSILON ? t : null);
  const found = past(foundAt(model)), planned = isOver || found !== null ? result.planned_at : null;
  sayNumber("found-at", found);
  sayNumber("planned-at", planned);
  sayNumber("all-stopped-at", past(result.all_stopped_at));
  sayNumber("scanned-total", totals.scanned);
  for (const name of ["duplicates", "collisions", "deadlocks"]) sayNumber(name, totals[name]);
  sayNumber("messages-terminate", saidAt(model, now));
  for (const name of ["pose", "scan", "command", "lost", "ignored"])
    sayNumber(`messages-${name}`, totals.messages?.[name]);
  for (const name of ["lost", "ignored"]) $(`other-${name}`).hidden = !finite(result.messages?.[name]);
  showLate(found, planned);
}

function showState(model, state) {
  sayNumber("scanned", state.scanned);
  say("faults", state.faults === 0 ? "" : `${state.faults} ${state.faults === 1 ? "fault" : "faults"} so far`);
  const moving = state.robots.filter(({ kind }) => kind === "moving").length;
  $("map").setAttribute("aria-label", `Map: ${state.scanned} of ${state.places.length} places scanned, ` +
    `${state.finds} found, ${moving} of ${state.robots.length} robots moving`);
  $("chart").setAttribute("aria-label", "Planned and achieved chance of the find over time; " +
    "the numbers below are those of this moment");
  state.places.forEach((place, number) => {
    const row = $("place-rows").rows[number];
    row.cells[4].textContent = place.at === null ? "–" : place.at.toFixed(2);
    row.cells[5].textContent = wordOf(place);
  });
}

/* What is known of a place: a door that is shut behind a scan changes nothing of it. */
function wordOf(place) {
  if (place.found !== null) return "found";
  if (place.missed) return "missed";
  if (place.at !== null) return "clear";
  return place.shut ? "shut" : "suspected";
}

function chip(robot) {
  const element = make("span", { class: "chip", title: `robot ${robot}` }, String(robot));
  element.style.background = colour(robot);
  element.style.color = inkOn(robot);
  return element;
}

function eventRow(event) {
  const what = make("span", { class: "what" }, String(event.text || event.kind));
  const button = make("button", { type: "button", "data-kind": event.kind, "data-t": String(event.t), class: "future" },
    make("span", { class: "when" }, event.t.toFixed(1)), icon(iconOf(event.kind)));
  if (validIndex(event.robot)) button.append(chip(event.robot));
  button.append(what);
  button.classList.toggle("fault", SETBACKS.has(event.kind));
  button.classList.toggle("mine", event.kind === "found");
  button.addEventListener("click", () => seek(event.t));
  return make("li", { hidden: "" }, button);
}

function placeRow(place, number) {
  const row = make("tr", {}, make("td", {}, placeName(place, number)), make("td", {}, place.likelihood.toFixed(4)), make("td"),
    make("td", {}, finite(place.planned) ? rounded(place.planned, 2) : "–"), make("td"), make("td"));
  row.cells[2].append(place.territory >= 0 ? chip(place.territory) : "–");
  return row;
}

/* On the time line. In a live run the whole line grows: the marks' places follow from --duration alone. */
function eventMark(event) {
  const mark = icon(iconOf(event.kind));
  mark.dataset.kind = event.kind;
  mark.dataset.t = String(event.t);
  mark.style.left = `calc(100% * ${event.t} / var(--duration))`;
  mark.style.display = "none"; // until it has happened
  // What matters most lies on top where marks meet.
  mark.style.zIndex = event.kind === "found" ? 3 : SETBACKS.has(event.kind) ? 2 : 1;
  return mark;
}

function addRows(events) {
  $("events").append(...events.map(eventRow));
  $("marks").append(...events.filter((event) => event.kind !== "end").map(eventMark));
  $("marks").classList.toggle("dense", $("marks").childElementCount > 40);
}

function listEvents(model) {
  $("events").replaceChildren();
  $("marks").replaceChildren();
  addRows(model.events);
}

/* What has not happened yet is not told. Who goes back sees what has been seen, in grey. */
function markPassed(passed) {
  const list = $("events");
  player.seen = Math.max(player.seen, passed);
  Array.from(list.children).forEach((item, k) => {
    item.hidden = k >= player.seen;
    item.firstChild.classList.toggle("future", k >= passed);
    item.firstChild.classList.toggle("latest", k === passed - 1);
    if (k === passed - 1) item.firstChild.setAttribute("aria-current", "true");
    else item.firstChild.removeAttribute("aria-current");
  });
  const last = player.model.events[player.seen - 1]?.t ?? -1;
  for (const mark of $("marks").children) mark.style.display = Number(mark.dataset.t) <= last ? "" : "none";
  // Never scroll the list away under somebody who reads it.
  if (list.contains(document.activeElement) || list.matches(":hover")) return;
  const latest = list.children[Math.max(0, passed - 1)];
  if (latest) list.scrollTop = latest.offsetTop - list.clientHeight / 2;
}
