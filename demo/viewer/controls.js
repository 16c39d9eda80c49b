"use strict";

/* ---- controls ---- */

const KEYS = {
  " ": () => toggle(),
  ArrowLeft: (shift) => seek(player.now - (shift ? 10 : 1)),
  ArrowRight: (shift) => seek(player.now + (shift ? 10 : 1)),
  Home: () => seek(0),
  End: () => seek(endOf(player.model)),
  "+": () => changeSpeed(1),
  "=": () => changeSpeed(1),
  "-": () => changeSpeed(-1),
};

function onKey(event) {
  if (player.model === null || event.ctrlKey || event.altKey || event.metaKey) return;
  // Space presses whatever control has the focus; on the time line it plays.
  const isPress = event.key === " " && event.target.closest("button, summary, input:not(#scrub)");
  if (isPress || !Object.hasOwn(KEYS, event.key)) return;
  event.preventDefault();
  KEYS[event.key](event.shiftKey);
}

function seekOnChart(event) {
  if (event.buttons % 2 === 0) return;
  const x = event.clientX - $("chart").getBoundingClientRect().left - chart.left;
  seek((x / (chart.width - chart.left - chart.right)) * chart.time);
}

function setTheme(theme) {
  document.documentElement.dataset.theme = theme;
  say("theme", theme === "dark" ? "Light" : "Dark");
  $("theme").setAttribute("aria-label", theme === "dark" ? "Light colours" : "Dark colours");
  redraw();
}

function wireTheme() {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  let isChosen = false; // by hand: the system's wish no longer counts
  setTheme(dark.matches ? "dark" : "light");
  dark.addEventListener("change", () => isChosen || setTheme(dark.matches ? "dark" : "light"));
  $("theme").addEventListener("click", () => {
    isChosen = true;
    setTheme(isDark() ? "light" : "dark");
  });
}

function wireControls() {
  for (const speed of SPEEDS) {
    const attributes = { type: "button", "data-speed": speed, "aria-label": `Speed ${speed} times` };
    const button = make("button", attributes, `${speed}×`);
    button.addEventListener("click", () => setSpeed(speed));
    $("speeds").append(button);
  }
  setSpeed(1);
  $("play").addEventListener("click", toggle);
  $("follow").addEventListener("click", () => (seek(player.model.duration), player.following = true, setPlaying(true)));
  $("scrub").addEventListener("input", () => seek(Number($("scrub").value)));
  $("hidden-mines").addEventListener("change", request);
  wireGhost();
  for (const name of ["pointerdown", "pointermove"]) $("chart").addEventListener(name, seekOnChart);
  document.addEventListener("keydown", onKey);
}

/* A run of minutes is shown in about half of one. */
function openingSpeed(duration) {
  return SPEEDS.find((speed) => duration / speed <= 40) ?? SPEEDS.at(-1);
}

function play(data) {
  const problem = problemOf(data, false);
  if (problem !== null) return refuse(problem);
  openModel(modelOf(data));
  setSpeed(openingSpeed(endOf(player.model)));
  setPlaying(!stillMedia.matches);
}

function start() {
  wireControls();
  wireTheme();
  let data;
  try {
    data = JSON.parse($("replay").textContent);
  } catch (error) {
    return refuse("The replay in this page is not JSON.");
  }
  if (data?.live === true) connect();
  else play(data);
  // The panel's width, not its height, which follows the map's.
  let width = 0;
  new ResizeObserver(([entry]) => {
    if (entry.contentRect.width !== width) width = entry.contentRect.width, redraw();
  }).observe($("main"));
}

start();
