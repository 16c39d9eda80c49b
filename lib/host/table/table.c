#include "host/table/table.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "host/table/table_check.h"
#include "quarter/nominal.h"
#include "quarter/status.h"

#define TABLE_LIMIT ((size_t)64 << 20)

static const char *mend_of(int status) {
  switch (status) {
  case QTR_ERR_MAGIC: return "name a file written by 'quarter learn -o'";
  case QTR_ERR_FORMAT: return "read it with the version of Quarter that wrote it, or learn it again";
  case QTR_ERR_LIMIT: return "rebuild with larger QTR_MAX_CELLS, QTR_MAX_PLACES or QTR_MAX_SEEKERS";
  default: return "copy it again from where it was learnt, or learn it again";
  }
}

/* What the table says beside what a robot plays by. */
static int read_rest(table *t) {
  const uint32_t behind = (uint32_t)t->bytes.size - t->policy.size;
  qtr_claim_read(&t->claim, &t->policy);
  for (unsigned place = 0; place < t->policy.board.places; place++)
    t->number[place] = (uint16_t)qtr_claim_number(&t->claim, &t->policy, qtr_policy_place(&t->policy, place));
  const int status = qtr_names_read(&t->names, &t->geo, t->bytes.data + t->policy.size, behind);
  fault_clean(t->names.mission); /* names from anywhere end up in terminals and in lines of other tools' files */
  for (int i = 0; i < QTR_MAX_PLACES; i++) fault_clean(t->names.place[i]);
  for (int i = 0; i < QTR_MAX_SEEKERS; i++) fault_clean(t->names.seeker[i]);
  return status;
}

int table_open_bytes(table *t) {
  int status = qtr_policy_open(&t->policy, t->bytes.data, (uint32_t)t->bytes.size);
  if (status == QTR_OK) status = qtr_policy_check(&t->policy);
  return status == QTR_OK ? read_rest(t) : status;
}

int table_read(table *t, const char *path, fault *why) {
  if (file_read(&t->bytes, path, TABLE_LIMIT, NULL, why) != 0) return -1;
  const int status = table_open_bytes(t);
  if (status != QTR_OK) fault_set(why, "%s: %s; %s", path, qtr_strerror(status), mend_of(status));
  if (status == QTR_OK && table_check(&t->policy, path, why) == 0) return 0;
  file_free(&t->bytes);
  return -1;
}

void table_free(table *t) {
  file_free(&t->bytes);
}

int table_add_names(file_bytes *bytes, const qtr_names *names, const qtr_geo *geo, fault *why) {
  const uint32_t more = qtr_names_size(names, geo);
  uint8_t *larger = realloc(bytes->data, bytes->size + more);
  if (larger == NULL) return fault_set(why, "no memory for the table");
  qtr_names_write(larger + bytes->size, names, geo);
  bytes->data = larger;
  bytes->size += more;
  return 0;
}

naming table_naming(const table *t) {
  return (naming){&t->names, t->number, t->policy.board.places, t->policy.board.seekers, t->policy.board.terms.look_of};
}

static table_name name_of(const char *name, const char *what, unsigned number) {
  table_name own;
  if (name[0] != '\0')
    snprintf(own.text, sizeof own.text, "%s", name);
  else
    snprintf(own.text, sizeof own.text, "%s %u", what, number);
  return own;
}

table_name table_place_name(const table *t, unsigned place) {
  const unsigned at = qtr_policy_place(&t->policy, place);
  return name_of(t->names.place[at], "place", t->number[at]);
}

table_name table_look_name(const table *t, unsigned place) {
  const naming n = table_naming(t);
  table_name own = table_place_name(t, place);
  const size_t length = strlen(own.text);
  if (qtr_policy_place(&t->policy, place) != place)
    snprintf(own.text + length, sizeof own.text - length, " (look %u)", naming_look(&n, place));
  return own;
}

table_name table_robot_name(const table *t, int robot) {
  return name_of(t->names.seeker[robot], "robot", (unsigned)robot);
}

