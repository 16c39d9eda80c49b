/* What a file is, by its contents; by its name only where they leave it open. */
#ifndef QUARTER_HOST_KIND_H
#define QUARTER_HOST_KIND_H

#include "host/base/file.h"

enum kind { KIND_DRAWING, KIND_MOVINGAI, KIND_YAML, KIND_IMAGE, KIND_FOREIGN /* see foreign.h */ };

enum kind kind_of(const char *path, const file_bytes *bytes);

#endif
