// Five points of the viridis colour map (van der Walt and Smith 2015), which grows evenly in
// lightness; sRGB-encoded red, green, blue. Colours between them are mixed linearly.
#ifndef MACULA_SHARED_VIRIDIS_H
#define MACULA_SHARED_VIRIDIS_H

#define VIRIDIS_POINTS 5
#define VIRIDIS_0 0.267, 0.005, 0.329
#define VIRIDIS_1 0.230, 0.322, 0.546
#define VIRIDIS_2 0.128, 0.567, 0.551
#define VIRIDIS_3 0.369, 0.789, 0.383
#define VIRIDIS_4 0.993, 0.906, 0.144

#endif
