// Work-groups, once for C++ and GLSL.
#ifndef MACULA_SHARED_DISPATCH_H
#define MACULA_SHARED_DISPATCH_H

// Threads a side of a full-screen pass: 64 in all fill a wavefront of any GPU, and a square keeps
// fetches close together.
#define FULLSCREEN_GROUP 8

// Threads of a work-group that walks a list.
#define LIST_GROUP 64

// The tile of places that a work-group of the passes over the whole image takes
// (shaders/lib/tile.glsl), in strips: parts of its rows. Where slots are scarce, each strip shares
// out its own (shaders/oit/allocate.comp). 256 threads hide each other's waiting on any GPU, and
// 1,024 places keep additions to the totals rare.
#define STRIP 32
#define TILE_WIDTH 256
#define TILE_HEIGHT 4

// Rows whose strips a work-group of oit/prefix.comp sums.
#define PREFIX_ROWS 32

// Threads of the one work-group that sums what all others have left.
#define SCAN_GROUP 256

// Work-groups in a row, as many as every GPU takes (OpenGL 4.5, table 23.71); longer lists take
// several rows.
#define ROW_GROUPS 65535u

#endif
