/* What a file is, by its contents; by its name only where they leave it open. */
#ifndef QUARTER_READER_KIND_H
#define QUARTER_READER_KIND_H

#include "file.h"

enum kind { KIND_DRAWING, KIND_MOVINGAI, KIND_YAML, KIND_IMAGE, KIND_FOREIGN /* see foreign.h */ };

enum kind kind_of(const char *path, const file_bytes *bytes);

#endif
