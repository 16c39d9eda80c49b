"use strict";

/* ---- the player ---- */

const player = { model: null, state: null, now: 0, seen: 0, speed: 1, playing: false, following: false, last: null, frame: 0 };
const isOpen = () => player.model !== null && live.state !== "none" && live.state !== "ended"; // more may come

function request() {
  if (player.frame === 0) player.frame = requestAnimationFrame(onFrame);
}

function onFrame(stamp) {
  player.frame = 0;
  // A page that was hidden for long must not leap on.
  const passed = player.last === null ? 0 : clamp((stamp - player.last) / 1000, 0, 1);
  player.last = stamp;
  if (player.playing) advance(passed);
  show();
  const waits = player.following && player.now >= player.model.duration && isOpen();
  if (player.playing && !waits) request();
  else player.last = null;
}

/* A live run is followed a little behind, quicker the further behind, so that frames that come in bursts look smooth. */
function advance(seconds) {
  const { model } = player, end = endOf(model), lag = end - player.now;
  const rate = player.following ? Math.max(1, 8 * lag) : player.speed;
  const isStill = player.following && stillMedia.matches;
  player.now = isStill ? end : Math.min(end, player.now + seconds * rate);
  if (player.now < end) return;
  if (isOpen()) player.following = true;
  else setPlaying(false);
}

function setPlaying(playing) {
  player.playing = playing;
  if (!playing) player.following = false;
  $("play").querySelector("use").setAttribute("href", playing ? "#icon-pause" : "#icon-play");
  $("play").lastElementChild.textContent = playing ? "Pause" : "Play";
  $("play").dataset.playing = String(playing);
  request();
}

function toggle() {
  if (!player.playing && player.now >= endOf(player.model) && !isOpen()) player.now = 0;
  setPlaying(!player.playing);
}

function seek(t) {
  player.now = clamp(t, 0, endOf(player.model));
  player.following = false;
  request();
}

function setSpeed(speed) {
  player.speed = speed;
  for (const button of $("speeds").children)
    button.setAttribute("aria-pressed", String(button.dataset.speed === String(speed)));
}

function changeSpeed(step) {
  setSpeed(SPEEDS[clamp(SPEEDS.indexOf(player.speed) + step, 0, SPEEDS.length - 1)]);
}

/* Spoken only for what a listener would stop for, and only when it happens, not when it is jumped over. */
function speakOf(events) {
  const told = events.filter(({ kind }) => ["found", "lost", "takeover", "stuck", "reset", "shut", "missed", "battery"].includes(kind));
  if (told.length > 0) say("said", told.map((event) => event.text || event.kind).join("; "));
}

function showTime() {
  const { model, now } = player, end = endOf(model), scrub = $("scrub");
  say("time", now.toFixed(1));
  $("time").dataset.value = String(now);
  scrub.max = String(Math.max(end, EPSILON));
  $("marks").style.setProperty("--duration", scrub.max);
  scrub.value = String(now);
  scrub.style.setProperty("--passed", `${(100 * now) / Math.max(end, EPSILON)}%`);
  scrub.setAttribute("aria-valuetext", `${now.toFixed(1)} of ${rounded(end, 2)} seconds`);
  $("follow").hidden = !isOpen() || player.following;
}

function show() {
  const { model } = player, passed = countUntil(model.events, player.now, (event) => event.t);
  if (view.ratio !== (devicePixelRatio || 1)) layOut();
  if (player.state?.passed !== passed) {
    const before = player.state?.passed ?? passed;
    player.state = stateAfter(model, passed);
    showState(model, player.state);
    markPassed(passed);
    if (player.playing && passed > before) speakOf(model.events.slice(before, passed));
  }
  showTime();
  showRace(model, player.state, player.now);
  showStory(model, player.state, player.now);
  showOutcome(model, player.now);
  showChart(model, player.state, player.now);
  drawMap(model, player.state, player.now);
}

function layOut() {
  readStyle();
  sizeMap(player.model);
  view.ground = null;
  drawChart(player.model);
}

/* All that hangs on the colours or the size. */
function redraw() {
  if (player.model === null) return;
  layOut();
  listEvents(player.model);
  $("place-rows").replaceChildren(...player.model.data.places.map(placeRow));
  player.state = null;
  request();
}

function subtitleOf(data) {
  const parts = [many(data.robots, "robot"), many(data.places.length, "suspected place"),
    data.mode === "clear" ? "searched to the last place" : "searched until the find", `seed ${data.seed ?? "unknown"}`];
  return parts.join(" · ");
}

/* A live page may be told of another run; only the first start plays by itself. */
function openModel(model) {
  const { data } = model;
  Object.assign(player, { model, state: null, now: 0, seen: 0 });
  const title = typeof data.title === "string" && data.title !== "" ? data.title : data.mission ?? "Replay";
  say("title", title);
  document.title = `${title} – Quarter`;
  say("sentence", sentenceOf(data));
  say("subtitle", subtitleOf(data));
  say("places-total", String(data.places.length));
  $("legend-slow").hidden = !/[2-9]/.test(data.map.rows_text.join(""));
  $("main").hidden = false;
  $("problem").hidden = true;
  // Where there is room for it beside the events.
  $("places").open = innerWidth > 900 && data.places.length <= 12;
  $("legend-ghost").hidden = model.ghost === null;
  for (const item of document.querySelectorAll(".of-terms")) item.hidden = !hasTerms(data);
  sayNumber("duration", endOf(model), 1);
  redraw();
}

function refuse(sentence) {
  $("main").hidden = true;
  $("problem").hidden = false;
  say("problem", sentence);
}
