#include "world.h"

#include <box2d/box2d.h>
#include <math.h>
#include <stdlib.h>

#include "rng.h"
#include "walls.h"

#define SUBSTEPS 4
#define GRIP 8.0f       /* cells a second squared: what the wheels can accelerate or brake */
#define TURN_GRIP 60.0f /* radians a second squared */
#define FASTEST 2.0     /* cells a second: what a wheel can do at most */
#define CROWD 0.27      /* cells between robots that share a start */

typedef struct {
  b2BodyId body;
  double left, right;
  double slip;
  bool stopped;
  double noise_left, noise_right; /* drifts slowly, as wheels on real ground do */
} vehicle;

struct world {
  ground g;
  b2WorldId id;
  int robots;
  vehicle vehicle[DEMO_MOST_ROBOTS];
  rng dice;
  int collisions;
};

/* ---- building ---- */

/* Walls are told from robots when they meet. */
enum { WALL = 1, ROBOT = 2 };

static void add_box(b2WorldId id, double left, double bottom, double width, double height) {
  b2BodyDef def = b2DefaultBodyDef();
  b2ShapeDef shape = b2DefaultShapeDef();
  def.position = (b2Vec2){(float)(left + width / 2), (float)(bottom + height / 2)};
  shape.filter.categoryBits = WALL;
  shape.material.friction = 0.1f;
  const b2Polygon box = b2MakeBox((float)width / 2, (float)height / 2);
  b2CreatePolygonShape(b2CreateBody(id, &def), &shape, &box);
}

static int add_walls(world *w) {
  const double columns = w->g.grid.columns, rows = w->g.grid.rows;
  wall *walls;
  const int count = walls_make(&walls, &w->g.grid);
  if (count < 0) return -1;
  for (int i = 0; i < count; i++)
    add_box(w->id, walls[i].column, rows - walls[i].row - walls[i].rows, walls[i].columns, walls[i].rows);
  free(walls);
  /* around the map */
  add_box(w->id, -1, -1, columns + 2, 1);
  add_box(w->id, -1, rows, columns + 2, 1);
  add_box(w->id, -1, 0, 1, rows);
  add_box(w->id, columns, 0, 1, rows);
  return 0;
}

/* Robots that share a start stand in rows of three about its middle. */
static point start_point(const world *w, const qtr_policy *policy, int robot) {
  const uint16_t *start_of = policy->board.start_of;
  int before = 0;
  int sharing = 0;
  for (int i = 0; i < w->robots; i++) {
    if (start_of[i] != start_of[robot]) continue;
    before += i < robot;
    sharing++;
  }
  const point middle = ground_centre(&w->g, qtr_policy_cell(policy, (unsigned)policy->board.places + start_of[robot]));
  if (sharing == 1) return middle;
  return (point){middle.x + CROWD * (before % 3 - 1), middle.y + CROWD * ((before / 3) % 3 - 1)};
}

static void add_robot(world *w, const qtr_policy *policy, int robot) {
  b2BodyDef def = b2DefaultBodyDef();
  b2ShapeDef shape = b2DefaultShapeDef();
  const point at = start_point(w, policy, robot);
  const b2Circle circle = {{0, 0}, (float)DEMO_RADIUS};
  def.type = b2_dynamicBody;
  def.position = (b2Vec2){(float)at.x, (float)at.y};
  def.rotation = b2MakeRot(6.28f * (float)rng_unit(&w->dice) - 3.14f);
  def.enableSleep = false;
  shape.filter.categoryBits = ROBOT;
  shape.material.friction = 0.1f;
  shape.enableContactEvents = true;
  w->vehicle[robot].body = b2CreateBody(w->id, &def);
  b2CreateCircleShape(w->vehicle[robot].body, &shape, &circle);
}

world *world_new(const qtr_policy *policy, uint64_t seed) {
  world *w = calloc(1, sizeof *w);
  if (w == NULL) return NULL;
  b2WorldDef def = b2DefaultWorldDef();
  def.gravity = (b2Vec2){0, 0};
  w->g = ground_of(policy);
  w->robots = policy->board.seekers;
  w->id = b2CreateWorld(&def);
  rng_seed(&w->dice, seed);
  if (add_walls(w) != 0) {
    world_free(w);
    return NULL;
  }
  for (int robot = 0; robot < w->robots; robot++) add_robot(w, policy, robot);
  return w;
}

void world_free(world *w) {
  if (w == NULL) return;
  b2DestroyWorld(w->id);
  free(w);
}

/* ---- driving ---- */

void world_drive(world *w, int robot, double left, double right) {
  w->vehicle[robot].left = fmin(fmax(left, -FASTEST), FASTEST);
  w->vehicle[robot].right = fmin(fmax(right, -FASTEST), FASTEST);
}

void world_stop_wheels(world *w, int robot, bool stopped) {
  w->vehicle[robot].stopped = stopped;
}