unsigned table_column(const table *t, qtr_cell cell) {
  return t->claim.left + cell % t->policy.grid.columns;
}

unsigned table_row(const table *t, qtr_cell cell) {
  return t->claim.top + cell / t->policy.grid.columns;
}

qtr_cell table_cell(const table *t, int column, int row) {
  const qtr_grid *grid = &t->policy.grid;
  const int here = column - t->claim.left, down = row - t->claim.top;
  if (here < 0 || down < 0 || here >= grid->columns || down >= grid->rows) return QTR_NO_CELL;
  return (qtr_cell)(down * grid->columns + here);
}

double table_step_seconds(const table *t) {
  return t->claim.step_time_us / 1e6;
}

bool table_is_late(const table *t, qtr_steps step) {
  return t->claim.deadline > 0 && step > t->claim.deadline;
}

double table_probability(const table *t, unsigned place) {
  double sum = 0.0;
  for (unsigned p = 0; p < t->policy.board.places; p++) sum += qtr_policy_weight(&t->policy, p);
  return qtr_policy_weight(&t->policy, place) / sum;
}

uint32_t table_routes(const table *t, table_route *routes) {
  const qtr_board *board = &t->policy.board;
  uint32_t off_table = 0;
  for (int seeker = 0; seeker < board->seekers; seeker++) {
    table_route *route = &routes[seeker];
    qtr_joint joint;
    qtr_steps now = 0;
    unsigned node = (unsigned)board->places + board->start_of[seeker];
    uint16_t place;
    route->places = 0;
    qtr_joint_start(&joint, board, NULL, NULL);
    while ((place = qtr_policy_play(&t->policy, &joint, seeker, &now, seeker == 0 ? &off_table : NULL)) !=
           QTR_STAND_DOWN) {
      route->step[route->places] = now + qtr_board_steps(board, (unsigned)seeker, node, place);
      route->place[route->places++] = place;
      node = place;
    }
  }
  return off_table;
}

bool table_is_one(const char *path) {
  char magic[4] = {0};
  /* Without O_NONBLOCK a pipe that nobody writes to would hang; what it is, the reader will tell. */
  const int file = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
  if (file < 0) return false;
  const ssize_t got = read(file, magic, sizeof magic);
  close(file);
  return got == (ssize_t)sizeof magic && memcmp(magic, "QTRP", sizeof magic) == 0;
}

static char sign_of(unsigned cost) {
  if (cost < 2) return cost == 0 ? '#' : '.';
  return (char)('0' + (cost < 9 ? cost : 9));
}

const char *table_grid_row(char *text, const qtr_grid *grid, unsigned row) {
  for (unsigned column = 0; column < grid->columns; column++)
    text[column] = sign_of(qtr_grid_cost(grid, (qtr_cell)(row * grid->columns + column)));
  text[grid->columns] = '\0';
  return text;
}

const char *table_map_row(char *text, const table *t, unsigned row) {
  for (unsigned column = 0; column < t->claim.map_columns; column++) {
    const qtr_cell cell = table_cell(t, (int)column, (int)row);
    text[column] = sign_of(cell != QTR_NO_CELL ? qtr_grid_cost(&t->policy.grid, cell) : 0);
  }
  text[t->claim.map_columns] = '\0';
  return text;
}

void table_map_origin(const table *t, double *x, double *y) {
  const qtr_frame frame = qtr_policy_frame(&t->policy);
  const bool is_turned = frame.cosine != 0 || frame.sine != 0;
  const double cosine = is_turned ? (double)frame.cosine / QTR_FRAME_ONE : 1.0;
  const double sine = (double)frame.sine / QTR_FRAME_ONE;
  const double side = frame.cell_size_um / 1e6;
  const double right = t->claim.left * side;
  const double up = (t->claim.map_rows - t->claim.top - t->policy.grid.rows) * side;
  *x = (double)frame.origin_x_um / 1e6 - (cosine * right - sine * up);
  *y = (double)frame.origin_y_um / 1e6 - (sine * right + cosine * up);
}
