/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Files for the readers of robots where there is no file system: the page gives them before it loads a model, and takes them back
 * afterwards. Paths are absolute, with "/". */
#ifndef _EPODE_HELD_FILES_H_
#define _EPODE_HELD_FILES_H_

#ifdef __cplusplus
extern "C" {
#endif

/* Holds a copy of these bytes as the file of that path, in place of another one. */
void epode_hold_file(const char* path, const void* bytes, unsigned size);
/* Forgets all files. */
void epode_drop_files(void);

#ifdef __cplusplus
}
#endif

#endif
