"use strict";

/* ---- what the page is about, in one sentence, and what has just happened, in another ---- */

/* What makes it harder, where it does. */
function setbacksOf({ places, tires }) {
  const told = [];
  if (places.some(({ looks }) => looks)) told.push("a look may miss what is there");
  if (tires === true) told.push("who is low on battery goes home");
  return told.length > 0 ? ` ${sentenceLike(told.join(", and "))}` : "";
}

function sentenceOf(data) {
  return ideaOf(data) + setbacksOf(data);
}

function ideaOf({ robots, mode }) {
  const why = mode === "clear" ? "so that all of it is searched soon" : "so that the find comes early";
  if (robots === 1) return `The robot searches by a plan that was made beforehand, ${why}.`;
  return `The ground was divided among ${robots} robots beforehand, ${why}: each searches its own part, ` +
    "without talking, and where one is lost others search what it left.";
}

const CHAPTERS = new Set(["lost", "takeover", "found", "missed", "battery"]);

/* How many places a robot leaves that is lost, none of which has found another owner yet. */
function lossText(model, event) {
  const owners = ownersOf(model.data);
  for (const earlier of model.events.slice(0, model.events.indexOf(event) + 1)) passOwner(owners, earlier);
  const left = leftBy(owners, event.robot).length;
  const rest = left === 0 ? "Its part was searched." :
    `Nobody is told: who is done with its own part comes for the ${many(left, "place")} that it left.`;
  return `Robot ${robotName(model.data, event.robot)} is lost. ${rest}`;
}

const sentenceLike = (text) => `${text.charAt(0).toUpperCase()}${text.slice(1)}.`;

/* The last thing that a listener would stop for: {kind, text, robots that it is about, t}. */
function chapterAt(model, passed) {
  const event = model.events.slice(0, passed).findLast(({ kind }) => CHAPTERS.has(kind));
  if (event === undefined) {
    const text = model.data.robots === 1 ? "The robot sets out." : `${model.data.robots} robots set out, each into its part.`;
    return { kind: "start", text, robot: -1, t: -Infinity };
  }
  const text = event.kind === "lost" ? lossText(model, event) : sentenceLike(String(event.text || event.kind));
  // Who takes over at the moment of the loss must not hide the loss.
  const loss = event.kind === "takeover" && model.events.find(({ kind, robot, t }) =>
    kind === "lost" && robot === event.territory && t === event.t);
  return { kind: event.kind, robot: event.robot ?? -1, t: event.t, 
    text: loss ? `Robot ${robotName(model.data, loss.robot)} is lost. ${text}` : text };
}

/* Shouted for a while after a loss, however fast it is played. */
function alarmAt(model, passed, now) {
  const loss = model.events.slice(0, passed).findLast(({ kind }) => kind === "lost");
  return loss !== undefined && now - loss.t < ALARM * player.speed ? loss : null;
}

function showStory(model, state, now) {
  const alarm = alarmAt(model, state.passed, now) !== null, chapter = chapterAt(model, state.passed);
  const isLoud = alarm && chapter.kind !== "found", kind = isLoud ? "lost" : chapter.kind;
  if (kind !== $("story").dataset.kind) $("story-icon").setAttribute("href", `#icon-${STORY_ICONS[kind]}`);
  $("story").dataset.kind = kind;
  $("story").classList.toggle("alarm", isLoud);
  $("story").style.setProperty("--robot", validIndex(chapter.robot) ? colour(chapter.robot) : "var(--line)");
  say("story-text", verdictAt(model, state, now) ?? chapter.text);
  $("map").classList.toggle("alarm", alarm);
}

const STORY_ICONS = { start: "robot", lost: "lost", takeover: "takeover", found: "found", missed: "missed", battery: "battery" };