void world_slip(world *w, int robot, double share) {
  w->vehicle[robot].slip = share;
}

static bool reaches_into(const world *w, int robot, point middle) {
  const point at = world_pose_of(w, robot).at;
  return fabs(at.x - middle.x) < 0.5 + DEMO_RADIUS && fabs(at.y - middle.y) < 0.5 + DEMO_RADIUS;
}

bool world_shut(world *w, qtr_cell cell) {
  const point middle = ground_centre(&w->g, cell);
  for (int robot = 0; robot < w->robots; robot++)
    if (reaches_into(w, robot, middle)) return false;
  add_box(w->id, middle.x - 0.5, middle.y - 0.5, 1, 1);
  return true;
}

/* An autoregressive drift: correlated over half a second or so. */
static double drift(world *w, double noise) {
  return 0.95 * noise + 0.31 * WORLD_WHEEL_NOISE * rng_normal(&w->dice);
}

static float limited(float wanted, float most) {
  return wanted > most ? most : wanted < -most ? -most : wanted;
}

static void push(world *w, int robot) {
  vehicle *v = &w->vehicle[robot];
  v->noise_left = drift(w, v->noise_left);
  v->noise_right = drift(w, v->noise_right);
  const double grip = 1.0 - v->slip * rng_unit(&w->dice);
  const double go = v->stopped ? 0.0 : grip / ground_slowness(&w->g, world_pose_of(w, robot).at);
  const double left = go * v->left * (1.0 + v->noise_left);
  const double right = go * v->right * (1.0 + v->noise_right);
  const float speed = (float)((left + right) / 2);
  const float turn = (float)((right - left) / DEMO_AXLE);
  const b2Rot rotation = b2Body_GetRotation(v->body);
  const b2Vec2 velocity = b2Body_GetLinearVelocity(v->body);
  const float mass = b2Body_GetMass(v->body);
  const float most = GRIP * (float)WORLD_STEP;
  const b2Vec2 wanted = {speed * rotation.c - velocity.x, speed * rotation.s - velocity.y};
  const float length = sqrtf(wanted.x * wanted.x + wanted.y * wanted.y);
  const float scale = mass * (length > most ? most / length : 1.0f);
  b2Body_ApplyLinearImpulseToCenter(v->body, (b2Vec2){scale * wanted.x, scale * wanted.y}, true);
  const float spin = b2Body_GetAngularVelocity(v->body);
  b2Body_SetAngularVelocity(v->body, spin + limited(turn - spin, TURN_GRIP * (float)WORLD_STEP));
}

static bool is_robot(b2ShapeId shape) {
  return b2Shape_GetFilter(shape).categoryBits == ROBOT;
}

void world_step(world *w) {
  for (int robot = 0; robot < w->robots; robot++) push(w, robot);
  b2World_Step(w->id, (float)WORLD_STEP, SUBSTEPS);
  const b2ContactEvents events = b2World_GetContactEvents(w->id);
  for (int i = 0; i < events.beginCount; i++)
    if (is_robot(events.beginEvents[i].shapeIdA) && is_robot(events.beginEvents[i].shapeIdB)) w->collisions++;
}

int world_collisions(const world *w) {
  return w->collisions;
}

/* ---- sensing ---- */

world_pose world_pose_of(const world *w, int robot) {
  const b2Vec2 at = b2Body_GetPosition(w->vehicle[robot].body);
  const b2Rot rotation = b2Body_GetRotation(w->vehicle[robot].body);
  return (world_pose){{(double)at.x, (double)at.y}, (double)b2Rot_GetAngle(rotation)};
}

typedef struct {
  b2BodyId self;
  float nearest;
} glance;

static float see(b2ShapeId shape, b2Vec2 at, b2Vec2 normal, float fraction, void *context) {
  glance *g = context;
  (void)at;
  (void)normal;
  if (B2_ID_EQUALS(b2Shape_GetBody(shape), g->self)) return -1.0f;
  g->nearest = fraction;
  return fraction;
}

void world_look(const world *w, int robot, float *range, int count) {
  const b2BodyId self = w->vehicle[robot].body;
  const b2Vec2 from = b2Body_GetPosition(self);
  const float heading = b2Rot_GetAngle(b2Body_GetRotation(self));
  for (int ray = 0; ray < count; ray++) {
    const b2Rot towards = b2MakeRot(b2UnwindAngle(heading + 6.2831853f * (float)ray / (float)count));
    const b2Vec2 reach = {(float)DEMO_EYE_RANGE * towards.c, (float)DEMO_EYE_RANGE * towards.s};
    glance g = {self, 1.0f};
    b2World_CastRay(w->id, from, reach, b2DefaultQueryFilter(), see, &g);
    range[ray] = g.nearest * (float)DEMO_EYE_RANGE;
  }
}
