// The work-group of full-screen passes, once for C++ and GLSL.
#ifndef MACULA_SHARED_DISPATCH_H
#define MACULA_SHARED_DISPATCH_H

// Threads a side: 64 in all fill a wavefront of any GPU, and a square keeps fetches close together.
#define FULLSCREEN_GROUP 8

#endif
