#include "host/table/table.h"

#include <fcntl.h>
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

int table_read(table *t, const char *path, fault *why) {
  if (file_read(&t->bytes, path, TABLE_LIMIT, NULL, why) != 0) return -1;
  const int status = qtr_policy_open(&t->policy, t->bytes.data, (uint32_t)t->bytes.size);
  if (status != QTR_OK) fault_set(why, "%s: %s; %s", path, qtr_strerror(status), mend_of(status));
  if (status == QTR_OK && table_check(&t->policy, path, why) == 0) return 0;
  file_free(&t->bytes);
  return -1;
}

void table_free(table *t) {
  file_free(&t->bytes);
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

const char *table_map_row(char *text, const qtr_grid *grid, unsigned row) {
  for (unsigned column = 0; column < grid->columns; column++) {
    const unsigned cost = qtr_grid_cost(grid, (qtr_cell)(row * grid->columns + column));
    text[column] = cost == 0 ? '#' : cost == 1 ? '.' : (char)('0' + (cost < 9 ? cost : 9));
  }
  text[grid->columns] = '\0';
  return text;
}
