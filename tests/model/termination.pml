/* The termination protocol: how robots that share nothing but two signals over a lossy broadcast come to a stop.
 *
 * A territory is scanned in one step: one scanned in part is known to nobody but the robot that walks it, so the others
 * see no difference. No copy is ever under way: one that arrives late is one that was said late, by a robot that died
 * late. README.md beside this file says what is proven of the model, and how.
 *
 * Settings:
 *   N          robots, and territories: 2, 3 or 4
 *   CLEAR_ALL  a find stops nobody; without it the first find ends the mission
 *   LATE       so many robots, the first ones, walk as slowly as they like, or never again; they still hear and say
 *   MISSED     part of one territory, and the target if it is there, is out of robot 0's reach
 *   NO_DEATHS  every robot stays alive
 * Mutations, each a way to get it wrong:
 *   ONCE       a signal is said once, not again and again
 *   NO_RELAY   what was only heard is not passed on
 *   SILENT     a robot that has stopped says nothing more
 *   EARLY      a territory may be announced before it is scanned
 *   STALE      a robot drives to the target that it read when it set out, scans there, and then counts as visited
 *              whatever its seeker's target is by then
 *   GO_ON      the finder broadcasts FOUND without hearing it itself, so that it goes on
 *   WAIT       a robot whose own territory is done waits to hear of the others
 */
#ifndef N
#define N 3
#endif
#ifndef LATE
#define LATE 0
#endif

/* A signal is one bit; what a robot knows is a set of them. */
#define TERRITORY_DONE(territory) (1 << (territory))
#define FOUND                     (1 << N)
#define ALL_DONE                  (FOUND - 1)
#define NOWHERE                   N

byte target = NOWHERE; /* the territory that holds it, if there is a target */
byte known[N];         /* by each robot: FOUND, and TERRITORY_DONE of all in its `done`. The dead want no news: all */
byte pass[N];          /* territories left behind; N: it has stopped, as in lib/robot/seeker.c */
bool alive[N] = true;
byte deaths;
#ifdef ONCE
byte said[N];
#endif
#ifdef NO_RELAY
byte own[N]; /* what a robot knows from its own scans */
#endif

/* The truth, which no robot reads. */
byte scanned; /* territories scanned from end to end, by their TERRITORY_DONE */
bool found;   /* some robot has stood before the target */
bool lost;    /* in the last step a copy was lost that would have been news */

#ifdef MISSED
byte far; /* the territory that robot 0 cannot scan to the end */
#define out_of_reach(i) ((i == 0) * TERRITORY_DONE(far))
#else
#define out_of_reach(i) 0
#endif

hidden byte word, other; /* scratch within a step */

#define territory(i) ((i + pass[i]) % N)
#define knows(i, s)  ((known[i] & (s)) != 0)
#define stopped(i)   (pass[i] == N)
#define walking(i)   (alive[i] && !stopped(i))

/* ---- what the seeker does ---- */

inline next_territory(i) {
  pass[i]++;
  do
  :: !stopped(i) && knows(i, TERRITORY_DONE(territory(i))) -> pass[i]++
  :: else -> break
  od
}

inline hear(i, what) {
  known[i] = known[i] | (what);
  if
  :: !stopped(i) && (what) == FOUND -> pass[i] = N
  :: !stopped(i) && (what) == TERRITORY_DONE(territory(i)) -> next_territory(i)
  :: else
  fi
}

inline learn(i, what) {
#ifdef NO_RELAY
  own[i] = own[i] | (what);
#endif
  hear(i, what)
}

/* Robot i comes to the end of territory `here`, or to the target in it. */
inline scan(i, here) {
  if
  :: out_of_reach(i) & TERRITORY_DONE(here) -> next_territory(i)
  :: else ->
     found = found || here == target;
     if
#ifndef CLEAR_ALL
     :: here == target ->
#ifdef GO_ON
        known[i] = known[i] | FOUND;
        scanned = scanned | TERRITORY_DONE(here);
        learn(i, TERRITORY_DONE(territory(i)))
#else
        learn(i, FOUND)
#endif
#endif
     :: else ->
        scanned = scanned | TERRITORY_DONE(here);
        learn(i, TERRITORY_DONE(territory(i)))
     fi
  fi
}

/* ---- a robot: it walks, and it says what it knows ---- */

#ifdef WAIT
#define on_the_way(i) (pass[i] == 0)
#else
#define on_the_way(i) true
#endif

proctype walk(byte i) {
#ifdef STALE
  byte here;
  do
  :: atomic { walking(i) -> here = territory(i) }
     if
     :: atomic { walking(i) -> scan(i, here); here = 0 }
     :: !walking(i) -> break
     fi
  :: !walking(i) -> break
  od
#else
  do
  :: atomic { walking(i) && on_the_way(i) -> lost = false; scan(i, territory(i)) }
  :: atomic { walking(i) && i < LATE -> lost = false }
#ifdef EARLY
  :: atomic { walking(i) && !knows(i, TERRITORY_DONE(territory(i))) ->
       known[i] = known[i] | TERRITORY_DONE(territory(i)) }
#endif
  :: !walking(i) -> break
  od
#endif
}

#if N == 2
#define over_all(join, what) (what(0) join what(1))
#elif N == 3
#define over_all(join, what) (what(0) join what(1) join what(2))
#else
#define over_all(join, what) (what(0) join what(1) join what(2) join what(3))
#endif

