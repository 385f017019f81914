// Work-groups, once for C++ and GLSL.
#ifndef MACULA_SHARED_DISPATCH_H
#define MACULA_SHARED_DISPATCH_H

// Threads a side of a full-screen pass: 64 in all fill a wavefront of any GPU, and a square keeps
// fetches close together.
#define FULLSCREEN_GROUP 8

// Threads of a work-group that walks a list.
#define LIST_GROUP 64

// Work-groups in a row, as many as every GPU takes (OpenGL 4.5, table 23.71); longer lists take
// several rows.
#define ROW_GROUPS 65535u

#endif
