"use strict";

/* ---- live ---- */

const live = { state: "none", source: null };
const CONNECTION = {
  connecting: "connecting to the run", live: "live", lost: "connection lost, trying again", ended: "the run has ended",
};

function setConnection(state) {
  live.state = state;
  $("badge").hidden = false;
  $("badge").dataset.state = state;
  say("badge", CONNECTION[state]);
  if (player.model !== null) request();
}

const isSameRun = (a, b) => ["title", "mission", "seed", "mode", "robots"].every((name) => a[name] === b[name]);

function follow(data) {
  openModel(modelOf({ ...data, tracks: undefined, duration: 0, result: undefined }));
  player.following = true;
  setPlaying(true);
}

/* A connection that came back says hello again: what was seen of the run before is kept. */
function onHello(data) {
  const problem = problemOf(data, true);
  if (problem !== null) return live.source.close(), refuse(problem);
  setConnection("live");
  if (player.model === null || !isSameRun(player.model.data, data)) follow(data);
  else addEvents(player.model, data.events ?? []);
}

const nameOf = ({ t, kind, robot, place, territory }) => [t, kind, robot, place, territory].join(" ");

/* Whoever connects is told all events so far, so after a lost connection most of them are known. */
function addEvents(model, events) {
  const known = new Set(model.events.map(nameOf));
  const sound = events.filter((event) => isEvent(event, model.data) && !known.has(nameOf(event)));
  if (sound.length === 0) return;
  const isLater = sound.sort(byTime)[0].t >= (model.events.at(-1)?.t ?? 0);
  const before = model.events.length;
  model.events = withTakeovers(model.data, [...model.events, ...sound]);
  if (isLater && model.events.length === before + sound.length) addRows(sound);
  else listEvents(model), player.state = null;
}

const isPose = (pose) => isPoint(pose) && finite(pose[2]);

function onLiveFrame(frame) {
  if (!finite(frame.t) || !Array.isArray(frame.robots) || !frame.robots.every(isPose)) return;
  // Time ran back: the same run was started again.
  if (frame.t < player.model.times.at(-1) - 1) follow({ ...player.model.data, events: [] });
  const { model } = player;
  if (Array.isArray(frame.events)) addEvents(model, frame.events);
  if (frame.t <= model.times.at(-1) || frame.robots.length < model.data.robots) return request();
  if (model.times.length === 0) player.now = frame.t; // who comes late starts where the run is
  model.times.push(frame.t);
  model.tracks.forEach((track, robot) => {
    const [x, y, heading] = frame.robots[robot];
    track.x.push(x), track.y.push(y), track.heading.push(heading);
  });
  model.duration = Math.max(model.duration, frame.t);
  stretch(model);
}

/* The run has become longer: the chart is drawn anew only when its end is reached. */
function stretch(model) {
  sayNumber("duration", model.duration, 1);
  if (model.duration > chart.time) drawChart(model);
  request();
}

function onEnd(message) {
  const { model } = player;
  live.source.close(); // or the browser would open it again
  model.result = message.result ?? null;
  if (finite(message.duration)) model.duration = Math.max(model.duration, message.duration);
  setConnection("ended");
  stretch(model);
}

function connect() {
  setConnection("connecting");
  live.source = new EventSource("events");
  live.source.addEventListener("error", () => live.state !== "ended" && setConnection("lost"));
  live.source.addEventListener("open", () => player.model !== null && setConnection("live"));
  const listen = (name, needsModel, handle) => live.source.addEventListener(name, (event) => {
    if (needsModel && player.model === null) return;
    try {
      handle(JSON.parse(event.data));
    } catch (error) {
      live.source.close();
      refuse(`The run sent a message that cannot be read: ${error.message}.`);
    }
  });
  listen("hello", false, onHello);
  listen("frame", true, onLiveFrame);
  listen("end", true, onEnd);
}