#if defined(ONCE)
#define to_say(i) (known[i] & ~said[i])
#elif defined(NO_RELAY)
#define to_say(i) own[i]
#elif defined(SILENT)
#define to_say(i) (known[i] * !stopped(i))
#else
#define to_say(i) known[i]
#endif

/* A copy of what its hearer knows changes nothing, so only news is ever said. */
#define known_to(i) known[i]
#define news(i, s)  (alive[i] && (to_say(i) & ~over_all(&, known_to) & (s)) != 0)

proctype say(byte i) {
end:
  do
  :: atomic {
       if
       :: news(i, FOUND) -> word = FOUND
       :: news(i, TERRITORY_DONE(0)) -> word = TERRITORY_DONE(0)
       :: news(i, TERRITORY_DONE(1)) -> word = TERRITORY_DONE(1)
#if N > 2
       :: news(i, TERRITORY_DONE(2)) -> word = TERRITORY_DONE(2)
#endif
#if N > 3
       :: news(i, TERRITORY_DONE(3)) -> word = TERRITORY_DONE(3)
#endif
       fi;
#ifdef ONCE
       said[i] = said[i] | word;
#endif
       lost = false;
       other = 0;
       do /* each copy is heard or lost, independently of all others */
       :: other < N && knows(other, word) -> other++
       :: other < N && !knows(other, word) -> hear(other, word); other++
       :: other < N && !knows(other, word) -> lost = true; other++
       :: other == N -> break
       od
     }
  od
}

/* ---- the world ---- */

inline die(i) {
  alive[i] = false;
  known[i] = FOUND | ALL_DONE;
  pass[i] = N
}

proctype fate() {
  do
#ifndef NO_DEATHS
  :: atomic {
       deaths < N - 1 ->
       if
       :: alive[0] -> die(0)
       :: alive[1] -> die(1)
#if N > 2
       :: alive[2] -> die(2)
#endif
#if N > 3
       :: alive[3] -> die(3)
#endif
       fi;
       deaths++;
       lost = false
     }
#endif
  :: break /* or fairness would kill N - 1 robots in every run */
  od
}

init {
  atomic {
    select(target : 0 .. N); /* N: NOWHERE */
#ifdef MISSED
    select(far : 0 .. N - 1);
#endif
    run walk(0); run say(0);
    run walk(1); run say(1);
#if N > 2
    run walk(2); run say(2);
#endif
#if N > 3
    run walk(3); run say(3);
#endif
    run fate()
  }
}

/* ---- safety ---- */

#define ended(i)        (alive[i] && stopped(i))
#define truth           (scanned | found * FOUND)
#define knows_truly(i)  (!alive[i] || (known[i] & ~truth) == 0)
ltl sound { [] over_all(&&, knows_truly) }

#ifdef CLEAR_ALL
#define enough(set) ((set) == ALL_DONE)
#else
#define enough(set) (found || (set) == ALL_DONE)
#endif
#define ends_rightly(i) (!ended(i) || enough(scanned))
#define ends_in_reach(i) (!ended(i) || enough(scanned | out_of_reach(i)))
ltl ends { [] over_all(&&, ends_rightly) }
ltl reach { [] over_all(&&, ends_in_reach) }

/* Find-first, and there is a target: its territory is known done to nobody, and who stops knows FOUND. */
#define target_open(i) (!alive[i] || !knows(i, TERRITORY_DONE(target)))
#define ends_found(i)  (!ended(i) || knows(i, FOUND))
ltl target_kept { [] (target == NOWHERE || over_all(&&, target_open)) }
ltl all_clear { [] (target == NOWHERE || over_all(&&, ends_found)) }

/* ---- liveness, under weak fairness of each process ---- */

/* Whatever is lost: if all who stay alive walk on, all who stay alive stop. */
#define at_rest(i)  (!walking(i))
#define all_stopped over_all(&&, at_rest)
ltl walkers_stop { <> all_stopped }

/* Whoever walks or not: if a robot that stays alive knows that it is over, and losses of news end some time, all stop.
 * News is heard finitely often, so losses without end are those that never let some repeated signal through. */
#define held(i)     (alive[i] * known[i])
#define heads       over_all(|, held)
#define over        ((heads & FOUND) != 0 || (heads & ALL_DONE) == ALL_DONE)
ltl told_stop { (<>[] (over && !lost)) -> <> all_stopped }
ltl told_stop_all_lost { (<>[] over) -> <> all_stopped }

/* Only the first LATE robots stand still: if another one stays alive, all stop. */
#define walker(i)   (alive[i] && i >= LATE)
ltl late_stop { (<>[] (over_all(||, walker) && !lost)) -> <> all_stopped }

/* ---- what must be possible, or the above would say nothing: each is to be refuted ---- */

ltl never_told { !(<> (over && lost && !all_stopped) && <>[] (over && !lost)) }
ltl never_late { !(<> (lost && walking(0)) && <>[] (over_all(||, walker) && !lost)) }
ltl never_stop { [] !(lost && deaths == 0 && <> (deaths == 0 && all_stopped)) }
ltl never_again { [] !(found && (heads & FOUND) == 0 && <> ((heads & FOUND) != 0)) }
