"use strict";

/* ---- small things ---- */

const $ = (id) => document.getElementById(id);
const EPSILON = 1e-6; // seconds: an event at 12.3 has happened at 12.3, whatever the sum of the ticks says
const SPEEDS = [1, 2, 5, 10, 20];
const TRAIL = 8; // seconds
const PULSE = 1.2; // seconds that an event glows on the map
const ALARM = 3; // seconds of the clock on the wall, at any speed, that a loss is shouted
const FAULTS = new Set(["lost", "stuck", "reset", "shut", "loss", "slip", "collision", "deadlock"]);
const SETBACKS = new Set([...FAULTS, "missed", "battery"]); // no faults of anything, but not what one hopes for
const stillMedia = matchMedia("(prefers-reduced-motion: reduce)");

const clamp = (value, low, high) => Math.min(high, Math.max(low, value));
const finite = (value) => typeof value === "number" && Number.isFinite(value);
const many = (count, noun) => `${count} ${noun}${count === 1 ? "" : "s"}`;
const rounded = (value, decimals) => String(Number(value.toFixed(decimals)));

/* Writes only what changed: the page is laid out anew on every write. */
function say(id, text) {
  const element = $(id);
  if (element.textContent !== text) element.textContent = text;
}

/* A number of the JSON for people, and exactly, as data-value, for programs. */
function sayNumber(id, value, decimals = 2) {
  const known = finite(value);
  say(id, known ? rounded(value, decimals) : "–");
  const exact = known ? String(value) : "";
  if ($(id).dataset.value !== exact) $(id).dataset.value = exact;
}

function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

function makeSvg(tag, attributes = {}) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  return element;
}

function icon(name) {
  const image = makeSvg("svg", { class: "icon", "aria-hidden": "true", viewBox: "0 0 16 16" });
  image.append(makeSvg("use", { href: `#icon-${name}` }));
  return image;
}

function iconOf(kind) {
  if (["lost", "reset", "shut", "battery", "missed"].includes(kind)) return kind;
  if (kind === "looked") return "scanned";
  if (kind === "home" || kind === "homeward") return "home";
  if (FAULTS.has(kind)) return "fault";
  if (kind === "end") return "stopped";
  return $(`icon-${kind}`) ? kind : "other";
}

/* How many of a rising list are not later than t. */
function countUntil(list, t, timeOf = (item) => item) {
  let low = 0, high = list.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (timeOf(list[middle]) <= t + EPSILON) low = middle + 1;
    else high = middle;
  }
  return low;
}

/* ---- colours: Okabe and Ito's, in the order of `quarter draw` ---- */

const PALETTE = [
  [0, 114, 178], [213, 94, 0], [0, 158, 115], [204, 121, 167], [230, 159, 0], [86, 180, 233], [179, 162, 0],
];
const isDark = () => document.documentElement.dataset.theme === "dark";

/* From the 8th robot on darker, then paler; on a dark page, which wants all of them a little paler, the other way round. */
function channels(robot) {
  const turn = Math.floor(robot / PALETTE.length) % 3;
  return PALETTE[robot % PALETTE.length].map((base) => {
    const varied = turn === 0 ? base : (turn === 1) === isDark() ? 255 - (255 - base) * 0.55 : base * 0.55;
    return Math.round(isDark() ? 255 - (255 - varied) * 0.82 : varied);
  });
}
const colour = (robot, alpha = 1) => `rgba(${channels(robot).join(", ")}, ${alpha})`;

function inkOn(robot) {
  const [red, green, blue] = channels(robot);
  return 0.299 * red + 0.587 * green + 0.114 * blue > 140 ? "#111" : "#fff";
}

let style = {}; // the page's colours, for the canvas
function readStyle() {
  const computed = getComputedStyle(document.documentElement);
  for (const name of ["panel", "ink", "soft", "line", "wall", "ground", "slow", "grid", "mine", "fault", "tint", "left", "ghost"])
    style[name] = computed.getPropertyValue(`--${name}`).trim();
}
